"""Families of tins, jars, cartons and dispensers; sizes in m."""

import math

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.families.prints import UNIT, front
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation


def can(d: Drawing, v: Variation) -> None:
    kind = v.pick(("tin", "drink", "flat", "tin"), ("oval", "waisted"))
    radius = v.between(0.03, 0.037) if kind == "drink" else v.between(0.036, 0.052)
    h = {"tin": v.between(0.09, 0.12), "drink": v.between(0.11, 0.165), "flat": v.between(0.038, 0.06)}.get(
        kind, v.between(0.08, 0.13)
    )
    label, lid = p.label(v), p.paint(v, (((0.72, 0.74, 0.76),), ((0.80, 0.72, 0.46), (0.72, 0.74, 0.76))))
    if kind == "oval":
        d.loft(
            [(0, 1.25 * radius, 0.8 * radius, 0.9, 0, 0), (h - 0.005, 1.25 * radius, 0.8 * radius, 0.9, 0, 0)], label
        )
        d.loft(
            [(h - 0.005, 1.28 * radius, 0.83 * radius, 0.9, 0, 0), (h, 1.28 * radius, 0.83 * radius, 0.9, 0, 0)], lid
        )
        return
    waist = 0.86 if kind in ("drink", "waisted") else 1.0
    d.lathe([(0, 0), (waist * radius, 0), (radius, 0.008)], lid)
    d.lathe([(radius, 0.008), (radius, h - 0.012)], label)
    d.lathe(
        [
            (radius, h - 0.012),
            (waist * radius, h - 0.002),
            (waist * radius, h),
            (waist * radius - 0.004, h),
            (waist * radius - 0.004, h - 0.004),
            (0, h - 0.004),
        ],
        lid,
    )
    if kind == "drink":
        d.block((0.008, 0, h - 0.003), (0.02, 0.012, 0.002), lid)


def canister(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.042, 0.065), v.between(0.11, 0.19)
    body, lid = v.pick((p.paint(v), p.metal(v), p.speckle(v)), (p.paint(v, p.PALE), p.speckle(v))), p.wood(v)
    square = v.pick((False, False, True), (False, True))
    segments = 4 if square else 24
    bulge = v.pick((1.0, 1.06), (1.12, 0.9))
    d.lathe(
        [(0, 0), (radius, 0), (bulge * radius, 0.45 * h), (radius, 0.86 * h), (0, 0.86 * h)], body, segments=segments
    )
    d.lathe(
        [(0, 0.86 * h), (1.03 * radius, 0.86 * h), (1.03 * radius, 0.95 * h), (0, 0.955 * h)], lid, segments=segments
    )
    d.lathe([(0.012, 0.95 * h), (0.016, 0.985 * h), (0, h)], lid, segments=12)
    d.turn(45 if square else 0)
    if v.pick((True, False), (True,)):
        z, reach = 0.45 * h, (0.72 if square else bulge) * radius
        d.block((0, -reach, z), (0.05, 0.006, 0.03), p.paint(v, p.PALE))


def jar(d: Drawing, v: Variation) -> None:
    profile = v.pick(
        (((1, 0), (1, 0.78), (0.82, 0.86)), ((0.9, 0), (1, 0.4), (0.8, 0.86))),
        (((0.75, 0), (1, 0.3), (1, 0.6), (0.7, 0.86)), ((1, 0), (0.85, 0.5), (0.85, 0.86))),
    )
    radius, h = v.between(0.034, 0.05), v.between(0.09, 0.16)
    filling = Finish(
        v.pick(
            ((0.55, 0.12, 0.16), (0.85, 0.58, 0.15), (0.25, 0.16, 0.1), (0.45, 0.55, 0.25)),
            ((0.86, 0.36, 0.12), (0.30, 0.12, 0.28)),
        )
    )
    d.lathe([(0, 0), *((radius * r, h * z) for r, z in profile)], filling)
    lid = p.paint(v)
    top = profile[-1][0] * radius
    d.lathe([(top + 0.002, 0.84 * h), (top + 0.002, h), (0, h)], lid)
    if v.pick((True, True, False), (True, False)):
        d.lathe([(0.99 * radius + 0.002, 0.25 * h), (0.99 * radius + 0.002, 0.6 * h)], p.label(v))


