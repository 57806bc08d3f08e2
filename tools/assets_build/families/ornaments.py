"""Families of lamps, lanterns, plants and statues; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def statue(d: Drawing, v: Variation) -> None:
    h = v.between(0.18, 0.3)
    stone = v.pick(
        (f.MARBLE, p.metal(v), f.speckled((0.62, 0.58, 0.52), 0.06)), (p.metal(v), f.speckled((0.42, 0.44, 0.42), 0.08))
    )
    base = v.pick((stone, p.wood(v)), (p.wood(v), stone))
    foot = v.pick((24, 4), (8, 6))
    d.lathe([(0, 0), (0.17 * h, 0), (0.17 * h, 0.1 * h), (0, 0.1 * h)], base, segments=foot)
    if v.pick((True, False), (True, False)):
        d.lathe([(0.1 * h, 0.1 * h), (0.07 * h, 0.2 * h)], base, segments=foot)
        d.loft(
            [
                (0.18 * h, 0.12 * h, 0.08 * h, 0.8, 0, 0),
                (0.36 * h, 0.24 * h, 0.11 * h, 0.9, 0, 0),
                (0.48 * h, 0.2 * h, 0.09 * h, 0.9, 0, 0),
                (0.53 * h, 0.07 * h, 0.07 * h, 1, 0, 0),
                (0.62 * h, 0.065 * h, 0.065 * h, 1, 0, 0),
            ],
            stone,
        )
        d.soft_block((0, -0.01 * h, 0.76 * h), (0.22 * h, 0.26 * h, 0.34 * h), 1.0, stone, 9)
        d.tube([(0, -0.13 * h, 0.8 * h), (0, -0.165 * h, 0.72 * h)], [0.02 * h, 0.03 * h], stone, 6)
        d.soft_block((0, 0.03 * h, 0.86 * h), (0.26 * h, 0.26 * h, 0.22 * h), 0.9, stone, 8)
        return
    d.loft(
        [
            (0.1 * h, 0.12 * h, 0.09 * h, 1, 0, 0),
            (0.35 * h, 0.09 * h, 0.07 * h, 1, 0, 0),
            (0.5 * h, 0.07 * h, 0.06 * h, 1, 0, 0),
            (0.7 * h, 0.12 * h, 0.065 * h, 0.9, 0, 0),
            (0.78 * h, 0.04 * h, 0.04 * h, 1, 0, 0),
        ],
        stone,
    )
    d.soft_block((0, 0, 0.88 * h), (0.13 * h, 0.14 * h, 0.19 * h), 1.0, stone, 8)
    raised = v.pick((0.95, 0.5), (1.15, 0.4))
    for side in (-1, 1):
        reach = raised if side > 0 else 0.45
        d.tube(
            [
                (side * 0.1 * h, 0, 0.72 * h),
                (side * 0.19 * h, -0.02 * h, 0.6 * h),
                (side * 0.16 * h, -0.1 * h, reach * h),
            ],
            [0.034 * h, 0.028 * h, 0.02 * h],
            stone,
            7,
        )


def lamp(d: Drawing, v: Variation) -> None:
    h, r = v.between(0.24, 0.38), v.between(0.05, 0.068)
    base, shade = (
        v.pick((p.metal(v), p.wood(v), p.paint(v)), (p.speckle(v), p.metal(v))),
        v.pick((f.CREAM, p.paint(v, p.PALE), p.cloth(v)), (p.cloth(v), p.paint(v))),
    )
    kind = v.pick(("stick", "vase", "cone"), ("ball", "stack"))
    if kind == "stick":
        d.lathe([(0, 0), (0.75 * r, 0), (0.7 * r, 0.014), (0.012, 0.028), (0.012, 0.56 * h), (0, 0.56 * h)], base)
    elif kind == "vase":
        d.lathe(
            [(0, 0), (0.5 * r, 0), (0.85 * r, 0.2 * h), (0.4 * r, 0.42 * h), (0.012, 0.5 * h), (0.012, 0.56 * h)], base
        )
    elif kind == "cone":
        d.lathe([(0, 0), (0.9 * r, 0), (0.15 * r, 0.52 * h), (0.012, 0.56 * h)], base)
    elif kind == "ball":
        d.soft_block((0, 0, 0.26 * h), (1.5 * r, 1.5 * r, 0.46 * h), 1.0, base, 8)
        d.lathe([(0, 0), (0.55 * r, 0), (0.55 * r, 0.05 * h), (0, 0.05 * h)], f.BRASS)
        d.tube([(0, 0, 0.45 * h), (0, 0, 0.57 * h)], 0.01, f.BRASS)
    else:
        for k in range(3):
            d.soft_block((0, 0, (0.09 + 0.17 * k) * h), (1.3 * r, 1.3 * r, 0.18 * h), 0.9, base, 7)
        d.tube([(0, 0, 0.5 * h), (0, 0, 0.57 * h)], 0.01, f.BRASS)
    top, sides = v.pick((0.7, 0.5), (0.95, 0.3)), v.pick((24, 24), (6, 4))
    d.lathe([(r, 0.55 * h), (top * r, h), (top * r - 0.003, h), (r - 0.003, 0.55 * h)], shade, segments=sides)
    d.lathe([(top * r, 0.97 * h), (0, 0.97 * h)], f.WHITE, segments=sides)


def lantern(d: Drawing, v: Variation) -> None:
    w, h = v.between(0.1, 0.136), v.between(0.17, 0.28)
    frame, sides = (
        v.pick((p.paint(v, p.DARK), p.metal(v), p.paint(v)), (p.metal(v), p.paint(v))),
        v.pick((4, 4, 6), (8, 5)),
    )
    r = w / 2
    d.lathe([(0, 0), (r, 0), (r, 0.07 * h), (0, 0.07 * h)], frame, segments=sides)
    d.lathe([(0.72 * r, 0.07 * h), (0.72 * r, 0.66 * h)], p.paint(v, p.GLASSES), segments=sides)
    d.lathe(
        [(0.97 * r, 0.66 * h), (0.97 * r, 0.7 * h), (v.pick((0.3, 0.2), (0.6,)) * r, 0.86 * h), (0, 0.87 * h)],
        frame,
        segments=sides,
    )
    for k in range(sides):
        a = 2 * math.pi * k / sides
        d.tube(
            [
                (0.88 * r * math.cos(a), 0.88 * r * math.sin(a), 0.05 * h),
                (0.88 * r * math.cos(a), 0.88 * r * math.sin(a), 0.68 * h),
            ],
            0.006,
            frame,
            5,
        )
    d.turn(180 / sides)
    d.tube(
        [(0.028 * math.cos(a), 0, 0.9 * h + 0.028 * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 13)],
        0.004,
        frame,
        5,
    )
    d.lathe([(0.76 * r, 0.1 * h), (0.76 * r, 0.13 * h)], p.paint(v), segments=sides)


def potted_plant(d: Drawing, v: Variation) -> None:
    r, h = v.between(0.05, 0.068), v.between(0.17, 0.32)
    pot, leaf = (
        v.pick((f.TERRACOTTA, p.paint(v), p.paint(v, p.PALE)), (p.speckle(v), p.wood(v))),
        Finish(
            v.pick(((0.3, 0.5, 0.24), (0.36, 0.56, 0.3), (0.22, 0.42, 0.26)), ((0.45, 0.56, 0.25), (0.32, 0.5, 0.42)))
        ),
    )
    top = min(0.42 * h, 0.11)
    d.lathe(
        [
            (0, 0),
            (v.pick((0.7, 0.9), (0.5, 1.0)) * r, 0),
            (r, top),
            (0.88 * r, top),
            (0.86 * r, 0.9 * top),
            (0, 0.9 * top),
        ],
        pot,
    )
    kind = v.pick(("spikes", "bush", "cactus"), ("fans", "trailing"))
    if kind == "cactus":
        d.soft_block((0, 0, 0.5 * (top + h)), (1.1 * r, 1.1 * r, h - 0.85 * top), 0.8, leaf, 8)
        d.tube(
            [(0.4 * r, 0, 0.55 * (top + h)), (0.95 * r, 0, 0.6 * (top + h)), (0.95 * r, 0, 0.8 * h)],
            [0.018, 0.02, 0.016],
            leaf,
            7,
        )
        return
    count = {"spikes": 12, "bush": 26, "fans": 9, "trailing": 22}[kind]
    for k in range(count):
        a, out = 2.4 * k, (0.25 + 0.75 * ((7 * k) % 11) / 11)
        c, s = math.cos(a), math.sin(a)
        if kind == "spikes":
            d.tube(
                [
                    (0.1 * r * c, 0.1 * r * s, 0.85 * top),
                    (0.5 * out * r * c, 0.5 * out * r * s, 0.5 * (top + h)),
                    (1.0 * out * r * c, 1.0 * out * r * s, h * (1 - 0.12 * (k % 4))),
                ],
                [0.007, 0.011, 0.001],
                leaf,
                5,
            )
        elif kind == "bush":
            z = top + (h - top) * (0.25 + 0.75 * ((5 * k) % 13) / 13) * (1.05 - 0.4 * out**2)
            d.soft_block((0.95 * r * out * c, 0.95 * r * out * s, z - 0.01), (0.05, 0.05, 0.022), 1.0, leaf, 4)
            d.tube([(0, 0, 0.85 * top), (0.9 * r * out * c, 0.9 * r * out * s, z - 0.01)], 0.002, leaf, 3)
        elif kind == "fans":
            part = Drawing()
            part.soft_block((0, 0, 0.45 * (h - top)), (0.036, 0.006, 0.9 * (h - top)), 1.0, leaf, 6)
            d.tube([(0, 0, 0.85 * top), (0.3 * r * c, 0.3 * r * s, top + 0.2 * (h - top))], 0.003, leaf, 4)
            d.place(part, (0.15 * r * c, 0.15 * r * s, top), (8 + 9 * (k % 3), 0, math.degrees(a) + 90))
        else:
            d.tube(
                [
                    (0.4 * r * c, 0.4 * r * s, 0.9 * top),
                    (0.9 * r * c, 0.9 * r * s, top + 0.3 * (h - top) * (k % 3) / 2 + 0.02),
                    (1.02 * r * c, 1.02 * r * s, top * (0.25 + 0.6 * out)),
                ],
                [0.005, 0.008, 0.004],
                leaf,
                5,
            )
            if k % 3 == 0:
                d.tube([(0, 0, 0.9 * top), (0.3 * r * c, 0.3 * r * s, h)], [0.006, 0.003], leaf, 5)


def trophy(d: Drawing, v: Variation) -> None:
    h = v.between(0.18, 0.32)
    gold, base = (
        v.pick((f.BRASS,), (f.BRASS, f.STEEL, Finish((0.72, 0.45, 0.3)))),
        v.pick((f.WALNUT,), (f.BLACK, f.MARBLE, f.CHERRY)),
    )
    kind = v.pick(("cup",), ("star", "cup", "figure"))
    sides = v.pick((4,), (4, 8, 20))
    d.lathe([(0, 0), (0.05, 0), (0.045, 0.17 * h), (0, 0.17 * h)], base, segments=sides)
    d.turn(45 if sides == 4 else 0)
    d.block((0, -0.044, 0.085 * h), (0.04, 0.012, 0.07 * h), gold)
    d.lathe([(0.028, 0.17 * h), (0.009, 0.24 * h), (0.009, 0.42 * h)], gold, segments=14)
    if kind == "cup":
        d.lathe([(0.009, 0.4 * h), (0.042, 0.56 * h), (0.052, h), (0.046, h), (0.03, 0.6 * h), (0, 0.56 * h)], gold)
        for side in (-1, 1):
            d.tube(
                [
                    (side * 0.046, 0, 0.9 * h),
                    (side * 0.075, 0, 0.86 * h),
                    (side * 0.07, 0, 0.68 * h),
                    (side * 0.042, 0, 0.6 * h),
                ],
                0.005,
                gold,
                6,
            )
    elif kind == "star":
        part = Drawing()
        points = [
            (
                (0.28 if k % 2 == 0 else 0.12) * h * math.sin(math.pi * k / 5),
                (0.28 if k % 2 == 0 else 0.12) * h * math.cos(math.pi * k / 5),
            )
            for k in range(10)
        ]
        part.prism(points[::-1], -0.008, 0.008, gold)
        d.place(part, (0, 0, 0.7 * h), (90, 0, 0))
    else:
        d.loft(
            [(0.42 * h, 0.02, 0.014, 1, 0, 0), (0.68 * h, 0.032, 0.018, 1, 0, 0), (0.76 * h, 0.012, 0.012, 1, 0, 0)],
            gold,
            12,
        )
        d.soft_block((0, 0, 0.82 * h), (0.036, 0.036, 0.044), 1.0, gold, 7)
        for side in (-1, 1):
            d.tube([(side * 0.028, 0, 0.7 * h), (side * 0.05, 0, 0.84 * h), (side * 0.03, 0, h)], 0.007, gold, 6)


FAMILIES = (
    Family("statue", "statue", statue, 350),
    Family("lamp", "table lamp", lamp, 180),
    Family("lantern", "lantern", lantern, 160),
    Family("potted_plant", "potted plant", potted_plant, 200),
    Family("trophy", "trophy", trophy, 450, train=0, test=3),
)
