"""What furniture shares: what it is made of, what it stands on, its fronts; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.boards import legs, panel
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def timber(v: Variation) -> Finish:
    """Return what furniture is made of: wood, or lacquer."""
    lacquer = p.paint(v, p.PALE)
    return v.pick((p.wood(v), p.wood(v), lacquer, p.paint(v)), (p.wood(v), lacquer, p.wood(v), p.paint(v, p.DARK)))


def plinth(d: Drawing, v: Variation, w: float, dep: float, low: float, finish: Finish) -> None:
    """Draw what a cabinet stands on, up to a height."""
    kind = v.pick(("legs", "board", "legs"), ("splayed", "rails"))
    if kind == "legs":
        legs(d, w - 0.04, dep - 0.05, low, 0.04, finish)
    elif kind == "board":
        d.box((-w / 2 + 0.03, -dep / 2 + 0.05, 0), (w / 2 - 0.03, dep / 2 - 0.01, low), f.DARK_STEEL)
    elif kind == "rails":
        for x in (-w / 2 + 0.06, w / 2 - 0.06):
            d.box((x - 0.02, -dep / 2 + 0.02, 0), (x + 0.02, dep / 2 - 0.02, low), f.DARK_STEEL)
    else:
        for x in (-1, 1):
            for y in (-1, 1):
                d.tube(
                    [
                        (x * (w / 2 - 0.02), y * (dep / 2 - 0.02), 0),
                        (x * (w / 2 - 0.09), y * (dep / 2 - 0.08), low + 0.004),
                    ],
                    [0.012, 0.02],
                    finish,
                    8,
                )


def fronts(
    d: Drawing, v: Variation, x: tuple[float, float], z: tuple[float, float], y: float, rows: int, columns: int,
    face: Finish, knob: Finish,
) -> None:  # fmt: skip
    """Draw rows and columns of drawers with one kind of handle."""
    kind = v.pick(("bar", "knob"), ("cup", "groove"))
    for row in range(rows):
        for column in range(columns):
            xs = tuple(x[0] + (x[1] - x[0]) * (column + k) / columns for k in (0, 1))
            zs = tuple(z[0] + (z[1] - z[0]) * (row + k) / rows for k in (0, 1))
            panel(
                d,
                xs,
                zs,
                y,
                face,
                knob if kind in ("bar", "knob") else face,
                kind if kind == "knob" else "bar" if kind == "bar" else "knob",
            )  # type: ignore[arg-type]
            middle, top = (xs[0] + xs[1]) / 2, zs[1]
            if kind == "cup":
                d.soft_block((middle, y - 0.026, top - 0.06), (0.11, 0.03, 0.035), 0.9, knob, 6)
            elif kind == "groove":
                d.box((xs[0] + 0.02, y - 0.019, top - 0.028), (xs[1] - 0.02, y - 0.014, top - 0.006), f.BLACK)


def receptacle(
    category: str, name: str, draw, density: float, train: int, test: int, collision: str = "", boxes: int = 14
) -> Family:  # type: ignore[no-untyped-def]
    return Family(category, name, draw, density, train, test, collision, boxes, "receptacle")
