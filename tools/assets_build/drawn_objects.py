"""Small objects drawn from turned profiles, blocks and tubes: what the sources lack, and further instances."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from assets_build import finishes as f
from assets_build.drawn_furniture import Drawn
from assets_build.primitives import Drawing, Finish

Draw = Callable[[Drawing], None]


def vessel(
    radii: Sequence[float], h: float, wall: float, finish: Finish, handle: bool = False, foot: float = 0.0
) -> Draw:
    """An open vessel: outer radii at even heights from the foot to the rim."""

    def draw(d: Drawing) -> None:
        heights = [foot + (h - foot) * k / (len(radii) - 1) for k in range(len(radii))]
        outer = list(zip(radii, heights, strict=True))
        inner = [(max(r - wall, 0.001), max(z, foot + wall)) for r, z in reversed(outer)]
        base = [(0.0, 0.0), (radii[0], 0.0)] if foot else [(0.0, 0.0)]
        d.lathe([*base, *outer, *inner, (0.0, foot + wall)], finish)
        if handle:
            r = max(radii)
            arc = [
                (r - 0.004 + 0.032 * math.sin(a), 0.0, h / 2 - 0.3 * h * math.cos(a))
                for a in np.linspace(0, math.pi, 7)
            ]
            d.tube(arc, 0.005, finish, 6)

    return draw


def turned(profile: Sequence[tuple[float, float]], finish: Finish, top: Finish | None = None, split: int = 0) -> Draw:
    """A solid turned body; from profile point `split` on it has the finish `top`."""

    def draw(d: Drawing) -> None:
        if top is None:
            d.lathe(profile, finish)
            return
        d.lathe([*profile[: split + 1], (0.0, profile[split][1])], finish)
        d.lathe([(0.0, profile[split][1]), *profile[split:]], top)

    return draw


def can(radius: float, h: float, label: Finish) -> Draw:
    """A tin with a label."""

    def draw(d: Drawing) -> None:
        d.lathe([(0, 0), (radius, 0), (radius, 0.006)], f.STEEL)
        d.lathe([(radius, 0.006), (radius, h - 0.006)], label)
        d.lathe(
            [(radius, h - 0.006), (radius, h), (radius - 0.004, h), (radius - 0.004, h - 0.003), (0, h - 0.003)],
            f.STEEL,
        )

    return draw


def bottle(radius: float, h: float, neck: float, body: Finish, cap: Finish, label: Finish) -> Draw:
    """A bottle with shoulders, a cap and a label."""

    def draw(d: Drawing) -> None:
        d.lathe(
            [(0, 0), (radius, 0), (radius, 0.6 * h), (0.8 * radius, 0.7 * h), (neck, 0.8 * h), (neck, 0.92 * h)], body
        )
        d.lathe([(radius + 0.0006, 0.2 * h), (radius + 0.0006, 0.5 * h)], label)
        d.lathe([(neck + 0.002, 0.9 * h), (neck + 0.002, h), (0, h)], cap)

    return draw


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


def ball(radius: float, finish: Finish, seams: Finish | None = None) -> Draw:
    """A ball, with three seams where given."""

    def draw(d: Drawing) -> None:
        d.soft_block((0, 0, radius), (2 * radius, 2 * radius, 2 * radius), 1.0, finish, 12)
        if seams is not None:
            r = radius * 0.998
            angles = np.linspace(0, 2 * math.pi, 25)
            for ring in (
                [(r * math.cos(a), r * math.sin(a), radius) for a in angles],
                [(r * math.cos(a), 0.0, radius + r * math.sin(a)) for a in angles],
                [(0.0, r * math.cos(a), radius + r * math.sin(a)) for a in angles],
            ):
                d.tube(ring, 0.02 * radius + 0.0008, seams, 5)

    return draw


def dumbbell(length: float, radius: float, finish: Finish) -> Draw:
    """Two hexagonal weights and a grip."""

    def draw(d: Drawing) -> None:
        half = length / 2
        d.tube([(-half, 0, radius), (half, 0, radius)], 0.014, f.STEEL, 10)
        for side in (-1, 1):
            d.tube([(side * half, 0, radius), (side * half * 0.45, 0, radius)], radius, finish, 6)

    return draw


def die(side: float, body: Finish, pips: Finish) -> Draw:
    """A die with pips on the faces one sees."""
    spots = {
        1: [(0, 0)],
        2: [(-1, -1), (1, 1)],
        3: [(-1, -1), (0, 0), (1, 1)],
        5: [(-1, -1), (-1, 1), (0, 0), (1, -1), (1, 1)],
    }

    def draw(d: Drawing) -> None:
        h, r = side / 2, 0.1 * side
        d.block((0, 0, h), (side, side, side), body)
        for u, v in spots[5]:
            d.block((0.5 * h * u, 0.5 * h * v, side), (2 * r, 2 * r, 0.0012), pips)
        for u, v in spots[3]:
            d.block((0.5 * h * u, -h, h + 0.5 * h * v), (2 * r, 0.0012, 2 * r), pips)
        for u, v in spots[2]:
            d.block((h, 0.5 * h * u, h + 0.5 * h * v), (0.0012, 2 * r, 2 * r), pips)

    return draw


def toy_bricks(colors: Sequence[Finish]) -> Draw:
    """A little pyramid of wooden blocks stuck together."""

    def draw(d: Drawing) -> None:
        s = 0.045
        places = [(-0.75, 0), (0.75, 0), (0, 1)]
        for k, (x, z) in enumerate(places):
            d.block((x * s * 1.02, 0, s / 2 + z * s), (s * 1.4, s, s), colors[k % len(colors)])
        d.lathe([(0.7 * s, 2 * s), (0.0, 3 * s)], colors[-1], segments=4)

    return draw


def cutlery(kind: str, length: float, finish: Finish, grip: Finish) -> Draw:
    """A fork, knife or spoon that lies on its back."""

    def draw(d: Drawing) -> None:
        half = length / 2
        d.soft_block((0, -half * 0.45, 0.005), (0.016, length * 0.55, 0.008), 0.6, grip, 6)
        d.box((-0.004, -0.02, 0.002), (0.004, half * 0.45, 0.006), finish)
        if kind == "spoon":
            d.soft_block((0, half * 0.7, 0.006), (0.042, length * 0.3, 0.012), 1.0, finish, 8)
        elif kind == "fork":
            d.box((-0.013, half * 0.4, 0.002), (0.013, half * 0.6, 0.006), finish)
            for x in (-0.011, -0.0037, 0.0037, 0.011):
                d.box((x - 0.002, half * 0.6, 0.002), (x + 0.002, half, 0.006), finish)
        else:
            d.box((-0.004, half * 0.1, 0.002), (0.016, half, 0.0045), finish)

    return draw


def pan(radius: float, depth: float, grip: float, metal: Finish, handle: Finish, two: bool = False) -> Draw:
    """A frying pan or a pot."""

    def draw(d: Drawing) -> None:
        wall = 0.004
        d.lathe(
            [
                (0, 0),
                (radius * 0.86, 0),
                (radius, depth),
                (radius - wall, depth),
                (radius * 0.86 - wall, wall),
                (0, wall),
            ],
            metal,
        )
        z = depth * 0.8
        if two:
            for side in (-1, 1):
                d.tube(
                    [
                        (side * (radius - 0.005), -0.03, z),
                        (side * (radius + grip), -0.03, z),
                        (side * (radius + grip), 0.03, z),
                        (side * (radius - 0.005), 0.03, z),
                    ],
                    0.006,
                    handle,
                    6,
                )
        else:
            d.tube(
                [(0, radius - 0.005, z), (0, radius + 0.3 * grip, z + 0.01), (0, radius + grip, z + 0.015)],
                [0.007, 0.009, 0.011],
                handle,
                8,
            )

    return draw


def basket(w: float, dep: float, h: float, finish: Finish, round_body: bool, handle: bool) -> Draw:
    """A basket, open above."""

    def draw(d: Drawing) -> None:
        if round_body:
            r, t = w / 2, 0.008
            d.lathe([(0, 0), (0.8 * r, 0), (r, h), (r - t, h), (0.8 * r - t, t), (0, t)], finish)
        else:
            t = 0.01
            d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, t), finish)
            for x in (-w / 2, w / 2 - t):
                d.box((x, -dep / 2, t), (x + t, dep / 2, h), finish)
            for y in (-dep / 2, dep / 2 - t):
                d.box((-w / 2 + t, y, t), (w / 2 - t, y + t, h), finish)
        if handle:
            d.tube(
                [(w / 2 * math.cos(a), 0, h - 0.01 + 0.45 * w * math.sin(a)) for a in np.linspace(0, math.pi, 9)],
                0.008,
                finish,
                6,
            )

    return draw


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


def fruit(radius: float, squash: float, finish: Finish, stem: bool, waist: float = 0.0) -> Draw:
    """An apple, orange, lemon, pear or tomato."""

    def draw(d: Drawing) -> None:
        profile = []
        for v in np.linspace(-math.pi / 2, math.pi / 2, 11):
            up = math.sin(v)
            profile.append(
                (
                    radius * math.cos(v) * (1 - waist * max(up, 0)),
                    radius * squash * (1 + up) + (0.5 * waist * radius * max(up, 0)),
                )
            )
        d.lathe(profile, finish, segments=16)
        if stem:
            top = profile[-1][1]
            d.tube([(0, 0, top - 0.006), (0.004, 0, top + 0.012)], 0.0025, f.WALNUT, 5)

    return draw


def banana(finish: Finish) -> Draw:
    """A banana that lies on its side."""

    def draw(d: Drawing) -> None:
        path = [(0.1 * math.cos(a), 0.1 * math.sin(a), 0.018) for a in np.linspace(0.35, math.pi - 0.35, 9)]
        d.tube(path, [0.005, 0.013, 0.017, 0.018, 0.018, 0.018, 0.017, 0.013, 0.005], finish, 7)

    return draw


def carrot() -> Draw:
    """A carrot with its green."""

    def draw(d: Drawing) -> None:
        d.tube(
            [(-0.085, 0, 0.017), (-0.03, 0, 0.017), (0.05, 0, 0.017), (0.07, 0, 0.017)],
            [0.003, 0.01, 0.017, 0.012],
            Finish((0.92, 0.48, 0.12)),
            8,
        )
        for k in (-1, 0, 1):
            d.tube(
                [(0.068, 0, 0.017), (0.11, 0.015 * k, 0.02 + 0.006 * abs(k))],
                [0.004, 0.002],
                Finish((0.28, 0.52, 0.2)),
                5,
            )

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


def rolling_pin(length: float, radius: float, finish: Finish) -> Draw:
    """A rolling pin that lies down."""

    def draw(d: Drawing) -> None:
        half = length / 2
        d.tube([(-half, 0, radius), (-half * 0.62, 0, radius)], 0.4 * radius, finish)
        d.tube([(half * 0.62, 0, radius), (half, 0, radius)], 0.4 * radius, finish)
        d.tube([(-half * 0.6, 0, radius), (half * 0.6, 0, radius)], radius, finish, 14)

    return draw


def rimmed_plate(radius: float, h: float, finish: Finish, rim: Finish) -> Draw:
    """A plate with a coloured rim."""

    def draw(d: Drawing) -> None:
        d.lathe([(0, 0), (0.55 * radius, 0), (0.62 * radius, 0.25 * h), (radius, h - 0.003)], finish, segments=32)
        d.lathe([(radius, h - 0.003), (radius, h), (0.85 * radius, 0.72 * h)], rim, segments=32)
        d.lathe([(0.85 * radius, 0.72 * h), (0.6 * radius, 0.4 * h), (0, 0.4 * h)], finish, segments=32)

    return draw


def tray(w: float, dep: float, h: float, finish: Finish) -> Draw:
    """A tray with a rim."""

    def draw(d: Drawing) -> None:
        t = 0.008
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, t), finish)
        for x in (-w / 2, w / 2 - t):
            d.box((x, -dep / 2, t), (x + t, dep / 2, h), finish)
        for y in (-dep / 2, dep / 2 - t):
            d.box((-w / 2 + t, y, t), (w / 2 - t, y + t, h), finish)

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


def trophy(h: float) -> Draw:
    """A cup of honour."""

    def draw(d: Drawing) -> None:
        d.box((-0.035, -0.035, 0), (0.035, 0.035, 0.04), f.WALNUT)
        d.lathe(
            [
                (0.025, 0.04),
                (0.008, 0.06),
                (0.008, 0.09),
                (0.045, 0.5 * h + 0.05),
                (0.05, h),
                (0.045, h),
                (0.035, 0.6 * h),
                (0, 0.55 * h),
            ],
            f.BRASS,
        )
        for side in (-1, 1):
            d.tube(
                [
                    (side * 0.044, 0, 0.85 * h),
                    (side * 0.07, 0, 0.8 * h),
                    (side * 0.065, 0, 0.65 * h),
                    (side * 0.04, 0, 0.58 * h),
                ],
                0.004,
                f.BRASS,
                6,
            )

    return draw


def toy_car(body: Finish, length: float) -> Draw:
    """A simple toy car."""

    def draw(d: Drawing) -> None:
        w, r = 0.45 * length, 0.11 * length
        d.box((-w / 2, -length / 2, 0.6 * r), (w / 2, length / 2, 2.2 * r), body)
        d.box((-w / 2 + 0.01, -0.2 * length, 2.2 * r), (w / 2 - 0.01, 0.28 * length, 3.9 * r), f.STEEL)
        d.box((-w / 2 + 0.006, -0.18 * length, 3.9 * r), (w / 2 - 0.006, 0.26 * length, 4.2 * r), body)
        for y in (-0.3 * length, 0.3 * length):
            for side in (-1, 1):
                d.tube([(side * (w / 2 - 0.004), y, r), (side * (w / 2 + 0.012), y, r)], r, f.BLACK, 12)

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


def kettle(radius: float, h: float, body: Finish) -> Draw:
    """An electric kettle with spout and handle."""

    def draw(d: Drawing) -> None:
        d.lathe(
            [
                (0, 0),
                (radius * 1.05, 0),
                (radius * 1.05, 0.02),
                (radius, 0.022),
                (0.75 * radius, 0.9 * h),
                (0, 0.92 * h),
            ],
            body,
        )
        d.lathe([(0, 0.91 * h), (0.012, 0.92 * h), (0.012, h), (0, h)], f.BLACK, segments=10)
        d.tube([(0, -0.8 * radius, 0.72 * h), (0, -1.2 * radius, 0.86 * h)], [0.02, 0.012], body, 8)
        d.tube(
            [
                (0, 0.7 * radius, 0.85 * h),
                (0, 1.45 * radius, 0.82 * h),
                (0, 1.5 * radius, 0.45 * h),
                (0, 0.95 * radius, 0.25 * h),
            ],
            0.009,
            f.BLACK,
            7,
        )

    return draw


def _color(r: float, g: float, b: float) -> Finish:
    return Finish((r, g, b))


def _print(paper: tuple[float, float, float], ink: tuple[float, float, float], seed: int) -> Finish:
    return f.printed(paper, ink, seed)


def _object(category: str, slug: str, draw: Draw, collision: str = "hull", mass: float = 0.0, name: str = "") -> Drawn:
    return Drawn("object", category, slug, name or category.replace("_", " "), draw, collision, 8, mass, 1100)


OBJECTS: tuple[Drawn, ...] = (
    _object("bowl", "white", vessel((0.035, 0.06, 0.072, 0.08), 0.07, 0.004, f.WHITE, foot=0.008), "hollow", 0.3),
    _object(
        "bowl",
        "blue",
        vessel((0.04, 0.075, 0.09, 0.095), 0.08, 0.005, _color(0.25, 0.42, 0.62), foot=0.01),
        "hollow",
        0.4,
    ),
    _object("bowl", "wood", vessel((0.05, 0.09, 0.11, 0.12), 0.085, 0.008, f.OAK), "hollow", 0.4),
    _object("cup", "red_mug", vessel((0.038, 0.04, 0.04, 0.04), 0.095, 0.004, f.RED, handle=True), "hollow", 0.3),
    _object("cup", "sage_mug", vessel((0.036, 0.043, 0.045, 0.042), 0.085, 0.004, f.SAGE, handle=True), "hollow", 0.3),
    _object(
        "cup",
        "yellow_mug",
        vessel((0.04, 0.041, 0.042, 0.042), 0.1, 0.004, _color(0.92, 0.76, 0.2), handle=True),
        "hollow",
        0.3,
    ),
    _object("plate", "blue_rim", rimmed_plate(0.13, 0.022, f.WHITE, _color(0.2, 0.35, 0.6)), mass=0.5),
    _object("plate", "terracotta", rimmed_plate(0.11, 0.022, f.TERRACOTTA, f.TERRACOTTA), mass=0.4),
    _object("plate", "cream", rimmed_plate(0.14, 0.025, f.CREAM, f.SAGE), mass=0.5),
    _object("can", "tomato_soup", can(0.037, 0.105, _print((0.8, 0.15, 0.1), (0.98, 0.95, 0.85), 1)), mass=0.4),
    _object("can", "beans", can(0.037, 0.11, _print((0.15, 0.5, 0.55), (0.98, 0.92, 0.7), 2)), mass=0.4),
    _object("can", "corn", can(0.042, 0.08, _print((0.95, 0.8, 0.2), (0.2, 0.45, 0.2), 3)), mass=0.35),
    _object("can", "cola", can(0.033, 0.12, _print((0.75, 0.08, 0.1), (0.95, 0.95, 0.95), 4)), mass=0.35),
    _object(
        "book",
        "red_novel",
        book(0.13, 0.2, 0.03, _print((0.6, 0.12, 0.12), (0.95, 0.85, 0.6), 5), _color(0.55, 0.1, 0.1)),
        mass=0.4,
    ),
    _object(
        "book",
        "blue_hardback",
        book(0.16, 0.24, 0.035, _print((0.15, 0.25, 0.5), (0.9, 0.9, 0.85), 6), f.NAVY),
        mass=0.6,
    ),
    _object(
        "book",
        "green_paperback",
        book(0.11, 0.18, 0.022, _print((0.25, 0.45, 0.3), (0.95, 0.9, 0.7), 7), _color(0.2, 0.4, 0.26)),
        mass=0.25,
    ),
    _object(
        "book",
        "cookery",
        book(0.21, 0.27, 0.028, _print((0.95, 0.9, 0.8), (0.75, 0.3, 0.15), 8), _color(0.9, 0.85, 0.75)),
        mass=0.8,
    ),
    _object("notebook", "black", book(0.14, 0.21, 0.014, f.BLACK, f.BLACK), mass=0.2),
    _object("notebook", "kraft", book(0.15, 0.21, 0.012, f.CARDBOARD, f.CARDBOARD), mass=0.2),
    _object("notebook", "teal", book(0.12, 0.18, 0.013, _color(0.15, 0.48, 0.5), _color(0.12, 0.4, 0.42)), mass=0.15),
    _object(
        "cereal_box",
        "flakes",
        carton(0.19, 0.065, 0.28, _print((0.95, 0.75, 0.15), (0.75, 0.15, 0.1), 9), _color(0.93, 0.72, 0.15)),
        mass=0.4,
    ),
    _object(
        "cereal_box",
        "oats",
        carton(0.18, 0.07, 0.26, _print((0.2, 0.4, 0.7), (0.98, 0.95, 0.85), 10), _color(0.18, 0.36, 0.62)),
        mass=0.4,
    ),
    _object(
        "cereal_box",
        "muesli",
        carton(0.17, 0.06, 0.25, _print((0.85, 0.88, 0.8), (0.3, 0.45, 0.2), 11), _color(0.8, 0.84, 0.74)),
        mass=0.4,
    ),
    _object(
        "tissue_box",
        "blue",
        carton(0.22, 0.12, 0.09, _print((0.7, 0.82, 0.9), (0.95, 0.95, 0.98), 12), _color(0.66, 0.78, 0.88)),
        mass=0.2,
    ),
    _object(
        "tissue_box",
        "rose",
        carton(0.12, 0.12, 0.13, _print((0.92, 0.78, 0.78), (0.98, 0.95, 0.92), 13), _color(0.9, 0.74, 0.74)),
        mass=0.2,
    ),
    _object(
        "tissue_box",
        "green",
        carton(0.22, 0.12, 0.07, _print((0.75, 0.86, 0.72), (0.4, 0.55, 0.38), 14), _color(0.7, 0.82, 0.68)),
        mass=0.2,
    ),
    _object(
        "bottle",
        "water",
        bottle(
            0.034, 0.22, 0.013, _color(0.72, 0.84, 0.9), _color(0.2, 0.4, 0.75), _print((0.3, 0.6, 0.85), (1, 1, 1), 15)
        ),
        mass=0.5,
    ),
    _object(
        "bottle",
        "ketchup",
        bottle(0.033, 0.2, 0.014, f.RED, f.WHITE, _print((0.95, 0.93, 0.88), (0.75, 0.1, 0.1), 16)),
        mass=0.5,
    ),
    _object(
        "bottle",
        "detergent",
        bottle(
            0.045,
            0.24,
            0.018,
            _color(0.95, 0.78, 0.2),
            _color(0.2, 0.45, 0.75),
            _print((0.2, 0.45, 0.75), (1, 1, 1), 17),
        ),
        mass=0.8,
    ),
    _object(
        "shampoo",
        "lilac",
        bottle(0.032, 0.19, 0.02, _color(0.72, 0.62, 0.82), f.WHITE, _print((0.95, 0.95, 0.98), (0.5, 0.35, 0.65), 18)),
        mass=0.4,
    ),
    _object(
        "shampoo",
        "green",
        bottle(
            0.03,
            0.21,
            0.018,
            _color(0.5, 0.74, 0.55),
            _color(0.2, 0.42, 0.28),
            _print((0.95, 0.98, 0.92), (0.2, 0.45, 0.28), 19),
        ),
        mass=0.4,
    ),
    _object("candle", "white_pillar", candle(0.035, 0.12, f.CREAM, False), mass=0.3),
    _object("candle", "red_saucer", candle(0.025, 0.14, f.RED, True), mass=0.3),
    _object("candle", "green_short", candle(0.04, 0.08, _color(0.35, 0.5, 0.36), False), mass=0.3),
    _object("sponge", "yellow", block((0.11, 0.07, 0.035), f.speckled((0.95, 0.8, 0.25), 0.08), 0.15), mass=0.02),
    _object("sponge", "blue", block((0.12, 0.075, 0.045), f.speckled((0.3, 0.6, 0.8), 0.08), 0.2), mass=0.02),
    _object("sponge", "pink", block((0.1, 0.1, 0.04), f.speckled((0.9, 0.55, 0.65), 0.08), 0.4), mass=0.02),
    _object("soap_bar", "white", block((0.085, 0.055, 0.03), _color(0.95, 0.93, 0.88), 0.4), mass=0.1),
    _object("soap_bar", "green", block((0.08, 0.05, 0.028), _color(0.62, 0.8, 0.6), 0.3), mass=0.1),
    _object("ball", "tennis", ball(0.034, f.cloth((0.8, 0.88, 0.25)), f.WHITE), mass=0.06),
    _object("ball", "red", ball(0.065, f.RED, f.WHITE), mass=0.15),
    _object("ball", "striped", ball(0.07, f.striped((0.95, 0.9, 0.3), (0.2, 0.5, 0.8)), None), mass=0.12),
    _object("ball", "orange_basket", ball(0.068, f.speckled((0.85, 0.45, 0.18), 0.05), f.BLACK), mass=0.2),
    _object("die", "white", die(0.06, f.WHITE, f.BLACK), mass=0.05),
    _object("die", "red", die(0.075, f.RED, f.WHITE), mass=0.08),
    _object("dumbbell", "black", dumbbell(0.24, 0.045, f.DARK_STEEL), mass=2.0),
    _object("dumbbell", "teal", dumbbell(0.2, 0.035, _color(0.15, 0.55, 0.55)), mass=1.0),
    _object("dumbbell", "pink", dumbbell(0.19, 0.032, _color(0.88, 0.42, 0.58)), mass=0.8),
    _object(
        "toy_construction_set",
        "wooden_blocks",
        toy_bricks((f.RED, _color(0.2, 0.45, 0.75), _color(0.95, 0.78, 0.2))),
        "boxes",
        0.15,
        "toy blocks",
    ),
    _object(
        "toy_construction_set",
        "pastel_blocks",
        toy_bricks((f.SAGE, f.TERRACOTTA, f.CREAM, _color(0.6, 0.7, 0.85))),
        "boxes",
        0.15,
        "toy blocks",
    ),
    _object("fork", "steel", cutlery("fork", 0.2, f.STEEL, f.STEEL), mass=0.05),
    _object("fork", "wood", cutlery("fork", 0.2, f.STEEL, f.WALNUT), mass=0.05),
    _object("knife", "wood", cutlery("knife", 0.22, f.STEEL, f.WALNUT), mass=0.08),
    _object("spoon", "steel", cutlery("spoon", 0.2, f.STEEL, f.STEEL), mass=0.05),
    _object("spoon", "red", cutlery("spoon", 0.24, f.STEEL, f.RED), mass=0.06),
    _object("pan", "black_frying", pan(0.12, 0.045, 0.17, f.DARK_STEEL, f.BLACK), "hollow", 0.9, "frying pan"),
    _object(
        "pan", "copper_frying", pan(0.1, 0.04, 0.16, _color(0.72, 0.42, 0.28), f.BRASS), "hollow", 0.8, "frying pan"
    ),
    _object("pot", "steel", pan(0.1, 0.11, 0.03, f.STEEL, f.BLACK, True), "hollow", 1.0, "cooking pot"),
    _object("pot", "red", pan(0.11, 0.1, 0.03, f.RED, f.STEEL, True), "hollow", 1.4, "cooking pot"),
    _object("pot", "saucepan", pan(0.08, 0.09, 0.15, f.STEEL, f.BLACK), "hollow", 0.7, "saucepan"),
    _object("basket", "round", basket(0.26, 0.26, 0.12, f.NATURAL_WICKER, True, False), "hollow", 0.3),
    _object("basket", "square", basket(0.3, 0.2, 0.13, f.DARK_WICKER, False, False), "boxes", 0.4),
    _object("basket", "handled", basket(0.14, 0.14, 0.08, f.WHITE_WICKER, True, True), "hull", 0.3),
    _object("laptop", "silver", laptop(0.32, 0.22, f.STEEL), mass=1.4, name="closed laptop"),
    _object("laptop", "black", laptop(0.34, 0.24, f.DARK_STEEL), mass=1.8, name="closed laptop"),
    _object("laptop", "blue", laptop(0.3, 0.21, f.NAVY), mass=1.2, name="closed laptop"),
    _object("keyboard", "black", keyboard(0.42, 0.14, f.BLACK, f.DARK_STEEL), mass=0.5),
    _object("keyboard", "white", keyboard(0.36, 0.13, f.STEEL, f.WHITE), mass=0.4),
    _object("computer_mouse", "black", mouse(f.DARK_STEEL), mass=0.1),
    _object("computer_mouse", "white", mouse(f.WHITE), mass=0.1),
    _object("apple", "red", fruit(0.04, 0.9, _color(0.75, 0.12, 0.12), True), mass=0.17),
    _object("apple", "green", fruit(0.039, 0.9, _color(0.55, 0.72, 0.22), True), mass=0.17),
    _object("orange", "plain", fruit(0.04, 0.97, f.speckled((0.95, 0.55, 0.12), 0.04), False), mass=0.17),
    _object("lemon", "plain", fruit(0.031, 1.25, f.speckled((0.95, 0.85, 0.2), 0.04), False), mass=0.1),
    _object("pear", "green", fruit(0.036, 1.2, _color(0.72, 0.76, 0.3), True, 0.45), mass=0.18),
    _object("tomato", "red", fruit(0.038, 0.8, _color(0.85, 0.16, 0.1), True), mass=0.15),
    _object("banana", "yellow", banana(_color(0.93, 0.8, 0.25)), mass=0.12),
    _object("carrot", "orange", carrot(), mass=0.08),
    _object("towel", "white", towel((0.3, 0.2, 0.09), f.cloth((0.93, 0.93, 0.92)), 3), mass=0.4),
    _object("towel", "blue", towel((0.28, 0.2, 0.08), f.cloth((0.35, 0.5, 0.68)), 3), mass=0.4),
    _object(
        "towel", "striped", towel((0.26, 0.18, 0.06), f.striped((0.9, 0.88, 0.84), (0.72, 0.4, 0.36)), 2), mass=0.3
    ),
    _object("toilet_paper", "roll", roll(0.055, 0.1, 0.02, f.WHITE, f.CARDBOARD), mass=0.1),
    _object(
        "toilet_paper",
        "large_roll",
        roll(0.065, 0.11, 0.02, f.speckled((0.95, 0.94, 0.92), 0.02), f.CARDBOARD),
        mass=0.15,
    ),
    _object("tape", "brown", roll(0.045, 0.05, 0.035, _color(0.62, 0.45, 0.25), f.CARDBOARD), mass=0.1),
    _object("rolling_pin", "pine", rolling_pin(0.42, 0.027, f.PINE), mass=0.5),
    _object("rolling_pin", "walnut", rolling_pin(0.38, 0.025, f.WALNUT), mass=0.5),
    _object("tray", "oak", tray(0.4, 0.28, 0.045, f.OAK), "boxes", 0.7),
    _object("tray", "white", tray(0.34, 0.24, 0.035, f.WHITE), "boxes", 0.5),
    _object("cutting_board", "oak", block((0.34, 0.22, 0.022), f.OAK, 0.12), mass=0.8),
    _object("cutting_board", "walnut", block((0.3, 0.2, 0.018), f.WALNUT, 0.12), mass=0.6),
    _object("potted_plant", "aloe", flower_pot(0.065, 0.2, f.TERRACOTTA, _color(0.35, 0.55, 0.3), 9), mass=0.7),
    _object("potted_plant", "grass", flower_pot(0.06, 0.26, f.WHITE, _color(0.3, 0.5, 0.22), 12), mass=0.6),
    _object(
        "picture_frame", "oak", frame(0.16, 0.21, f.OAK, _print((0.7, 0.8, 0.85), (0.3, 0.45, 0.35), 20)), mass=0.3
    ),
    _object(
        "picture_frame", "black", frame(0.2, 0.16, f.BLACK, _print((0.9, 0.75, 0.6), (0.5, 0.25, 0.3), 21)), mass=0.3
    ),
    _object("trophy", "gold", trophy(0.24), mass=0.8),
    _object("trophy", "small", trophy(0.18), mass=0.5),
    _object("toy_vehicle", "red_car", toy_car(f.RED, 0.18), mass=0.25, name="toy car"),
    _object("toy_vehicle", "yellow_truck", toy_car(_color(0.93, 0.75, 0.2), 0.24), mass=0.35, name="toy truck"),
    _object("wallet", "brown", wallet((0.11, 0.09, 0.022), f.speckled((0.42, 0.26, 0.16), 0.05)), mass=0.12),
    _object("wallet", "black", wallet((0.12, 0.09, 0.02), f.speckled((0.12, 0.12, 0.13), 0.08)), mass=0.12),
    _object("umbrella", "blue", umbrella(0.42, f.NAVY), mass=0.4),
    _object("umbrella", "red", umbrella(0.3, f.RED), mass=0.3),
    _object("lamp", "white_shade", lamp(0.32, 0.068, f.BRASS, f.CREAM), mass=0.8, name="table lamp"),
    _object("lamp", "blue_shade", lamp(0.28, 0.066, f.OAK, _color(0.35, 0.5, 0.65)), mass=0.7, name="table lamp"),
    _object("kettle", "white", kettle(0.065, 0.22, f.WHITE), mass=0.9),
    _object("kettle", "steel", kettle(0.06, 0.24, f.STEEL), mass=0.9),
    _object("cushion", "blue", block((0.42, 0.42, 0.13), f.cloth((0.30, 0.42, 0.62)), 0.55), mass=0.4),
    _object("cushion", "mustard", block((0.4, 0.4, 0.12), f.cloth((0.82, 0.64, 0.22)), 0.55), mass=0.4),
    _object(
        "cushion", "striped", block((0.45, 0.3, 0.12), f.striped((0.9, 0.88, 0.82), (0.4, 0.5, 0.46)), 0.55), mass=0.4
    ),
    _object("box", "cardboard_small", cuboid((0.24, 0.18, 0.12), f.CARDBOARD), mass=0.3, name="cardboard box"),
    _object("box", "cardboard_flat", cuboid((0.3, 0.22, 0.08), f.CARDBOARD), mass=0.3, name="cardboard box"),
    _object("box", "wooden", cuboid((0.2, 0.13, 0.1), f.CHERRY), mass=0.5, name="wooden box"),
    _object(
        "jar",
        "jam",
        turned(
            [(0, 0), (0.035, 0), (0.036, 0.07), (0.03, 0.078), (0.032, 0.078), (0.032, 0.095), (0, 0.095)],
            _color(0.55, 0.12, 0.16),
            f.BRASS,
            3,
        ),
        mass=0.4,
    ),
    _object(
        "jar",
        "honey",
        turned(
            [(0, 0), (0.04, 0), (0.041, 0.085), (0.033, 0.095), (0.036, 0.095), (0.036, 0.112), (0, 0.112)],
            _color(0.85, 0.58, 0.15),
            f.WHITE,
            3,
        ),
        mass=0.5,
    ),
    _object(
        "jar",
        "coffee",
        turned(
            [(0, 0), (0.042, 0), (0.042, 0.11), (0.036, 0.12), (0.038, 0.12), (0.038, 0.14), (0, 0.14)],
            _color(0.25, 0.16, 0.1),
            f.RED,
            3,
        ),
        mass=0.4,
    ),
    _object(
        "vase",
        "blue",
        vessel((0.045, 0.06, 0.066, 0.05, 0.032, 0.038), 0.24, 0.005, _color(0.2, 0.36, 0.58)),
        "hull",
        0.7,
    ),
    _object("vase", "terracotta", vessel((0.04, 0.055, 0.06, 0.05, 0.045), 0.18, 0.006, f.TERRACOTTA), "hull", 0.6),
    _object(
        "salt_and_pepper_shaker",
        "wood",
        turned([(0, 0), (0.025, 0), (0.022, 0.05), (0.014, 0.065), (0.02, 0.08), (0.012, 0.1), (0, 0.105)], f.WALNUT),
        mass=0.1,
    ),
    _object(
        "salt_and_pepper_shaker",
        "white",
        turned([(0, 0), (0.022, 0), (0.018, 0.06), (0.02, 0.06), (0.016, 0.078), (0, 0.08)], f.WHITE, f.STEEL, 3),
        mass=0.1,
    ),
    _object(
        "coaster",
        "cork",
        turned([(0, 0), (0.048, 0), (0.048, 0.008), (0, 0.008)], f.speckled((0.72, 0.54, 0.36), 0.08)),
        mass=0.03,
    ),
    _object("coaster", "slate", cuboid((0.1, 0.1, 0.008), f.GRANITE), mass=0.08),
    _object("lunch_box", "red", block((0.2, 0.14, 0.07), f.RED, 0.15), mass=0.3),
    _object("lunch_box", "blue", block((0.18, 0.12, 0.065), _color(0.25, 0.5, 0.75), 0.15), mass=0.3),
    _object("egg", "brown", fruit(0.022, 1.3, _color(0.82, 0.62, 0.46), False, 0.12), mass=0.06),
    _object("egg", "white", fruit(0.022, 1.3, _color(0.95, 0.93, 0.9), False, 0.12), mass=0.06),
)
