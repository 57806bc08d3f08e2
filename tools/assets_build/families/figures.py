"""Families of figures, dolls and stuffed toys; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation

SKINS = (((0.93, 0.76, 0.62), (0.62, 0.42, 0.3)), ((0.82, 0.62, 0.48), (0.45, 0.3, 0.22)))


def action_figure(d: Drawing, v: Variation) -> None:
    h = v.between(0.16, 0.26)
    suit, trim, skin = (
        p.paint(v),
        p.paint(v),
        v.pick((Finish(SKINS[0][0]), Finish(SKINS[0][1])), (Finish(SKINS[1][0]), p.metal(v))),
    )
    boxy = v.pick((True, False), (True, False))
    power = 0.3 if boxy else 0.8
    for side in (-1, 1):
        x = side * 0.075 * h
        d.soft_block((x, 0, 0.24 * h), (0.1 * h, 0.11 * h, 0.46 * h), power, suit, 6)
        d.soft_block((x, -0.03 * h, 0.03 * h), (0.11 * h, 0.19 * h, 0.06 * h), 0.4, trim, 6)
        lift = v.pick((0.0, 0.16), (0.3, -0.02)) if side > 0 else 0.0
        d.tube(
            [
                (side * 0.16 * h, 0, 0.76 * h),
                (side * 0.23 * h, -0.02 * h, (0.6 + 0.5 * lift) * h),
                (side * 0.22 * h, -0.1 * h, (0.48 + lift) * h),
            ],
            [0.05 * h, 0.04 * h, 0.035 * h],
            suit,
            7,
        )
        d.soft_block((side * 0.22 * h, -0.11 * h, (0.47 + lift) * h), (0.07 * h, 0.07 * h, 0.07 * h), 0.6, skin, 5)
    d.loft(
        [
            (0.44 * h, 0.13 * h, 0.075 * h, power, 0, 0),
            (0.6 * h, 0.12 * h, 0.075 * h, power, 0, 0),
            (0.77 * h, 0.18 * h, 0.09 * h, power, 0, 0),
            (0.8 * h, 0.08 * h, 0.06 * h, power, 0, 0),
        ],
        suit,
    )
    d.loft([(0.45 * h, 0.135 * h, 0.08 * h, power, 0, 0), (0.49 * h, 0.135 * h, 0.08 * h, power, 0, 0)], trim)
    d.block((0, -0.09 * h, 0.68 * h), (0.12 * h, 0.02 * h, 0.08 * h), trim)
    d.soft_block((0, 0, 0.9 * h), (0.15 * h, 0.16 * h, 0.2 * h), 0.4 if boxy else 0.9, skin, 7)
    for side in (-1, 1):
        d.block((side * 0.035 * h, -0.08 * h, 0.92 * h), (0.03 * h, 0.015 * h, 0.02 * h), f.BLACK)
    d.soft_block((0, 0.02 * h, 0.96 * h), (0.17 * h, 0.17 * h, 0.12 * h), 0.5, trim, 6)


def doll(d: Drawing, v: Variation) -> None:
    h = v.between(0.2, 0.34)
    dress, hair, skin = (
        p.cloth(v),
        Finish(v.pick(((0.3, 0.18, 0.1),), ((0.82, 0.62, 0.25), (0.12, 0.1, 0.1), (0.6, 0.25, 0.12)))),
        Finish(v.pick(*SKINS)),
    )
    for side in (-1, 1):
        d.tube([(side * 0.06 * h, 0, 0.03 * h), (side * 0.06 * h, 0, 0.3 * h)], 0.035 * h, skin, 7)
        d.soft_block((side * 0.06 * h, -0.02 * h, 0.025 * h), (0.07 * h, 0.12 * h, 0.05 * h), 0.8, p.paint(v), 5)
        d.tube([(side * 0.1 * h, 0, 0.63 * h), (side * 0.22 * h, -0.03 * h, 0.42 * h)], [0.035 * h, 0.025 * h], skin, 6)
        d.soft_block((side * 0.12 * h, 0, 0.62 * h), (0.1 * h, 0.09 * h, 0.09 * h), 1.0, dress, 5)
    d.lathe(
        [(0.2 * h, 0.2 * h), (0.1 * h, 0.48 * h), (0.11 * h, 0.64 * h), (0.05 * h, 0.68 * h), (0, 0.68 * h)],
        dress,
        segments=16,
    )
    d.soft_block((0, 0, 0.82 * h), (0.25 * h, 0.24 * h, 0.27 * h), 1.0, skin, 8)
    d.soft_block((0, 0.035 * h, 0.87 * h), (0.29 * h, 0.24 * h, 0.25 * h), 1.0, hair, 8)
    if v.pick((True,), (True, False)):
        for side in (-1, 1):
            d.tube(
                [
                    (side * 0.13 * h, 0.02 * h, 0.9 * h),
                    (side * 0.19 * h, 0.02 * h, 0.8 * h),
                    (side * 0.17 * h, 0, 0.62 * h),
                ],
                [0.04 * h, 0.045 * h, 0.015 * h],
                hair,
                6,
            )
    for side in (-1, 1):
        d.soft_block((side * 0.045 * h, -0.115 * h, 0.83 * h), (0.03 * h, 0.02 * h, 0.04 * h), 1.0, f.BLACK, 4)
    d.soft_block((0, -0.116 * h, 0.76 * h), (0.05 * h, 0.015 * h, 0.018 * h), 1.0, f.RED, 4)


def stuffed_toy(d: Drawing, v: Variation) -> None:
    h = v.between(0.2, 0.3)
    fur = f.speckled(v.pick(((0.5, 0.34, 0.2),), ((0.72, 0.55, 0.36), (0.62, 0.62, 0.64), (0.88, 0.72, 0.74))), 0.08, 3)
    pale, kind = f.CREAM, v.pick(("bear",), ("bear", "rabbit", "cat"))
    depth = min(0.118, 0.5 * h)
    d.soft_block((0, 0, 0.29 * h), (0.42 * h, 0.8 * depth, 0.48 * h), 1.0, fur, 8)
    d.soft_block((0, -0.25 * depth, 0.28 * h), (0.26 * h, 0.4 * depth, 0.3 * h), 1.0, pale, 6)
    d.soft_block((0, -0.02, 0.68 * h), (0.38 * h, 0.82 * depth, 0.34 * h), 1.0, fur, 8)
    d.soft_block((0, -0.02 - 0.38 * depth, 0.63 * h), (0.17 * h, 0.3 * depth, 0.12 * h), 1.0, pale, 6)
    d.soft_block((0, -0.02 - 0.52 * depth, 0.66 * h), (0.05 * h, 0.02, 0.035 * h), 1.0, f.BLACK, 4)
    for side in (-1, 1):
        d.soft_block((side * 0.075 * h, -0.02 - 0.4 * depth, 0.73 * h), (0.035 * h, 0.016, 0.04 * h), 1.0, f.BLACK, 4)
        d.tube(
            [(side * 0.17 * h, 0, 0.44 * h), (side * 0.28 * h, -0.15 * depth, 0.26 * h)], [0.07 * h, 0.06 * h], fur, 7
        )
        d.soft_block((side * 0.17 * h, -0.3 * depth, 0.08 * h), (0.17 * h, 0.75 * depth, 0.16 * h), 1.0, fur, 6)
        if kind == "rabbit":
            d.soft_block((side * 0.09 * h, 0, 0.94 * h), (0.09 * h, 0.04, 0.3 * h), 1.0, fur, 6)
        elif kind == "bear":
            d.soft_block((side * 0.15 * h, 0, 0.84 * h), (0.13 * h, 0.035, 0.13 * h), 1.0, fur, 6)
        else:
            d.loft(
                [(0.78 * h, 0.06 * h, 0.02, 1, side * 0.13 * h, 0), (0.92 * h, 0.004, 0.004, 1, side * 0.15 * h, 0)],
                fur,
                8,
            )


FAMILIES = (
    Family("action_figure", "action figure", action_figure, 130),
    Family("doll", "doll", doll, 110, train=0, test=3),
    Family("stuffed_toy", "stuffed toy", stuffed_toy, 60, train=0, test=3),
)
