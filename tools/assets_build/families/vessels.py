"""Families of cups, bowls, plates, jugs and other open vessels; sizes in m."""

import math
from collections.abc import Sequence

import numpy as np

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish, Vector
from assets_build.variation import Variation

Profile = Sequence[tuple[float, float]]

CUPS: tuple[tuple[Profile, ...], tuple[Profile, ...]] = (
    (
        ((0.98, 0), (1, 0.5), (1, 1)),
        ((0.7, 0), (0.86, 0.5), (1, 1)),
        ((0.55, 0), (0.9, 0.22), (1, 0.6), (1, 1)),
        ((0.8, 0), (1, 0.45), (0.86, 1)),
    ),
    (
        ((0.5, 0), (0.98, 0.3), (0.82, 0.72), (0.96, 1)),
        ((0.98, 0), (0.8, 0.5), (1, 1)),
        ((0.6, 0), (0.62, 0.18), (0.96, 0.3), (1, 1)),
    ),
)
BOWLS: tuple[tuple[Profile, ...], tuple[Profile, ...]] = (
    (
        ((0.4, 0), (0.8, 0.4), (1, 1)),
        ((0.5, 0), (0.95, 0.35), (1, 0.7), (1, 1)),
        ((0.35, 0), (0.7, 0.7), (0.85, 0.85), (1, 1)),
    ),
    (((0.45, 0), (0.62, 0.5), (1, 1)), ((0.4, 0), (0.42, 0.15), (0.9, 0.5), (1, 0.85), (0.96, 1))),
)


def open_vessel(
    d: Drawing, profile: Profile, radius: float, h: float, wall: float, outside: Finish, inside: Finish
) -> None:
    """Draw an open vessel after a profile of relative (radius, height)."""
    outer = [(radius * r, h * z) for r, z in profile]
    inner = [(max(r - wall, 0.002), max(z, wall)) for r, z in reversed(outer)]
    d.lathe([(0, 0), *outer], outside)
    d.lathe([outer[-1], *inner, (0.0, wall)], inside)


def handle(
    d: Drawing, kind: str, at: float, low: float, high: float, reach: float, thick: float, finish: Finish
) -> None:
    """Draw a handle on the side towards +x, between two heights."""
    middle, half = (low + high) / 2, (high - low) / 2
    power = {"ring": 1.0, "ear": 1.0, "square": 0.35, "slim": 0.6}[kind]
    path: list[Vector] = []
    for a in np.linspace(-math.pi / 2, math.pi / 2, 9):
        out, up = math.cos(a), math.sin(a)
        drop = 0.35 * half if kind == "ear" and up < 0.5 else 0.0
        path.append(
            (
                at + reach * math.copysign(abs(out) ** power, out) - 0.003,
                0.0,
                middle + half * math.copysign(abs(up) ** power, up) + drop * out,
            )
        )
    d.tube(path, thick, finish, 7)


def banded(d: Drawing, profile: Profile, radius: float, h: float, low: float, high: float, finish: Finish) -> None:
    """Draw a painted band round a vessel between two relative heights."""
    heights = [z for _, z in profile]
    radii = [r for r, _ in profile]
    points = [(radius * float(np.interp(z, heights, radii)) + 0.0007, h * z) for z in np.linspace(low, high, 4)]
    d.lathe(points, finish)


def cup(d: Drawing, v: Variation) -> None:
    profile = v.pick(*CUPS)
    radius, h = v.between(0.036, 0.048), v.between(0.075, 0.12)
    body = p.paint(v) if v.pick((True, False), (True,)) else p.speckle(v)
    inside = p.paint(v, p.PALE)
    open_vessel(d, profile, radius, h, 0.004, body, inside)
    at = radius * float(np.interp(0.5, [z for _, z in profile], [r for r, _ in profile]))
    handle(d, v.pick(("ring", "ear"), ("square", "slim")), at, 0.2 * h, 0.8 * h, v.between(0.026, 0.036), 0.005, body)
    if v.pick((False, True, False), (True, False)):
        banded(d, profile, radius, h, 0.65, 0.85, p.paint(v, p.PALE))


def bowl(d: Drawing, v: Variation) -> None:
    profile = v.pick(*BOWLS)
    radius, h = v.between(0.065, 0.125), v.between(0.05, 0.09)
    outside = v.pick((p.paint(v), p.wood(v), p.metal(v), p.speckle(v)), (p.paint(v), p.speckle(v)))
    inside = outside if v.pick((True, False), (False, True)) else p.paint(v, p.PALE)
    open_vessel(d, profile, radius, h, 0.005, outside, inside)


