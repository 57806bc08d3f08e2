"""Vessels, tins, bottles and other kitchenware, drawn from turned profiles; sizes in m."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from assets_build import finishes as f
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


def rolling_pin(length: float, radius: float, finish: Finish) -> Draw:
    """A rolling pin that lies down."""

    def draw(d: Drawing) -> None:
        half = length / 2
        d.tube([(-half, 0, radius), (-half * 0.62, 0, radius)], 0.4 * radius, finish)
        d.tube([(half * 0.62, 0, radius), (half, 0, radius)], 0.4 * radius, finish)
        d.tube([(-half * 0.6, 0, radius), (half * 0.6, 0, radius)], radius, finish, 14)

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
