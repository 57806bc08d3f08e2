"""Fruit and vegetables; sizes in m."""

import math
from collections.abc import Callable

import numpy as np

from assets_build import finishes as f
from assets_build.primitives import Drawing, Finish

Draw = Callable[[Drawing], None]


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
