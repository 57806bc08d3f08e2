"""Furniture to sit, lie or put things on, drawn from boards; sizes in m."""

import math
from collections.abc import Callable

from assets_build import finishes as f
from assets_build.boards import castors, legs, panel
from assets_build.primitives import Drawing, Finish


def serving_cart(
    w: float, dep: float, heights: tuple[float, ...], board: Finish, frame: Finish, rim: float, handle: bool
) -> Callable[[Drawing], None]:
    """Boards between posts on castors; `rim` (m) stands up round each board."""

    def draw(d: Drawing) -> None:
        castors(d, w, dep)
        legs(d, w, dep, heights[-1] - 0.001, 0.025, frame, 0.055)
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


def bench(
    w: float, dep: float, h: float, seat: Finish, frame: Finish, cushion: Finish | None, shelf: bool
) -> Callable[[Drawing], None]:
    """A bench: a seat on four legs, with a cushion or a shelf below where wanted."""

    def draw(d: Drawing) -> None:
        top = h - (0.06 if cushion else 0.0)
        legs(d, w, dep, top - 0.03, 0.045, frame)
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
        legs(d, w - 0.02, dep - 0.02, h - 0.02, 0.035, leg or finish)
        d.box((-w / 2, -dep / 2, h - 0.022), (w / 2, dep / 2, h), finish)
        if drawer:
            d.box((-w / 2 + 0.012, -dep / 2 + 0.02, h - 0.17), (w / 2 - 0.012, dep / 2 - 0.01, h - 0.022), finish)
            panel(d, (-w / 2 + 0.03, w / 2 - 0.03), (h - 0.17, h - 0.024), -dep / 2 + 0.02, finish, f.BRASS, "knob")
        if shelf is not None:
            d.box((-w / 2 + 0.012, -dep / 2 + 0.012, shelf - 0.02), (w / 2 - 0.012, dep / 2 - 0.012, shelf), finish)

    return draw


def ottoman_bed(w: float, h: float, frame: Finish, blanket: Finish, head: float) -> Callable[[Drawing], None]:
    """A bed: frame, mattress under a blanket, pillows and a headboard at the back."""

    def draw(d: Drawing) -> None:
        length = 2.06
        d.box((-w / 2, -length / 2, 0.06), (w / 2, length / 2, h - 0.2), frame)
        legs(d, w - 0.06, length - 0.06, 0.06, 0.06, frame)
        d.box((-w / 2 + 0.02, -length / 2 + 0.02, h - 0.2), (w / 2 - 0.02, length / 2 - 0.01, h - 0.02), f.WHITE)
        d.box((-w / 2 + 0.005, -length / 2 + 0.005, h - 0.16), (w / 2 - 0.005, length / 2 - 0.55, h), blanket)
        d.box((-w / 2, length / 2, 0.06), (w / 2, length / 2 + 0.05, head), frame)
        count = 2 if w > 1.2 else 1
        for k in range(count):
            x = (k - (count - 1) / 2) * w / 2
            d.soft_block((x, length / 2 - 0.27, h + 0.03), (0.62, 0.4, 0.13), 0.5, f.WHITE, 8)

    return draw
