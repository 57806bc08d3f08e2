"""Families of what stands in kitchens and bathrooms; sizes in m."""

import math

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.boards import legs, panel
from assets_build.families.timber import receptacle, timber
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def counter(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.8, 1.9), v.between(0.58, 0.68), v.between(0.86, 0.95)
    body = timber(v)
    face = v.pick((body, timber(v)), (timber(v),))
    top = v.pick((f.MARBLE, f.GRANITE, p.wood(v)), (p.wood(v), p.speckle(v, 0.04), f.STEEL))
    thick, front = v.pick((0.03, 0.04), (0.06, 0.02)), -dep / 2 + 0.04
    d.box((-w / 2 + 0.01, front + 0.05, 0.0), (w / 2 - 0.01, dep / 2, 0.1), f.DARK_STEEL)
    d.box((-w / 2 + 0.005, front, 0.1), (w / 2 - 0.005, dep / 2, h - thick), body)
    d.box((-w / 2, -dep / 2, h - thick), (w / 2, dep / 2, h), top)
    count, metal = max(2, round(w / 0.55)), p.metal(v)
    layout = v.pick(("doors", "both", "both"), ("drawers", "mixed"))
    for k in range(count):
        x = -w / 2 + 0.005 + (w - 0.01) * k / count, -w / 2 + 0.005 + (w - 0.01) * (k + 1) / count
        if layout == "drawers" or (layout == "mixed" and k == 0):
            for row in range(3):
                z = 0.1 + (h - thick - 0.105) * row / 3, 0.1 + (h - thick - 0.105) * (row + 1) / 3
                panel(d, x, z, front, face, metal)
            continue
        split = h - thick - 0.18 if layout in ("both", "mixed") else h - thick - 0.004
        panel(d, x, (0.1, split), front, face, metal, "right" if k % 2 == 0 else "left")
        if layout in ("both", "mixed"):
            panel(d, x, (split, h - thick - 0.004), front, face, metal)


def washer(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.55, 0.66), v.between(0.52, 0.64), v.between(0.82, 0.96)
    body, door, strip = (
        v.pick(
            (f.WHITE, p.paint(v, p.PALE), p.paint(v, p.DARK), f.GREY_PAINT),
            (p.paint(v, p.CERAMIC), p.metal(v), p.paint(v, p.CERAMIC)),
        ),
        p.paint(v, p.DARK),
        v.pick((f.WHITE, p.paint(v, p.PALE), f.BLACK), (p.paint(v, p.DARK), p.paint(v, p.PALE))),
    )
    d.box((-w / 2, -dep / 2 + 0.02, 0.02), (w / 2, dep / 2, h), body)
    d.box((-w / 2 + 0.02, -dep / 2 + 0.04, 0), (w / 2 - 0.02, dep / 2 - 0.02, 0.02), f.BLACK)
    y = -dep / 2 + 0.02
    if v.pick((False, False, False, True), (False, False, True)):
        d.box((-w / 2, dep / 2 - 0.1, h), (w / 2, dep / 2, h + 0.14), strip)
        d.box((-w / 2 + 0.06, -dep / 2 + 0.05, h), (w / 2 - 0.06, dep / 2 - 0.13, h + 0.012), door)
        for k in range(3):
            d.tube(
                [(-0.15 + 0.12 * k, dep / 2 - 0.1, h + 0.07), (-0.15 + 0.12 * k, dep / 2 - 0.12, h + 0.07)],
                0.022,
                f.STEEL,
                12,
            )
        return
    d.box((-w / 2, -dep / 2, h - 0.13), (w / 2, -dep / 2 + 0.02, h), strip)
    r, at = v.between(0.16, 0.23), v.pick((0.42, 0.45), (0.5, 0.38)) * h / 0.85
    sides = v.pick((28, 28), (10, 28))
    for radius, depth, finish in (
        (1.0, 0.03, v.pick((f.STEEL, body), (p.metal(v), strip))),
        (0.8, 0.04, door),
        (0.45, 0.044, Finish((0.4, 0.5, 0.55))),
    ):
        d.tube([(0, y, at), (0, y - depth, at)], radius * r, finish, sides)
    knob = v.pick((0.14, -0.02), (-0.18, 0.2))
    d.tube([(knob, -dep / 2, h - 0.065), (knob, -dep / 2 - 0.02, h - 0.065)], 0.03, f.STEEL, 12)
    d.box((-w / 2 + 0.03, -dep / 2 - 0.003, h - 0.1), (-w / 2 + 0.17, -dep / 2, h - 0.03), body)
    d.box(
        (knob + 0.06 if knob < 0.1 else knob - 0.14, -dep / 2 - 0.003, h - 0.085),
        (knob + 0.14 if knob < 0.1 else knob - 0.06, -dep / 2, h - 0.045),
        f.BLACK,
    )


