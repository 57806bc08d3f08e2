"""Families of books, papers and what one writes with; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.families.prints import sheet
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def book(d: Drawing, v: Variation) -> None:
    w, thick = v.between(0.105, 0.19), v.between(0.014, 0.05)
    h = w * v.between(1.25, 1.6)
    cover, spine = p.label(v), p.paint(v)
    hard = v.pick((True, False), (True, True, False))
    over = 0.004 if hard else 0.0005
    d.box((-w / 2, -h / 2, 0), (w / 2, h / 2, 0.003), spine)
    d.box((-w / 2 + 0.004, -h / 2 + over, 0.003), (w / 2 - over, h / 2 - over, thick - 0.003), f.CREAM)
    if v.pick((False, True), (True,)) and hard:
        d.tube([(-w / 2 + 0.002, -h / 2, thick / 2), (-w / 2 + 0.002, h / 2, thick / 2)], thick / 2, spine, 10)
    else:
        d.box((-w / 2, -h / 2, 0.003), (-w / 2 + 0.004, h / 2, thick - 0.003), spine)
    d.box((-w / 2, -h / 2, thick - 0.003), (w / 2, h / 2, thick - 0.0004), spine)
    sheet(d, (-w / 2 + 0.004, w / 2), (-h / 2, h / 2), thick, cover)


def notebook(d: Drawing, v: Variation) -> None:
    w, h, thick = v.between(0.09, 0.2), v.between(0.14, 0.27), v.between(0.008, 0.018)
    cover = v.pick((p.paint(v), p.leather(v), f.CARDBOARD), (p.cloth(v), p.paint(v)))
    d.box((-w / 2, -h / 2, 0), (w / 2, h / 2, 0.002), cover)
    d.box((-w / 2 + 0.003, -h / 2 + 0.003, 0.002), (w / 2 - 0.003, h / 2 - 0.003, thick - 0.002), f.CREAM)
    d.box((-w / 2, -h / 2, thick - 0.002), (w / 2, h / 2, thick), cover)
    kind = v.pick(("spiral", "band", "plain"), ("top", "label"))
    if kind in ("spiral", "top"):
        count = 14
        for k in range(count):
            s = -0.45 + 0.9 * k / (count - 1)
            at = (-w / 2, s * h, thick / 2) if kind == "spiral" else (s * w, h / 2, thick / 2)
            size = (0.014, 0.003, thick + 0.006) if kind == "spiral" else (0.003, 0.014, thick + 0.006)
            d.block(at, size, f.DARK_STEEL)
    elif kind == "band":
        d.box((0.32 * w, -h / 2 - 0.001, -0.0002), (0.35 * w, h / 2 + 0.001, thick + 0.001), p.paint(v))
    else:
        d.block((0, 0.18 * h, thick), (0.55 * w, 0.2 * h, 0.001), p.paint(v, p.PALE))


def newspaper(d: Drawing, v: Variation) -> None:
    w, h = v.between(0.2, 0.3), v.between(0.26, 0.38)
    page = f.printed(
        (0.88, 0.87, 0.83),
        v.pick(((0.2, 0.2, 0.2), (0.15, 0.15, 0.2)), ((0.45, 0.12, 0.12), (0.1, 0.25, 0.4))),
        v.seed(),
    )
    grey = Finish((0.84, 0.83, 0.8))
    if v.pick((False, False, True), (True, False)):
        r = v.between(0.025, 0.04)
        d.lathe([(0.75 * r, 0), (r, 0), (r, w), (0.75 * r, w)], page, segments=18)
        d.lathe([(0, 0.004), (0.8 * r, 0.004)], grey, segments=18)
        d.lathe([(r + 0.001, 0.45 * w), (r + 0.001, 0.5 * w)], p.paint(v), segments=18)
        d.turn(90, 0)
        return
    layers = v.pick((3, 4), (2, 5))
    for k in range(layers):
        shift = 0.004 * ((k * 7) % 3 - 1)
        d.loft(
            [
                (0.006 * k, w / 2, h / 2, 0.12, shift, -shift),
                (0.006 * k + 0.0055, w / 2 - 0.002, h / 2, 0.12, shift, -shift),
            ],
            grey,
        )
    sheet(d, (-w / 2 + 0.004, w / 2 - 0.004), (-h / 2 + 0.004, h / 2 - 0.004), 0.006 * layers + 0.0006, page)


def calendar(d: Drawing, v: Variation) -> None:
    w, h, foot = v.between(0.14, 0.22), v.between(0.12, 0.18), v.between(0.042, 0.062)
    page = f.printed((0.95, 0.95, 0.93), v.pick(*p.COLORS), v.seed())
    back = p.paint(v)
    for side in (-1, 1):
        part = Drawing()
        part.box((-w / 2, -0.0015, 0), (w / 2, 0.0015, h), back)
        if side < 0:
            uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
            q = np.array(
                [[-w / 2, -0.002, 0], [w / 2, -0.002, 0], [w / 2, -0.002, 0.94 * h], [-w / 2, -0.002, 0.94 * h]]
            )
            part.add(np.array([q[[0, 1, 2]], q[[0, 2, 3]]]), page, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))
            for row in range(4):
                for column in range(7):
                    x, z = (-0.38 + 0.127 * column) * w, (0.1 + 0.12 * row) * h
                    part.box(
                        (x - 0.026 * w, -0.0032, z), (x + 0.026 * w, -0.0018, z + 0.055 * h), Finish((0.35, 0.35, 0.38))
                    )
        d.place(part, (0, side * foot, 0.002), (side * math.degrees(math.atan2(foot, h)), 0, 0))
    d.box((-w / 2, -foot, 0), (w / 2, foot, 0.003), back)
    for k in range(v.pick((10, 14), (8,))):
        x = (-0.45 + 0.9 * k / 9) * w if k < 10 else 0.0
        d.block((x, 0, h), (0.004, 0.012, 0.016), f.STEEL)


def pen(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.065, 0.078), v.between(0.0042, 0.006)
    body, tip = p.paint(v), v.pick((p.metal(v), p.paint(v)), (p.metal(v),))
    sides = v.pick((10, 6), (8, 3))
    d.tube([(-half, 0, r), (-0.9 * half, 0, r)], [0.8 * r, 0.8 * r], tip, 8)
    d.tube([(-0.9 * half, 0, r), (0.7 * half, 0, r)], r, body, sides)
    d.tube([(0.7 * half, 0, r), (0.93 * half, 0, r), (half, 0, r)], [0.9 * r, 0.5 * r, 0.1 * r], tip, 8)
    d.block((-0.55 * half, 0, 2.1 * r), (0.6 * half, 0.003, 0.0016), tip)


def marker(d: Drawing, v: Variation) -> None:
    half, r = v.between(0.058, 0.075), v.between(0.008, 0.012)
    ink = p.paint(v)
    body = v.pick((ink, p.paint(v, p.PALE)), (p.paint(v, p.DARK), ink))
    cap = v.pick((0.25, 0.35), (0.5, 0.12))
    d.tube([(-half, 0, r), (cap * half, 0, r)], 0.9 * r, body, v.pick((12, 12), (6, 10)))
    d.tube([(cap * half, 0, r), (0.9 * half, 0, r), (half, 0, r)], [r, r, 0.8 * r], ink, 12)
    d.tube([(-half, 0, r), (-0.9 * half, 0, r)], 0.95 * r, ink, 12)
    d.block((0.5 * half, 0, 2.05 * r), (0.6 * half, 0.004, 0.002), ink)


def ruler(d: Drawing, v: Variation) -> None:
    half, w = v.between(0.105, 0.24), v.between(0.026, 0.042)
    body = v.pick((p.wood(v), p.paint(v, p.GLASSES), p.metal(v), p.paint(v)), (p.paint(v), p.wood(v)))
    d.box((-half, -w / 2, 0), (half, w / 2, 0.003), body)
    count = int(half / 0.005)
    for k in range(count):
        x = (-0.97 + 1.94 * k / (count - 1)) * half
        long = 0.011 if k % 5 == 0 else 0.006
        d.box((x - 0.0005, -w / 2 + 0.0004, 0.003), (x + 0.0005, -w / 2 + long, 0.0034), f.BLACK)


def pencil_case(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.19, 0.23), v.between(0.06, 0.1), v.between(0.035, 0.06)
    body, zipper = v.pick((p.cloth(v), p.leather(v), p.paint(v)), (p.cloth(v), p.speckle(v))), f.DARK_STEEL
    kind = v.pick(("roll", "flat"), ("box", "wedge"))
    if kind == "roll":
        d.tube([(-w / 2, 0, h / 2), (w / 2, 0, h / 2)], h / 2, body, 14)
        d.block((0, 0, h), (0.9 * w, 0.006, 0.003), zipper)
    else:
        power, top = {"flat": (0.35, 0.9), "box": (0.15, 1.0), "wedge": (0.3, 0.4)}[kind]
        d.loft(
            [
                (0, w / 2, dep / 2, power, 0, 0),
                (0.7 * h, w / 2, 0.5 * (top + 1) * dep / 2, power, 0, 0),
                (h, 0.98 * w / 2, top * dep / 2 * 0.96, power, 0, 0),
            ],
            body,
        )
        d.block((0, 0, h), (0.92 * w, 0.005, 0.003), zipper)
    d.block((0.42 * w, 0, h + 0.002), (0.03, 0.006, 0.005), p.paint(v))


def file_sorter(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.16, 0.26), v.between(0.11, 0.136), v.between(0.12, 0.2)
    body = v.pick((p.metal(v), p.wood(v), p.paint(v)), (p.paint(v), p.metal(v)))
    count = v.pick((4, 5), (3, 6))
    d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, 0.006), body)
    rise = v.pick((0.0, 0.5), (-0.4,))
    for k in range(count):
        x = -w / 2 + w * k / (count - 1)
        tall = h * (1 - abs(rise) * (k / (count - 1) if rise > 0 else 1 - k / (count - 1)))
        d.box((x - 0.002, -dep / 2, 0.006), (x + 0.002, dep / 2, tall), body)
    sheets = v.pick((3, 2), (4, 1))
    for k in range(min(sheets, count - 1)):
        x = -w / 2 + w * (k + 0.5) / (count - 1)
        d.block((x, 0, 0.006 + 0.5 * h), (0.006, 0.92 * dep, 0.98 * h), p.paint(v, p.PALE) if k % 2 else p.paint(v))


def stapler(d: Drawing, v: Variation) -> None:
    length, h = v.between(0.12, 0.16), v.between(0.045, 0.06)
    body = p.paint(v)
    d.box((-0.019, -length / 2, 0), (0.019, length / 2, 0.008), f.DARK_STEEL)
    part = Drawing()
    part.box((-0.013, -length, 0), (0.013, 0, 0.009), f.STEEL)
    part.loft(
        [(0.009, 0.016, 0.5 * length, 0.3, 0, -0.5 * length), (0.45 * h, 0.014, 0.48 * length, 0.4, 0, -0.5 * length)],
        body,
    )
    d.place(part, (0, length / 2, 0.4 * h), (9, 0, 0))
    d.box((-0.017, 0.3 * length, 0.008), (0.017, length / 2, 0.62 * h), body)


FAMILIES = (
    Family("book", "book", book, 650),
    Family("notebook", "notebook", notebook, 600),
    Family("newspaper", "newspaper", newspaper, 280),
    Family("calendar", "desk calendar", calendar, 120),
    Family("pen", "pen", pen, 900),
    Family("marker", "marker", marker, 600),
    Family("ruler", "ruler", ruler, 900),
    Family("pencil_case", "pencil case", pencil_case, 150),
    Family("file_sorter", "file sorter", file_sorter, 170),
    Family("stapler", "stapler", stapler, 700, train=0, test=3),
)
