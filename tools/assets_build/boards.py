"""Pieces that much furniture shares: legs, castors, open boxes, fronts with their handles."""

from assets_build import finishes as f
from assets_build.primitives import Drawing, Finish


def castors(d: Drawing, w: float, dep: float, radius: float = 0.03) -> None:
    for x in (-w / 2 + 0.04, w / 2 - 0.04):
        for y in (-dep / 2 + 0.04, dep / 2 - 0.04):
            d.tube([(x - 0.011, y, radius), (x + 0.011, y, radius)], radius, f.BLACK, 10)


def legs(d: Drawing, w: float, dep: float, h: float, t: float, finish: Finish, bottom: float = 0.0) -> None:
    for x in (-w / 2, w / 2 - t):
        for y in (-dep / 2, dep / 2 - t):
            d.box((x, y, bottom), (x + t, y + t, h), finish)


def carcass(d: Drawing, w: float, dep: float, low: float, high: float, finish: Finish, t: float = 0.02) -> None:
    """An open-fronted box: bottom, top, sides and back."""
    d.box((-w / 2, -dep / 2, low), (w / 2, dep / 2, low + t), finish)
    d.box((-w / 2, -dep / 2, high - t), (w / 2, dep / 2, high), finish)
    d.box((-w / 2, -dep / 2, low + t), (-w / 2 + t, dep / 2, high - t), finish)
    d.box((w / 2 - t, -dep / 2, low + t), (w / 2, dep / 2, high - t), finish)
    d.box((-w / 2 + t, dep / 2 - t / 2, low + t), (w / 2 - t, dep / 2, high - t), finish)


def panel(
    d: Drawing, x: tuple[float, float], z: tuple[float, float], y: float, face: Finish, knob: Finish, side: str = "bar"
) -> None:
    """A drawer's or door's front with its handle, 18 mm thick before the plane y."""
    gap = 0.003
    d.box((x[0] + gap, y - 0.018, z[0] + gap), (x[1] - gap, y, z[1] - gap), face)
    middle, height = (x[0] + x[1]) / 2, (z[0] + z[1]) / 2
    if side == "bar":
        half = min(0.07, (x[1] - x[0]) / 4)
        d.box((middle - half, y - 0.04, height - 0.006), (middle + half, y - 0.018, height + 0.006), knob)
    elif side == "knob":
        d.block((middle, y - 0.03, height), (0.028, 0.024, 0.028), knob)
    else:
        at = x[1] - 0.05 if side == "right" else x[0] + 0.05
        d.box((at - 0.006, y - 0.04, height - 0.08), (at + 0.006, y - 0.018, height + 0.08), knob)
