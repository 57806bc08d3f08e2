"""Families of fruit, vegetables and eggs; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build.family import Draw, Family
from assets_build.primitives import Color, Drawing, Finish
from assets_build.variation import Variation

Palette = tuple[tuple[Color, ...], tuple[Color, ...]]


RED: Palette = (
    ((0.75, 0.12, 0.12), (0.55, 0.72, 0.22), (0.85, 0.55, 0.2)),
    ((0.6, 0.1, 0.16), (0.82, 0.75, 0.3), (0.7, 0.3, 0.2)),
)


def fruit(
    radius: tuple[float, float], tall: tuple[float, float], skins: Palette, waist: float = 0.0, dimple: float = 0.0,
    grain: float = 0.02, tips: bool = False, lying: bool = False,
) -> Draw:  # fmt: skip
    """Return the drawer of a round fruit.

    `waist` narrows it above, `dimple` sinks its top, `tips` draws out its ends, `lying` lays it on its side.
    """

    def draw(d: Drawing, v: Variation) -> None:
        r, squash = v.between(*radius), v.between(*tall)
        skin = f.speckled(v.pick(*skins), grain, 1 + v.seed() % 97)
        lean, narrow = v.pick((0.0, 0.15), (-0.18, 0.3)), waist * v.between(0.75, 1.2)
        profile = []
        for a in np.linspace(-math.pi / 2, math.pi / 2, 13):
            up = math.sin(a)
            wide = r * math.cos(a) * (1 - narrow * max(up, 0.0) - lean * 0.5 * up)
            sink = dimple * r * math.exp(-((wide / (0.35 * r)) ** 2)) * (1 if up > 0 else -0.6)
            point = 0.25 * r * math.copysign(abs(up) ** 8, up) if tips else 0.0
            profile.append((wide, r * squash * (1 + up) - sink + point + (0.4 * narrow * r * max(up, 0))))
        low = min(z for _, z in profile)
        d.lathe([(x, z - low) for x, z in profile], skin, segments=16)
        if not tips:
            top = profile[-1][1] - low
            bend = v.pick((0.004, -0.006), (0.01,))
            d.tube([(0, 0, top - 0.004), (bend, 0, top + v.between(0.008, 0.022))], 0.0022, f.WALNUT, 5)
        if v.pick((False, True), (True, False)) and not tips and waist == 0.0:
            top = profile[-1][1] - low
            d.soft_block((0.012, 0.004, top + 0.008), (0.026, 0.012, 0.003), 0.9, Finish((0.3, 0.5, 0.2)), 6)
        if lying:
            d.turn(90, 1)

    return draw


def tomato(d: Drawing, v: Variation) -> None:
    fruit(
        (0.028, 0.044),
        (0.7, 0.95),
        (((0.85, 0.16, 0.1), (0.78, 0.2, 0.12)), ((0.9, 0.3, 0.12), (0.7, 0.12, 0.14))),
        0,
        0.12,
    )(d, v)
    top = max(float(c[..., 2].max()) for c in d.corners[:1])
    for k in range(v.pick((5, 6), (4,))):
        a = 2 * math.pi * k / 5
        d.tube(
            [
                (0, 0, top - 0.002),
                (0.012 * math.cos(a), 0.012 * math.sin(a), top),
                (0.02 * math.cos(a), 0.02 * math.sin(a), top - 0.004),
            ],
            [0.003, 0.0025, 0.001],
            Finish((0.25, 0.45, 0.18)),
            5,
        )


def egg(d: Drawing, v: Variation) -> None:
    fruit(
        (0.02, 0.025),
        (1.2, 1.45),
        (((0.82, 0.62, 0.46), (0.95, 0.93, 0.9), (0.7, 0.48, 0.34)), ((0.72, 0.8, 0.78), (0.88, 0.78, 0.62))),
        0.14,
        grain=0.012,
    )(d, v)
    del d.corners[1:], d.uvs[1:], d.owners[1:]
    d.turn(90, 1)


def banana(d: Drawing, v: Variation) -> None:
    big, bend = v.between(0.09, 0.115), v.between(0.35, 0.75)
    skin = f.speckled(v.pick(((0.93, 0.8, 0.25),), ((0.93, 0.8, 0.25), (0.78, 0.76, 0.28), (0.88, 0.72, 0.2))), 0.05, 3)
    path = [(big * math.cos(a), big * math.sin(a), 0.018) for a in np.linspace(bend, math.pi - bend, 9)]
    d.tube(path, [0.005, 0.013, 0.017, 0.018, 0.019, 0.018, 0.017, 0.012, 0.004], skin, v.pick((7,), (5, 6)))
    d.tube([path[-1], tuple(2 * np.array(path[-1]) - np.array(path[-2]) * 1.0)], [0.005, 0.004], f.WALNUT, 5)  # type: ignore[list-item]


def carrot(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.07, 0.11), v.between(0.013, 0.021)
    skin = f.speckled(
        v.pick(((0.92, 0.48, 0.12),), ((0.92, 0.48, 0.12), (0.85, 0.4, 0.16), (0.55, 0.2, 0.35))), 0.06, 5
    )
    d.tube(
        [(-half, 0, r), (-0.4 * half, 0, r), (0.55 * half, 0, r), (0.8 * half, 0, r)],
        [0.002, 0.6 * r, r, 0.6 * r],
        skin,
        9,
    )
    for k in range(v.pick((3,), (4, 5))):
        d.tube(
            [(0.78 * half, 0, r), (1.1 * half, 0.012 * (k - 1.5), r + 0.004), (1.35 * half, 0.022 * (k - 1.5), r)],
            [0.003, 0.003, 0.001],
            Finish((0.28, 0.52, 0.2)),
            5,
        )


FAMILIES = (
    Family("apple", "apple", fruit((0.034, 0.044), (0.82, 0.98), RED, 0.0, 0.22), 420),
    Family(
        "orange",
        "orange",
        fruit(
            (0.034, 0.045),
            (0.92, 1.02),
            (((0.95, 0.55, 0.12), (0.92, 0.48, 0.1)), ((0.96, 0.62, 0.2), (0.88, 0.42, 0.14))),
            0.0,
            0.08,
            0.03,
        ),
        450,
    ),
    Family(
        "lemon",
        "lemon",
        fruit(
            (0.026, 0.034),
            (1.15, 1.4),
            (((0.95, 0.85, 0.2), (0.93, 0.88, 0.35)), ((0.86, 0.84, 0.22), (0.98, 0.8, 0.16))),
            0.0,
            0.0,
            0.03,
            True,
            True,
        ),
        480,
    ),
    Family(
        "pear",
        "pear",
        fruit(
            (0.032, 0.04),
            (1.15, 1.35),
            (((0.72, 0.76, 0.3),), ((0.72, 0.76, 0.3), (0.8, 0.66, 0.25), (0.6, 0.5, 0.26))),
            0.5,
        ),
        400,
        train=0,
        test=3,
    ),
    Family("tomato", "tomato", tomato, 470),
    Family("egg", "egg", egg, 560),
    Family("banana", "banana", banana, 290, train=0, test=3),
    Family("carrot", "carrot", carrot, 260, train=0, test=3),
)
