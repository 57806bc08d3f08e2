"""Furniture drawn from boards: classes that the sources lack or have few of."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from assets_build import finishes as f
from assets_build.primitives import Drawing, Finish


@dataclass(frozen=True)
class Drawn:
    """A model drawn here: what it is and how it is drawn; `collision`, `boxes`, `mass`, `budget` as in an `Entry`."""

    role: str
    category: str
    slug: str
    name: str
    draw: Callable[[Drawing], None]
    collision: str = ""
    boxes: int = 0
    mass: float = 0.0
    budget: int = 0


def _board(d: Drawing, low: tuple[float, float, float], high: tuple[float, float, float], finish: Finish) -> None:
    d.box(low, high, finish)


def _castors(d: Drawing, w: float, dep: float, radius: float = 0.03) -> None:
    for x in (-w / 2 + 0.04, w / 2 - 0.04):
        for y in (-dep / 2 + 0.04, dep / 2 - 0.04):
            d.tube([(x - 0.011, y, radius), (x + 0.011, y, radius)], radius, f.BLACK, 10)


def _legs(d: Drawing, w: float, dep: float, h: float, t: float, finish: Finish, bottom: float = 0.0) -> None:
    for x in (-w / 2, w / 2 - t):
        for y in (-dep / 2, dep / 2 - t):
            d.box((x, y, bottom), (x + t, y + t, h), finish)


def _carcass(d: Drawing, w: float, dep: float, low: float, high: float, finish: Finish, t: float = 0.02) -> None:
    """An open-fronted box: bottom, top, sides and back."""
    d.box((-w / 2, -dep / 2, low), (w / 2, dep / 2, low + t), finish)
    d.box((-w / 2, -dep / 2, high - t), (w / 2, dep / 2, high), finish)
    d.box((-w / 2, -dep / 2, low + t), (-w / 2 + t, dep / 2, high - t), finish)
    d.box((w / 2 - t, -dep / 2, low + t), (w / 2, dep / 2, high - t), finish)
    d.box((-w / 2 + t, dep / 2 - t / 2, low + t), (w / 2 - t, dep / 2, high - t), finish)


def _front(
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


def drawers(
    w: float,
    dep: float,
    h: float,
    rows: int,
    columns: int,
    body: Finish,
    face: Finish,
    knob: Finish,
    leg: float = 0.05,
    handle: str = "bar",
) -> Callable[[Drawing], None]:
    """A chest of drawers, on short legs."""

    def draw(d: Drawing) -> None:
        front = -dep / 2 + 0.018
        d.box((-w / 2, front, leg), (w / 2, dep / 2, h - 0.022), body)
        d.box((-w / 2 - 0.008, -dep / 2 - 0.004, h - 0.022), (w / 2 + 0.008, dep / 2, h), body)
        if leg:
            _legs(d, w - 0.04, dep - 0.06, leg, 0.045, body)
        for row in range(rows):
            for column in range(columns):
                z = leg + 0.01 + (h - 0.04 - leg) * row / rows, leg + 0.01 + (h - 0.04 - leg) * (row + 1) / rows
                x = -w / 2 + 0.01 + (w - 0.02) * column / columns, -w / 2 + 0.01 + (w - 0.02) * (column + 1) / columns
                _front(d, x, z, front, face, knob, handle)

    return draw


def sideboard(
    w: float, dep: float, h: float, doors: int, body: Finish, face: Finish, leg: float = 0.12, niche: bool = True
) -> Callable[[Drawing], None]:
    """A low cabinet of doors, one of its sections an open niche with a board."""

    def draw(d: Drawing) -> None:
        low = leg
        _carcass(d, w, dep, low, h, body, 0.022)
        _legs(d, w - 0.1, dep - 0.08, leg, 0.04, f.DARK_STEEL)
        width = (w - 0.044) / doors
        for k in range(doors):
            x0 = -w / 2 + 0.022 + k * width
            if k:
                d.box((x0 - 0.01, -dep / 2, low + 0.022), (x0 + 0.01, dep / 2 - 0.011, h - 0.022), body)
            if niche and k == doors // 2:
                middle = (low + h) / 2
                d.box((x0, -dep / 2 + 0.01, middle - 0.01), (x0 + width, dep / 2 - 0.011, middle + 0.01), body)
            else:
                d.box((x0, -dep / 2 + 0.02, low + 0.022), (x0 + width, dep / 2 - 0.011, h - 0.022), body)
                _front(
                    d,
                    (x0, x0 + width),
                    (low + 0.022, h - 0.022),
                    -dep / 2 + 0.02,
                    face,
                    f.BRASS,
                    "right" if k % 2 else "left",
                )

    return draw


def wardrobe(
    w: float, h: float, body: Finish, face: Finish, open_left: bool, boards: tuple[float, ...]
) -> Callable[[Drawing], None]:
    """A wardrobe, one half behind a door, the other open with boards at the given heights and a rail."""

    def draw(d: Drawing) -> None:
        dep, t = 0.58, 0.022
        _carcass(d, w, dep, 0.06, h, body, t)
        d.box((-w / 2 + 0.01, -dep / 2 + 0.03, 0.0), (w / 2 - 0.01, dep / 2, 0.06), body)
        split = -0.06 if open_left else 0.06
        d.box((split - t / 2, -dep / 2, 0.08), (split + t / 2, dep / 2 - 0.01, h - t), body)
        x = (-w / 2 + t, split - t / 2) if open_left else (split + t / 2, w / 2 - t)
        closed = (split + t / 2, w / 2 - t) if open_left else (-w / 2 + t, split - t / 2)
        for height in boards:
            d.box((x[0], -dep / 2 + 0.02, height - t), (x[1], dep / 2 - 0.01, height), body)
        if h - max(boards) > 0.6:
            d.tube([(x[0], 0.0, h - 0.12), (x[1], 0.0, h - 0.12)], 0.014, f.STEEL)
        d.box((closed[0], -dep / 2 + 0.02, 0.082), (closed[1], dep / 2 - 0.01, h - t), body)
        _front(d, closed, (0.08, h - t), -dep / 2 + 0.02, face, f.STEEL, "left" if open_left else "right")

    return draw


def shelves(
    w: float, dep: float, h: float, boards: int, finish: Finish, back: bool = True, posts: Finish | None = None
) -> Callable[[Drawing], None]:
    """Open shelves between sides, or between posts where `posts` is given."""

    def draw(d: Drawing) -> None:
        t = 0.022
        if posts is None:
            d.box((-w / 2, -dep / 2, 0.0), (-w / 2 + t, dep / 2, h), finish)
            d.box((w / 2 - t, -dep / 2, 0.0), (w / 2, dep / 2, h), finish)
        else:
            _legs(d, w, dep, h, 0.03, posts)
        if back:
            d.box((-w / 2 + t, dep / 2 - 0.01, 0.04), (w / 2 - t, dep / 2, h), finish)
        inset = t if posts is None else 0.0
        for k in range(boards):
            z = 0.06 + (h - 0.06) * k / (boards - 1)
            d.box((-w / 2 + inset, -dep / 2, z - t), (w / 2 - inset, dep / 2 - (0.01 if back else 0.0), z), finish)

    return draw


def shoe_rack(
    w: float, dep: float, tiers: int, spacing: float, finish: Finish, metal: bool, top: bool
) -> Callable[[Drawing], None]:
    """Tiers of slats, or of rods, between two sides; `top` closes it with a board that one can sit on."""

    def draw(d: Drawing) -> None:
        h = 0.1 + spacing * (tiers - 1) + (0.24 if top else 0.03)
        side = f.DARK_STEEL if metal else finish
        if metal:
            _legs(d, w, dep, h, 0.02, side)
        else:
            d.box((-w / 2, -dep / 2, 0.0), (-w / 2 + 0.02, dep / 2, h), side)
            d.box((w / 2 - 0.02, -dep / 2, 0.0), (w / 2, dep / 2, h), side)
        for tier in range(tiers):
            z = 0.1 + spacing * tier
            count = 6
            for k in range(count):
                y = -dep / 2 + 0.025 + (dep - 0.05) * k / (count - 1)
                if metal:
                    d.tube([(-w / 2, y, z - 0.008), (w / 2, y, z - 0.008)], 0.008, f.STEEL, 6)
                else:
                    d.box((-w / 2 + 0.02, y - 0.022, z - 0.014), (w / 2 - 0.02, y + 0.022, z), finish)
        if top:
            d.box((-w / 2, -dep / 2, h - 0.025), (w / 2, dep / 2, h), finish)

    return draw


def serving_cart(
    w: float, dep: float, heights: tuple[float, ...], board: Finish, frame: Finish, rim: float, handle: bool
) -> Callable[[Drawing], None]:
    """Boards between posts on castors; `rim` (m) stands up round each board."""

    def draw(d: Drawing) -> None:
        _castors(d, w, dep)
        _legs(d, w, dep, heights[-1] - 0.001, 0.025, frame, 0.055)
        for height in heights:
            d.box((-w / 2, -dep / 2, height - 0.02), (w / 2, dep / 2, height), board)
            if rim:
                for x in (-w / 2, w / 2 - 0.01):
                    d.box((x, -dep / 2, height), (x + 0.01, dep / 2, height + rim), frame)
                for y in (-dep / 2, dep / 2 - 0.01):
                    d.box((-w / 2, y, height), (w / 2, y + 0.01, height + rim), frame)
        if handle:
            z, x = heights[-1] - 0.03, w / 2
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

    return draw


def hamper(
    w: float, dep: float, h: float, finish: Finish, lid: Finish | None, round_body: bool
) -> Callable[[Drawing], None]:
    """A laundry basket, with a lid, or open and full of laundry."""

    def draw(d: Drawing) -> None:
        if round_body:
            r = w / 2
            if lid is None:
                d.lathe([(0, 0), (r * 0.85, 0), (r, h), (r - 0.015, h), (r * 0.97 - 0.015, h - 0.1)], finish)
                d.lathe([(r * 0.97 - 0.015, h - 0.1), (0, h - 0.1)], f.cloth((0.72, 0.76, 0.82)))
            else:
                d.lathe([(0, 0), (r * 0.9, 0), (r, h - 0.04), (0, h - 0.04)], finish)
                d.lathe([(0, h - 0.04), (r + 0.01, h - 0.04), (r + 0.01, h), (0, h)], lid)
            return
        if lid is None:
            t = 0.015
            d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, 0.02), finish)
            d.box((-w / 2, -dep / 2, 0.02), (-w / 2 + t, dep / 2, h), finish)
            d.box((w / 2 - t, -dep / 2, 0.02), (w / 2, dep / 2, h), finish)
            d.box((-w / 2 + t, -dep / 2, 0.02), (w / 2 - t, -dep / 2 + t, h), finish)
            d.box((-w / 2 + t, dep / 2 - t, 0.02), (w / 2 - t, dep / 2, h), finish)
            d.box((-w / 2 + t, -dep / 2 + t, 0.02), (w / 2 - t, dep / 2 - t, h - 0.1), f.cloth((0.82, 0.80, 0.76)))
            return
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, h - 0.035), finish)
        d.box((-w / 2 - 0.01, -dep / 2 - 0.01, h - 0.035), (w / 2 + 0.01, dep / 2 + 0.01, h), lid)
        d.box((-0.05, -dep / 2 - 0.022, h - 0.06), (0.05, -dep / 2 - 0.01, h - 0.035), f.BRASS)

    return draw


def trunk(w: float, dep: float, h: float, body: Finish, trim: Finish, bands: int) -> Callable[[Drawing], None]:
    """A chest with a flat lid, bands round it, a lock and handles."""

    def draw(d: Drawing) -> None:
        seam = 0.72 * h
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, seam - 0.004), body)
        d.box((-w / 2 - 0.006, -dep / 2 - 0.006, seam), (w / 2 + 0.006, dep / 2 + 0.006, h), body)
        for k in range(bands):
            x = -w / 2 + w * (k + 0.5) / bands
            d.box((x - 0.02, -dep / 2 - 0.01, 0), (x + 0.02, -dep / 2, seam - 0.004), trim)
            d.box((x - 0.02, -dep / 2 - 0.014, seam), (x + 0.02, -dep / 2 - 0.006, h), trim)
        d.box((-0.04, -dep / 2 - 0.018, seam - 0.07), (0.04, -dep / 2, seam + 0.04), f.BRASS)
        for side in (-1, 1):
            d.block((side * (w / 2 + 0.012), 0, 0.55 * h), (0.02, 0.14, 0.025), f.DARK_STEEL)

    return draw


def washer(body: Finish, door: Finish, panel: Finish, top_loader: bool = False) -> Callable[[Drawing], None]:
    """A washing machine or dryer, with a round door in front or a lid on top."""

    def draw(d: Drawing) -> None:
        w, dep, h = 0.6, 0.6, 0.85
        d.box((-w / 2, -dep / 2 + 0.02, 0.02), (w / 2, dep / 2, h), body)
        d.box((-w / 2 + 0.02, -dep / 2 + 0.04, 0.0), (w / 2 - 0.02, dep / 2 - 0.02, 0.02), f.BLACK)
        if top_loader:
            d.box((-w / 2, dep / 2 - 0.1, h), (w / 2, dep / 2, h + 0.14), panel)
            d.box((-w / 2 + 0.06, -dep / 2 + 0.05, h), (w / 2 - 0.06, dep / 2 - 0.13, h + 0.012), door)
            return
        d.box((-w / 2, -dep / 2, h - 0.13), (w / 2, -dep / 2 + 0.02, h), panel)
        for radius, depth, finish in ((0.2, 0.03, f.STEEL), (0.165, 0.04, door)):
            d.tube([(0, -dep / 2 + 0.02, 0.42), (0, -dep / 2 + 0.02 - depth, 0.42)], radius, finish, 24)
        d.tube([(0.12, -dep / 2, h - 0.065), (0.12, -dep / 2 - 0.02, h - 0.065)], 0.03, f.STEEL, 12)

    return draw


def counter(
    w: float, dep: float, h: float, body: Finish, top: Finish, doors: int, face: Finish, drawers_too: bool
) -> Callable[[Drawing], None]:
    """A kitchen counter: plinth, cabinet, fronts and a worktop that juts out."""

    def draw(d: Drawing) -> None:
        front = -dep / 2 + 0.04
        d.box((-w / 2 + 0.01, front + 0.05, 0.0), (w / 2 - 0.01, dep / 2, 0.1), f.DARK_STEEL)
        d.box((-w / 2 + 0.005, front, 0.1), (w / 2 - 0.005, dep / 2, h - 0.038), body)
        d.box((-w / 2, -dep / 2, h - 0.038), (w / 2, dep / 2, h), top)
        for k in range(doors):
            x = -w / 2 + 0.005 + (w - 0.01) * k / doors, -w / 2 + 0.005 + (w - 0.01) * (k + 1) / doors
            split = h - 0.22 if drawers_too else h - 0.04
            _front(d, x, (0.1, split), front, face, f.STEEL, "right" if k % 2 == 0 else "left")
            if drawers_too:
                _front(d, x, (split, h - 0.04), front, face, f.STEEL)

    return draw


def toilet(body: Finish, lid: Finish, square: bool) -> Callable[[Drawing], None]:
    """A toilet with its lid closed and a cistern behind."""

    def draw(d: Drawing) -> None:
        if square:
            d.box((-0.17, -0.33, 0.0), (0.17, 0.33, 0.40), body)
            d.box((-0.18, -0.345, 0.40), (0.18, 0.14, 0.435), lid)
        else:
            d.box((-0.12, -0.12, 0.0), (0.12, 0.33, 0.30), body)
            d.lathe([(0, 0), (0.13, 0.0), (0.11, 0.12), (0.185, 0.34), (0.19, 0.40), (0, 0.40)], body, (0.0, -0.14))
            d.box((-0.19, -0.12, 0.30), (0.19, 0.33, 0.40), body)
            d.lathe([(0, 0.40), (0.195, 0.40), (0.195, 0.43), (0, 0.43)], lid, (0.0, -0.14))
            d.box((-0.195, -0.14, 0.40), (0.195, 0.14, 0.43), lid)
        d.box((-0.2, 0.16, 0.40), (0.2, 0.34, 0.78), body)
        d.box((-0.21, 0.15, 0.78), (0.21, 0.35, 0.80), body)
        d.tube([(0, 0.25, 0.80), (0, 0.25, 0.81)], 0.025, f.STEEL, 12)

    return draw


def basin(w: float, dep: float, h: float, cabinet: Finish | None, ceramic: Finish) -> Callable[[Drawing], None]:
    """A washbasin with a rectangular hollow, on a cabinet or a pedestal, with its tap."""

    def draw(d: Drawing) -> None:
        rim, depth, low = 0.05, 0.12, h - 0.16
        if cabinet is None:
            d.lathe([(0, 0), (0.13, 0), (0.08, 0.08), (0.08, low - 0.05), (0.14, low), (0, low)], ceramic, (0, 0.04))
        else:
            d.box((-w / 2 + 0.02, -dep / 2 + 0.03, 0.0), (w / 2 - 0.02, dep / 2, low), cabinet)
            _front(d, (-w / 2 + 0.02, 0.0), (0.04, low), -dep / 2 + 0.03, cabinet, f.STEEL, "right")
            _front(d, (0.0, w / 2 - 0.02), (0.04, low), -dep / 2 + 0.03, cabinet, f.STEEL, "left")
        d.box((-w / 2, -dep / 2, low), (w / 2, dep / 2, h - depth), ceramic)
        d.box((-w / 2, -dep / 2, h - depth), (-w / 2 + rim, dep / 2, h), ceramic)
        d.box((w / 2 - rim, -dep / 2, h - depth), (w / 2, dep / 2, h), ceramic)
        d.box((-w / 2 + rim, -dep / 2, h - depth), (w / 2 - rim, -dep / 2 + rim, h), ceramic)
        d.box((-w / 2 + rim, dep / 2 - 2.2 * rim, h - depth), (w / 2 - rim, dep / 2, h), ceramic)
        y = dep / 2 - rim
        arc = [(0, y - 0.07 + 0.07 * math.cos(a), h + 0.12 + 0.07 * math.sin(a)) for a in (0, 0.8, 1.6, 2.4, 3.0)]
        d.tube([(0, y, h), (0, y, h + 0.12), *arc[1:]], 0.012, f.STEEL)

    return draw


def kitchen_sink(w: float, dep: float, h: float, body: Finish, top: Finish, basins: int) -> Callable[[Drawing], None]:
    """A counter with steel basins let into its worktop, open above, and a tap."""

    def draw(d: Drawing) -> None:
        depth, hollow = 0.17, 0.38
        front, low = -dep / 2 + 0.04, h - 0.19
        d.box((-w / 2 + 0.01, front + 0.05, 0.0), (w / 2 - 0.01, dep / 2, 0.1), f.DARK_STEEL)
        d.box((-w / 2 + 0.005, front, 0.1), (w / 2 - 0.005, dep / 2, low), body)
        _front(d, (-w / 2 + 0.005, 0.0), (0.1, low), front, body, f.STEEL, "right")
        _front(d, (0.0, w / 2 - 0.005), (0.1, low), front, body, f.STEEL, "left")
        wide = hollow * basins + 0.04 * (basins - 1)
        x0, x1, y0, y1 = -w / 2 + 0.06, -w / 2 + 0.06 + wide, -dep / 2 + 0.08, dep / 2 - 0.12
        d.box((-w / 2, -dep / 2, low), (w / 2, dep / 2, h - depth), body)
        d.box((-w / 2, -dep / 2, h - depth), (w / 2, y0, h), top)
        d.box((-w / 2, y1, h - depth), (w / 2, dep / 2, h), top)
        d.box((-w / 2, y0, h - depth), (x0, y1, h), top)
        d.box((x1, y0, h - depth), (w / 2, y1, h), top)
        d.box((x0, y0, h - depth), (x1, y1, h - depth + 0.006), f.STEEL)
        for k in range(1, basins):
            at = x0 + k * (hollow + 0.04) - 0.04
            d.box((at, y0, h - depth), (at + 0.04, y1, h - 0.01), f.STEEL)
        for low_y, high_y in ((y0 - 0.012, y0), (y1, y1 + 0.012)):
            d.box((x0 - 0.012, low_y, h), (x1 + 0.012, high_y, h + 0.003), f.STEEL)
        middle = (x0 + x1) / 2
        d.tube(
            [
                (middle, y1 + 0.05, h),
                (middle, y1 + 0.05, h + 0.22),
                (middle, y1 - 0.02, h + 0.28),
                (middle, y1 - 0.12, h + 0.26),
                (middle, y1 - 0.13, h + 0.2),
            ],
            0.013,
            f.STEEL,
        )

    return draw


def bench(
    w: float, dep: float, h: float, seat: Finish, frame: Finish, cushion: Finish | None, shelf: bool
) -> Callable[[Drawing], None]:
    """A bench: a seat on four legs, with a cushion or a shelf below where wanted."""

    def draw(d: Drawing) -> None:
        top = h - (0.06 if cushion else 0.0)
        _legs(d, w, dep, top - 0.03, 0.045, frame)
        d.box((-w / 2 - 0.01, -dep / 2 - 0.01, top - 0.035), (w / 2 + 0.01, dep / 2 + 0.01, top), seat)
        if cushion:
            d.box((-w / 2, -dep / 2, top), (w / 2, dep / 2, h), cushion)
        if shelf:
            d.box((-w / 2 + 0.045, -dep / 2 + 0.01, 0.12), (w / 2 - 0.045, dep / 2 - 0.01, 0.14), seat)

    return draw


def stool(radius: float, h: float, seat: Finish, frame: Finish, ring: bool) -> Callable[[Drawing], None]:
    """A round stool on four splayed legs."""

    def draw(d: Drawing) -> None:
        d.lathe([(0, h - 0.04), (radius, h - 0.04), (radius, h), (0, h)], seat)
        for k in range(4):
            a = math.pi / 4 + k * math.pi / 2
            near, far = 0.6 * radius, 0.95 * radius
            d.tube(
                [(far * math.cos(a), far * math.sin(a), 0), (near * math.cos(a), near * math.sin(a), h - 0.04)],
                0.016,
                frame,
            )
        if ring:
            z, r = 0.3 * h, 0.84 * radius
            d.tube(
                [(r * math.cos(a), r * math.sin(a), z) for a in (k * math.pi / 8 for k in range(17))], 0.008, frame, 6
            )

    return draw


def stand(
    w: float, dep: float, h: float, finish: Finish, shelf: float | None, drawer: bool, leg: Finish | None = None
) -> Callable[[Drawing], None]:
    """A small stand: a top on legs, with a drawer under it and a shelf at a height where wanted."""

    def draw(d: Drawing) -> None:
        _legs(d, w - 0.02, dep - 0.02, h - 0.02, 0.035, leg or finish)
        d.box((-w / 2, -dep / 2, h - 0.022), (w / 2, dep / 2, h), finish)
        if drawer:
            d.box((-w / 2 + 0.012, -dep / 2 + 0.02, h - 0.17), (w / 2 - 0.012, dep / 2 - 0.01, h - 0.022), finish)
            _front(d, (-w / 2 + 0.03, w / 2 - 0.03), (h - 0.17, h - 0.024), -dep / 2 + 0.02, finish, f.BRASS, "knob")
        if shelf is not None:
            d.box((-w / 2 + 0.012, -dep / 2 + 0.012, shelf - 0.02), (w / 2 - 0.012, dep / 2 - 0.012, shelf), finish)

    return draw


def television_bench(w: float, dep: float, h: float, body: Finish, face: Finish) -> Callable[[Drawing], None]:
    """A low bench for a television: an open niche between two doors."""

    def draw(d: Drawing) -> None:
        _carcass(d, w, dep, 0.08, h, body)
        _legs(d, w - 0.1, dep - 0.08, 0.08, 0.04, f.BLACK)
        third = (w - 0.04) / 3
        for k in (0, 2):
            x = -w / 2 + 0.02 + k * third
            d.box((x, -dep / 2 + 0.02, 0.1), (x + third, dep / 2 - 0.01, h - 0.02), body)
            _front(d, (x, x + third), (0.1, h - 0.02), -dep / 2 + 0.02, face, f.STEEL, "right" if k == 0 else "left")

    return draw


def ottoman_bed(w: float, h: float, frame: Finish, blanket: Finish, head: float) -> Callable[[Drawing], None]:
    """A bed: frame, mattress under a blanket, pillows and a headboard at the back."""

    def draw(d: Drawing) -> None:
        length = 2.06
        d.box((-w / 2, -length / 2, 0.06), (w / 2, length / 2, h - 0.2), frame)
        _legs(d, w - 0.06, length - 0.06, 0.06, 0.06, frame)
        d.box((-w / 2 + 0.02, -length / 2 + 0.02, h - 0.2), (w / 2 - 0.02, length / 2 - 0.01, h - 0.02), f.WHITE)
        d.box((-w / 2 + 0.005, -length / 2 + 0.005, h - 0.16), (w / 2 - 0.005, length / 2 - 0.55, h), blanket)
        d.box((-w / 2, length / 2, 0.06), (w / 2, length / 2 + 0.05, head), frame)
        count = 2 if w > 1.2 else 1
        for k in range(count):
            x = (k - (count - 1) / 2) * w / 2
            d.soft_block((x, length / 2 - 0.27, h + 0.03), (0.62, 0.4, 0.13), 0.5, f.WHITE, 8)

    return draw


FURNITURE: tuple[Drawn, ...] = (
    Drawn(
        "receptacle",
        "serving_cart",
        "oak_two_tier",
        "serving cart",
        serving_cart(0.75, 0.42, (0.28, 0.78), f.OAK, f.DARK_STEEL, 0.0, True),
    ),
    Drawn(
        "receptacle",
        "serving_cart",
        "steel_three_tier",
        "kitchen trolley",
        serving_cart(0.6, 0.4, (0.16, 0.48, 0.8), f.STEEL, f.DARK_STEEL, 0.03, True),
        boxes=20,
    ),
    Drawn(
        "receptacle",
        "serving_cart",
        "white_slim",
        "utility cart",
        serving_cart(0.45, 0.35, (0.14, 0.45, 0.76), f.WHITE, f.WHITE, 0.035, False),
        boxes=20,
    ),
    Drawn(
        "receptacle",
        "serving_cart",
        "brass_bar",
        "bar cart",
        serving_cart(0.8, 0.45, (0.2, 0.75), f.WALNUT, f.BRASS, 0.025, True),
        boxes=18,
    ),
    Drawn(
        "receptacle",
        "serving_cart",
        "butcher_block",
        "butcher block trolley",
        serving_cart(0.85, 0.5, (0.2, 0.52, 0.88), f.PINE, f.WHITE, 0.0, True),
    ),
    Drawn(
        "receptacle", "shoe_rack", "pine_three_tier", "shoe rack", shoe_rack(0.75, 0.3, 3, 0.19, f.PINE, False, False)
    ),
    Drawn(
        "receptacle",
        "shoe_rack",
        "steel_four_tier",
        "metal shoe rack",
        shoe_rack(0.66, 0.28, 4, 0.18, f.STEEL, True, False),
    ),
    Drawn("receptacle", "shoe_rack", "oak_bench", "shoe bench", shoe_rack(0.9, 0.34, 2, 0.19, f.OAK, False, True)),
    Drawn(
        "receptacle",
        "shoe_rack",
        "walnut_narrow",
        "narrow shoe rack",
        shoe_rack(0.5, 0.3, 4, 0.2, f.WALNUT, False, True),
    ),
    Drawn(
        "receptacle", "shoe_rack", "white_wide", "wide shoe rack", shoe_rack(1.05, 0.32, 2, 0.2, f.WHITE, False, True)
    ),
    Drawn(
        "receptacle",
        "hamper",
        "wicker_lidded",
        "wicker laundry hamper",
        hamper(0.42, 0.34, 0.58, f.NATURAL_WICKER, f.DARK_WICKER, False),
    ),
    Drawn(
        "receptacle",
        "hamper",
        "round_lidded",
        "round laundry hamper",
        hamper(0.4, 0.4, 0.6, f.DARK_WICKER, f.OAK, True),
    ),
    Drawn(
        "receptacle",
        "hamper",
        "white_lidded",
        "white laundry hamper",
        hamper(0.5, 0.36, 0.62, f.WHITE_WICKER, f.PINE, False),
    ),
    Drawn(
        "receptacle",
        "hamper",
        "cloth_open",
        "laundry bin",
        hamper(0.46, 0.36, 0.42, f.cloth((0.55, 0.62, 0.68)), None, False),
        boxes=6,
    ),
    Drawn(
        "receptacle",
        "hamper",
        "round_open",
        "round laundry basket",
        hamper(0.44, 0.44, 0.5, f.WHITE_WICKER, None, True),
    ),
    Drawn("receptacle", "trunk", "oak_banded", "wooden chest", trunk(0.9, 0.48, 0.46, f.OAK, f.DARK_STEEL, 2)),
    Drawn("receptacle", "trunk", "navy_steamer", "steamer trunk", trunk(0.8, 0.45, 0.42, f.NAVY, f.BRASS, 3)),
    Drawn("receptacle", "trunk", "wicker", "wicker trunk", trunk(0.84, 0.46, 0.44, f.NATURAL_WICKER, f.WALNUT, 2)),
    Drawn("receptacle", "trunk", "white_blanket_box", "blanket box", trunk(1.05, 0.44, 0.5, f.WHITE, f.WHITE, 4)),
    Drawn(
        "receptacle",
        "filing_cabinet",
        "grey_two_drawer",
        "filing cabinet",
        drawers(0.41, 0.56, 0.7, 2, 1, f.GREY_PAINT, f.GREY_PAINT, f.STEEL, 0.0),
    ),
    Drawn(
        "receptacle",
        "filing_cabinet",
        "green_three_drawer",
        "three-drawer filing cabinet",
        drawers(0.42, 0.58, 1.0, 3, 1, f.SAGE, f.SAGE, f.BRASS, 0.0),
    ),
    Drawn(
        "receptacle",
        "filing_cabinet",
        "white_lateral",
        "lateral filing cabinet",
        drawers(0.85, 0.48, 0.74, 2, 1, f.WHITE, f.WHITE, f.DARK_STEEL, 0.0),
    ),
    Drawn(
        "receptacle",
        "filing_cabinet",
        "black_pedestal",
        "office pedestal",
        drawers(0.4, 0.52, 0.6, 3, 1, f.DARK_STEEL, f.DARK_STEEL, f.STEEL, 0.04),
    ),
    Drawn("receptacle", "washer_dryer", "white_front", "washing machine", washer(f.WHITE, f.DARK_STEEL, f.CREAM)),
    Drawn("receptacle", "washer_dryer", "graphite_front", "dryer", washer(f.GRAPHITE, f.BLACK, f.BLACK)),
    Drawn(
        "receptacle",
        "washer_dryer",
        "white_top",
        "top-loading washing machine",
        washer(f.WHITE, f.CREAM, f.STEEL, top_loader=True),
    ),
    Drawn("receptacle", "wardrobe", "oak_open_left", "wardrobe", wardrobe(1.2, 1.95, f.OAK, f.OAK, True, (0.45, 0.85))),
    Drawn(
        "receptacle",
        "wardrobe",
        "white_open_right",
        "white wardrobe",
        wardrobe(1.0, 1.9, f.WHITE, f.WHITE, False, (0.4, 0.75, 1.1)),
    ),
    Drawn(
        "receptacle",
        "wardrobe",
        "walnut_open_left",
        "walnut wardrobe",
        wardrobe(1.5, 2.05, f.WALNUT, f.CREAM, True, (0.5, 0.95)),
    ),
    Drawn(
        "receptacle",
        "wardrobe",
        "grey_open_right",
        "grey wardrobe",
        wardrobe(1.1, 2.0, f.GREY_WOOD, f.WHITE, False, (0.35, 0.7, 1.05)),
    ),
    Drawn("receptacle", "wardrobe", "pine_low", "low wardrobe", wardrobe(0.9, 1.25, f.PINE, f.PINE, True, (0.5,))),
    Drawn("receptacle", "cabinet", "oak_sideboard", "sideboard", sideboard(1.5, 0.42, 0.78, 3, f.OAK, f.OAK)),
    Drawn(
        "receptacle",
        "cabinet",
        "walnut_sideboard",
        "walnut sideboard",
        sideboard(1.2, 0.42, 0.72, 3, f.WALNUT, f.CREAM),
    ),
    Drawn(
        "receptacle",
        "cabinet",
        "white_small",
        "small cabinet",
        sideboard(0.8, 0.38, 0.85, 2, f.WHITE, f.WHITE, 0.08, niche=False),
    ),
    Drawn(
        "receptacle",
        "cabinet",
        "grey_tall",
        "tall cabinet",
        sideboard(0.75, 0.4, 1.1, 2, f.GREY_WOOD, f.GREY_WOOD, 0.06),
    ),
    Drawn("receptacle", "cabinet", "navy_hall", "hall cabinet", sideboard(0.95, 0.36, 0.82, 3, f.NAVY, f.NAVY, 0.1)),
    Drawn(
        "receptacle",
        "counter",
        "white_marble_120",
        "kitchen counter",
        counter(1.2, 0.63, 0.9, f.WHITE, f.MARBLE, 2, f.WHITE, True),
    ),
    Drawn(
        "receptacle",
        "counter",
        "oak_granite_180",
        "long kitchen counter",
        counter(1.8, 0.63, 0.9, f.OAK, f.GRANITE, 3, f.OAK, True),
    ),
    Drawn(
        "receptacle",
        "counter",
        "navy_oak_120",
        "blue kitchen counter",
        counter(1.2, 0.63, 0.91, f.NAVY, f.OAK, 2, f.NAVY, False),
    ),
    Drawn(
        "receptacle",
        "counter",
        "sage_marble_80",
        "small kitchen counter",
        counter(0.8, 0.63, 0.9, f.SAGE, f.MARBLE, 2, f.SAGE, True),
    ),
    Drawn(
        "receptacle",
        "counter",
        "grey_walnut_160",
        "grey kitchen counter",
        counter(1.6, 0.63, 0.9, f.GREY_WOOD, f.WALNUT, 3, f.GREY_WOOD, False),
    ),
    Drawn("receptacle", "toilet", "white_round", "toilet", toilet(f.WHITE, f.WHITE, False)),
    Drawn("receptacle", "toilet", "white_square", "square toilet", toilet(f.WHITE, f.CREAM, True)),
    Drawn("receptacle", "toilet", "white_wood_lid", "toilet with a wooden lid", toilet(f.WHITE, f.WALNUT, False)),
    Drawn("receptacle", "sink", "vanity_oak", "vanity", basin(0.8, 0.48, 0.86, f.OAK, f.WHITE), boxes=12),
    Drawn("receptacle", "sink", "vanity_grey", "grey vanity", basin(0.6, 0.46, 0.85, f.GREY_WOOD, f.WHITE), boxes=12),
    Drawn("receptacle", "sink", "pedestal", "pedestal washbasin", basin(0.6, 0.48, 0.84, None, f.WHITE), boxes=12),
    Drawn(
        "receptacle",
        "sink",
        "kitchen_white_double",
        "kitchen sink",
        kitchen_sink(1.2, 0.63, 0.9, f.WHITE, f.GRANITE, 2),
        boxes=14,
    ),
    Drawn(
        "receptacle",
        "sink",
        "kitchen_oak_single",
        "kitchen sink",
        kitchen_sink(1.0, 0.63, 0.9, f.OAK, f.MARBLE, 1),
        boxes=14,
    ),
    Drawn("receptacle", "bench", "oak_shelf", "hall bench", bench(1.1, 0.36, 0.46, f.OAK, f.OAK, None, True)),
    Drawn(
        "receptacle",
        "bench",
        "blue_cushion",
        "upholstered bench",
        bench(1.2, 0.42, 0.48, f.WALNUT, f.WALNUT, f.cloth((0.30, 0.42, 0.56)), False),
    ),
    Drawn("receptacle", "bench", "steel_pine", "pine bench", bench(1.4, 0.34, 0.45, f.PINE, f.DARK_STEEL, None, False)),
    Drawn("receptacle", "stool", "oak_round", "round stool", stool(0.18, 0.46, f.OAK, f.OAK, False)),
    Drawn("receptacle", "stool", "red_bar", "bar stool", stool(0.17, 0.72, f.RED, f.DARK_STEEL, True)),
    Drawn("receptacle", "stool", "white_step", "wide stool", stool(0.21, 0.42, f.WHITE, f.PINE, False)),
    Drawn("receptacle", "stand", "oak_nightstand", "nightstand", stand(0.45, 0.4, 0.55, f.OAK, 0.14, True)),
    Drawn("receptacle", "stand", "white_nightstand", "white nightstand", stand(0.42, 0.38, 0.6, f.WHITE, 0.2, True)),
    Drawn(
        "receptacle", "stand", "walnut_side", "side stand", stand(0.5, 0.5, 0.56, f.WALNUT, 0.18, False, f.DARK_STEEL)
    ),
    Drawn("receptacle", "stand", "tall_plant", "plant stand", stand(0.36, 0.36, 0.78, f.CHERRY, 0.3, False)),
    Drawn("receptacle", "stand", "tv_oak", "TV stand", television_bench(1.5, 0.42, 0.5, f.OAK, f.WHITE)),
    Drawn("receptacle", "stand", "tv_black", "TV stand", television_bench(1.2, 0.4, 0.48, f.DARK_STEEL, f.BLACK)),
    Drawn("receptacle", "shelves", "low_pine", "low shelves", shelves(0.9, 0.32, 0.82, 3, f.PINE), boxes=10),
    Drawn("receptacle", "shelves", "white_tall", "shelves", shelves(0.8, 0.32, 1.8, 6, f.WHITE), boxes=12),
    Drawn(
        "receptacle",
        "shelves",
        "steel_open",
        "open shelving",
        shelves(0.95, 0.38, 1.6, 5, f.OAK, False, f.DARK_STEEL),
        boxes=12,
    ),
    Drawn(
        "receptacle", "shelves", "walnut_low_wide", "wide low shelves", shelves(1.3, 0.34, 0.95, 3, f.WALNUT), boxes=10
    ),
    Drawn(
        "receptacle",
        "chest_of_drawers",
        "oak_four",
        "chest of drawers",
        drawers(0.9, 0.46, 0.95, 4, 1, f.OAK, f.OAK, f.BRASS, handle="knob"),
    ),
    Drawn(
        "receptacle",
        "chest_of_drawers",
        "white_six",
        "white dresser",
        drawers(1.4, 0.48, 0.8, 3, 2, f.WHITE, f.WHITE, f.STEEL, handle="knob"),
    ),
    Drawn(
        "receptacle",
        "chest_of_drawers",
        "grey_three",
        "small chest of drawers",
        drawers(0.7, 0.42, 0.76, 3, 1, f.GREY_WOOD, f.WHITE, f.DARK_STEEL),
    ),
    Drawn(
        "receptacle",
        "bed",
        "grey_double",
        "double bed",
        ottoman_bed(1.6, 0.52, f.cloth((0.5, 0.5, 0.52)), f.cloth((0.36, 0.46, 0.58)), 1.05),
    ),
    Drawn(
        "receptacle",
        "bed",
        "oak_single",
        "single bed",
        ottoman_bed(0.95, 0.5, f.OAK, f.striped((0.8, 0.84, 0.86), (0.62, 0.7, 0.74)), 0.85),
    ),
)
