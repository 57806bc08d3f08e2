"""Families of shelves, racks, trunks and hampers; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.boards import legs
from assets_build.families.timber import receptacle, timber
from assets_build.primitives import Drawing
from assets_build.variation import Variation


def shelves(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.6, 1.35), v.between(0.28, 0.4), v.between(0.75, 1.85)
    body, t = timber(v), v.between(0.016, 0.03)
    boards = max(3, round(h / v.between(0.32, 0.42)) + 1)
    kind = v.pick(("sides", "posts"), ("ladder", "split"))
    inset = t if kind in ("sides", "split") else 0.0
    if kind == "posts":
        legs(d, w, dep, h, 0.03, p.metal(v))
    elif kind == "ladder":
        metal = p.metal(v)
        for x in (-w / 2 + 0.01, w / 2 - 0.01):
            for y in (-dep / 2 + 0.012, dep / 2 - 0.012):
                d.tube([(x, y, 0), (x, y, h + 0.03)], 0.012, metal, 8)
            d.tube([(x, -dep / 2 + 0.012, h + 0.03), (x, dep / 2 - 0.012, h + 0.03)], 0.012, metal, 8)
            d.tube([(x, -dep / 2 + 0.012, 0.1), (x, dep / 2 - 0.012, 0.4 * h)], 0.006, metal, 6)
    else:
        for x in (-w / 2, w / 2 - t):
            d.box((x, -dep / 2, 0), (x + t, dep / 2, h), body)
    if v.pick((True, False), (False, True)):
        d.box((-w / 2 + inset, dep / 2 - 0.01, 0.04), (w / 2 - inset, dep / 2, h), body)
    for k in range(boards):
        z = 0.07 + (h - 0.07) * k / (boards - 1)
        d.box((-w / 2 + inset, -dep / 2, z - t), (w / 2 - inset, dep / 2 - 0.01, z), body)
        if kind == "split" and k:
            below = 0.07 + (h - 0.07) * (k - 1) / (boards - 1)
            x = (0.15 if k % 2 else -0.15) * w
            d.box((x - t / 2, -dep / 2 + 0.01, below), (x + t / 2, dep / 2 - 0.01, z - t), body)


def shoe_rack(d: Drawing, v: Variation) -> None:
    w, dep, tiers, gap = v.between(0.5, 1.05), v.between(0.26, 0.36), v.pick((3, 2, 4), (3, 4)), v.between(0.17, 0.24)
    body, metal = timber(v), p.metal(v)
    kind = v.pick(("slats", "rods", "bench"), ("boards", "arched"))
    h = 0.1 + gap * (tiers - 1) + (0.25 if kind in ("bench", "boards") else 0.06)
    if kind in ("slats", "bench", "boards"):
        for x in (-w / 2, w / 2 - 0.02):
            d.box((x, -dep / 2, 0), (x + 0.02, dep / 2, h), body)
    elif kind == "rods":
        legs(d, w, dep, h, 0.02, metal)
    else:
        for x in (-w / 2 + 0.01, w / 2 - 0.01):
            d.tube(
                [
                    (x, -dep / 2 + 0.012, 0),
                    (x, -dep / 2 + 0.012, h - 0.05),
                    (x, -dep / 2 + 0.06, h),
                    (x, dep / 2 - 0.06, h),
                    (x, dep / 2 - 0.012, h - 0.05),
                    (x, dep / 2 - 0.012, 0),
                ],
                0.011,
                body,
                8,
            )
    for tier in range(tiers):
        z = 0.1 + gap * tier
        if kind == "boards":
            d.box((-w / 2 + 0.02, -dep / 2 + 0.01, z - 0.016), (w / 2 - 0.02, dep / 2, z), body)
            d.box((-w / 2 + 0.02, -dep / 2 + 0.01, z), (w / 2 - 0.02, -dep / 2 + 0.02, z + 0.02), metal)
            continue
        count = {"rods": 8, "arched": 9}.get(kind, 6)
        for k in range(count):
            y = -dep / 2 + 0.025 + (dep - 0.05) * k / (count - 1)
            if kind in ("rods", "arched"):
                d.tube([(-w / 2 + 0.005, y, z - 0.012), (w / 2 - 0.005, y, z - 0.012)], 0.012, metal, 6)
            else:
                d.box((-w / 2 + 0.02, y - 0.022, z - 0.014), (w / 2 - 0.02, y + 0.022, z), body)
    if kind in ("bench", "boards"):
        d.box((-w / 2, -dep / 2, h - 0.025), (w / 2, dep / 2, h), body)
        if v.pick((True, False), (False, True)):
            d.soft_block((0, 0, h + 0.02), (0.98 * w, 0.98 * dep, 0.05), 0.2, p.cloth(v), 6)


def trunk(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.7, 1.1), v.between(0.4, 0.52), v.between(0.38, 0.54)
    body = v.pick(
        (p.wood(v), f.wicker((0.7, 0.55, 0.35)), p.leather(v), p.paint(v)), (p.wood(v), p.leather(v), p.paint(v))
    )
    trim, seam = p.metal(v) if v.pick((True, False), (False, True)) else p.wood(v), v.between(0.62, 0.78) * h
    over = v.pick((0.006, 0.0), (0.018, 0.004))
    low = v.pick((0.0, 0.0), (0.05, 0.03))
    d.box((-w / 2, -dep / 2, low), (w / 2, dep / 2, seam - 0.004), body)
    if low:
        legs(d, w, dep, low, 0.07, trim)
    bevel = v.pick((0.0, 0.0), (0.05, 0.08))
    if bevel:
        part = Drawing()
        rise = h - seam
        part.prism(
            [
                (-dep / 2 - over, 0),
                (dep / 2 + over, 0),
                (dep / 2 + over, 0.45 * rise),
                (dep / 2 - bevel, rise),
                (-dep / 2 + bevel, rise),
                (-dep / 2 - over, 0.45 * rise),
            ],
            -w / 2 - over,
            w / 2 + over,
            body,
        )
        d.place(part, (0, 0, seam), (90, 0, 90))
    else:
        d.box((-w / 2 - over, -dep / 2 - over, seam), (w / 2 + over, dep / 2 + over, h), body)
    count = v.pick((2, 3, 0), (4, 1))
    for k in range(count):
        x = -w / 2 + w * (k + 0.5) / count
        d.box((x - 0.022, -dep / 2 - 0.01, low), (x + 0.022, -dep / 2, seam - 0.004), trim)
        d.box((x - 0.022, -dep / 2 - over - 0.008, seam), (x + 0.022, -dep / 2, seam + 0.45 * (h - seam)), trim)
    if v.pick((False, True), (True,)):
        for x in (-w / 2 - 0.008, w / 2 - 0.03):
            d.box((x, -dep / 2 - 0.008, low), (x + 0.038, -dep / 2 + 0.03, seam - 0.004), trim)
    d.box((-0.04, -dep / 2 - 0.02, seam - 0.07), (0.04, -dep / 2, seam + 0.03), f.BRASS)
    for side in (-1, 1):
        d.tube(
            [
                (side * (w / 2 + 0.002), -0.07, 0.5 * h),
                (side * (w / 2 + 0.03), -0.05, 0.5 * h),
                (side * (w / 2 + 0.03), 0.05, 0.5 * h),
                (side * (w / 2 + 0.002), 0.07, 0.5 * h),
            ],
            0.01,
            trim,
            6,
        )


def hamper(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.36, 0.54), v.between(0.32, 0.42), v.between(0.46, 0.68)
    weave = v.pick(
        ((0.76, 0.60, 0.38), (0.45, 0.31, 0.20), (0.92, 0.90, 0.86)),
        ((0.62, 0.42, 0.28), (0.34, 0.36, 0.38), (0.84, 0.74, 0.58)),
    )
    body = v.pick((f.wicker(weave), f.wicker(weave), p.cloth(v)), (f.wicker(weave), p.cloth(v)))
    lid, laundry = v.pick((f.wicker(weave), p.wood(v)), (p.wood(v), p.cloth(v))), f.cloth(v.pick(*p.PALE))
    power, taper = v.pick((0.15, 1.0), (0.4, 0.7)), v.pick((0.95, 0.85), (1.0, 0.75))
    if v.pick((False, False, True), (False, True)):
        rings = [
            (0.0, 0.5 * taper * w, 0.5 * taper * dep),
            (h, 0.5 * w, 0.5 * dep),
            (h, 0.5 * w - 0.015, 0.5 * dep - 0.015),
            (h - 0.09, 0.49 * w - 0.015, 0.49 * dep - 0.015),
        ]
        d.loft([(z, x, y, power, 0, 0) for z, x, y in rings], body, 24)
        d.loft(
            [
                (h - 0.1, 0.49 * w - 0.015, 0.49 * dep - 0.015, power, 0, 0),
                (h - 0.085, 0.49 * w - 0.015, 0.49 * dep - 0.015, power, 0, 0),
            ],
            laundry,
            24,
        )
    else:
        d.loft(
            [(0, 0.5 * taper * w, 0.5 * taper * dep, power, 0, 0), (h - 0.04, 0.5 * w, 0.5 * dep, power, 0, 0)],
            body,
            24,
        )
        d.loft(
            [
                (h - 0.04, 0.5 * w + 0.01, 0.5 * dep + 0.01, power, 0, 0),
                (h, 0.5 * w + 0.01, 0.5 * dep + 0.01, power, 0, 0),
            ],
            lid,
            24,
        )
    for side in (-1, 1):
        d.tube(
            [
                (side * 0.48 * w, -0.05, 0.76 * h),
                (side * 0.53 * w, -0.03, 0.79 * h),
                (side * 0.53 * w, 0.03, 0.79 * h),
                (side * 0.48 * w, 0.05, 0.76 * h),
            ],
            0.01,
            p.wood(v),
            6,
        )
    if v.pick((False,), (True, False)):
        d.loft(
            [
                (
                    0.3 * h,
                    0.5 * w * (taper + 0.3 * (1 - taper)) + 0.004,
                    0.5 * dep * (taper + 0.3 * (1 - taper)) + 0.004,
                    power,
                    0,
                    0,
                ),
                (
                    0.36 * h,
                    0.5 * w * (taper + 0.36 * (1 - taper)) + 0.004,
                    0.5 * dep * (taper + 0.36 * (1 - taper)) + 0.004,
                    power,
                    0,
                    0,
                ),
            ],
            p.paint(v),
            24,
        )


FAMILIES = (
    receptacle("shelves", "shelves", shelves, 70, 6, 4, boxes=16),
    receptacle("shoe_rack", "shoe rack", shoe_rack, 60, 9, 6, boxes=18),
    receptacle("trunk", "chest", trunk, 90, 9, 5),
    receptacle("hamper", "laundry hamper", hamper, 30, 9, 6),
)
