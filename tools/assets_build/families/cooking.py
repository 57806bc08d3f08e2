"""Families of kettles, pots and kitchen machines; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.families.vessels import handle, open_vessel
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def kettle(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.058, 0.068), v.between(0.15, 0.23)
    body, dark = v.pick((p.metal(v), p.paint(v), p.paint(v, p.PALE)), (p.paint(v), p.metal(v))), p.paint(v, p.DARK)
    profile = v.pick(
        (((1, 0), (1, 0.1), (0.75, 0.9), (0, 0.94)), ((1, 0), (1, 0.6), (0.6, 0.9), (0, 0.95))),
        (((0.9, 0), (1, 0.3), (0.85, 0.7), (0.45, 0.92), (0, 0.95)), ((1, 0), (0.95, 0.85), (0.8, 0.92), (0, 0.93))),
    )
    d.lathe([(0, 0), *((radius * r, h * z) for r, z in profile)], body)
    d.lathe([(1.02 * radius, 0), (1.02 * radius, 0.018), (0.98 * radius, 0.02)], dark)
    d.lathe([(0.014, 0.92 * h), (0.014, h + 0.01), (0, h + 0.012)], dark, segments=12)
    low = v.pick((0.62, 0.7), (0.4,))
    d.tube(
        [(-0.7 * radius, 0, low * h), (-1.15 * radius, 0, (low + 0.12) * h), (-1.4 * radius, 0, 0.9 * h)],
        [0.022, 0.014, 0.009],
        body,
        8,
    )
    if v.pick((True, True, False), (False, True)):
        handle(d, v.pick(("ear", "ring"), ("square",)), 0.75 * radius, 0.2 * h, 0.9 * h, 0.055, 0.009, dark)
    else:
        d.tube(
            [(0.8 * radius * math.cos(a), 0, 0.85 * h + 0.075 * math.sin(a)) for a in np.linspace(0, math.pi, 9)],
            0.007,
            dark,
            7,
        )


def pot(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.085, 0.125), v.between(0.075, 0.11)
    body = v.pick((p.metal(v), p.paint(v)), (p.paint(v), p.metal(v)))
    profile = v.pick(
        (((0.95, 0), (1, 0.1), (1, 1)), ((0.86, 0), (1, 1))),
        (((0.8, 0), (1, 0.35), (0.92, 1)), ((1, 0), (1.0, 0.15), (0.88, 1))),
    )
    grip = p.paint(v, p.DARK)
    lidded = v.pick((False, True, False), (True,))
    h -= 0.016 if lidded else 0.0
    open_vessel(d, profile, radius, h, 0.004, body, f.STEEL)
    top = profile[-1][0] * radius
    if lidded:
        d.lathe([(top + 0.002, h), (top + 0.002, h + 0.004), (0.5 * top, h + 0.018), (0, h + 0.022)], body)
        d.lathe([(0.007, h + 0.02), (0.018, h + 0.038), (0, h + 0.042)], grip, segments=12)
    if v.pick((True, True, False), (True, False)):
        reach = v.between(0.02, 0.035)
        for side in (-1, 1):
            d.tube(
                [
                    (side * (top - 0.005), -0.032, 0.8 * h),
                    (side * (top + reach), -0.028, 0.82 * h),
                    (side * (top + reach), 0.028, 0.82 * h),
                    (side * (top - 0.005), 0.032, 0.8 * h),
                ],
                0.006,
                grip,
                6,
            )
    else:
        d.tube(
            [(top - 0.005, 0, 0.8 * h), (top + 0.08, 0, 0.86 * h), (top + v.between(0.14, 0.18), 0, 0.9 * h)],
            [0.008, 0.008, 0.011],
            grip,
            8,
        )


def toaster(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.26, 0.34), v.between(0.115, 0.137), v.between(0.17, 0.21)
    body = v.pick((p.metal(v), p.paint(v), p.paint(v, p.PALE)), (p.paint(v), p.metal(v)))
    power = v.pick((0.3, 0.45), (0.18, 0.7))
    d.loft(
        [
            (0.012, 0.49 * w, 0.48 * dep, power, 0, 0),
            (0.7 * h, 0.5 * w, 0.5 * dep, power, 0, 0),
            (0.95 * h, 0.48 * w, 0.46 * dep, power, 0, 0),
            (h, 0.43 * w, 0.38 * dep, power, 0, 0),
        ],
        body,
    )
    d.loft([(0, 0.47 * w, 0.46 * dep, power, 0, 0), (0.02, 0.495 * w, 0.49 * dep, power, 0, 0)], f.BLACK)
    long_slot = v.pick((False, False), (True, False))
    for y in (0.0,) if long_slot else (-0.2 * dep, 0.2 * dep):
        d.block((0, y, h + 0.001), ((0.72 if long_slot else 0.6) * w, 0.024, 0.003), f.BLACK)
    d.block((0.5 * w + 0.008, 0, 0.6 * h), (0.02, 0.035, 0.012), f.BLACK)
    d.block((0.5 * w + 0.002, 0, 0.55 * h), (0.006, 0.008, 0.5 * h), f.BLACK)
    d.tube(
        [
            (0.49 * w, v.pick((-0.03, 0.03), (0.0,)), 0.22 * h),
            (0.5 * w + 0.014, v.pick((-0.03, 0.03), (0.0,)), 0.22 * h),
        ],
        0.014,
        p.metal(v),
        12,
    )


def blender(d: Drawing, v: Variation) -> None:
    r, base, jug = v.between(0.052, 0.062), v.between(0.1, 0.13), v.between(0.17, 0.22)
    body, glass, dark = v.pick((p.paint(v), p.metal(v)), (p.paint(v),)), p.paint(v, p.GLASSES), p.paint(v, p.DARK)
    power = v.pick((1.0, 0.5), (0.3, 0.8))
    d.loft(
        [
            (0, r, r, power, 0, 0),
            (0.4 * base, 0.95 * r, 0.95 * r, power, 0, 0),
            (base, 0.68 * r, 0.68 * r, power, 0, 0),
        ],
        body,
    )
    d.lathe([(0.6 * r, base), (0.62 * r, base + 0.02)], dark)
    top = v.pick((0.9, 1.0), (0.7,)) * r
    d.loft([(base + 0.01, 0.58 * r, 0.58 * r, power, 0, 0), (base + jug, top, top, power, 0, 0)], glass)
    d.loft([(base + jug, 1.03 * top, 1.03 * top, power, 0, 0), (base + jug + 0.018, top, top, power, 0, 0)], dark)
    d.lathe([(0.02, base + jug + 0.015), (0.018, base + jug + 0.035), (0, base + jug + 0.035)], dark, segments=12)
    handle(d, v.pick(("ear", "ring"), ("square",)), 0.8 * top, base + 0.25 * jug, base + 0.92 * jug, 0.045, 0.009, dark)
    d.tube([(0, -0.8 * r, 0.4 * base), (0, -r - 0.008, 0.38 * base)], 0.018, p.metal(v), 12)


def citrus_juicer(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.055, 0.07), v.between(0.06, 0.09)
    body, cone = p.paint(v), p.paint(v, p.PALE)
    d.lathe(
        [
            (0, 0),
            (0.75 * radius, 0),
            (radius, 0.45 * h),
            (0.92 * radius, 0.45 * h),
            (0.7 * radius, 0.3 * h),
            (0, 0.3 * h),
        ],
        body,
    )
    ribs = v.pick((8, 6), (10, 5))
    rings = []
    for t in np.linspace(0, 1, 6):
        rings.append((0.3 * h + 0.75 * h * t, 0.52 * radius * (1 - t**1.6) + 0.004))
    d.lathe([(r, z) for z, r in rings] + [(0, 1.06 * h)], cone, segments=ribs)
    for k in range(ribs):
        a = 2 * math.pi * k / ribs
        d.tube([((r + 0.001) * math.cos(a), (r + 0.001) * math.sin(a), z) for z, r in rings], 0.004, cone, 5)
    if v.pick((True, False), (True,)):
        handle(d, v.pick(("ring",), ("square",)), 0.9 * radius, 0.05 * h, 0.45 * h, 0.035, 0.006, body)
    d.tube([(-0.9 * radius, 0, 0.38 * h), (-1.2 * radius, 0, 0.45 * h)], [0.012, 0.006], body, 6)


def sandwich_maker(d: Drawing, v: Variation) -> None:
    w, dep = v.between(0.22, 0.28), v.between(0.2, 0.26)
    body, dark = v.pick((p.metal(v), p.paint(v), p.paint(v, p.PALE)), (p.paint(v), p.metal(v))), p.paint(v, p.DARK)
    h, power = v.between(0.08, 0.105), v.pick((0.3, 0.45), (0.7, 1.0))
    d.loft([(0, 0.46 * w, 0.46 * dep, power, 0, 0), (0.42 * h, 0.5 * w, 0.5 * dep, power, 0, 0)], dark)
    d.loft([(0.42 * h, 0.49 * w, 0.49 * dep, power, 0, 0), (0.5 * h, 0.49 * w, 0.49 * dep, power, 0, 0)], f.STEEL)
    d.loft(
        [
            (0.5 * h, 0.5 * w, 0.5 * dep, power, 0, 0),
            (0.85 * h, 0.46 * w, 0.46 * dep, power, 0, 0),
            (h, 0.35 * w, 0.36 * dep, power, 0, 0),
        ],
        body,
    )
    d.tube(
        [
            (-0.2 * w, -0.48 * dep, 0.6 * h),
            (-0.18 * w, -0.5 * dep - 0.035, 0.6 * h),
            (0.18 * w, -0.5 * dep - 0.035, 0.6 * h),
            (0.2 * w, -0.48 * dep, 0.6 * h),
        ],
        0.009,
        dark,
        6,
    )
    for x, light in ((-0.03, (0.8, 0.1, 0.1)), (0.03, (0.1, 0.6, 0.2))):
        d.block((x, 0.1 * dep, h - 0.002), (0.012, 0.012, 0.008), p.Finish(light))


def scale(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.17, 0.3), v.between(0.2, 0.28), v.between(0.02, 0.035)
    top = v.pick((p.paint(v, p.GLASSES), p.paint(v, p.PALE), p.paint(v, p.DARK)), (p.paint(v), p.wood(v)))
    power = v.pick((0.2, 0.35), (1.0, 0.6))
    d.loft(
        [
            (0, 0.46 * w, 0.46 * dep, power, 0, 0),
            (0.6 * h, 0.5 * w, 0.5 * dep, power, 0, 0),
            (h, 0.5 * w, 0.5 * dep, power, 0, 0),
        ],
        top,
    )
    d.block((0, 0.32 * dep, h), (0.09, 0.036, 0.004), f.BLACK)
    d.block((0, 0.32 * dep, h + 0.0016), (0.07, 0.024, 0.002), p.Finish((0.62, 0.75, 0.6)))
    if v.pick((True, False), (True,)):
        for x in (-0.25 * w, 0.25 * w):
            d.soft_block((x, -0.1 * dep, h), (0.06, 0.5 * dep, 0.004), 0.6, f.GRAPHITE, 6)


def moka_pot(d: Drawing, v: Variation) -> None:
    r, h = v.between(0.042, 0.052), v.between(0.16, 0.22)
    metal, dark = v.pick((f.STEEL,), (p.metal(v), p.paint(v))), p.paint(v, p.DARK)
    d.lathe([(0, 0), (r, 0), (0.8 * r, 0.42 * h), (0.7 * r, 0.5 * h)], metal, segments=8)
    d.lathe([(0.78 * r, 0.47 * h), (0.78 * r, 0.54 * h)], dark, segments=8)
    d.lathe([(0.7 * r, 0.52 * h), (0.95 * r, 0.9 * h), (0.6 * r, 0.95 * h), (0, 0.97 * h)], metal, segments=8)
    d.lathe([(0.008, 0.96 * h), (0.012, h), (0, h + 0.004)], dark, segments=8)
    d.tube([(-0.75 * r, 0, 0.75 * h), (-1.25 * r, 0, 0.9 * h)], [0.014, 0.005], metal, 6)
    handle(d, "ear", 0.8 * r, 0.5 * h, 0.88 * h, 0.045, 0.008, dark)


def coffee_press(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.042, 0.052), v.between(0.15, 0.2)
    frame, glass = p.metal(v), p.paint(v, p.GLASSES)
    open_vessel(d, ((1, 0), (1, 1)), radius, h, 0.003, glass, glass)
    d.lathe([(radius + 0.0008, 0.01), (radius + 0.0008, v.between(0.3, 0.6) * h)], Finish((0.24, 0.15, 0.09)))
    for z in (0.0, 0.75 * h):
        d.lathe([(radius + 0.002, z), (radius + 0.002, z + 0.012)], frame)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        x, y = (radius + 0.003) * math.cos(a), (radius + 0.003) * math.sin(a)
        d.tube([(x, y, 0), (x, y, 0.8 * h)], 0.003, frame, 5)
    d.lathe([(radius + 0.003, h), (v.pick((0.6, 0.8), (0.3,)) * radius, h + 0.018), (0, h + 0.02)], frame)
    d.tube([(0, 0, h), (0, 0, h + 0.045)], 0.003, frame, 6)
    d.soft_block((0, 0, h + 0.052), (0.022, 0.022, 0.02), 1.0, f.BLACK, 6)
    handle(d, v.pick(("ring", "ear"), ("square",)), radius, 0.1 * h, 0.9 * h, 0.05, 0.008, p.paint(v, p.DARK))


FAMILIES = (
    Family("kettle", "kettle", kettle, 230),
    Family("pot", "cooking pot", pot, 230, collision="hull"),
    Family("toaster", "toaster", toaster, 270),
    Family("blender", "blender", blender, 230),
    Family("citrus_juicer", "citrus juicer", citrus_juicer, 350),
    Family("sandwich_maker", "sandwich maker", sandwich_maker, 330),
    Family("scale", "scale", scale, 620),
    Family("moka_pot", "moka pot", moka_pot, 450, train=0, test=3),
    Family("coffee_press", "coffee press", coffee_press, 260),
)