def toilet(d: Drawing, v: Variation) -> None:
    body, lid = p.paint(v, p.CERAMIC), v.pick((f.WHITE, p.paint(v, p.CERAMIC)), (p.wood(v), p.paint(v, p.DARK)))
    h, long, wide = v.between(0.38, 0.44), v.between(0.44, 0.54), v.between(0.34, 0.4)
    power = v.pick((1.0, 0.8), (0.3, 0.55))
    y = -0.12
    foot = v.pick((0.62, 0.5), (0.85, 0.7))
    d.loft(
        [
            (0, 0.5 * foot * wide, 0.5 * foot * long + 0.05, power, 0, y + 0.08),
            (0.4 * h, 0.45 * foot * wide, 0.45 * foot * long + 0.05, power, 0, y + 0.08),
            (0.8 * h, 0.47 * wide, 0.48 * long, power, 0, y),
            (h, 0.5 * wide, 0.5 * long, power, 0, y),
        ],
        body,
        24,
    )
    d.loft([(h, 0.51 * wide, 0.51 * long, power, 0, y), (h + 0.03, 0.5 * wide, 0.5 * long, power, 0, y)], lid, 24)
    back = y + 0.5 * long - 0.06
    d.box((-0.42 * wide, back - 0.1, 0), (0.42 * wide, back + 0.12, h), body)
    tall, tank = v.between(0.3, 0.4), v.between(0.15, 0.19)
    d.loft(
        [
            (h, 0.2, tank / 2, 0.2, 0, back + 0.03 + tank / 2),
            (h + tall, 0.21, tank / 2, 0.2, 0, back + 0.03 + tank / 2),
        ],
        body,
        20,
    )
    d.loft(
        [
            (h + tall, 0.22, tank / 2 + 0.01, 0.2, 0, back + 0.03 + tank / 2),
            (h + tall + 0.025, 0.215, tank / 2 + 0.01, 0.2, 0, back + 0.03 + tank / 2),
        ],
        body,
        20,
    )
    d.tube(
        [(0, back + 0.03 + tank / 2, h + tall + 0.02), (0, back + 0.03 + tank / 2, h + tall + 0.034)],
        0.022,
        p.metal(v),
        12,
    )


