"""Families of what lies in a bathroom; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def soap_bar(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.07, 0.1), v.between(0.045, 0.065), v.between(0.022, 0.036)
    soap = v.pick((p.paint(v, p.PALE), Finish((0.62, 0.8, 0.6))), (p.speckle(v, 0.08), p.paint(v, p.PALE)))
    power = v.pick((0.3, 0.45), (0.15, 1.0))
    if v.pick((False, True), (True, False)):
        d.loft(
            [
                (0, 0.5 * w, 0.5 * dep, 0.6, 0, 0),
                (0.014, 0.66 * w, 0.68 * dep, 0.6, 0, 0),
                (0.016, 0.66 * w, 0.68 * dep, 0.6, 0, 0),
                (0.006, 0.5 * w, 0.5 * dep, 0.6, 0, 0),
            ],
            p.paint(v),
        )
    base = 0.008
    d.soft_block((0, 0, base + h / 2), (w, dep, h), power, soap, 9)
    d.block((0, 0, base + h - 0.0012), (0.42 * w, 0.3 * dep, 0.0024), Finish((0.85, 0.85, 0.82)))


def sponge(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.085, 0.13), v.between(0.06, 0.09), v.between(0.026, 0.048)
    foam, pad = (
        p.speckle(v, 0.05),
        Finish(v.pick(((0.2, 0.42, 0.25), (0.3, 0.3, 0.32)), ((0.25, 0.3, 0.5), (0.6, 0.2, 0.2)))),
    )
    kind = v.pick(("block", "block"), ("round", "waist"))
    power = 1.0 if kind == "round" else 0.12
    mid = 0.8 if kind == "waist" else 1.0
    d.loft([(0, w / 2, dep / 2, power, 0, 0), (0.72 * h, w / 2, mid * dep / 2, power, 0, 0)], foam)
    d.loft([(0.72 * h, w / 2, mid * dep / 2, power, 0, 0), (h, w / 2, mid * dep / 2, power, 0, 0)], pad)


def roll(core: tuple[float, float], radius: tuple[float, float], h: tuple[float, float], kind: str):  # type: ignore[no-untyped-def]
    """Return the drawer of a roll that stands on its end: of paper, or of tape."""

    def draw(d: Drawing, v: Variation) -> None:
        c, r, tall = v.between(*core), v.between(*radius), v.between(*h)
        paper = (
            v.pick(
                (f.WHITE, f.speckled((0.95, 0.94, 0.92), 0.03)),
                (Finish((0.93, 0.88, 0.86)), Finish((0.86, 0.91, 0.94))),
            )
            if kind != "tape"
            else p.paint(v)
        )
        d.lathe([(c, 0), (r, 0), (r, tall), (c, tall)], paper, segments=24)
        d.lathe([(c, tall), (c, 0)], f.CARDBOARD, segments=24)
        if kind == "tape":
            d.lathe([(r - 0.004, tall + 0.0004), (c + 0.003, tall + 0.0004)], p.paint(v, p.PALE))
            return
        for share in v.pick((0.3, 0.5), (0.7, 0.2)), 0.75:
            d.lathe([(c + share * (r - c), tall + 0.0006), (c + share * (r - c) - 0.0012, tall + 0.0006)], f.GREY_PAINT)
        hang = v.pick((0.02, 0.05), (0.08, 0.0))
        if hang:
            d.box((r - 0.002, -hang, 0.001), (r + 0.0004, 0.0, tall - 0.001), paper)
        if kind == "towel" and v.pick((True, False), (True, False)):
            wood = p.wood(v)
            d.lathe([(0, -0.016), (1.12 * r, -0.016), (1.12 * r, 0), (0, 0)], wood)
            d.tube([(0, 0, 0), (0, 0, tall + 0.03)], 0.011, wood, 10)
            d.soft_block((0, 0, tall + 0.035), (0.03, 0.03, 0.03), 1.0, wood, 6)

    return draw


def comb(d: Drawing, v: Variation) -> None:
    half, w = v.between(0.07, 0.1), v.between(0.032, 0.046)
    body = v.pick((p.paint(v, p.DARK), p.paint(v), p.wood(v)), (p.paint(v), p.speckle(v, 0.15)))
    tail = v.pick((0.0, 0.35), (0.55, 0.2))
    start = -half + 2 * half * tail
    spine = v.pick((0.35, 0.42), (0.6, 0.28)) * w
    if tail:
        d.prism([(-half, -0.003), (start, -spine / 2), (start, spine / 2), (-half, 0.003)], 0, 0.004, body)
    d.prism([(start, -spine / 2), (half, -spine / 2), (half, spine / 2), (start, spine / 2)], 0, 0.005, body)
    count = v.pick((28, 22), (14, 34))
    for k in range(count):
        x = start + (half - start) * (k + 0.5) / count
        thick = 0.3 * (half - start) / count
        d.box((x - thick, spine / 2, 0.001), (x + thick, spine / 2 + w - spine, 0.004), body)


def brush(d: Drawing, v: Variation) -> None:
    half, w = v.between(0.095, 0.125), v.between(0.026, 0.04)
    body = v.pick((p.wood(v), p.paint(v), p.paint(v, p.DARK)), (p.paint(v), p.wood(v)))
    power, long = v.pick((1.0, 0.6), (0.25, 1.3)), v.pick((0.95, 1.05), (0.75, 1.25)) * half
    d.soft_block((0, half - long / 2, 0.011), (2 * w, long, 0.02), power, body, 8)
    d.tube(
        [(0, half - 0.9 * long, 0.01), (0, -0.3 * half, 0.01), (0, -0.9 * half, 0.01), (0, -half, 0.01)],
        [0.012, 0.008, 0.012, 0.008],
        body,
        8,
    )
    bristle, pad = v.pick((f.BLACK, f.CREAM), (p.paint(v),)), p.paint(v, p.DARK)
    d.soft_block((0, half - long / 2, 0.021), (1.6 * w, 0.84 * long, 0.006), power, pad, 7)
    rows = v.pick((7, 6), (5, 9))
    for row in range(rows):
        for column in (-1.5, -0.5, 0.5, 1.5):
            y = half - 0.14 * long - 0.72 * long * row / (rows - 1)
            d.block((0.36 * w * column, y, 0.03), (0.0032, 0.0032, 0.02), bristle)


def lipstick(d: Drawing, v: Variation) -> None:
    r, h = v.between(0.009, 0.0125), v.between(0.024, 0.034)
    base, ring, color = (
        p.paint(v, p.DARK),
        v.pick((f.BRASS, f.STEEL), (p.metal(v),)),
        Finish(v.pick(((0.7, 0.08, 0.15), (0.85, 0.3, 0.4)), ((0.45, 0.08, 0.18), (0.86, 0.45, 0.32)))),
    )
    sides = v.pick((16, 16), (4, 8))
    d.lathe([(0, 0), (r, 0), (r, h), (0, h)], base, segments=sides)
    d.lathe([(0.85 * r, h), (0.85 * r, 1.5 * h), (0, 1.5 * h)], ring, segments=sides)
    top = v.pick((2.2, 2.0), (1.8, 2.4)) * h
    d.loft(
        [
            (1.45 * h, 0.66 * r, 0.66 * r, 1, 0, 0),
            (0.82 * top, 0.66 * r, 0.66 * r, 1, 0, 0),
            (top, 0.2 * r, 0.5 * r, 1, 0.35 * r, 0),
        ],
        color,
        12,
    )


def toilet_brush(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.045, 0.058), v.between(0.1, 0.16)
    body = v.pick((p.paint(v, p.PALE), p.metal(v), p.paint(v)), (p.speckle(v), p.paint(v)))
    taper = v.pick((0.9, 1.0), (0.7, 1.15))
    d.lathe(
        [(0, 0), (radius, 0), (taper * radius, h), (0.3 * radius, h + 0.01), (0, h + 0.01)],
        body,
        segments=v.pick((24, 4), (6, 24)),
    )
    top = v.between(0.36, 0.44)
    d.tube([(0, 0, h), (0, 0, top)], 0.007, p.metal(v), 8)
    d.soft_block((0, 0, top), v.pick(((0.025, 0.025, 0.05), (0.03, 0.03, 0.03)), ((0.04, 0.015, 0.04),)), 0.9, body, 8)


FAMILIES = (
    Family("soap_bar", "bar of soap", soap_bar, 500),
    Family("sponge", "sponge", sponge, 80),
    Family("toilet_paper", "toilet paper", roll((0.018, 0.022), (0.048, 0.062), (0.09, 0.11), "paper"), 100),
    Family("paper_towel", "paper towel", roll((0.018, 0.024), (0.048, 0.062), (0.2, 0.27), "towel"), 80),
    Family("tape", "tape", roll((0.02, 0.038), (0.042, 0.058), (0.018, 0.05), "tape"), 400),
    Family("comb", "comb", comb, 500),
    Family("brush", "hairbrush", brush, 270),
    Family("lipstick", "lipstick", lipstick, 900),
    Family("toilet_brush", "toilet brush", toilet_brush, 130),
)
