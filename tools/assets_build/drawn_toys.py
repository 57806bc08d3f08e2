"""Balls, dice, toys and what one exercises with; sizes in m."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from assets_build import finishes as f
from assets_build.primitives import Drawing, Finish

Draw = Callable[[Drawing], None]


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
