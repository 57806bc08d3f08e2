"""Families of bottles; sizes in m."""

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.families.prints import UNIT, front
from assets_build.families.vessels import handle
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation

BODIES = (
    (
        ((1, 0), (1, 0.62), (0.75, 0.74), (0.38, 0.82)),
        ((1, 0), (0.92, 0.3), (1, 0.6), (0.4, 0.82)),
        ((1, 0), (1, 0.7), (0.4, 0.8)),
    ),
    (((0.8, 0), (1, 0.12), (0.78, 0.5), (0.95, 0.66), (0.36, 0.82)), ((0.9, 0), (1, 0.25), (0.55, 0.6), (0.36, 0.82))),
)  # fmt: skip


def labelled(d: Drawing, radius: float, h: float, low: float, high: float, finish: Finish) -> None:
    """Draw a label round a straight part."""
    d.lathe([(radius + 0.0008, low * h), (radius + 0.0008, high * h)], finish)


def bottle(d: Drawing, v: Variation) -> None:
    profile = v.pick(*BODIES)
    radius, h = v.between(0.03, 0.042), v.between(0.18, 0.27)
    body, cap = v.pick((p.paint(v, p.GLASSES), p.paint(v)), (p.paint(v), p.paint(v, p.GLASSES))), p.paint(v)
    neck = 0.38 * radius
    d.lathe([(0, 0), *((radius * r, h * z) for r, z in profile), (neck, 0.93 * h)], body)
    widest = max(float(np.interp(z, [b for _, b in profile], [a for a, _ in profile])) for z in (0.2, 0.35, 0.5))
    labelled(d, radius * widest, h, v.between(0.15, 0.22), v.between(0.42, 0.55), p.label(v))
    d.lathe([(neck + 0.002, 0.9 * h), (neck + 0.002, h), (0, h)], cap, segments=16)


def wine_bottle(d: Drawing, v: Variation) -> None:
    shoulder = v.pick((0.6, 0.66, 0.55), (0.48, 0.7))
    radius, h = v.between(0.036, 0.043), v.between(0.27, 0.33)
    glass = Finish(
        v.pick(((0.10, 0.20, 0.13), (0.16, 0.10, 0.08), (0.62, 0.66, 0.44)), ((0.20, 0.30, 0.16), (0.70, 0.62, 0.50)))
    )
    neck = 0.014
    d.lathe(
        [
            (0, 0),
            (radius, 0),
            (radius, shoulder * h),
            (0.75 * radius, (shoulder + 0.07) * h),
            (neck, (shoulder + 0.17) * h),
            (neck, h),
            (0, h),
        ],
        glass,
    )
    labelled(d, radius, h, 0.16, v.between(0.38, 0.46), p.label(v))
    d.lathe([(neck + 0.001, 0.86 * h), (neck + 0.001, h + 0.001), (0, h + 0.001)], p.paint(v, p.DARK), segments=16)


def shampoo(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.026, 0.038), v.between(0.018, 0.027), v.between(0.16, 0.23)
    body = p.paint(v)
    kind = v.pick(("straight", "round", "tottle"), ("pear", "waist"))
    waist = {"straight": 1.0, "round": 1.05, "tottle": 0.9, "pear": 1.2, "waist": 0.75}[kind]
    d.loft(
        [
            (0, w, dep, 0.7, 0, 0),
            (0.35 * h, waist * w, waist * dep, 0.7, 0, 0),
            (0.78 * h, 0.9 * w, dep, 0.8, 0, 0),
            (0.84 * h, 0.5 * w, 0.6 * dep, 1, 0, 0),
        ],
        body,
    )
    cap = p.paint(v, p.PALE)
    top = v.pick((0.55, 0.45), (0.75, 0.35))
    d.loft([(0.84 * h, top * w, 0.6 * dep, 0.9, 0, 0), (h, top * w, 0.6 * dep, 0.9, 0, 0)], cap)
    face = p.label(v)
    reach = max(waist, 1.0) * dep + 0.0008
    d.add(front(0.62 * w, 0.2 * h, 0.68 * h, reach), face, UNIT)


