"""Books, boxes, cloths, office and household things; sizes in m."""

import math
from collections.abc import Callable

import numpy as np

from assets_build import finishes as f
from assets_build.primitives import Drawing, Finish

Draw = Callable[[Drawing], None]


def carton(w: float, dep: float, h: float, face: Finish, side: Finish) -> Draw:
    """A printed box: cereals, tissues, medicine."""

    def draw(d: Drawing) -> None:
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, h), side)
        for y, turn in ((-dep / 2 - 0.0004, 1), (dep / 2 + 0.0004, -1)):
            x = turn * w / 2
            p = np.array([[-x, y, 0], [x, y, 0], [x, y, h], [-x, y, h]])
            uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
            d.add(np.array([p[[0, 1, 2]], p[[0, 2, 3]]]), face, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))

    return draw


def book(w: float, h: float, thick: float, cover: Finish, spine: Finish) -> Draw:
    """A closed book that lies on its back: cover, pages, spine."""

    def draw(d: Drawing) -> None:
        d.box((-w / 2, -h / 2, 0), (w / 2, h / 2, 0.003), spine)
        d.box((-w / 2 + 0.004, -h / 2 + 0.004, 0.003), (w / 2 - 0.004, h / 2 - 0.004, thick - 0.003), f.CREAM)
        d.box((-w / 2, -h / 2, 0.003), (-w / 2 + 0.004, h / 2, thick - 0.003), spine)
        d.box((-w / 2, -h / 2, thick - 0.003), (w / 2, h / 2, thick - 0.0002), spine)
        p = np.array([[-w / 2, -h / 2, thick], [w / 2, -h / 2, thick], [w / 2, h / 2, thick], [-w / 2, h / 2, thick]])
        uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
        d.add(np.array([p[[0, 1, 2]], p[[0, 2, 3]]]), cover, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))

    return draw


def block(size: tuple[float, float, float], finish: Finish, power: float = 0.25) -> Draw:
    """A rounded block: soap, sponge, cushion, eraser."""
    return lambda d: d.soft_block((0, 0, size[2] / 2), size, power, finish, 10)


def cuboid(size: tuple[float, float, float], finish: Finish) -> Draw:
    """A plain block."""
    return lambda d: d.block((0, 0, size[2] / 2), size, finish)


def laptop(w: float, dep: float, body: Finish) -> Draw:
    """A closed laptop."""

    def draw(d: Drawing) -> None:
        d.box((-w / 2, -dep / 2, 0.002), (w / 2, dep / 2, 0.012), body)
        d.box((-w / 2, -dep / 2, 0.0135), (w / 2, dep / 2, 0.02), body)
        d.box((-w / 2 + 0.01, -dep / 2 + 0.01, 0.012), (w / 2 - 0.01, dep / 2 - 0.002, 0.0135), f.BLACK)
        d.lathe([(0.012, 0.02), (0.012, 0.0205), (0, 0.0205)], f.STEEL, segments=12)
        for x in (-w / 2 + 0.03, w / 2 - 0.03):
            for y in (-dep / 2 + 0.03, dep / 2 - 0.03):
                d.block((x, y, 0.001), (0.02, 0.02, 0.002), f.BLACK)

    return draw


def keyboard(w: float, dep: float, body: Finish, keys: Finish) -> Draw:
    """A computer keyboard."""

    def draw(d: Drawing) -> None:
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, 0.014), body)
        columns = int(w / 0.028)
        for row in range(5):
            y = dep / 2 - 0.012 - (row + 1) * (dep - 0.024) / 5
            for column in range(columns):
                x = -w / 2 + 0.012 + column * (w - 0.024) / columns
                if row == 4 and 2 < column < 8:
                    continue
                d.box(
                    (x + 0.0015, y + 0.0015, 0.014),
                    (x + (w - 0.024) / columns - 0.0015, y + (dep - 0.024) / 5 - 0.0015, 0.02),
                    keys,
                )
            if row == 4:
                step = (w - 0.024) / columns
                d.box(
                    (-w / 2 + 0.012 + 3 * step, y + 0.0015, 0.014),
                    (-w / 2 + 0.012 + 8 * step - 0.0015, y + (dep - 0.024) / 5 - 0.0015, 0.02),
                    keys,
                )

    return draw


def mouse(body: Finish) -> Draw:
    """A computer mouse."""

    def draw(d: Drawing) -> None:
        d.soft_block((0, 0, 0.009), (0.062, 0.108, 0.05), 0.8, body, 10)
        d.corners[-1][..., 2] = np.maximum(d.corners[-1][..., 2], 0.0)
        d.block((0, 0.018, 0.0315), (0.007, 0.02, 0.006), f.BLACK)

    return draw


def towel(size: tuple[float, float, float], finish: Finish, folds: int) -> Draw:
    """A folded towel: rounded layers one upon another."""

    def draw(d: Drawing) -> None:
        thick = size[2] / folds
        for k in range(folds):
            shrink = 1 - 0.015 * k
            d.soft_block((0, 0, thick * (k + 0.5)), (size[0] * shrink, size[1] * shrink, thick * 1.08), 0.22, finish, 6)

    return draw


