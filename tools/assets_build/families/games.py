"""Families of balls, dice and what one exercises with; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def ball(d: Drawing, v: Variation) -> None:
    kind = v.pick(("beach", "tennis", "seams", "stars"), ("rugby", "panels"))
    r = v.between(0.03, 0.036) if kind == "tennis" else v.between(0.05, 0.0695)
    body, line = (p.cloth(v) if kind == "beach" else p.paint(v)), p.paint(v, p.PALE)
    long = 1.5 if kind == "rugby" else 1.0
    if kind == "panels":
        colors = (p.paint(v), p.paint(v, p.PALE), p.paint(v, p.DARK))
        grid = np.linspace(0, 2 * math.pi, 7)
        for k in range(6):
            a0, a1 = grid[k], grid[k + 1]
            for low in np.linspace(-math.pi / 2, math.pi / 2, 9)[:-1]:
                high = low + math.pi / 8
                for s0, s1 in ((a0, (a0 + a1) / 2), ((a0 + a1) / 2, a1)):
                    q = [
                        np.array([r * math.cos(e) * math.cos(a), r * math.cos(e) * math.sin(a), r + r * math.sin(e)])
                        for e, a in ((low, s0), (low, s1), (high, s1), (high, s0))
                    ]
                    d.add(np.array([[q[0], q[1], q[2]], [q[0], q[2], q[3]]]), colors[k % 3])
        return
    d.soft_block((0, 0, r), (2 * long * r, 2 * r, 2 * r), 1.0, body, 11)
    angles = np.linspace(0, 2 * math.pi, 21)
    s = 0.998 * r
    if kind in ("tennis", "seams", "rugby"):
        d.tube([(long * s * math.cos(a), 0.0, r + s * math.sin(a)) for a in angles], 0.02 * r + 0.0008, line, 5)
        if kind != "tennis":
            d.tube([(long * s * math.cos(a), s * math.sin(a), r) for a in angles], 0.02 * r + 0.0008, line, 5)
    if kind == "rugby":
        for x in (-0.7 * r, 0.7 * r):
            at = math.sqrt(1 - (x / (long * r)) ** 2) * r
            d.tube([(x, at * math.cos(a), r + at * math.sin(a)) for a in angles], 0.03 * r, line, 5)
    if kind == "stars":
        for k in range(9):
            a, e = 2.4 * k, 0.2 * (k - 3)
            at = (s * math.cos(e) * math.cos(a), s * math.cos(e) * math.sin(a), r + s * math.sin(e))
            d.soft_block(at, (0.3 * r, 0.3 * r, 0.3 * r), 1.0, line, 5)


def die(d: Drawing, v: Variation) -> None:
    side = v.between(0.045, 0.09)
    body, pip = v.pick((f.WHITE,), (p.paint(v), f.CREAM)), v.pick((f.BLACK,), (f.WHITE, f.BLACK))
    h, r = side / 2, 0.09 * side
    d.soft_block((0, 0, h), (side, side, side), 0.16, body, 9)
    spots = {
        1: [(0, 0)],
        2: [(-1, -1), (1, 1)],
        3: [(-1, -1), (0, 0), (1, 1)],
        4: [(-1, -1), (1, 1), (-1, 1), (1, -1)],
        6: [(u, w) for u in (-1, 1) for w in (-1, 0, 1)],
    }
    top, front, right = v.pick(((6, 3, 2),), ((4, 2, 1), (6, 4, 3), (1, 2, 3)))
    for u, w in spots[top]:
        d.lathe([(r, side - 0.0004), (r, side + 0.0006), (0, side + 0.0006)], pip, (0.5 * h * u, 0.5 * h * w), 8)
    for u, w in spots[front]:
        d.tube([(0.5 * h * u, -h + 0.0005, h + 0.5 * h * w), (0.5 * h * u, -h - 0.0006, h + 0.5 * h * w)], r, pip, 8)
    for u, w in spots[right]:
        d.tube([(h - 0.0005, 0.5 * h * u, h + 0.5 * h * w), (h + 0.0006, 0.5 * h * u, h + 0.5 * h * w)], r, pip, 8)


def puzzle_cube(d: Drawing, v: Variation) -> None:
    side, n = v.between(0.052, 0.068), v.pick((3,), (3, 2, 4))
    h, step = side / 2, side / n
    d.box((-h, -h, 0), (h, h, side), f.BLACK)
    colors = [
        Finish(c)
        for c in (
            (0.8, 0.1, 0.1),
            (0.95, 0.95, 0.95),
            (0.1, 0.35, 0.8),
            (0.1, 0.6, 0.25),
            (0.95, 0.85, 0.1),
            (0.95, 0.5, 0.1),
        )
    ]
    mixed, seed = v.pick((1,), (0, 1, 1)), v.seed()
    for face in range(5):
        for i in range(n):
            for j in range(n):
                a, b = (i + 0.5) * step - h, (j + 0.5) * step
                color = colors[(face + mixed * ((seed + 5 * i + 3 * j + i * j * face) % 6)) % 6]
                size = 0.84 * step
                if face < 2:
                    d.block((a, (-1) ** face * -h, b), (size, 0.0016, size), color)
                elif face < 4:
                    d.block(((-1) ** face * h, a, b), (0.0016, size, size), color)
                else:
                    d.block((a, b - h, side), (size, size, 0.0016), color)


def dumbbell(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.085, 0.13), v.between(0.032, 0.055)
    weight, grip = (
        v.pick((p.paint(v, p.DARK), p.paint(v)), (p.paint(v), p.metal(v))),
        v.pick((f.STEEL, f.BLACK), (p.paint(v),)),
    )
    kind, sides = v.pick(("block", "discs"), ("ball", "steps")), v.pick((6, 16), (8, 12))
    d.tube([(-half, 0, r), (half, 0, r)], 0.014, grip, 8)
    for side in (-1, 1):
        if kind == "ball":
            d.soft_block((side * 0.78 * half, 0, r), (2 * r, 2 * r, 2 * r), 1.0, weight, 8)
        elif kind == "block":
            d.tube(
                [
                    (side * half, 0, r),
                    (side * 0.92 * half, 0, r),
                    (side * 0.5 * half, 0, r),
                    (side * 0.45 * half, 0, r),
                ],
                [0.85 * r, r, r, 0.85 * r],
                weight,
                sides,
            )
        else:
            steps = ((0.5, 0.62, 1.0), (0.64, 0.76, 0.9), (0.78, 0.88, 0.7 if kind == "steps" else 0.95))
            for a, b, size in steps:
                d.tube([(side * a * half, 0, r), (side * b * half, 0, r)], size * r, weight, max(sides, 12))


def table_tennis_paddle(d: Drawing, v: Variation) -> None:
    r, grip = v.between(0.068, 0.082), v.between(0.085, 0.11)
    rubber, wood = (
        Finish(v.pick(((0.75, 0.1, 0.12), (0.12, 0.12, 0.13)), ((0.1, 0.3, 0.6), (0.85, 0.3, 0.12)))),
        p.wood(v),
    )
    squash = v.pick((1.0, 1.08), (1.2, 0.9))
    outline = [
        (r * math.cos(a), squash * r * math.sin(a)) for a in np.linspace(-math.pi / 2 + 0.35, 1.5 * math.pi - 0.35, 22)
    ]
    d.prism(outline, 0.006, 0.012, wood)
    blade = [(0.985 * x, 0.985 * y) for x, y in outline]
    d.prism(blade, 0.012, 0.0145, rubber)
    d.prism(blade, 0.0035, 0.006, f.BLACK)
    flare = v.pick((1.15, 1.0), (1.5, 0.8))
    d.loft(
        [
            (0, 0.012, 0.5 * grip, 0.3, 0, -squash * r - 0.4 * grip),
            (0.018, 0.012, 0.5 * grip, 0.3, 0, -squash * r - 0.4 * grip),
        ],
        wood,
    )
    d.block((0, -squash * r - 0.82 * grip, 0.009), (0.026 * flare, 0.02, 0.02), wood)
    if v.pick((False, True), (True,)):
        d.soft_block((0.3 * r, 0.2 * r, 0.0345), (0.04, 0.04, 0.04), 1.0, f.WHITE, 8)


FAMILIES = (
    Family("ball", "ball", ball, 90),
    Family("die", "die", die, 230, train=0, test=3),
    Family("puzzle_cube", "puzzle cube", puzzle_cube, 480, train=0, test=3),
    Family("dumbbell", "dumbbell", dumbbell, 1300),
    Family("table_tennis_paddle", "table tennis paddle", table_tennis_paddle, 230),
)
