"""Families of hand tools; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def pliers(d: Drawing, v: Variation) -> None:
    half, spread = v.between(0.075, 0.105), v.between(0.018, 0.03)
    grip, steel = p.paint(v), p.metal(v)
    kind = v.pick(("flat", "needle"), ("cutter", "wide"))
    jaw = {"flat": 0.45, "needle": 0.75, "cutter": 0.3, "wide": 0.55}[kind] * half
    tip = {"flat": 0.008, "needle": 0.003, "cutter": 0.014, "wide": 0.012}[kind]
    for side in (-1, 1):
        d.tube(
            [(side * -0.004, 0.02, 0.008), (side * spread, -0.25 * half, 0.008), (side * 0.95 * spread, -half, 0.008)],
            [0.006, 0.0075, 0.0065],
            grip,
            7,
        )
        outline = [(0.0008, 0), (0.013, 0.0), (0.012, 0.5 * jaw), (tip, jaw), (0.0008, jaw)]
        d.prism([(side * x, y + 0.012) for x, y in (outline if side > 0 else outline[::-1])], 0.003, 0.014, steel)
    d.lathe([(0.013, 0.002), (0.013, 0.0155), (0, 0.0155)], steel, (0.0, 0.01), 14)
    d.lathe([(0.005, 0.0155), (0.004, 0.018), (0, 0.018)], f.DARK_STEEL, (0.0, 0.01), 10)


def scissors(d: Drawing, v: Variation) -> None:
    half, opened = v.between(0.075, 0.11), v.between(5.0, 16.0)
    steel, grip = f.STEEL, p.paint(v)
    wide, power = v.between(0.017, 0.024), v.pick((1.0, 0.8), (0.5, 1.0))
    for side in (-1, 1):
        part = Drawing()
        blade = [(-0.004, -0.02), (0.006, -0.02), (0.008, 0.2 * half), (0.0005, half), (-0.004, 0.3 * half)]
        part.prism(
            [(side * x, y) for x, y in (blade if side > 0 else blade[::-1])],
            0.004 + 0.002 * (side > 0),
            0.006 + 0.002 * (side > 0),
            steel,
        )
        long = v.pick((1.3, 1.5), (2.1, 1.1))
        ring = [
            (
                -side * (wide + 0.004) + wide * math.copysign(abs(math.cos(a)) ** power, math.cos(a)),
                -0.55 * half - 0.012 + long * wide * math.copysign(abs(math.sin(a)) ** power, math.sin(a)),
                0.006,
            )
            for a in np.linspace(0, 2 * math.pi, 15)
        ]
        part.tube(ring, 0.0052, grip, 6)
        part.tube([(0, -0.015, 0.006), (-side * 0.6 * wide, -0.55 * half + 0.004, 0.006)], 0.0055, grip, 6)
        d.place(part, turn=(0, 0, side * opened))
    d.lathe([(0.006, 0.003), (0.006, 0.0095), (0, 0.0095)], f.DARK_STEEL, segments=10)


def saw(d: Drawing, v: Variation) -> None:
    blade, high = v.between(0.25, 0.35), v.between(0.075, 0.12)
    steel, grip = f.STEEL, v.pick((p.wood(v), p.paint(v)), (p.paint(v), p.wood(v)))
    kind = v.pick(("hand", "hand"), ("bow", "tenon"))
    part = Drawing()
    if kind == "bow":
        arch = [
            (-blade / 2, 0.0, 0.01),
            (-blade / 2, 0.0, high),
            (-0.3 * blade, 0, 1.2 * high),
            (0.3 * blade, 0, 1.2 * high),
            (blade / 2, 0, high),
            (blade / 2, 0, 0.01),
        ]
        part.tube(arch, 0.008, grip, 7)
        part.box((-blade / 2, -0.001, 0), (blade / 2, 0.001, 0.016), steel)
        count = int(blade / 0.012)
        for k in range(count):
            x = -blade / 2 + blade * k / count
            part.prism([(x, -0.008), (x + 0.011, -0.0005), (x, -0.0005)], -0.001, 0.001, steel)
        d.place(part, (0, 0, 0.009), (90, 0, 0))
        return
    front = 0.45 * high if kind == "hand" else high
    count = int(blade / 0.013)
    teeth = [
        (blade * k / count + (0.0065 if half else 0.0), -0.006 if half else 0.0)
        for k in range(count)
        for half in (0, 1)
    ]
    part.prism([*teeth, (blade, 0), (blade, front), (0, high)], 0.008, 0.0095, steel)
    if kind == "tenon":
        part.box((0, high - 0.008, 0.006), (blade, high + 0.006, 0.0115), f.BRASS)
    part.loft(
        [(0, 0.02, 0.52 * high, 0.6, -0.012, 0.5 * high), (0.018, 0.02, 0.52 * high, 0.6, -0.012, 0.5 * high)], grip, 14
    )
    part.tube(
        [
            (-0.02, 0.95 * high, 0.009),
            (-0.07, 0.85 * high, 0.009),
            (-0.085, 0.5 * high, 0.009),
            (-0.07, 0.15 * high, 0.009),
            (-0.02, 0.05 * high, 0.009),
        ],
        0.0095,
        grip,
        7,
    )
    d.place(part)


def drill(d: Drawing, v: Variation) -> None:
    length, h = v.between(0.15, 0.2), v.between(0.17, 0.21)
    body, dark = p.paint(v), f.BLACK
    r = v.between(0.026, 0.033)
    z = h - r
    d.tube(
        [(-0.45 * length, 0, z), (-0.4 * length, 0, z), (0.25 * length, 0, z), (0.35 * length, 0, z)],
        [0.7 * r, r, r, 0.7 * r],
        body,
        12,
    )
    d.tube(
        [(0.35 * length, 0, z), (0.45 * length, 0, z), (0.62 * length, 0, z)], [0.7 * r, 0.65 * r, 0.35 * r], dark, 10
    )
    d.tube([(0.6 * length, 0, z), (0.62 * length + v.between(0.05, 0.08), 0, z)], 0.0035, f.STEEL, 6)
    lean = v.pick((0.02, 0.035), (0.0, 0.05))
    d.loft([(0.04, 0.022, 0.015, 0.7, -0.1 * length - lean, 0), (z, 0.026, 0.018, 0.7, -0.1 * length, 0)], body, 12)
    d.block((0.06 * length, 0, z - r - 0.012), (0.012, 0.014, 0.03), dark)
    battery = v.pick((0.045, 0.055), (0.03, 0.07))
    d.loft(
        [(0, 0.06, 0.034, 0.3, -0.02 * length - lean, 0), (battery, 0.06, 0.034, 0.3, -0.02 * length - lean, 0)],
        dark if v.pick((True, False), (True,)) else p.paint(v),
        12,
    )
    d.block((-0.42 * length, 0, z), (0.01, 1.5 * r, 0.9 * r), dark)


def hammer(d: Drawing, v: Variation) -> None:
    half = v.between(0.13, 0.17)
    grip, steel = v.pick((f.OAK,), (p.wood(v), p.paint(v))), v.pick((f.STEEL,), (f.DARK_STEEL, f.STEEL))
    kind = v.pick(("claw",), ("claw", "ball", "mallet"))
    d.tube([(0, -half, 0.017), (0, -0.4 * half, 0.017), (0, 0.75 * half, 0.017)], [0.016, 0.014, 0.01], grip, 8)
    y = 0.8 * half
    if kind == "mallet":
        d.tube([(-0.055, y, 0.03), (0.055, y, 0.03)], 0.03, p.paint(v, p.DARK), 14)
        return
    d.box((-0.02, y - 0.014, 0.005), (0.03, y + 0.014, 0.031), steel)
    d.tube(
        [(0.03, y, 0.018), (0.05, y, 0.018), (0.052, y, 0.018), (0.06, y, 0.018)], [0.01, 0.01, 0.016, 0.016], steel, 12
    )
    if kind == "ball":
        d.soft_block((-0.035, y, 0.018), (0.032, 0.032, 0.032), 1.0, steel, 8)
    else:
        for side in (-1, 1):
            d.tube(
                [
                    (-0.015, y + side * 0.006, 0.02),
                    (-0.045, y + side * 0.008, 0.019),
                    (-0.07, y - 0.02 + side * 0.012, 0.012),
                ],
                [0.009, 0.007, 0.003],
                steel,
                6,
            )


def screwdriver(d: Drawing, v: Variation) -> None:
    half = v.between(0.085, 0.125)
    grip = v.pick((f.RED,), (p.paint(v), p.wood(v)))
    r = v.between(0.012, 0.018)
    sides = v.pick((6,), (6, 8, 10))
    waist = v.pick((0.7,), (0.75, 1.1, 0.55))
    d.tube(
        [(-half, 0, r), (-0.95 * half, 0, r), (-0.5 * half, 0, r), (-0.2 * half, 0, r), (-0.1 * half, 0, r)],
        [0.7 * r, r, r, waist * r, 0.8 * r],
        grip,
        sides,
    )
    d.tube([(-0.1 * half, 0, r), (0.9 * half, 0, r), (half, 0, r)], [0.0038, 0.0038, 0.002], f.STEEL, 8)
    d.tube([(-0.98 * half, 0, r), (-0.9 * half, 0, r)], 1.02 * r, p.paint(v, p.DARK), sides)


def flashlight(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.07, 0.11), v.between(0.014, 0.02)
    body = v.pick((f.BLACK,), (p.paint(v), p.metal(v), p.paint(v, p.DARK)))
    wide = v.pick((1.4,), (1.7, 1.3, 2.0)) * r
    d.tube(
        [(-half, 0, wide), (0.35 * half, 0, wide), (0.6 * half, 0, wide), (half, 0, wide)], [r, r, wide, wide], body, 12
    )
    d.tube([(half - 0.001, 0, wide), (half + 0.001, 0, wide)], 0.85 * wide, Finish((0.95, 0.93, 0.75)), 12)
    for k in range(3):
        d.tube([((-0.8 + 0.2 * k) * half, 0, wide), ((-0.72 + 0.2 * k) * half, 0, wide)], 1.06 * r, f.DARK_STEEL, 12)
    d.block((0.1 * half, 0, wide + r), (0.022, 0.01, 0.007), p.paint(v))


FAMILIES = (
    Family("pliers", "pliers", pliers, 900),
    Family("scissors", "scissors", scissors, 650),
    Family("saw", "saw", saw, 550),
    Family("drill", "drill", drill, 480),
    Family("hammer", "hammer", hammer, 700, train=0, test=3),
    Family("screwdriver", "screwdriver", screwdriver, 700, train=0, test=3),
    Family("flashlight", "torch", flashlight, 500, train=0, test=3),
)