def roll(radius: float, h: float, core: float, finish: Finish, inside: Finish) -> Draw:
    """A roll of paper or tape that stands on its end."""

    def draw(d: Drawing) -> None:
        d.lathe([(core, 0), (radius, 0), (radius, h), (core, h)], finish)
        d.lathe([(core, h), (core, 0)], inside)

    return draw


def candle(radius: float, h: float, wax: Finish, plate: bool) -> Draw:
    """A candle with its wick, upon a saucer where wanted."""

    def draw(d: Drawing) -> None:
        base = 0.012 if plate else 0.0
        if plate:
            d.lathe([(0, 0), (1.5 * radius, 0), (1.9 * radius, base), (0, base)], f.BRASS)
        d.lathe([(0, base), (radius, base), (radius, h), (radius - 0.004, h), (0, h - 0.006)], wax)
        d.tube([(0, 0, h - 0.008), (0.001, 0, h + 0.012)], 0.0015, f.BLACK, 5)

    return draw


def flower_pot(radius: float, h: float, pot: Finish, leaf: Finish, leaves: int) -> Draw:
    """A pot with a plant of pointed leaves."""

    def draw(d: Drawing) -> None:
        d.lathe(
            [
                (0, 0),
                (0.7 * radius, 0),
                (radius, 0.5 * h),
                (0.9 * radius, 0.5 * h),
                (0.88 * radius, 0.45 * h),
                (0, 0.45 * h),
            ],
            pot,
        )
        for k in range(leaves):
            a = 2.4 * k
            lean = 0.35 + 0.5 * (k % 3) / 3
            tip = (lean * 1.3 * radius * math.cos(a), lean * 1.3 * radius * math.sin(a), h * (1 - 0.1 * (k % 4)))
            middle = (0.45 * tip[0], 0.45 * tip[1], 0.45 * h + 0.5 * (tip[2] - 0.45 * h))
            d.tube([(0.1 * tip[0], 0.1 * tip[1], 0.43 * h), middle, tip], [0.006, 0.011, 0.001], leaf, 5)

    return draw


def frame(w: float, h: float, border: Finish, art: Finish) -> Draw:
    """A small standing picture frame that leans back on its foot."""

    def draw(d: Drawing) -> None:
        t, b = 0.016, 0.022
        d.box((-w / 2, 0, 0), (w / 2, t, b), border)
        d.box((-w / 2, 0, h - b), (w / 2, t, h), border)
        d.box((-w / 2, 0, b), (-w / 2 + b, t, h - b), border)
        d.box((w / 2 - b, 0, b), (w / 2, t, h - b), border)
        p = np.array(
            [[-w / 2 + b, 0.004, b], [w / 2 - b, 0.004, b], [w / 2 - b, 0.004, h - b], [-w / 2 + b, 0.004, h - b]]
        )
        uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
        d.add(np.array([p[[0, 1, 2]], p[[0, 2, 3]]]), art, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))
        d.box((-w / 2 + b, 0.006, b), (w / 2 - b, 0.012, h - b), f.BLACK)
        d.turn(-12, 0)
        d.box((-0.02, 0.0, 0.0), (0.02, 0.5 * h, 0.006), f.BLACK)

    return draw


def wallet(size: tuple[float, float, float], finish: Finish) -> Draw:
    """A folded wallet."""

    def draw(d: Drawing) -> None:
        x, y, z = size
        d.soft_block((0, 0, z / 4), (x, y, z / 2), 0.2, finish, 6)
        d.soft_block((0, 0, 3 * z / 4), (x * 0.99, y, z / 2), 0.2, finish, 6)

    return draw


def umbrella(length: float, cloth: Finish) -> Draw:
    """A folded umbrella that lies down."""

    def draw(d: Drawing) -> None:
        half, r = length / 2, 0.028
        d.tube(
            [(-half * 0.6, 0, r), (-half * 0.4, 0, r), (half * 0.6, 0, r), (half * 0.85, 0, r)],
            [0.012, r, 0.022, 0.006],
            cloth,
            10,
        )
        d.tube([(half * 0.85, 0, r), (half, 0, r)], 0.004, f.STEEL, 6)
        d.tube([(-half * 0.6, 0, r), (-half, 0, r)], 0.013, f.WALNUT, 8)

    return draw


def lamp(h: float, radius: float, base: Finish, shade: Finish) -> Draw:
    """A small table lamp."""

    def draw(d: Drawing) -> None:
        d.lathe(
            [(0, 0), (0.75 * radius, 0), (0.7 * radius, 0.015), (0.012, 0.03), (0.012, 0.55 * h), (0, 0.55 * h)], base
        )
        d.lathe([(radius, 0.52 * h), (0.7 * radius, h), (0.7 * radius - 0.003, h), (radius - 0.003, 0.52 * h)], shade)

    return draw
