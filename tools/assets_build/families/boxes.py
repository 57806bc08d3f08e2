"""Families of boxes; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.families.prints import UNIT, front, printed_box, sheet
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def tissue_box(d: Drawing, v: Variation) -> None:
    cube = v.pick((False, True, False), (False, True))
    w = v.between(0.115, 0.135) if cube else v.between(0.2, 0.26)
    dep, h = v.between(0.11, 0.132), v.between(0.11, 0.14) if cube else v.between(0.06, 0.1)
    side = p.paint(v)
    printed_box(d, w, dep, h, p.label(v), side)
    hole = v.pick((0.4, 0.3), (0.22, 0.5))
    d.loft([(h, hole * w, 0.28 * dep, 0.8, 0, 0), (h + 0.001, hole * w, 0.28 * dep, 0.8, 0, 0)], f.BLACK)
    tall = v.between(0.03, 0.06)
    for k in range(v.pick((2, 3), (1, 4))):
        part = Drawing()
        part.loft(
            [
                (0, 0.02, 0.004, 0.8, 0, 0),
                (0.5 * tall, 0.035, 0.012, 0.8, 0.004, 0),
                (tall, 0.012, 0.004, 0.8, 0.012, 0),
            ],
            f.WHITE,
            10,
        )
        d.place(part, (0, 0, h), (0, 0, 60 * k))


def cereal_box(d: Drawing, v: Variation) -> None:
    printed_box(d, v.between(0.16, 0.22), v.between(0.05, 0.08), v.between(0.22, 0.3), p.label(v), p.paint(v))


def crate(d: Drawing, v: Variation) -> None:
    """A box: of cardboard, of wood, or open."""
    w, dep, h = v.between(0.18, 0.34), v.between(0.12, 0.24), v.between(0.07, 0.115)
    kind = v.pick(("taped", "taped", "lidded"), ("open", "slatted"))
    body = f.CARDBOARD if kind in ("taped", "open") else v.pick((p.wood(v), p.paint(v)), (p.wood(v), p.paint(v)))
    if kind in ("open", "slatted"):
        t = 0.006 if kind == "open" else 0.01
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, t), body)
        for low, high in ((0.0, h),) if kind == "open" else ((0.1 * h, 0.42 * h), (0.58 * h, 0.95 * h)):
            for x in (-w / 2, w / 2 - t):
                d.box((x, -dep / 2, low), (x + t, dep / 2, high), body)
            for y in (-dep / 2, dep / 2 - t):
                d.box((-w / 2, y, low), (w / 2, y + t, high), body)
        if kind == "open":
            for side in (-1, 1):
                part = Drawing()
                part.box((-w / 2, 0, -0.002), (w / 2, 0.3 * dep, 0.002), body)
                d.place(part, (0, side * dep / 2, h), (35, 0, 0 if side > 0 else 180))
            shade = Finish((0.42, 0.32, 0.21))
            d.box((-w / 2 + t, -dep / 2 + t, t), (w / 2 - t, dep / 2 - t, t + 0.002), shade)
            d.box((-w / 2 + t, dep / 2 - t - 0.001, t), (w / 2 - t, dep / 2 - t, 0.98 * h), shade)
        else:
            for x in (-w / 2 + t, w / 2 - 2 * t):
                d.box((x, -dep / 2 + t, 0), (x + t, -dep / 2 + 2 * t, h), body)
        return
    d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, 0.84 * h if kind == "lidded" else h), body)
    if kind == "lidded":
        d.box((-w / 2 - 0.004, -dep / 2 - 0.004, 0.8 * h), (w / 2 + 0.004, dep / 2 + 0.004, h), body)
        d.block((0, -dep / 2 - 0.004, 0.5 * h), (0.06, 0.006, 0.025), f.BRASS)
    else:
        d.box((-w / 2, -0.024, h), (w / 2, 0.024, h + 0.0008), Finish((0.82, 0.7, 0.5)))
        for x in (-w / 2 - 0.0008, w / 2):
            d.box((x, -0.024, 0.6 * h), (x + 0.0008, 0.024, h), Finish((0.82, 0.7, 0.5)))
        d.block((0.25 * w, -dep / 2, 0.6 * h), (0.28 * w, 0.0016, 0.4 * h), f.WHITE)


def gift_box(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.14, 0.28), v.between(0.11, 0.2), v.between(0.06, 0.105)
    paper, ribbon = v.pick((p.paint(v), p.cloth(v)), (p.cloth(v),)), p.paint(v, p.PALE)
    d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, h), paper)
    at = v.pick((0.0, 0.0), (0.22 * w, -0.22 * w))
    d.box((at - 0.011, -dep / 2 - 0.001, -0.0002), (at + 0.011, dep / 2 + 0.001, h + 0.001), ribbon)
    d.box((-w / 2 - 0.001, -0.011, -0.0002), (w / 2 + 0.001, 0.011, h + 0.001), ribbon)
    loops = v.pick((2, 4), (3, 6))
    for k in range(loops):
        a = 2 * math.pi * (k + 0.25) / loops
        c, s = 0.035 * math.cos(a), 0.035 * math.sin(a)
        d.tube(
            [
                (at, 0, h),
                (at + 0.7 * c - 0.3 * s, 0.7 * s + 0.3 * c, h + 0.022),
                (at + 1.2 * c, 1.2 * s, h + 0.012),
                (at + 0.7 * c + 0.3 * s, 0.7 * s - 0.3 * c, h + 0.008),
                (at, 0, h),
            ],
            0.007,
            ribbon,
            6,
        )


def lunch_box(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.15, 0.22), v.between(0.11, 0.138), v.between(0.055, 0.11)
    body, lid = p.paint(v), v.pick((p.paint(v, p.PALE), p.paint(v)), (p.wood(v), p.paint(v)))
    power = v.pick((0.15, 0.3), (0.6, 1.0))
    d.loft([(0, 0.46 * w, 0.46 * dep, power, 0, 0), (0.68 * h, 0.49 * w, 0.49 * dep, power, 0, 0)], body)
    d.loft(
        [
            (0.68 * h, w / 2, dep / 2, power, 0, 0),
            (0.9 * h, w / 2, dep / 2, power, 0, 0),
            (h, 0.46 * w, 0.46 * dep, power, 0, 0),
        ],
        lid,
    )
    for side in (-1, 1):
        d.block((side * 0.5 * w, 0, 0.66 * h), (0.01, 0.035, 0.32 * h), f.DARK_STEEL)
    if v.pick((True, False), (True, False)):
        d.tube(
            [(-0.22 * w, 0, h - 0.004), (-0.2 * w, 0, h + 0.028), (0.2 * w, 0, h + 0.028), (0.22 * w, 0, h - 0.004)],
            0.006,
            body,
            6,
        )


def board_game(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.26, 0.42), v.between(0.2, 0.3), v.between(0.04, 0.08)
    face, body = p.label(v), p.paint(v)
    if v.pick((False, False, True), (True, False)):
        squares = p.pattern(v.pick(((0.2, 0.15, 0.1),), ((0.15, 0.3, 0.22),)), (0.92, 0.86, 0.74), "checked")
        d.box((-dep / 2, -dep / 2, 0), (dep / 2, dep / 2, 0.02), p.wood(v))
        uv = np.array([[0, 0], [2, 0], [2, 2], [0, 2]], float)
        q = np.array(
            [
                [-0.42 * dep, -0.42 * dep, 0.0206],
                [0.42 * dep, -0.42 * dep, 0.0206],
                [0.42 * dep, 0.42 * dep, 0.0206],
                [-0.42 * dep, 0.42 * dep, 0.0206],
            ]
        )
        d.add(np.array([q[[0, 1, 2]], q[[0, 2, 3]]]), squares, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))
        for k in range(v.pick((8, 12), (6,))):
            x, y = (-0.36 + 0.105 * (3 * k % 8)) * dep, (-0.36 + 0.105 * (5 * k % 8)) * dep
            d.lathe(
                [(0.011, 0.02), (0.006, 0.03), (0.009, 0.045), (0, 0.052)], f.CREAM if k % 2 else f.BLACK, (x, y), 8
            )
        return
    d.box((-w / 2 + 0.002, -dep / 2 + 0.002, 0), (w / 2 - 0.002, dep / 2 - 0.002, 0.6 * h), f.WHITE)
    d.box((-w / 2, -dep / 2, 0.2 * h), (w / 2, dep / 2, h), body)
    sheet(d, (-w / 2, w / 2), (-dep / 2, dep / 2), h + 0.0005, face)
    d.add(front(w / 2, 0.2 * h, h, dep / 2 + 0.0005), face, UNIT)


FAMILIES = (
    Family("tissue_box", "tissue box", tissue_box, 90),
    Family("cereal_box", "cereal box", cereal_box, 130, train=0, test=2),
    Family("box", "box", crate, 80),
    Family("gift_box", "gift box", gift_box, 150),
    Family("lunch_box", "lunch box", lunch_box, 220),
    Family("board_game", "board game", board_game, 220),
)
