"""Families of towels, clothes and cushions; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing
from assets_build.variation import Variation


def towel(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.22, 0.34), v.between(0.14, 0.24), v.between(0.05, 0.11)
    fabric = p.cloth(v)
    if v.pick((False, False, True), (True, False)):
        r = min(0.5 * h + 0.012, 0.06)
        d.tube([(-w / 2, 0, r), (w / 2, 0, r)], r, fabric, 16)
        for side in (-1, 1):
            for share in (0.75, 0.45, 0.2):
                x = side * (w / 2 + 0.001)
                d.tube(
                    [(x, share * r * math.cos(a), r + share * r * math.sin(a)) for a in np.linspace(0, 5.6, 10)],
                    0.003,
                    fabric,
                    4,
                )
        return
    folds = v.pick((3, 2), (4, 5))
    thick = h / folds
    for k in range(folds):
        d.soft_block(
            (0.004 * (k % 2), 0, thick * (k + 0.5)),
            (w * (1 - 0.015 * k), dep * (1 - 0.01 * k), 1.06 * thick),
            0.22,
            fabric,
            6,
        )
    d.block((0.3 * w, 0, h + 0.0005), (0.05 * w, 0.9 * dep, 0.003), p.paint(v, p.PALE))


def folded_clothes(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.22, 0.3), v.between(0.26, 0.34), v.between(0.035, 0.07)
    fabric, count = p.cloth(v), v.pick((1, 2), (3, 1))
    thick = h / count
    for k in range(count):
        d.soft_block(
            (0, 0, thick * (k + 0.5)),
            (w * (1 - 0.02 * k), dep * (1 - 0.02 * k), 1.05 * thick),
            0.2,
            fabric if k == count - 1 else p.cloth(v),
            6,
        )
    collar = v.pick(("shirt", "polo"), ("round", "vee"))
    y = 0.38 * dep
    inside = p.paint(v, p.PALE)
    if collar in ("shirt", "polo"):
        for side in (-1, 1):
            part = Drawing()
            part.prism(
                [(0, 0), (0.075, 0.02), (0.06, 0.07), (0, 0.05)]
                if side > 0
                else [(0, 0), (0, 0.05), (-0.06, 0.07), (-0.075, 0.02)],
                0,
                0.006,
                fabric,
            )
            d.place(part, (0, y - 0.03, h))
        for k in range(4 if collar == "shirt" else 2):
            d.lathe([(0.005, h), (0.005, h + 0.004), (0, h + 0.004)], f.WHITE, (0.0, y - 0.06 - 0.05 * k), 8)
        d.block((0, y - 0.14, h + 0.0005), (0.018, 0.24, 0.002), inside)
    else:
        d.lathe(
            [(0.055, h), (0.055, h + 0.005), (0.042, h + 0.005), (0.04, h + 0.001), (0, h + 0.001)],
            inside,
            (0.0, y - 0.02),
            18 if collar == "round" else 3,
        )
    for side in (-1, 1):
        d.soft_block((side * 0.4 * w, 0.12 * dep, h), (0.14 * w, 0.5 * dep, 0.012), 0.3, fabric, 5)


def cushion(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.34, 0.48), v.between(0.28, 0.46), v.between(0.09, 0.135)
    fabric, power = p.cloth(v), v.pick((0.5, 0.6), (0.35, 1.0))
    d.soft_block((0, 0, h / 2), (w, dep, h), power, fabric, 10)
    trim = v.pick(("none", "button"), ("piping", "button"))
    if trim == "button":
        d.soft_block((0, 0, h), (0.04, 0.04, 0.014), 1.0, p.paint(v), 6)
    elif trim == "piping":
        around = [
            (
                math.copysign(abs(math.cos(a)) ** power, math.cos(a)) * w / 2,
                math.copysign(abs(math.sin(a)) ** power, math.sin(a)) * dep / 2,
                h / 2,
            )
            for a in np.linspace(0.01, 2 * math.pi + 0.01, 33)
        ]
        d.tube(around, 0.006, p.paint(v), 5)


def sock(d: Drawing, v: Variation) -> None:
    long, leg, wide = v.between(0.15, 0.19), v.between(0.09, 0.2), v.between(0.038, 0.047)
    fabric, trim = p.cloth(v), p.paint(v, p.PALE)
    h = 0.02
    bend = v.pick((0.0, 0.02), (0.045, -0.015))
    foot = [
        (0.0, -wide),
        (long - 0.03, -wide),
        (long, -0.6 * wide),
        (long, 0.3 * wide),
        (long - 0.03, 0.7 * wide),
        (1.9 * wide, wide),
    ]
    shin = [(1.9 * wide + bend, wide + leg), (bend, wide + leg), (-0.012, 0.5 * wide)]
    d.prism([*foot, *shin], 0, h, fabric)
    d.prism(
        [
            (bend - 0.003, wide + 0.82 * leg),
            (1.9 * wide + bend + 0.003, wide + 0.82 * leg),
            (1.9 * wide + bend + 0.003, wide + leg),
            (bend - 0.003, wide + leg),
        ],
        -0.001,
        h + 0.002,
        trim,
    )
    if v.pick((True, True, False), (True, False)):
        d.prism(
            [
                (long - 0.035, -wide - 0.001),
                (long - 0.029, -wide - 0.001),
                (long + 0.001, -0.6 * wide),
                (long + 0.001, 0.3 * wide),
                (long - 0.035, 0.74 * wide),
            ],
            -0.0005,
            h + 0.0015,
            trim,
        )
        d.prism([(-0.001, -wide - 0.001), (0.035, -wide - 0.001), (-0.004, 0.1 * wide)], -0.0005, h + 0.0015, trim)


def glove(d: Drawing, v: Variation) -> None:
    scale_ = v.between(0.9, 1.15)
    fabric, trim = v.pick((p.paint(v), p.leather(v), p.cloth(v)), (p.cloth(v), p.speckle(v))), p.paint(v, p.PALE)
    mitten = v.pick((False, False, True), (False, True))
    s, h = scale_, 0.022
    d.loft([(0, 0.046 * s, 0.055 * s, 0.5, 0, 0), (h, 0.044 * s, 0.053 * s, 0.5, 0, 0)], fabric, 16)
    if mitten:
        d.loft([(0, 0.044 * s, 0.06 * s, 0.8, 0, 0.075 * s), (h, 0.042 * s, 0.058 * s, 0.8, 0, 0.075 * s)], fabric, 16)
    else:
        for k, long in enumerate((0.062, 0.075, 0.07, 0.055)):
            x = (-0.034 + 0.0225 * k) * s
            d.tube(
                [
                    (x, 0.04 * s, 0.011),
                    (1.25 * x, (0.045 + 0.8 * long) * s, 0.011),
                    (1.3 * x, (0.05 + long) * s, 0.011),
                ],
                [0.011 * s, 0.0105 * s, 0.006 * s],
                fabric,
                8,
            )
    d.tube(
        [(0.03 * s, -0.03 * s, 0.011), (0.066 * s, 0.015 * s, 0.011), (0.078 * s, 0.045 * s, 0.011)],
        [0.013 * s, 0.0125 * s, 0.007 * s],
        fabric,
        8,
    )
    cuff = v.pick((0.03, 0.045), (0.07, 0.02)) * s
    flare = v.pick((0.045, 0.042), (0.06, 0.05)) * s
    d.loft(
        [
            (0, flare, cuff / 2, 0.3, 0, -0.055 * s - cuff / 2),
            (h + 0.002, flare, cuff / 2, 0.3, 0, -0.055 * s - cuff / 2),
        ],
        trim,
        14,
    )


def hat(d: Drawing, v: Variation) -> None:
    r, kind = v.between(0.085, 0.1), v.pick(("fedora",), ("top", "straw", "cap", "bobble"))
    felt = v.pick((f.BLACK,), (p.paint(v, p.DARK), f.speckled((0.82, 0.68, 0.42), 0.06), p.paint(v), p.cloth(v)))
    band = p.paint(v)
    dome = [(r * math.cos(a), 0.012 + 0.08 * math.sin(a)) for a in np.linspace(0, math.pi / 2, 7)]
    if kind == "cap":
        d.lathe([(r, 0), *dome], felt)
        d.loft([(0.006, 0.075, 0.075, 0.9, 0, -0.085), (0.012, 0.07, 0.07, 0.9, 0, -0.085)], band, 16)
        d.soft_block((0, 0, 0.092), (0.02, 0.02, 0.01), 1.0, band, 5)
    elif kind == "bobble":
        d.lathe([(1.02 * r, 0), (1.02 * r, 0.035), (0.98 * r, 0.036)], band)
        d.lathe([(0.97 * r, 0.03), *((x, z + 0.012) for x, z in dome)], felt)
        d.soft_block((0, 0, 0.112), (0.045, 0.045, 0.04), 1.0, p.paint(v, p.PALE), 7)
    else:
        wide, tall = {"fedora": (1.5, 0.11), "top": (1.45, 0.138), "straw": (1.9, 0.09)}[kind]
        d.lathe(
            [
                (0.9 * r, 0),
                (wide * r, 0.004),
                (wide * r, 0.008),
                (r, 0.008),
                (0.97 * r if kind == "top" else 0.85 * r, tall),
                (0.5 * r, tall - 0.004),
                (0, tall - 0.012 if kind == "fedora" else tall),
            ],
            felt,
            segments=26,
        )
        d.lathe([(1.012 * r, 0.009), (0.985 * r, 0.036)], band, segments=26)


FAMILIES = (
    Family("towel", "towel", towel, 110),
    Family("folded_clothes", "folded clothes", folded_clothes, 110),
    Family("cushion", "cushion", cushion, 30),
    Family("sock", "sock", sock, 80),
    Family("glove", "glove", glove, 100),
    Family("hat", "hat", hat, 30, train=0, test=4),
)
