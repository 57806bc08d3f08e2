"""Families of keys, spectacles and watches; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def keys(d: Drawing, v: Variation) -> None:
    r, count = v.between(0.012, 0.018), v.pick((2, 3), (4, 3))
    d.tube([(r * math.cos(a), r * math.sin(a), 0.003) for a in np.linspace(0, 2 * math.pi, 17)], 0.0015, f.STEEL, 5)
    head = v.pick((1.0, 0.5), (0.3, 0.7))
    for k in range(count):
        part = Drawing()
        metal, wide, long = p.metal(v) if k else f.BRASS, v.between(0.009, 0.013), v.between(0.026, 0.036)
        part.loft(
            [(0, wide, wide, head, wide, 0), (0.0025, wide, wide, head, wide, 0)], p.paint(v) if k == 1 else metal, 12
        )
        part.prism(
            [
                (2 * wide - 0.002, -0.003),
                (2 * wide + 0.3 * long, -0.003),
                (2 * wide + 0.4 * long, -0.006),
                (2 * wide + 0.5 * long, -0.003),
                (2 * wide + 0.7 * long, -0.007),
                (2 * wide + 0.8 * long, -0.003),
                (2 * wide + long, 0),
                (2 * wide + 0.9 * long, 0.003),
                (2 * wide - 0.002, 0.003),
            ],
            0,
            0.0022,
            metal,
        )
        turn = 55 * k - 40
        d.place(
            part,
            (0.85 * r * math.cos(math.radians(turn)), 0.85 * r * math.sin(math.radians(turn)), 0.0012 * k),
            (0, 0, turn),
        )
    if v.pick((True, False), (True,)):
        tag = Drawing()
        tag.loft(
            [(0, 0.014, 0.02, v.pick((1.0, 0.4), (0.2,)), 0.022, 0), (0.006, 0.014, 0.02, 0.8, 0.022, 0)],
            p.leather(v),
            12,
        )
        d.place(tag, (0.8 * r * math.cos(3.6), 0.8 * r * math.sin(3.6), 0), (0, 0, 206))


def spectacles(d: Drawing, v: Variation) -> None:
    w, r = v.between(0.125, 0.145), v.between(0.019, 0.025)
    frame = v.pick((p.paint(v, p.DARK), p.metal(v), p.paint(v)), (p.paint(v), p.metal(v)))
    lens = Finish(v.pick(((0.74, 0.81, 0.83), (0.15, 0.15, 0.17)), ((0.4, 0.28, 0.2), (0.6, 0.72, 0.8))))
    power, tall = v.pick((1.0, 0.6), (0.35, 0.8)), v.pick((1.0, 0.85), (0.7, 1.15))
    thick = v.pick((0.0022, 0.003), (0.004, 0.0016))
    for side in (-1, 1):
        x, z = side * 0.25 * w, tall * r + thick
        ring = [
            (
                x + 1.1 * r * math.copysign(abs(math.cos(a)) ** power, math.cos(a)),
                0,
                z + tall * r * math.copysign(abs(math.sin(a)) ** power, math.sin(a)),
            )
            for a in np.linspace(0, 2 * math.pi, 19)
        ]
        d.tube(ring, thick, frame, 5)
        part = Drawing()
        part.loft([(-0.0006, 1.1 * r, tall * r, power, 0, 0), (0.0006, 1.1 * r, tall * r, power, 0, 0)], lens, 18)
        d.place(part, (x, 0, z), (90, 0, 0))
        d.tube(
            [
                (side * 0.48 * w, 0, z + 0.3 * r),
                (side * 0.5 * w, 0.015, z + 0.3 * r),
                (side * 0.48 * w, 0.1, z + 0.25 * r),
                (side * 0.46 * w, 0.135, 0.006),
            ],
            0.8 * thick + 0.0006,
            frame,
            5,
        )
        d.tube([(side * 0.25 * w + side * 1.1 * r, 0, z + 0.3 * r), (side * 0.48 * w, 0, z + 0.3 * r)], thick, frame, 5)
    d.tube(
        [(-0.25 * w + 1.1 * r, 0, tall * r), (0, -0.003, 1.35 * tall * r), (0.25 * w - 1.1 * r, 0, tall * r)],
        thick,
        frame,
        5,
    )


def watch(d: Drawing, v: Variation) -> None:
    r, strap = (
        v.between(0.016, 0.023),
        v.pick((p.leather(v), p.metal(v), p.paint(v, p.DARK)), (p.leather(v), p.paint(v))),
    )
    case, face = p.metal(v), p.paint(v, p.PALE) if v.pick((True, False), (False, True)) else p.paint(v, p.DARK)
    sides = v.pick((20, 20), (4, 8))
    wide = 0.55 * r
    if v.pick((False, False, True), (True, False)):
        around = 0.032
        for k in range(16):
            a0, a1 = 2 * math.pi * k / 16, 2 * math.pi * (k + 1) / 16
            quad = [(around * math.cos(a), around * math.sin(a)) for a in (a0, a1)] + [
                ((around - 0.003) * math.cos(a), (around - 0.003) * math.sin(a)) for a in (a1, a0)
            ]
            d.prism(quad, r - wide, r + wide, strap)
        part = Drawing()
        part.lathe([(0, 0), (r, 0), (r, 0.008), (0.85 * r, 0.009)], case, segments=sides)
        part.lathe([(0.86 * r, 0.0085), (0, 0.0085)], face, segments=sides)
        part.block((0, 0.25 * r, 0.009), (0.002, 0.5 * r, 0.001), f.BLACK)
        d.place(part, (0, -around + 0.001, r), (90, 0, 0))
        return
    long = v.between(0.09, 0.115)
    for side in (-1, 1):
        outline = [(-wide, 0), (wide, 0), (0.75 * wide, side * long), (-0.75 * wide, side * long)]
        d.prism(outline if side > 0 else outline[::-1], 0.001, 0.004, strap)
        if side > 0:
            d.block((0, 0.97 * long, 0.004), (2.1 * wide, 0.008, 0.006), case)
    head = Drawing()
    head.lathe([(0, 0), (r, 0), (r, 0.009), (0.85 * r, 0.0105)], case, segments=sides)
    head.lathe([(0.86 * r, 0.01), (0, 0.01)], face, segments=sides)
    head.turn(45 if sides == 4 else 0)
    head.block((0, 0.24 * r, 0.0105), (0.0018, 0.5 * r, 0.001), f.RED)
    head.block((0.18 * r, 0, 0.0105), (0.4 * r, 0.0018, 0.001), f.STEEL)
    d.place(head)


FAMILIES = (
    Family("keys", "bunch of keys", keys, 900),
    Family("spectacles", "spectacles", spectacles, 40),
    Family("watch", "watch", watch, 700),
)
