"""Families of toys that drive, fly, build and sound; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def toy_airplane(d: Drawing, v: Variation) -> None:
    length, span = v.between(0.16, 0.28), v.between(0.9, 1.25)
    body, wing, trim = v.pick((p.paint(v), p.wood(v)), (p.paint(v), p.metal(v))), p.paint(v), p.paint(v, p.PALE)
    r = 0.075 * length
    z = 1.6 * r
    d.tube(
        [
            (0, -0.5 * length, z),
            (0, -0.44 * length, z),
            (0, -0.1 * length, z),
            (0, 0.42 * length, 1.15 * z),
            (0, 0.5 * length, 1.2 * z),
        ],
        [0.5 * r, r, r, 0.45 * r, 0.2 * r],
        body,
        10,
    )
    half, sweep = 0.5 * span * length, v.pick((0.0, 0.12), (0.3, -0.05)) * length
    root = v.pick((0.2, 0.26), (0.34, 0.15)) * length
    for level in (0.0, 1.5 * r) if v.pick((False, True), (True, False)) else (0.0,):
        for side in (-1, 1):
            outline = [
                (0, -0.5 * root),
                (side * half, -0.5 * root + sweep + 0.2 * root),
                (side * half, 0.3 * root + sweep),
                (0, 0.5 * root),
            ]
            d.prism(
                [(x, y - 0.1 * length) for x, y in (outline if side > 0 else outline[::-1])],
                z - 0.2 * r + level,
                z + level,
                wing,
            )
        if level:
            for side in (-1, 1):
                d.tube(
                    [(side * 0.5 * half, -0.1 * length, z), (side * 0.5 * half, -0.1 * length, z + level)],
                    0.003,
                    trim,
                    5,
                )
    for side in (-1, 1):
        outline = [
            (0, 0.36 * length),
            (side * 0.2 * length, 0.42 * length),
            (side * 0.2 * length, 0.49 * length),
            (0, 0.49 * length),
        ]
        d.prism(outline if side > 0 else outline[::-1], 1.15 * z, 1.15 * z + 0.003, wing)
    tail = Drawing()
    tail.prism(
        [(0.36 * length, 0), (0.5 * length, 0), (0.52 * length, 0.16 * length), (0.45 * length, 0.16 * length)],
        -0.002,
        0.002,
        wing,
    )
    d.place(tail, (0, 0, 1.2 * z), (90, 0, 90))
    d.soft_block((0, -0.22 * length, z + r), (1.1 * r, 0.16 * length, r), 1.0, Finish((0.6, 0.75, 0.85)), 6)
    if v.pick((True, False), (True,)):
        d.tube([(0, -0.5 * length, z), (0, -0.53 * length, z)], 0.25 * r, trim, 8)
        for turn in (20, 110):
            blade = Drawing()
            blade.block((0, 0, 0), (0.15 * length, 0.004, 0.014), trim)
            d.place(blade, (0, -0.525 * length, z), (0, turn, 0))
    for x in (-0.55 * r, 0.55 * r):
        d.tube(
            [(1.6 * x - 0.004, -0.18 * length, 0.35 * r), (1.6 * x + 0.004, -0.18 * length, 0.35 * r)],
            0.35 * r,
            f.BLACK,
            10,
        )
        d.tube([(1.6 * x, -0.18 * length, 0.35 * r), (x, -0.18 * length, z - 0.5 * r)], 0.003, trim, 5)


def toy_bricks(d: Drawing, v: Variation) -> None:
    s = v.between(0.03, 0.042)
    colors = (p.paint(v), p.paint(v), p.paint(v), p.paint(v))
    layout = v.pick(
        (
            ((-0.75, 0, 0), (0.75, 0, 0), (0, 0, 1)),
            ((-0.75, 0, 0), (0.75, 0, 0), (-0.4, 0, 1), (0.0, 0, 2)),
            ((0, 0, 0), (0.1, 0, 1), (-0.15, 0, 2)),
        ),
        (
            ((-1.5, 0, 0), (0, 0, 0), (1.5, 0, 0), (-0.7, 0, 1), (0.8, 0, 1)),
            ((0, -0.55, 0), (0, 0.55, 0), (0, 0, 1), (0, 0, 2)),
        ),
    )
    studs = v.pick((True, True, False), (True, False))
    for k, (x, y, z) in enumerate(layout):
        d.block((1.02 * x * s, 1.9 * y * s, (z + 0.5) * s), (1.46 * s, 1.0 * s, s), colors[k % 4])
        for u in (-0.36, 0.36) if studs else ():
            for w in (-0.25, 0.25):
                at = (1.02 * x * s + u * s, 1.9 * y * s + w * s)
                d.lathe(
                    [(0.15 * s, (z + 1) * s), (0.15 * s, (z + 1.16) * s), (0, (z + 1.16) * s)], colors[k % 4], at, 8
                )
    if not studs:
        x, y, z = layout[-1]
        d.lathe(
            [(0.68 * s, (z + 1) * s), (0, (z + 1.9) * s)], colors[3], (1.02 * x * s, 1.9 * y * s), v.pick((4,), (12,))
        )


def toy_vehicle(d: Drawing, v: Variation) -> None:
    length = v.between(0.15, 0.26)
    body, trim = p.paint(v), p.paint(v)
    w, r = 0.42 * length, v.between(0.08, 0.11) * length
    kind = v.pick(("car",), ("bus", "truck", "tractor"))
    d.box((-w / 2, -length / 2, 0.7 * r), (w / 2, length / 2, 1.9 * r), body)
    if kind == "bus":
        d.box((-w / 2, -length / 2, 1.9 * r), (w / 2, length / 2, 5.0 * r), body)
        for k in range(4):
            y = (-0.36 + 0.24 * k) * length
            d.box(
                (-w / 2 - 0.001, y - 0.09 * length, 3.0 * r),
                (w / 2 + 0.001, y + 0.09 * length, 4.3 * r),
                Finish((0.6, 0.75, 0.85)),
            )
    elif kind == "truck":
        d.box((-w / 2, -length / 2, 1.9 * r), (w / 2, -0.22 * length, 4.6 * r), body)
        d.box(
            (-w / 2 - 0.001, -0.46 * length, 3.0 * r),
            (w / 2 + 0.001, -0.26 * length, 4.2 * r),
            Finish((0.6, 0.75, 0.85)),
        )
        d.box((-w / 2, -0.18 * length, 2.1 * r), (w / 2, length / 2, 4.0 * r), trim)
    else:
        d.box((-w / 2 + 0.2 * w, 0.0, 1.9 * r), (w / 2 - 0.2 * w, 0.45 * length, 5.0 * r), trim)
        d.tube([(0, -0.3 * length, 1.9 * r), (0, -0.3 * length, 4.4 * r)], 0.05 * w, f.STEEL, 8)
    for y in (-0.32 * length, 0.3 * length):
        size = 1.7 * r if kind == "tractor" and y > 0 else r
        for side in (-1, 1):
            d.tube([(side * (w / 2 - 0.004), y, size), (side * (w / 2 + 0.014), y, size)], size, f.BLACK, 14)
            d.tube([(side * (w / 2 + 0.013), y, size), (side * (w / 2 + 0.016), y, size)], 0.5 * size, f.STEEL, 10)


def xylophone(d: Drawing, v: Variation) -> None:
    length, w = v.between(0.24, 0.38), v.between(0.1, 0.16)
    frame, count = v.pick((p.wood(v), p.paint(v)), (p.wood(v), p.metal(v))), v.pick((8, 6), (7, 10))
    colors = [
        Finish(c)
        for c in (
            (0.85, 0.15, 0.15),
            (0.93, 0.5, 0.12),
            (0.95, 0.82, 0.2),
            (0.3, 0.65, 0.3),
            (0.2, 0.55, 0.75),
            (0.2, 0.3, 0.7),
            (0.5, 0.25, 0.6),
        )
    ]
    plain = v.pick((False, False, True), (False, True))
    taper = v.pick((0.55, 0.7), (0.4, 0.85))
    for side in (-1, 1):
        outline = [
            (-length / 2, side * 0.36 * w - 0.008),
            (length / 2, side * 0.36 * w * taper - 0.008),
            (length / 2, side * 0.36 * w * taper + 0.008),
            (-length / 2, side * 0.36 * w + 0.008),
        ]
        d.prism(outline, 0, 0.022, frame)
    metal = p.metal(v)
    for k in range(count):
        x = length * (-0.46 + 0.92 * (k + 0.5) / count)
        reach = w * (1 - (1 - taper) * (k + 0.5) / count)
        d.block((x, 0, 0.027), (0.72 * length / count, reach, 0.008), metal if plain else colors[k % 7])
    for y, turn in ((-0.62, 8.0), (0.62, -6.0)) if v.pick((True, False), (True, False)) else ():
        part = Drawing()
        part.tube([(-0.3 * length, 0, 0), (0.28 * length, 0, 0)], 0.004, p.wood(v), 6)
        part.soft_block((0.3 * length, 0, 0), (0.024, 0.024, 0.024), 1.0, colors[0], 6)
        d.place(part, (0, y * w, 0.012), (0, 0, turn))


FAMILIES = (
    Family("toy_airplane", "toy aeroplane", toy_airplane, 70),
    Family("toy_construction_set", "toy bricks", toy_bricks, 330, collision="boxes"),
    Family("toy_vehicle", "toy vehicle", toy_vehicle, 170, train=0, test=3),
    Family("xylophone", "xylophone", xylophone, 350),
)
