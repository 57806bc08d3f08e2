"""Families of bread, cakes and dishes; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.families.prints import UNIT, front
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def bread(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.2, 0.3), v.between(0.1, 0.13), v.between(0.08, 0.12)
    crust = f.speckled(
        v.pick(((0.66, 0.42, 0.2), (0.52, 0.32, 0.17), (0.78, 0.56, 0.3)), ((0.4, 0.25, 0.15), (0.84, 0.66, 0.4))),
        0.06,
        1 + v.seed() % 97,
    )
    kind = v.pick(("loaf", "tin", "round"), ("baguette", "sliced"))
    if kind == "baguette":
        d.soft_block((0, 0, 0.035), (0.45, 0.075, 0.07), 0.9, crust, 10)
        for k in range(6):
            d.soft_block((-0.17 + 0.068 * k, 0, 0.067), (0.012, 0.055, 0.01), 0.8, f.CREAM, 5)
        return
    if kind == "round":
        d.soft_block((0, 0, 0.05), (0.2, 0.19, 0.1), 0.95, crust, 10)
        for turn in (0.0, 90.0):
            part = Drawing()
            part.soft_block((0, 0, 0.0), (0.12, 0.012, 0.014), 0.8, f.CREAM, 5)
            d.place(part, (0, 0, 0.096), (0, 0, turn + 20))
        return
    rings = [
        (0, 0.48 * w, 0.42 * dep),
        (0.55 * h, 0.5 * w, 0.44 * dep),
        (0.75 * h, 0.52 * w, 0.5 * dep),
        (h, 0.44 * w, 0.34 * dep),
    ]
    d.loft([(z, x, y, 0.4 if kind != "loaf" else 0.75, 0, 0) for z, x, y in rings], crust)
    if kind == "sliced":
        for k in range(7):
            d.block((0.1 * w + 0.055 * w * k, 0, 0.53 * h), (0.004, 0.9 * dep, 0.96 * h), f.CREAM)
    else:
        for k in range(3):
            d.soft_block((-0.25 * w + 0.25 * w * k, 0, 0.99 * h), (0.014, 0.6 * dep, 0.012), 0.8, f.CREAM, 5)


def butter(d: Drawing, v: Variation) -> None:
    w, dep = v.between(0.12, 0.17), v.between(0.08, 0.105)
    dish = p.paint(v, p.PALE)
    power = v.pick((0.3, 0.5), (1.0, 0.2))
    d.loft(
        [
            (0, 0.42 * w, 0.42 * dep, power, 0, 0),
            (0.012, 0.5 * w, 0.5 * dep, power, 0, 0),
            (0.016, 0.5 * w, 0.5 * dep, power, 0, 0),
            (0.01, 0.42 * w, 0.4 * dep, power, 0, 0),
        ],
        dish,
    )
    yellow = Finish(v.pick(((0.96, 0.85, 0.45), (0.95, 0.88, 0.58)), ((0.98, 0.9, 0.5),)))
    long = v.pick((0.6, 0.5), (0.35, 0.68)) * w
    d.block((0, 0, 0.012 + 0.022), (long, 0.5 * dep, 0.044), yellow)
    d.block((long / 2 + 0.012, 0, 0.016), (0.012, 0.48 * dep, 0.01), yellow)
    if v.pick((True, False), (False, True)):
        d.block((-0.2 * long, 0, 0.034), (0.58 * long, 0.5 * dep + 0.002, 0.046), p.label(v))


def cake(d: Drawing, v: Variation) -> None:
    r, h = v.between(0.08, 0.115), v.between(0.05, 0.075)
    plate, crumb, cream = (
        p.paint(v, p.PALE),
        Finish(v.pick(((0.45, 0.28, 0.16), (0.86, 0.68, 0.42)), ((0.6, 0.14, 0.16),))),
        Finish(
            v.pick(((0.96, 0.92, 0.86), (0.94, 0.7, 0.74), (0.34, 0.2, 0.13)), ((0.75, 0.88, 0.74), (0.74, 0.68, 0.88)))
        ),
    )
    segments = v.pick((28, 28), (4, 28))
    d.lathe([(0, 0), (1.25 * r, 0), (1.32 * r, 0.008), (0, 0.008)], plate, segments=28)
    d.lathe([(r, 0.008), (r, 0.45 * h)], crumb, segments=segments)
    d.lathe([(r + 0.002, 0.42 * h), (r + 0.002, 0.55 * h)], cream, segments=segments)
    d.lathe([(r, 0.55 * h), (r, 0.9 * h)], crumb, segments=segments)
    d.lathe([(r + 0.003, 0.86 * h), (r + 0.003, h), (0, h + 0.004)], cream, segments=segments)
    count = v.pick((8, 6, 0), (5, 10))
    for k in range(count):
        a = 2 * math.pi * k / count
        x, y = 0.75 * r * math.cos(a), 0.75 * r * math.sin(a)
        d.soft_block((x, y, h + 0.008), (0.024, 0.024, 0.02), 1.0, Finish((0.75, 0.1, 0.14)), 5)
    for k in range(v.pick((0, 3, 5), (1, 4))):
        a = 1.3 * k
        at = (0.3 * r * math.cos(a), 0.3 * r * math.sin(a))
        d.tube([(*at, h), (*at, h + 0.05)], 0.003, p.paint(v), 6)
        d.soft_block((*at, h + 0.056), (0.006, 0.006, 0.012), 1.0, Finish((0.98, 0.8, 0.25)), 5)


def cupcake(d: Drawing, v: Variation) -> None:
    r = v.between(0.028, 0.036)
    d.lathe([(0, 0), (0.72 * r, 0), (r, 0.045), (0, 0.045)], p.paint(v), segments=12)
    cream = Finish(v.pick(((1, 1, 1),), ((0.94, 0.7, 0.74), (0.96, 0.92, 0.86), (0.34, 0.2, 0.13))))
    for k in range(4):
        d.soft_block(
            (0, 0, 0.048 + 0.011 * k), (2.1 * r * (1 - 0.24 * k), 2.1 * r * (1 - 0.24 * k), 0.02), 0.9, cream, 8
        )
    d.soft_block((0, 0, 0.094), (0.016, 0.016, 0.016), 1.0, Finish((0.75, 0.1, 0.14)), 6)


def hamburger(d: Drawing, v: Variation) -> None:
    r = v.between(0.048, 0.06)
    bun = f.speckled(v.pick(((0.8, 0.52, 0.24),), ((0.8, 0.52, 0.24), (0.7, 0.42, 0.2), (0.86, 0.64, 0.36))), 0.03, 7)
    z = 0.0
    for wide, thick, finish, sides in (
        (1.0, 0.018, bun, 24),
        (1.02, 0.014, Finish((0.36, 0.2, 0.12)), 24),
        (1.08, 0.005, Finish((0.96, 0.74, 0.2)), 4),
        (1.1, 0.008, Finish((0.42, 0.65, 0.24)), 11),
        (0.98, 0.007, Finish((0.82, 0.2, 0.14)), 24),
    ):
        d.lathe([(0, z), (wide * r, z), (wide * r, z + thick), (0, z + thick)], finish, segments=sides)
        z += thick
    top = v.between(0.025, 0.04)
    d.lathe(
        [
            (0, z),
            (1.02 * r, z),
            *((1.02 * r * math.cos(a), z + 0.006 + top * math.sin(a)) for a in np.linspace(0, math.pi / 2, 6)),
        ],
        bun,
    )
    for k in range(14):
        a, s = 2.4 * k, 0.16 + 0.05 * (k % 12)
        d.soft_block(
            (s * r * math.cos(a), s * r * math.sin(a), z + 0.006 + top * math.sqrt(1 - s * s)),
            (0.006, 0.003, 0.003),
            1.0,
            f.CREAM,
            4,
        )


def hot_dog(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.065, 0.09), v.between(0.018, 0.024)
    bun = f.speckled(v.pick(((0.84, 0.62, 0.34), (0.74, 0.48, 0.24)), ((0.62, 0.4, 0.22), (0.9, 0.74, 0.5))), 0.03, 7)
    for side in (-1, 1):
        d.soft_block((0, side * 0.8 * r, 0.9 * r), (2 * half, 1.5 * r, 1.9 * r), 0.7, bun, 7)
    stick = v.between(1.0, 1.18) * half
    d.tube(
        [(-stick, 0, 1.5 * r), (-0.94 * stick, 0, 1.5 * r), (0.94 * stick, 0, 1.5 * r), (stick, 0, 1.5 * r)],
        [0.4 * r, 0.75 * r, 0.75 * r, 0.4 * r],
        Finish(v.pick(((0.62, 0.24, 0.14), (0.72, 0.34, 0.2)), ((0.5, 0.18, 0.14),))),
        9,
    )
    sauce = Finish(v.pick(((0.93, 0.76, 0.15), (0.75, 0.1, 0.08)), ((0.93, 0.9, 0.8), (0.5, 0.6, 0.2))))
    waves = v.pick((3, 4), (2, 6))
    d.tube(
        [(x * half * 0.9, 0.3 * r * math.sin(waves * math.pi * x), 2.28 * r) for x in np.linspace(-1, 1, 19)],
        0.0035,
        sauce,
        5,
    )


def french_fries(d: Drawing, v: Variation) -> None:
    w, h = v.between(0.075, 0.105), v.between(0.08, 0.11)
    box = p.paint(v)
    d.loft(
        [
            (0, 0.34 * w, 0.018, 0.4, 0, 0),
            (h, 0.5 * w, 0.028, 0.4, 0, 0),
            (h, 0.47 * w, 0.025, 0.4, 0, 0),
            (0.6 * h, 0.4 * w, 0.02, 0.4, 0, 0),
        ],
        box,
    )
    d.add(front(0.3 * w, 0.2 * h, 0.7 * h, 0.0285), p.label(v), UNIT)
    fry = Finish(v.pick(((0.93, 0.78, 0.35), (0.88, 0.68, 0.28)), ((0.96, 0.84, 0.45),)))
    thick, count = v.pick((0.008, 0.01), (0.013, 0.006)), v.pick((14, 18), (10, 24))
    for k in range(count):
        x = (k / (count - 1) - 0.5) * 0.8 * w
        y = 0.012 * (k % 3 - 1)
        top = h * (1.15 + 0.1 * ((7 * k) % 5))
        part = Drawing()
        part.block((0, 0, 0), (thick, thick, top - 0.3 * h), fry)
        d.place(part, (1.15 * x, y, (top + 0.3 * h) / 2), (0, 0.3 * math.degrees(math.atan2(x, h)), 0))


def roasted_chicken(d: Drawing, v: Variation) -> None:
    size = v.between(0.85, 1.2)
    skin = f.speckled(v.pick(((0.68, 0.38, 0.15), (0.58, 0.3, 0.12)), ((0.76, 0.48, 0.2), (0.46, 0.24, 0.12))), 0.08, 9)
    plate = p.paint(v, p.PALE)
    d.loft(
        [
            (0, 0.11 * size, 0.085 * size, 1, 0, 0),
            (0.012, 0.145 * size, 0.115 * size, 1, 0, 0),
            (0.016, 0.145 * size, 0.115 * size, 1, 0, 0),
            (0.008, 0.11 * size, 0.08 * size, 1, 0, 0),
        ],
        plate,
        28,
    )
    d.soft_block((0, 0, 0.055 * size), (0.17 * size, 0.125 * size, 0.095 * size), 0.9, skin, 9)
    d.soft_block((-0.035 * size, 0, 0.075 * size), (0.09 * size, 0.1 * size, 0.07 * size), 1.0, skin, 7)
    out = v.pick((0.02, 0.035), (0.05,))
    for side in (-1, 1):
        d.tube(
            [
                (0.02 * size, side * 0.05 * size, 0.05 * size),
                (0.075 * size, side * (0.035 + out) * size, 0.075 * size),
                (0.115 * size, side * (0.03 + out) * size, 0.085 * size),
            ],
            [0.03 * size, 0.022 * size, 0.008 * size],
            skin,
            8,
        )
        d.soft_block((0.122 * size, side * (0.03 + out) * size, 0.087 * size), (0.02, 0.016, 0.016), 1.0, f.CREAM, 5)
        d.tube(
            [(-0.05 * size, side * 0.055 * size, 0.06 * size), (-0.01, side * 0.075 * size, 0.045 * size)],
            [0.016, 0.01],
            skin,
            6,
        )
    for k in range(v.pick((4, 0), (6, 3))):
        a = 2.1 * k + 0.5
        d.soft_block(
            (0.115 * size * math.cos(a), 0.09 * size * math.sin(a), 0.022),
            (0.028, 0.028, 0.024),
            1.0,
            Finish(v.pick(((0.85, 0.62, 0.25),), ((0.4, 0.55, 0.2),))),
            5,
        )


def steak(d: Drawing, v: Variation) -> None:
    w = v.between(0.13, 0.17)
    outline = [
        (w / 2 * math.cos(a) * (1 + 0.16 * math.sin(2 * a + 0.6)), 0.34 * w * math.sin(a) * (1 + 0.22 * math.cos(a)))
        for a in np.linspace(0, 2 * math.pi, 19)[:-1]
    ]
    meat = f.speckled(v.pick(((0.5, 0.2, 0.14),), ((0.42, 0.2, 0.13), (0.62, 0.16, 0.16), (0.35, 0.18, 0.1))), 0.14, 11)
    d.prism([(1.04 * x, 1.06 * y) for x, y in outline], 0, 0.02, Finish((0.9, 0.84, 0.72)))
    d.prism(outline, 0.002, 0.024, meat)
    d.soft_block((-0.18 * w, 0.02, 0.024), (0.03, 0.014, 0.005), 0.8, f.CREAM, 5)
    for k in range(4):
        d.block((w * (-0.24 + 0.15 * k), 0, 0.0245), (0.006, 0.4 * w, 0.0016), Finish((0.2, 0.1, 0.07)))


FAMILIES = (
    Family("bread", "bread", bread, 190),
    Family("butter", "butter", butter, 420),
    Family("cake", "cake", cake, 190),
    Family("cupcake", "cupcake", cupcake, 260, train=0, test=3),
    Family("hamburger", "hamburger", hamburger, 330, train=0, test=3),
    Family("hot_dog", "hot dog", hot_dog, 330),
    Family("french_fries", "french fries", french_fries, 170),
    Family("roasted_chicken", "roasted chicken", roasted_chicken, 280),
    Family("steak", "steak", steak, 500, train=0, test=3),
)
