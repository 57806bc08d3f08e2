"""Furniture to keep things in, drawn from boards; sizes in m."""

from collections.abc import Callable

from assets_build import finishes as f
from assets_build.boards import carcass, legs, panel
from assets_build.primitives import Drawing, Finish


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
            legs(d, w - 0.04, dep - 0.06, leg, 0.045, body)
        for row in range(rows):
            for column in range(columns):
                z = leg + 0.01 + (h - 0.04 - leg) * row / rows, leg + 0.01 + (h - 0.04 - leg) * (row + 1) / rows
                x = -w / 2 + 0.01 + (w - 0.02) * column / columns, -w / 2 + 0.01 + (w - 0.02) * (column + 1) / columns
                panel(d, x, z, front, face, knob, handle)

    return draw


def sideboard(
    w: float, dep: float, h: float, doors: int, body: Finish, face: Finish, leg: float = 0.12, niche: bool = True
) -> Callable[[Drawing], None]:
    """A low cabinet of doors, one of its sections an open niche with a board."""

    def draw(d: Drawing) -> None:
        low = leg
        carcass(d, w, dep, low, h, body, 0.022)
        legs(d, w - 0.1, dep - 0.08, leg, 0.04, f.DARK_STEEL)
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
                panel(
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
        carcass(d, w, dep, 0.06, h, body, t)
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
        panel(d, closed, (0.08, h - t), -dep / 2 + 0.02, face, f.STEEL, "left" if open_left else "right")

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
            legs(d, w, dep, h, 0.03, posts)
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
            legs(d, w, dep, h, 0.02, side)
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


def television_bench(w: float, dep: float, h: float, body: Finish, face: Finish) -> Callable[[Drawing], None]:
    """A low bench for a television: an open niche between two doors."""

    def draw(d: Drawing) -> None:
        carcass(d, w, dep, 0.08, h, body)
        legs(d, w - 0.1, dep - 0.08, 0.08, 0.04, f.BLACK)
        third = (w - 0.04) / 3
        for k in (0, 2):
            x = -w / 2 + 0.02 + k * third
            d.box((x, -dep / 2 + 0.02, 0.1), (x + third, dep / 2 - 0.01, h - 0.02), body)
            panel(d, (x, x + third), (0.1, h - 0.02), -dep / 2 + 0.02, face, f.STEEL, "right" if k == 0 else "left")

    return draw
