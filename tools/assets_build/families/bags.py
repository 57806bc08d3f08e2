"""Families of bags and wallets; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def briefcase(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.36, 0.44), v.between(0.08, 0.125), v.between(0.26, 0.33)
    body, metal = v.pick((p.leather(v), p.leather(v), p.metal(v)), (p.leather(v), p.paint(v))), f.BRASS
    power = v.pick((0.12, 0.2), (0.35, 0.06))
    part = Drawing()
    part.loft(
        [
            (-dep / 2, 0.48 * w, 0.47 * h, power, 0, 0),
            (-0.3 * dep, w / 2, h / 2, power, 0, 0),
            (0.3 * dep, w / 2, h / 2, power, 0, 0),
            (dep / 2, 0.48 * w, 0.47 * h, power, 0, 0),
        ],
        body,
    )
    part.loft(
        [(-0.012, 0.503 * w, 0.505 * h, power, 0, 0), (0.012, 0.503 * w, 0.505 * h, power, 0, 0)], p.paint(v, p.DARK)
    )
    d.place(part, (0, 0, h / 2), (90, 0, 0))
    for side in (-1, 1):
        d.block((side * 0.28 * w, -dep / 2, 0.88 * h), (0.045, 0.008, 0.03), metal)
    d.tube(
        [(-0.065, 0, h - 0.004), (-0.058, 0, h + 0.03), (0.058, 0, h + 0.03), (0.065, 0, h - 0.004)],
        0.008,
        p.paint(v, p.DARK),
        7,
    )
    if v.pick((False, True), (True,)):
        d.block((0, -dep / 2 - 0.001, 0.42 * h), (0.7 * w, 0.008, 0.5 * h), body)
        d.block((0, -dep / 2 - 0.006, 0.62 * h), (0.04, 0.006, 0.03), metal)


def backpack(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.26, 0.33), v.between(0.11, 0.135), v.between(0.34, 0.45)
    body, trim = v.pick((p.paint(v), p.cloth(v)), (p.cloth(v), p.paint(v))), p.paint(v, p.DARK)
    top = v.pick((0.7, 0.85), (1.0, 0.5))
    dep *= 0.6
    d.loft(
        [
            (0, 0.44 * w, 0.42 * dep, 0.5, 0, 0),
            (0.12 * h, 0.5 * w, 0.5 * dep, 0.5, 0, 0),
            (0.7 * h, 0.48 * w, 0.48 * dep, 0.5, 0, 0),
            (0.93 * h, 0.44 * top * w, 0.4 * dep, 0.6, 0, 0),
            (h, 0.3 * top * w, 0.2 * dep, 0.8, 0, 0),
        ],
        body,
    )
    pocket = v.pick((0.42, 0.5), (0.3, 0.6))
    d.soft_block(
        (0, -0.5 * dep, 0.08 * h + 0.5 * pocket * h),
        (0.74 * w, 0.55 * dep, pocket * h),
        0.4,
        trim if v.pick((True, False), (False,)) else body,
        7,
    )
    d.block((0, -0.78 * dep, 0.08 * h + 0.8 * pocket * h), (0.6 * w, 0.006, 0.006), f.STEEL)
    for side in (-1, 1):
        d.tube(
            [
                (side * 0.2 * w, 0.42 * dep, 0.88 * h),
                (side * 0.3 * w, 0.66 * dep, 0.62 * h),
                (side * 0.38 * w, 0.42 * dep, 0.12 * h),
            ],
            0.016,
            trim,
            6,
        )
        if v.pick((True, False), (True,)):
            d.soft_block((side * 0.5 * w, 0, 0.22 * h), (0.12 * w, 0.6 * dep, 0.3 * h), 0.5, trim, 6)
    d.tube(
        [
            (-0.05, 0.2 * dep, h - 0.012),
            (-0.04, 0.2 * dep, h + 0.025),
            (0.04, 0.2 * dep, h + 0.025),
            (0.05, 0.2 * dep, h - 0.012),
        ],
        0.007,
        trim,
        6,
    )


def handbag(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.22, 0.3), v.between(0.08, 0.12), v.between(0.15, 0.2)
    skin, metal = v.pick((f.speckled((0.42, 0.26, 0.16), 0.05),), (p.leather(v), p.paint(v), p.cloth(v))), f.BRASS
    top = v.pick((0.8,), (0.65, 1.05, 0.85))
    d.loft(
        [
            (0, 0.48 * w, 0.46 * dep, 0.35, 0, 0),
            (0.15 * h, 0.5 * w, 0.5 * dep, 0.35, 0, 0),
            (0.85 * h, 0.5 * top * w, 0.36 * dep, 0.4, 0, 0),
            (h, 0.46 * top * w, 0.2 * dep, 0.5, 0, 0),
        ],
        skin,
    )
    flap = v.pick((True,), (True, False))
    if flap:
        d.loft(
            [
                (0.5 * h, 0.4 * top * w, 0.02, 0.4, 0, -0.46 * dep),
                (0.97 * h, 0.47 * top * w, 0.018, 0.4, 0, -0.24 * dep),
            ],
            skin,
            16,
        )
        d.block((0, -0.55 * dep, 0.55 * h), (0.03, 0.012, 0.02), metal)
    else:
        d.tube([(-0.42 * top * w, 0, h), (0.42 * top * w, 0, h)], 0.006, metal, 6)
    high = v.between(0.07, 0.12)
    for y in (0.0,) if flap else (-0.25 * dep, 0.25 * dep):
        d.tube(
            [(0.28 * w * math.cos(a), y, 0.96 * h + high * math.sin(a)) for a in np.linspace(0, math.pi, 11)],
            0.007,
            skin,
            6,
        )


def wallet(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.1, 0.19), v.between(0.085, 0.1), v.between(0.016, 0.026)
    skin = v.pick((f.speckled((0.42, 0.26, 0.16), 0.05),), (p.leather(v), p.paint(v)))
    for k in range(2):
        d.soft_block((0, 0, (0.25 + 0.5 * k) * h), (w * (1 - 0.02 * k), dep, 0.52 * h), 0.2, skin, 6)
    d.block((0.1 * w, 0.48 * dep, 0.5 * h), (0.7 * w, 0.02, 0.002), Finish((0.55, 0.66, 0.5)))
    d.block((0.32 * w, -0.1 * dep, h), (0.05 * w, 0.3 * dep, 0.002), f.BRASS)


def umbrella(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.15, 0.24), v.between(0.022, 0.036)
    fabric, grip = p.cloth(v), v.pick((f.WALNUT,), (p.wood(v), p.paint(v, p.DARK)))
    d.tube(
        [(-0.6 * half, 0, r), (-0.45 * half, 0, r), (0.5 * half, 0, r), (0.85 * half, 0, r)],
        [0.5 * r, r, 0.75 * r, 0.2 * r],
        fabric,
        v.pick((10,), (8, 6)),
    )
    d.tube([(0.85 * half, 0, r), (half, 0, r)], 0.004, f.STEEL, 6)
    d.tube([(-0.1 * half, 0, r), (-0.02 * half, 0, r)], 1.02 * r, p.paint(v), 10)
    if v.pick((True,), (True, False)):
        d.tube(
            [
                (-0.6 * half, 0, r),
                (-0.9 * half, 0, r),
                (-half, 0.02, r),
                (-0.97 * half, 0.045, r),
                (-0.88 * half, 0.05, r),
            ],
            0.008,
            grip,
            7,
        )
    else:
        d.tube([(-0.6 * half, 0, r), (-half, 0, r)], 0.014, grip, 8)


FAMILIES = (
    Family("briefcase", "briefcase", briefcase, 110),
    Family("backpack", "backpack", backpack, 45),
    Family("handbag", "handbag", handbag, 80, train=0, test=3),
    Family("wallet", "wallet", wallet, 420, train=0, test=3),
    Family("umbrella", "umbrella", umbrella, 150, train=0, test=3),
)
