"""Families of chests of drawers, cabinets and wardrobes; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.boards import carcass, castors, panel
from assets_build.families.timber import fronts, plinth, receptacle, timber
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def chest_of_drawers(d: Drawing, v: Variation) -> None:
    w, dep, h, low = v.between(0.6, 1.5), v.between(0.38, 0.52), v.between(0.7, 1.05), v.between(0.05, 0.16)
    body = timber(v)
    face = body if v.pick((True, False), (False, True)) else timber(v)
    over = v.pick((0.008, 0.0), (0.025, -0.006))
    front = -dep / 2 + 0.018
    d.box((-w / 2, front, low), (w / 2, dep / 2, h - 0.022), body)
    d.box((-w / 2 - over, -dep / 2 - max(over, 0) / 2, h - 0.022), (w / 2 + over, dep / 2, h), body)
    plinth(d, v, w, dep, low, body)
    columns = 1 if w < 0.85 else 2 if w < 1.25 else v.pick((2, 3), (3,))
    fronts(
        d,
        v,
        (-w / 2 + 0.01, w / 2 - 0.01),
        (low + 0.01, h - 0.03),
        front,
        v.pick((3, 4, 5), (3, 4)),
        columns,
        face,
        p.metal(v),
    )


def filing_cabinet(d: Drawing, v: Variation) -> None:
    wide = v.pick((False, False, True), (False, True))
    w, dep, h = v.between(0.75, 0.95) if wide else v.between(0.38, 0.48), v.between(0.45, 0.62), v.between(0.58, 1.04)
    body = v.pick(
        (p.paint(v, p.PALE), p.paint(v), p.paint(v, p.DARK), f.GREY_PAINT), (p.paint(v), p.paint(v, p.PALE), f.CHERRY)
    )
    knob, low = p.metal(v), v.pick((0.02, 0.02, 0.06), (0.05, 0.03))
    front = -dep / 2 + 0.02
    d.box((-w / 2, front, low), (w / 2, dep / 2, h), body)
    if low > 0.04:
        castors(d, w, dep, 0.03)
    else:
        d.box((-w / 2 + 0.02, -dep / 2 + 0.05, 0), (w / 2 - 0.02, dep / 2 - 0.02, low), f.BLACK)
    rows = 2 if h < 0.75 else v.pick((3, 2), (3,))
    handle = v.pick(("bar", "cup"), ("side", "recess"))
    for row in range(rows):
        z = low + 0.01 + (h - low - 0.02) * row / rows, low + 0.01 + (h - low - 0.02) * (row + 1) / rows
        d.box((-w / 2 + 0.012, -dep / 2, z[0] + 0.004), (w / 2 - 0.012, front, z[1] - 0.004), body)
        top = z[1] - 0.07
        if handle == "bar":
            d.box((-0.07, -dep / 2 - 0.025, top - 0.012), (0.07, -dep / 2, top + 0.004), knob)
        elif handle == "cup":
            d.soft_block((0, -dep / 2, top), (0.12, 0.03, 0.03), 0.8, knob, 6)
        elif handle == "side":
            d.box((w / 2 - 0.05, -dep / 2 - 0.02, z[0] + 0.04), (w / 2 - 0.035, -dep / 2, z[1] - 0.04), knob)
        else:
            d.box((-0.3 * w, -dep / 2 - 0.001, z[1] - 0.035), (0.3 * w, -dep / 2 + 0.004, z[1] - 0.012), f.BLACK)
        d.box((-0.04, -dep / 2 - 0.003, top - 0.065), (0.04, -dep / 2, top - 0.035), f.WHITE)


def cabinet(d: Drawing, v: Variation) -> None:
    w, dep, h, low = v.between(0.6, 1.6), v.between(0.34, 0.46), v.between(0.68, 1.02), v.between(0.06, 0.16)
    body, t = timber(v), 0.022
    face = v.pick((body, timber(v)), (timber(v), body))
    carcass(d, w, dep, low, h, body, t)
    plinth(d, v, w, dep, low, body)
    count = 2 if w < 0.9 else 3 if w < 1.3 else 4
    open_at = v.pick((-1, count // 2, 0), (count - 1, -1))
    slatted = v.pick((False,), (True, False))
    width = (w - 2 * t) / count
    for k in range(count):
        x0 = -w / 2 + t + k * width
        if k:
            d.box((x0 - 0.01, -dep / 2, low + t), (x0 + 0.01, dep / 2 - 0.011, h - t), body)
        if k == open_at:
            middle = (low + h) / 2
            d.box((x0, -dep / 2 + 0.01, middle - 0.01), (x0 + width, dep / 2 - 0.011, middle + 0.01), body)
            continue
        d.box((x0, -dep / 2 + 0.02, low + t), (x0 + width, dep / 2 - 0.011, h - t), body)
        panel(
            d, (x0, x0 + width), (low + t, h - t), -dep / 2 + 0.02, face, p.metal(v), "right" if k % 2 == 0 else "left"
        )
        if slatted:
            for row in range(9):
                z = low + 0.06 + (h - low - 0.12) * row / 8
                d.box((x0 + 0.07, -dep / 2 - 0.004, z), (x0 + width - 0.07, -dep / 2 + 0.004, z + 0.025), body)
        elif v.pick((True, False), (False, True)):
            d.box((x0 + 0.08, -dep / 2 - 0.003, low + 0.09), (x0 + width - 0.08, -dep / 2 + 0.003, h - 0.09), body)


def wardrobe(d: Drawing, v: Variation) -> None:
    w, dep, h, t = v.between(0.85, 1.6), v.between(0.5, 0.62), v.between(1.7, 2.0), 0.022
    body = timber(v)
    face = v.pick((body, timber(v)), (timber(v),))
    carcass(d, w, dep, 0.06, h, body, t)
    d.box((-w / 2 + 0.01, -dep / 2 + 0.03, 0), (w / 2 - 0.01, dep / 2, 0.06), body)
    left = v.pick((True, False), (False, True))
    split = v.between(-0.1, 0.1)
    opened, closed = ((-w / 2 + t, split - t / 2), (split + t / 2, w / 2 - t))
    if not left:
        opened, closed = closed, opened
    d.box((split - t / 2, -dep / 2, 0.08), (split + t / 2, dep / 2 - 0.01, h - t), body)
    boards = v.pick(((0.45, 0.85), (0.4, 0.75, 1.1), (0.55,)), ((0.62, 0.98), (0.34, 0.66, 1.0)))
    for z in boards:
        d.box((opened[0], -dep / 2 + 0.02, z - t), (opened[1], dep / 2 - 0.01, z), body)
    if v.pick((False,), (True, False)):
        fronts(d, v, opened, (0.085, boards[0] - t), -dep / 2 + 0.02, 2, 1, face, p.metal(v))
        d.box((opened[0], -dep / 2 + 0.02, 0.08), (opened[1], dep / 2 - 0.01, boards[0] - t), body)
    d.tube([(opened[0], 0, h - 0.12), (opened[1], 0, h - 0.12)], 0.014, f.STEEL)
    d.box((closed[0], -dep / 2 + 0.02, 0.082), (closed[1], dep / 2 - 0.01, h - t), body)
    mid = (closed[0] + closed[1]) / 2
    leaves = ((closed[0], mid), (mid, closed[1])) if w > 1.25 else (closed,)
    for k, x in enumerate(leaves):
        panel(d, x, (0.08, h - t), -dep / 2 + 0.02, face, p.metal(v), "left" if (k or left) else "right")
        if v.pick((False, True), (True, False)):
            d.box(
                (x[0] + 0.06, -dep / 2 - 0.003, 0.2),
                (x[1] - 0.06, -dep / 2 + 0.002, h - 0.2),
                Finish((0.74, 0.8, 0.83)) if v.pick((False,), (True, False)) else body,
            )
    if v.pick((False, True), (True, False)):
        d.box((-w / 2 - 0.03, -dep / 2 - 0.03, h), (w / 2 + 0.03, dep / 2, h + 0.04), body)


FAMILIES = (
    receptacle("chest_of_drawers", "chest of drawers", chest_of_drawers, 110, 9, 5),
    receptacle("filing_cabinet", "filing cabinet", filing_cabinet, 130, 9, 6),
    receptacle("cabinet", "cabinet", cabinet, 100, 9, 5),
    receptacle("wardrobe", "wardrobe", wardrobe, 80, 9, 6),
)
