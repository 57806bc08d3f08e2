"""Families of carts, benches, stools, stands and beds; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.boards import castors, legs, panel
from assets_build.families.timber import fronts, plinth, receptacle, timber
from assets_build.primitives import Drawing
from assets_build.variation import Variation


def serving_cart(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.45, 0.88), v.between(0.34, 0.5), v.between(0.72, 0.92)
    board, frame = (
        v.pick((p.wood(v), p.metal(v), p.paint(v, p.PALE), p.paint(v)), (p.wood(v), p.paint(v), f.MARBLE)),
        v.pick((p.metal(v), p.wood(v)), (p.metal(v), p.paint(v))),
    )
    tiers, rim = v.pick((2, 3), (3, 2)), v.pick((0.0, 0.03, 0.025), (0.05, 0.015))
    kind = v.pick(("posts", "posts"), ("round", "arch"))
    bottom = v.between(0.14, 0.24)
    heights = [bottom + (h - bottom) * k / (tiers - 1) for k in range(tiers)]
    castors(d, w, dep, 0.035 if kind == "posts" else 0.045)
    if kind == "posts":
        legs(d, w, dep, h - 0.001, 0.025, frame, 0.055)
    else:
        for x in (-w / 2 + 0.014, w / 2 - 0.014):
            for y in (-dep / 2 + 0.014, dep / 2 - 0.014):
                d.tube([(x, y, 0.05), (x, y, h + (0.0 if kind == "round" else 0.06))], 0.014, frame, 8)
            if kind == "arch":
                d.tube(
                    [(x, -dep / 2 + 0.014, h + 0.06), (x, 0, h + 0.1), (x, dep / 2 - 0.014, h + 0.06)], 0.012, frame, 8
                )
    for height in heights:
        d.box((-w / 2, -dep / 2, height - 0.02), (w / 2, dep / 2, height), board)
        if rim and not (kind == "arch" and height == h):
            for x in (-w / 2, w / 2 - 0.01):
                d.box((x, -dep / 2, height), (x + 0.01, dep / 2, height + rim), frame)
            for y in (-dep / 2, dep / 2 - 0.01):
                d.box((-w / 2, y, height), (w / 2, y + 0.01, height + rim), frame)
    if kind != "arch" and v.pick((True, True, False), (True,)):
        z, x = h - 0.03, w / 2
        d.tube(
            [
                (x, -dep / 2 + 0.05, z),
                (x + 0.07, -dep / 2 + 0.05, z + 0.04),
                (x + 0.07, dep / 2 - 0.05, z + 0.04),
                (x, dep / 2 - 0.05, z),
            ],
            0.011,
            f.STEEL,
        )


def bench(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.9, 1.5), v.between(0.32, 0.46), v.between(0.42, 0.5)
    seat, frame = timber(v), v.pick((timber(v), p.metal(v)), (p.metal(v), timber(v)))
    kind = v.pick(("legs", "slab", "legs"), ("trestle", "hairpin"))
    cushion = v.pick((False, True), (True, False))
    top = h - (0.06 if cushion else 0.0)
    if kind == "legs":
        legs(d, w, dep, top - 0.03, 0.045, frame)
    elif kind == "slab":
        for x in (-w / 2, w / 2 - 0.035):
            d.box((x, -dep / 2, 0), (x + 0.035, dep / 2, top - 0.03), frame)
    else:
        for x in (-w / 2 + 0.12, w / 2 - 0.12):
            for side in (-1, 1):
                if kind == "hairpin":
                    d.tube(
                        [
                            (x - 0.05, side * 0.35 * dep, top - 0.03),
                            (x, side * 0.46 * dep, 0),
                            (x + 0.05, side * 0.35 * dep, top - 0.03),
                        ],
                        0.007,
                        frame,
                        6,
                    )
                else:
                    d.tube([(x, side * 0.1 * dep, top - 0.03), (x, side * 0.45 * dep, 0)], 0.022, frame, 6)
        if kind == "trestle":
            d.box((-w / 2 + 0.12, -0.02, 0.4 * h), (w / 2 - 0.12, 0.02, 0.4 * h + 0.05), frame)
    slats = v.pick((1, 1), (4, 1))
    for k in range(slats):
        y0, y1 = -dep / 2 + dep * k / slats, -dep / 2 + dep * (k + 1) / slats
        d.box((-w / 2, y0 + 0.004 * (slats > 1), top - 0.035), (w / 2, y1 - 0.004 * (slats > 1), top), seat)
    if cushion:
        d.box((-w / 2 + 0.01, -dep / 2 + 0.01, top), (w / 2 - 0.01, dep / 2 - 0.01, h), p.cloth(v))
    if v.pick((False, True), (True, False)) and kind in ("legs", "slab"):
        d.box((-w / 2 + 0.04, -dep / 2 + 0.02, 0.12), (w / 2 - 0.04, dep / 2 - 0.02, 0.14), seat)


def stool(d: Drawing, v: Variation) -> None:
    r, h = v.between(0.16, 0.21), v.between(0.4, 0.76)
    seat, frame = (
        v.pick((timber(v), p.leather(v), p.paint(v)), (p.cloth(v), timber(v))),
        v.pick((p.wood(v), p.metal(v)), (p.metal(v), p.wood(v))),
    )
    kind, sides = v.pick(("splayed", "straight", "splayed"), ("pedestal", "three")), v.pick((20, 20, 4), (20, 6))
    thick = v.between(0.03, 0.07)
    part = Drawing()
    part.lathe(
        [(0, h - thick), (0.96 * r, h - thick), (r, h - 0.3 * thick), (0.97 * r, h), (0, h)], seat, segments=sides
    )
    d.place(part, turn=(0, 0, 45 if sides == 4 else 0))
    if kind == "pedestal":
        d.lathe([(0, 0), (0.95 * r, 0), (0.9 * r, 0.02), (0.03, 0.045), (0.03, h - thick), (0, h - thick)], frame)
        return
    count = 3 if kind == "three" else 4
    near, far = (0.55, 0.95) if kind != "straight" else (0.72, 0.76)
    for k in range(count):
        a = math.pi / 4 + 2 * k * math.pi / count
        d.tube(
            [
                (far * r * math.cos(a), far * r * math.sin(a), 0),
                (near * r * math.cos(a), near * r * math.sin(a), h - thick),
            ],
            [0.014, 0.019],
            frame,
        )
    if v.pick((True, False), (True, True, False)) or h > 0.6:
        z, q = 0.32 * h, (far - (far - near) * 0.32) * r
        ring = [(q * math.cos(a), q * math.sin(a), z) for a in np.arange(count + 1) * 2 * math.pi / count + math.pi / 4]
        d.tube(ring, 0.009, frame, 6)


def stand(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.36, 0.55), v.between(0.34, 0.5), v.between(0.45, 0.78)
    body, leg = timber(v), v.pick((p.wood(v), p.metal(v)), (p.metal(v), p.wood(v)))
    kind = v.pick(("drawer", "open", "cube"), ("round", "cross", "box"))
    if kind == "round":
        d.lathe([(0, h - 0.025), (0.5 * w, h - 0.025), (0.5 * w, h), (0, h)], body, segments=28)
        for k in range(3):
            a = 2 * math.pi * k / 3 + 0.5
            d.tube(
                [
                    (0.46 * w * math.cos(a), 0.46 * w * math.sin(a), 0),
                    (0.2 * w * math.cos(a), 0.2 * w * math.sin(a), h - 0.025),
                ],
                [0.012, 0.018],
                leg,
                8,
            )
        d.lathe([(0, 0.3 * h), (0.3 * w, 0.3 * h), (0.3 * w, 0.3 * h + 0.015), (0, 0.3 * h + 0.015)], body, segments=28)
        return
    d.box((-w / 2, -dep / 2, h - 0.024), (w / 2, dep / 2, h), body)
    if kind == "cross":
        for y in (-dep / 2 + 0.03, dep / 2 - 0.03):
            d.tube([(-w / 2 + 0.03, y, 0), (w / 2 - 0.03, y, h - 0.024)], 0.016, leg, 8)
            d.tube([(w / 2 - 0.03, y, 0), (-w / 2 + 0.03, y, h - 0.024)], 0.016, leg, 8)
        return
    if kind in ("cube", "box"):
        for x in (-w / 2, w / 2 - 0.02):
            d.box((x, -dep / 2, 0.06), (x + 0.02, dep / 2, h - 0.024), body)
        d.box((-w / 2, -dep / 2, 0.06), (w / 2, dep / 2, 0.08), body)
        plinth(d, v, w, dep, 0.06, body)
        if kind == "box":
            d.box((-w / 2 + 0.02, -dep / 2 + 0.02, 0.08), (w / 2 - 0.02, dep / 2, h - 0.024), body)
            fronts(d, v, (-w / 2 + 0.02, w / 2 - 0.02), (0.085, h - 0.03), -dep / 2 + 0.02, 2, 1, body, p.metal(v))
        else:
            d.box((-w / 2 + 0.02, dep / 2 - 0.012, 0.08), (w / 2 - 0.02, dep / 2, h - 0.024), body)
        return
    legs(d, w - 0.02, dep - 0.02, h - 0.024, 0.034, leg)
    if kind == "drawer":
        d.box((-w / 2 + 0.012, -dep / 2 + 0.02, h - 0.17), (w / 2 - 0.012, dep / 2 - 0.01, h - 0.024), body)
        panel(d, (-w / 2 + 0.03, w / 2 - 0.03), (h - 0.168, h - 0.026), -dep / 2 + 0.02, body, p.metal(v), "knob")
    d.box((-w / 2 + 0.014, -dep / 2 + 0.014, 0.13), (w / 2 - 0.014, dep / 2 - 0.014, 0.15), body)


def bed(d: Drawing, v: Variation) -> None:
    w, length, h = v.pick((0.95, 1.4, 1.6), (1.2, 1.8)), v.between(2.0, 2.14), v.between(0.42, 0.58)
    frame, blanket, pillow = v.pick((timber(v), p.cloth(v)), (timber(v), p.leather(v))), p.cloth(v), p.paint(v, p.PALE)
    low, head = v.pick((0.06, 0.12), (0.2, 0.02)), v.between(0.8, 1.15)
    d.box((-w / 2, -length / 2, low), (w / 2, length / 2, h - 0.2), frame)
    legs(d, w - 0.06, length - 0.06, low, 0.06, frame)
    d.box((-w / 2 + 0.02, -length / 2 + 0.02, h - 0.2), (w / 2 - 0.02, length / 2 - 0.01, h - 0.02), f.WHITE)
    d.box((-w / 2 + 0.004, -length / 2 + 0.004, h - 0.17), (w / 2 - 0.004, length / 2 - 0.55, h), blanket)
    kind = v.pick(("board", "posts"), ("slats", "padded"))
    y = length / 2
    if kind in ("board", "padded"):
        d.box((-w / 2, y, low), (w / 2, y + 0.05, head), frame)
        if kind == "padded":
            for k in range(4):
                x = -w / 2 + w * (k + 0.5) / 4
                d.soft_block(
                    (x, y - 0.005, 0.5 * (h + head) + 0.08), (0.96 * w / 4, 0.09, head - h - 0.04), 0.3, frame, 6
                )
    else:
        for x in (-w / 2, w / 2 - 0.05):
            d.box((x, y, 0), (x + 0.05, y + 0.05, head + 0.06), frame)
        d.box((-w / 2, y + 0.01, head - 0.06), (w / 2, y + 0.04, head), frame)
        for k in range(9 if kind == "slats" else 3):
            n = 9 if kind == "slats" else 3
            if kind == "slats":
                x = -w / 2 + 0.1 + (w - 0.2) * k / (n - 1)
                d.box((x - 0.018, y + 0.015, h - 0.2), (x + 0.018, y + 0.035, head - 0.06), frame)
            else:
                z = h + (head - h) * k / n
                d.box((-w / 2 + 0.05, y + 0.015, z), (w / 2 - 0.05, y + 0.035, z + 0.06), frame)
    count = 2 if w > 1.15 else 1
    for k in range(count):
        d.soft_block(
            ((k - (count - 1) / 2) * w / 2, length / 2 - 0.27, h + 0.03),
            (min(0.62, 0.46 * w * (3 - count)), 0.4, 0.13),
            0.5,
            pillow,
            8,
        )


FAMILIES = (
    receptacle("serving_cart", "serving cart", serving_cart, 60, 9, 6, boxes=20),
    receptacle("bench", "bench", bench, 90, 10, 5),
    receptacle("stool", "stool", stool, 50, 5, 3),
    receptacle("stand", "stand", stand, 100, 5, 3),
    receptacle("bed", "bed", bed, 35, 5, 2),
)