def medicine_bottle(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.017, 0.026), v.between(0.06, 0.095)
    body = Finish(
        v.pick(((0.85, 0.45, 0.1), (0.93, 0.93, 0.91), (0.45, 0.25, 0.1)), ((0.2, 0.45, 0.3), (0.3, 0.35, 0.6)))
    )
    neck = v.pick((1.0, 0.75), (0.6, 0.9))
    d.lathe([(0, 0), (radius, 0), (radius, 0.66 * h), (neck * radius, 0.74 * h)], body)
    d.lathe([(neck * radius + 0.003, 0.74 * h), (neck * radius + 0.003, h), (0, h)], p.paint(v, p.PALE))
    labelled(d, radius, h, 0.15, 0.58, p.label(v))


def perfume(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.026, 0.04), v.between(0.014, 0.024), v.between(0.055, 0.085)
    glass = Finish(
        v.pick(((0.85, 0.72, 0.55), (0.74, 0.81, 0.83), (0.85, 0.6, 0.66)), ((0.62, 0.55, 0.78), (0.55, 0.75, 0.68)))
    )
    kind = v.pick(("block", "disc", "dome"), ("taper", "drop"))
    if kind == "disc":
        d.tube([(0, -dep, h / 2), (0, dep, h / 2)], h / 2, glass, 20)
    elif kind in ("block", "taper"):
        top = 1.0 if kind == "block" else 0.6
        d.loft([(0, w, dep, 0.3, 0, 0), (h, top * w, top * dep, 0.3, 0, 0)], glass)
    else:
        rings = np.linspace(0, 1, 6)
        power = 0.5 if kind == "dome" else 1.1
        d.loft([(h * t, w * (1 - 0.75 * t**2) ** power, w * (1 - 0.75 * t**2) ** power, 1, 0, 0) for t in rings], glass)
    d.lathe([(0.008, h - 0.002), (0.008, h + 0.008), (0.006, h + 0.008)], f.BRASS, segments=12)
    cap = v.pick((0.011, 0.014), (0.018, 0.009))
    d.lathe(
        [(cap, h + 0.008), (cap, h + 0.034), (0, h + 0.034)],
        p.paint(v, p.DARK) if v.pick((True, False), (False,)) else f.BRASS,
        segments=v.pick((16, 4), (6,)),
    )


def baby_bottle(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.025, 0.032), v.between(0.11, 0.15)
    waist = v.pick((1.0, 0.85), (0.75, 1.15))
    d.lathe(
        [(0, 0), (radius, 0), (radius, 0.2 * h), (waist * radius, 0.55 * h), (radius, 0.85 * h), (0.85 * radius, h)],
        Finish((0.93, 0.92, 0.88)),
    )
    ring = p.paint(v)
    d.lathe([(radius, h - 0.006), (radius, h + 0.016), (0.5 * radius, h + 0.02)], ring)
    d.lathe(
        [(0.6 * radius, h + 0.018), (0.25 * radius, h + 0.03), (0.22 * radius, h + 0.045), (0, h + 0.05)],
        Finish((0.82, 0.64, 0.42)),
        segments=14,
    )
    for k in range(v.pick((4, 3), (5, 2))):
        d.block((0, -radius, 0.25 * h + 0.13 * h * k), (0.018, 0.003, 0.003), ring)
    if v.pick((False, True), (True, False)):
        for side in (-1, 1):
            d.place(_side_handle(radius, h, ring), turn=(0, 0, 0 if side > 0 else 180))


def _side_handle(radius: float, h: float, finish: Finish) -> Drawing:
    d = Drawing()
    handle(d, "ring", radius, 0.5 * h, 0.9 * h, 0.03, 0.005, finish)
    return d


FAMILIES = (
    Family("bottle", "bottle", bottle, 600),
    Family("wine_bottle", "wine bottle", wine_bottle, 640),
    Family("shampoo", "shampoo bottle", shampoo, 650),
    Family("medicine_bottle", "medicine bottle", medicine_bottle, 600),
    Family("perfume", "perfume bottle", perfume, 900),
    Family("baby_bottle", "baby bottle", baby_bottle, 450),
)