def plate(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.1, 0.145), v.between(0.016, 0.03)
    body, rim = p.paint(v, p.PALE), p.paint(v)
    well = v.pick((0.55, 0.62, 0.7), (0.8, 0.48))
    kind = v.pick(("round", "round", "square"), ("octagon", "coupe"))
    segments = {"round": 32, "square": 4, "octagon": 8, "coupe": 32}[kind]
    lip = 0.85 if kind != "coupe" else 0.96
    d.lathe(
        [(0, 0), (well * radius, 0), (well * radius * 1.05, 0.25 * h), (radius, h - 0.003)], body, segments=segments
    )
    d.lathe([(radius, h - 0.003), (radius, h), (lip * radius, 0.78 * h)], rim, segments=segments)
    d.lathe(
        [(lip * radius, 0.78 * h), (well * radius * 1.02, 0.4 * h), (0, 0.35 * h)],
        v.pick((body, rim), (body,)),
        segments=segments,
    )
    if segments == 4:
        d.turn(45)


def pitcher(d: Drawing, v: Variation) -> None:
    profile = v.pick(
        (
            ((0.85, 0), (1, 0.35), (0.7, 0.78), (0.8, 1)),
            ((0.8, 0), (0.9, 0.5), (1, 1)),
            ((1, 0), (0.8, 0.6), (0.72, 1)),
        ),
        (
            ((0.7, 0), (1, 0.2), (0.62, 0.6), (0.66, 0.85), (0.85, 1)),
            ((0.9, 0), (1, 0.15), (1, 0.6), (0.6, 0.8), (0.62, 1)),
        ),
    )
    radius, h = v.between(0.055, 0.068), v.between(0.19, 0.27)
    body = v.pick((p.paint(v, p.PALE), p.paint(v, p.GLASSES), p.paint(v)), (p.speckle(v), p.paint(v, p.GLASSES)))
    open_vessel(d, profile, radius, h, 0.005, body, body)
    top = profile[-1][0] * radius
    d.tube([(0.3 * top, 0, 0.9 * h), (-top, 0, 0.97 * h), (-top - 0.022, 0, h)], [0.02, 0.016, 0.006], body, 8)
    at = radius * float(np.interp(0.5, [z for _, z in profile], [r for r, _ in profile]))
    handle(d, v.pick(("ear", "ring"), ("square",)), 0.9 * at, 0.25 * h, 0.9 * h, 0.05, 0.007, body)


def vase(d: Drawing, v: Variation) -> None:
    profile = v.pick(
        (((0.6, 0), (1, 0.4), (0.5, 0.85), (0.6, 1)),),
        (
            ((0.55, 0), (0.9, 0.2), (1, 0.45), (0.35, 0.7), (0.3, 0.9), (0.5, 1)),
            ((0.5, 0), (0.75, 0.6), (1, 1)),
            ((0.8, 0), (1, 0.3), (0.9, 0.75), (0.45, 0.9), (0.5, 1)),
        ),
    )
    open_vessel(d, profile, v.between(0.05, 0.068), v.between(0.18, 0.32), 0.005, p.speckle(v), f.BLACK)


def teapot(d: Drawing, v: Variation) -> None:
    radius, squash = v.between(0.062, 0.07), v.between(0.75, 1.05)
    h = 2 * radius * squash
    body = p.paint(v)
    rings = [(radius * math.cos(a), h / 2 + h / 2 * math.sin(a)) for a in np.linspace(-1.15, 1.2, 9)]
    d.lathe([(0, rings[0][1]), *rings, (0, rings[-1][1])], body)
    top, low = rings[-1][1], rings[0][1]
    d.lathe([(0, low - 0.004), (0.5 * radius, low - 0.004), (0.5 * radius, low + 0.01)], body)
    d.lathe([(0.42 * radius, top - 0.002), (0.3 * radius, top + 0.01), (0, top + 0.014)], body)
    d.lathe(
        [(0.006, top + 0.012), (0.013, top + 0.024), (0, top + 0.032)],
        v.pick((f.BRASS,), (f.BRASS, f.WALNUT, body)),
        segments=12,
    )
    d.tube(
        [(-0.85 * radius, 0, 0.35 * h), (-1.35 * radius, 0, 0.55 * h), (-1.65 * radius, 0, 0.95 * h)],
        [0.02, 0.012, 0.009], body, 8,
    )  # fmt: skip
    handle(d, v.pick(("ring",), ("ear", "ring", "square")), 0.9 * radius, 0.2 * h, 0.85 * h, 0.045, 0.008, body)


