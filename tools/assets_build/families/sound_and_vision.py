"""Families of loudspeakers, radios, clocks and cameras; sizes in m."""

import math

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def speaker(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.1, 0.138), v.between(0.1, 0.138), v.between(0.14, 0.26)
    body = v.pick((p.wood(v), p.paint(v, p.DARK), p.paint(v)), (p.paint(v), p.wood(v), p.cloth(v)))
    kind = v.pick(("box", "box"), ("tower", "round"))
    if kind == "round":
        d.lathe([(0, 0), (0.5 * w, 0), (0.5 * w, 0.7 * h), (0.44 * w, 0.78 * h), (0, 0.78 * h)], body)
        d.lathe([(0.505 * w, 0.08 * h), (0.505 * w, 0.6 * h)], f.DARK_STEEL)
        d.lathe([(0.3 * w, 0.78 * h), (0.3 * w, 0.79 * h), (0, 0.79 * h)], f.STEEL)
        return
    d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, h), body)
    d.box((-0.46 * w, -dep / 2 - 0.003, 0.03 * h), (0.46 * w, -dep / 2, 0.97 * h), f.BLACK)
    cones = ((0.3, 0.36), (0.76, 0.17)) if kind == "box" else ((0.2, 0.22), (0.5, 0.22), (0.8, 0.14))
    for at, size in cones:
        y = -dep / 2 - 0.003
        d.tube([(0, y, at * h), (0, y - 0.005, at * h)], size * w, f.GREY_PAINT, 18)
        d.tube([(0, y - 0.005, at * h), (0, y - 0.008, at * h)], 0.82 * size * w, f.DARK_STEEL, 18)
        d.tube([(0, y - 0.008, at * h), (0, y - 0.012, at * h)], 0.3 * size * w, f.STEEL, 12)


def radio(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.2, 0.32), v.between(0.07, 0.11), v.between(0.12, 0.19)
    body = v.pick((p.wood(v), p.paint(v), p.paint(v, p.DARK)), (p.paint(v), p.leather(v), p.wood(v)))
    power = v.pick((0.12, 0.3), (0.5, 0.2))
    part = Drawing()
    part.loft([(-dep / 2, w / 2, h / 2, power, 0, 0), (dep / 2, w / 2, h / 2, power, 0, 0)], body)
    d.place(part, (0, 0, h / 2), (90, 0, 0))
    side = v.pick((-1, 1), (0,))
    y = -dep / 2
    d.block((side * 0.2 * w, y - 0.001, 0.45 * h), (0.46 * w, 0.005, 0.6 * h), f.CREAM)
    for k in range(6):
        d.block((side * 0.2 * w, y - 0.004, (0.2 + 0.1 * k) * h), (0.44 * w, 0.004, 0.02 * h), f.DARK_STEEL)
    at = -side * 0.28 * w if side else 0.36 * w
    d.tube([(at, y, 0.35 * h), (at, y - 0.015, 0.35 * h)], 0.13 * h, f.STEEL, 14)
    d.block((at, y - 0.002, 0.72 * h), (0.24 * w if side else 0.16 * w, 0.006, 0.16 * h), Finish((0.9, 0.78, 0.5)))
    if v.pick((True, True, False), (True,)):
        d.tube([(0.4 * w, 0.3 * dep, 0.96 * h), (0.3 * w, 0.3 * dep, 1.75 * h)], 0.003, f.STEEL, 5)
    if v.pick((False, True), (True, False)):
        d.tube(
            [(-0.36 * w, 0, 0.98 * h), (-0.34 * w, 0, 1.2 * h), (0.34 * w, 0, 1.2 * h), (0.36 * w, 0, 0.98 * h)],
            0.007,
            f.DARK_STEEL,
            6,
        )


def clock(d: Drawing, v: Variation) -> None:
    r, dep = v.between(0.045, 0.075), v.between(0.03, 0.05)
    body, face = v.pick((p.metal(v), p.paint(v), p.wood(v)), (p.paint(v), p.metal(v))), p.paint(v, p.PALE)
    sides = v.pick((20, 20, 4), (8, 6))
    middle = r + 0.012
    part = Drawing()
    part.lathe(
        [(0, -dep / 2), (r, -dep / 2), (r, dep / 2), (0.9 * r, dep / 2), (0.9 * r, dep / 2 - 0.004)],
        body,
        segments=sides,
    )
    part.lathe([(0.9 * r, dep / 2 - 0.003), (0, dep / 2 - 0.003)], face, segments=sides)
    part.turn(45 if sides == 4 else 22.5 if sides == 8 else 0)
    part.block((0, 0.28 * r, dep / 2), (0.06 * r, 0.6 * r, 0.002), f.BLACK)
    part.block((0.2 * r, 0, dep / 2), (0.45 * r, 0.06 * r, 0.002), f.BLACK)
    for k in range(12):
        a = math.pi * k / 6
        part.block(
            (0.76 * r * math.cos(a), 0.76 * r * math.sin(a), dep / 2 - 0.002), (0.07 * r, 0.07 * r, 0.002), f.BLACK
        )
    d.place(part, (0, 0, middle * (0.74 if sides == 4 else 1.0)), (90, 0, 0))
    low = 0.62 * r
    for side in (-1, 1):
        d.tube([(side * low, 0, 0), (side * 0.5 * r, 0, 0.5 * r)], 0.006, body, 6)
    if v.pick((True, False), (True, False)):
        for side in (-1, 1):
            d.soft_block((side * 0.55 * r, 0, middle + 0.95 * r), (0.62 * r, 0.62 * r, 0.4 * r), 0.9, f.BRASS, 7)
        d.tube(
            [(-0.3 * r, 0, middle + 1.05 * r), (0, 0, middle + 1.45 * r), (0.3 * r, 0, middle + 1.05 * r)],
            0.004,
            f.BRASS,
            6,
        )


def camera(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.11, 0.14), v.between(0.035, 0.055), v.between(0.07, 0.09)
    body, trim = (
        v.pick((f.BLACK,), (p.paint(v, p.DARK), p.leather(v), f.BLACK)),
        v.pick((f.STEEL,), (f.STEEL, p.metal(v))),
    )
    d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, 0.72 * h), body)
    d.box((-w / 2, -dep / 2, 0.72 * h), (w / 2, dep / 2, 0.84 * h), trim)
    d.box((-0.16 * w, -dep / 2, 0.84 * h), (0.16 * w, 0.4 * dep, h), trim)
    r = 0.4 * h
    for out, size, finish in ((0.5, 1.0, body), (0.9, 0.9, trim), (1.0, 0.7, f.BLACK)):
        d.tube([(0, -dep / 2, 0.42 * h), (0, -dep / 2 - out * 0.045, 0.42 * h)], size * r, finish, 18)
    d.lathe([(0.011, 0.84 * h), (0.011, 0.92 * h), (0, 0.92 * h)], f.BLACK, (0.34 * w, 0.0), 12)
    d.block((-0.36 * w, -dep / 2 - 0.002, 0.66 * h), (0.03, 0.006, 0.014), Finish((0.7, 0.85, 0.9)))


FAMILIES = (
    Family("speaker", "speaker", speaker, 550),
    Family("radio", "radio", radio, 200),
    Family("clock", "alarm clock", clock, 350),
    Family("camera", "camera", camera, 650, train=0, test=3),
)