def basin(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.52, 0.95), v.between(0.44, 0.54), v.between(0.8, 0.9)
    ceramic, metal = p.paint(v, p.CERAMIC), p.metal(v)
    kind = v.pick(("cabinet", "pedestal", "cabinet"), ("legs", "open"))
    rim, depth, low = 0.05, 0.12, h - 0.16
    if kind == "pedestal":
        d.lathe([(0, 0), (0.13, 0), (0.08, 0.08), (0.08, low - 0.05), (0.14, low), (0, low)], ceramic, (0, 0.04))
    elif kind == "cabinet":
        body = timber(v)
        d.box((-w / 2 + 0.02, -dep / 2 + 0.03, 0), (w / 2 - 0.02, dep / 2, low), body)
        panel(d, (-w / 2 + 0.02, 0.0), (0.04, low), -dep / 2 + 0.03, body, metal, "right")
        panel(d, (0.0, w / 2 - 0.02), (0.04, low), -dep / 2 + 0.03, body, metal, "left")
    else:
        body = timber(v) if kind == "open" else p.metal(v)
        legs(d, w - 0.04, dep - 0.04, low, 0.035, body)
        d.box((-w / 2 + 0.03, -dep / 2 + 0.03, 0.22), (w / 2 - 0.03, dep / 2 - 0.03, 0.24), body)
    d.box((-w / 2, -dep / 2, low), (w / 2, dep / 2, h - depth), ceramic)
    for x in (-w / 2, w / 2 - rim):
        d.box((x, -dep / 2, h - depth), (x + rim, dep / 2, h), ceramic)
    d.box((-w / 2 + rim, -dep / 2, h - depth), (w / 2 - rim, -dep / 2 + rim, h), ceramic)
    d.box((-w / 2 + rim, dep / 2 - 2.2 * rim, h - depth), (w / 2 - rim, dep / 2, h), ceramic)
    y, reach, rise = dep / 2 - rim, v.between(0.08, 0.14), v.between(0.08, 0.2)
    arc = [
        (0, y - reach / 2 + reach / 2 * math.cos(a), h + rise + reach / 2 * math.sin(a)) for a in (0.8, 1.6, 2.4, 3.0)
    ]
    d.tube([(0, y, h), (0, y, h + rise), *arc], 0.012, metal)
    for side in (-1, 1) if v.pick((True, False), (True, False)) else ():
        d.lathe([(0.016, h), (0.02, h + 0.04), (0, h + 0.045)], metal, (0.09 * side, y), 10)


def bathtub(d: Drawing, v: Variation) -> None:
    w, length, h = v.between(0.7, 0.84), v.between(1.5, 1.8), v.between(0.5, 0.6)
    outside, white = v.pick((f.WHITE, p.paint(v, p.CERAMIC)), (p.paint(v), p.wood(v))), p.paint(v, p.CERAMIC)
    power, wall = v.pick((0.12, 0.5), (0.3, 0.9)), 0.06
    floor = 0.14
    taper = v.pick((1.0, 0.85), (0.92, 0.78))
    d.shell(
        [
            (0, 0, 0, power, 0, 0),
            (0, 0.5 * taper * w, 0.5 * taper * length, power, 0, 0),
            (h - 0.03, 0.5 * w - 0.02, 0.5 * length - 0.02, power, 0, 0),
        ],
        outside,
        28,
    )
    d.shell(
        [
            (h - 0.03, 0.5 * w - 0.02, 0.5 * length - 0.02, power, 0, 0),
            (h - 0.03, 0.5 * w, 0.5 * length, power, 0, 0),
            (h, 0.5 * w, 0.5 * length, power, 0, 0),
            (h, 0.5 * w - wall, 0.5 * length - wall, power, 0, 0),
            (floor, 0.42 * taper * w - wall + 0.02, 0.45 * length - wall, power, 0, 0),
            (floor, 0, 0, power, 0, 0),
        ],
        white,
        28,
    )
    metal, side = p.metal(v), v.pick((-1, 1), (1, -1))
    y = side * (length / 2 - 0.03)
    d.tube([(0, y, h), (0, y, h + 0.12), (0, y - side * 0.06, h + 0.14), (0, y - side * 0.12, h + 0.1)], 0.013, metal)
    for x in (-0.09, 0.09):
        d.lathe([(0.018, h), (0.02, h + 0.05), (0, h + 0.055)], metal, (x, y), 10)


FAMILIES = (
    receptacle("counter", "kitchen counter", counter, 110, 8, 5),
    receptacle("washer_dryer", "washing machine", washer, 190, 10, 5),
    receptacle("toilet", "toilet", toilet, 110, 5, 3),
    receptacle("sink", "washbasin", basin, 90, 5, 3),
    receptacle("bathtub", "bathtub", bathtub, 70, 5, 3, boxes=18),
)