def milk_carton(d: Drawing, v: Variation) -> None:
    side, h = v.between(0.035, 0.048), v.between(0.15, 0.2)
    face, flat = p.label(v), p.paint(v)
    d.box((-side, -side, 0), (side, side, h), flat)
    for turn in (0, 90, 180, 270):
        part = Drawing()
        part.add(front(side, 0.0, h, side + 0.0006), face, UNIT)
        d.place(part, turn=(0, 0, turn))
    roof = v.pick((0.045, 0.035), (0.06, 0.02))
    for s in (-1, 1):
        q = np.array(
            [[-side, s * side, h], [side, s * side, h], [side, s * 0.002, h + roof], [-side, s * 0.002, h + roof]]
        )
        d.add(np.array([q[[0, 1, 2]], q[[0, 2, 3]]])[:, :: s * -1], flat)
        e = np.array([[s * side, -side, h], [s * side, side, h], [s * side, 0, h + roof]])
        d.add(e[None, ::s], flat)
    d.box((-side, -0.002, h + roof - 0.002), (side, 0.002, h + roof + 0.02), f.WHITE)
    if v.pick((True, False), (True,)):
        d.place(_screw_cap(), (0, -0.5 * side, h + 0.45 * roof), (math.degrees(math.atan2(roof, side)), 0, 0))


def _screw_cap() -> Drawing:
    d = Drawing()
    d.lathe([(0.013, 0), (0.013, 0.012), (0, 0.012)], Finish((0.85, 0.2, 0.2)), segments=14)
    return d


def soap_dispenser(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.03, 0.038), v.between(0.11, 0.14)
    body, pump = (
        v.pick((p.paint(v), p.paint(v, p.GLASSES), p.speckle(v)), (p.speckle(v), p.paint(v, p.PALE))),
        p.metal(v),
    )
    sides = v.pick((24, 4, 24), (24, 6))
    d.lathe(
        [
            (0, 0),
            (radius, 0),
            (v.pick((1.0, 1.1), (0.85, 1.2)) * radius, 0.4 * h),
            (radius, 0.85 * h),
            (0.4 * radius, h),
            (0, h),
        ],
        body,
        segments=sides,
    )
    d.lathe([(0.013, h - 0.002), (0.013, h + 0.012), (0, h + 0.012)], pump, segments=12)
    d.tube([(0, 0, h), (0, 0, h + 0.04)], 0.004, pump, 8)
    d.tube([(0, 0.012, h + 0.04), (0, -0.04, h + 0.04), (0, -0.045, h + 0.03)], [0.008, 0.006, 0.004], pump, 8)


def spray_bottle(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.038, 0.048), v.between(0.026, 0.036), v.between(0.15, 0.19)
    body, head = p.paint(v), p.paint(v, p.PALE)
    bulge = v.pick((1.0, 0.92), (1.1, 0.8))
    d.loft(
        [
            (0, dep, w, 0.8, 0, 0),
            (0.5 * h, bulge * dep, bulge * w, 0.8, 0, 0),
            (0.8 * h, 0.8 * dep, 0.8 * w, 0.9, 0, 0),
            (h, 0.014, 0.014, 1, 0, 0),
        ],
        body,
    )
    d.lathe([(0.016, h - 0.005), (0.016, h + 0.02)], head, segments=14)
    d.box((-0.012, -0.05, h + 0.02), (0.012, 0.035, h + 0.05), head)
    d.tube([(0, -0.05, h + 0.038), (0, -0.062, h + 0.038)], 0.008, p.paint(v), 8)
    d.tube([(0, -0.025, h + 0.022), (0, -0.042, h + 0.0), (0, -0.036, h - 0.025)], [0.006, 0.005, 0.004], p.paint(v), 6)
    d.add(front(0.6 * dep, 0.2 * h, 0.6 * h, max(bulge, 1.0) * w + 0.0008), p.label(v), UNIT)


FAMILIES = (
    Family("can", "can", can, 850),
    Family("canister", "canister", canister, 420),
    Family("jar", "jar", jar, 780),
    Family("milk_carton", "milk carton", milk_carton, 700),
    Family("soap_dispenser", "soap dispenser", soap_dispenser, 420),
    Family("spray_bottle", "spray bottle", spray_bottle, 330),
)