def ashtray(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.055, 0.085), v.between(0.022, 0.04)
    finish = v.pick((p.paint(v, p.GLASSES), p.metal(v), p.paint(v)), (p.speckle(v), p.paint(v, p.DARK)))
    sides = v.pick((24, 4, 6), (8, 24))
    d.lathe(
        [(0, 0), (0.92 * radius, 0), (radius, h), (0.8 * radius, h), (0.7 * radius, 0.25 * h), (0, 0.25 * h)],
        finish,
        segments=sides,
    )
    for k in range(v.pick((1, 2), (1, 3))):
        a = 1.9 * k + 0.7
        out, within = (
            (radius * math.cos(a), radius * math.sin(a)),
            (0.35 * radius * math.cos(a), 0.35 * radius * math.sin(a)),
        )
        d.tube([(1.1 * out[0], 1.1 * out[1], h + 0.006), (*out, h + 0.004)], 0.004, Finish((0.85, 0.55, 0.25)), 6)
        d.tube([(*out, h + 0.004), (*within, 0.45 * h)], 0.004, f.WHITE, 6)
        d.soft_block((*within, 0.45 * h), (0.009, 0.009, 0.009), 1.0, Finish((0.2, 0.2, 0.2)), 4)


def coaster(d: Drawing, v: Variation) -> None:
    side = v.between(0.045, 0.055)
    finish = v.pick((p.wood(v), p.speckle(v, 0.08), p.leather(v)), (p.cloth(v), f.MARBLE))
    sides = v.pick((24, 4, 24), (6, 8))
    thick = v.between(0.005, 0.011)
    d.lathe([(0, 0), (side, 0), (side, thick), (0, thick)], finish, segments=sides)
    ring = p.paint(v)
    d.lathe([(0.8 * side, thick + 0.0005), (0.72 * side, thick + 0.0008)], ring, segments=sides)


def utensil_holder(d: Drawing, v: Variation) -> None:
    radius, h = v.between(0.046, 0.06), v.between(0.12, 0.16)
    body = v.pick((p.paint(v), p.metal(v), p.speckle(v)), (p.wood(v), p.paint(v)))
    open_vessel(d, v.pick(*CUPS), radius, h, 0.005, body, body)
    grips = (p.wood(v), f.STEEL, p.paint(v))
    for k in range(v.pick((4, 5), (3, 6))):
        a = 2.4 * k
        x, y = 0.4 * radius * math.cos(a), 0.4 * radius * math.sin(a)
        top = (2.0 * x, 2.0 * y, h + v.between(0.08, 0.13))
        d.tube([(x, y, 0.012), top], 0.005, grips[k % 3], 6)
        d.soft_block(top, (0.04, 0.012, 0.06) if k % 2 else (0.045, 0.045, 0.03), 0.8, grips[k % 3], 6)


def basket(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.24, 0.34), v.between(0.16, 0.24), v.between(0.09, 0.135)
    finish = f.wicker(v.pick(((0.7, 0.55, 0.35),), ((0.62, 0.44, 0.26), (0.80, 0.70, 0.52), (0.36, 0.28, 0.22))))
    d.loft(
        [
            (0, 0.4 * w, 0.4 * dep, 0.5, 0, 0),
            (h, 0.5 * w, 0.5 * dep, 0.5, 0, 0),
            (h, 0.46 * w, 0.46 * dep, 0.5, 0, 0),
            (0.02, 0.37 * w, 0.37 * dep, 0.5, 0, 0),
        ],
        finish,
    )
    for side in (-1, 1):
        d.tube(
            [
                (side * 0.49 * w, -0.04, h - 0.01),
                (side * 0.53 * w, -0.02, h + 0.004),
                (side * 0.53 * w, 0.02, h + 0.004),
                (side * 0.49 * w, 0.04, h - 0.01),
            ],
            0.007,
            finish,
            6,
        )


FAMILIES = (
    Family("cup", "mug", cup, 330, collision="hollow"),
    Family("bowl", "bowl", bowl, 330, collision="hollow"),
    Family("plate", "plate", plate, 800),
    Family("pitcher", "pitcher", pitcher, 260),
    Family("vase", "vase", vase, 450, train=0, test=3),
    Family("teapot", "teapot", teapot, 330, train=0, test=3),
    Family("ashtray", "ashtray", ashtray, 900),
    Family("coaster", "coaster", coaster, 700),
    Family("utensil_holder", "utensil holder", utensil_holder, 280),
    Family("basket", "basket", basket, 40, train=0, test=2),
)
