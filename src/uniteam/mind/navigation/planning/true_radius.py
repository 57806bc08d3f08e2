"""Planning with the base's true radius where there is room for it (`true_radius`)."""

from uniteam.stretch import BASE_RADIUS


def true_radius(cell_size: float) -> tuple[int, ...]:
    """Return by how many cells of a size (m) obstacles grow: the base's radius, or a cell less.

    HomeRobot's three cells of 5 cm are half the radius, so a path may pass where the base does not. A cell less, where
    there is no path otherwise, allows for an obstacle that fills only a part of its cell.
    """
    radius = round(BASE_RADIUS / cell_size)
    return radius, radius - 1
