"""What stands in kitchens and bathrooms, drawn from boards and turned profiles; sizes in m."""

import math
from collections.abc import Callable

from assets_build import finishes as f
from assets_build.boards import panel
from assets_build.primitives import Drawing, Finish


def washer(body: Finish, door: Finish, strip: Finish, top_loader: bool = False) -> Callable[[Drawing], None]:
    """A washing machine or dryer, with a round door in front or a lid on top."""

    def draw(d: Drawing) -> None:
        w, dep, h = 0.6, 0.6, 0.85
        d.box((-w / 2, -dep / 2 + 0.02, 0.02), (w / 2, dep / 2, h), body)
        d.box((-w / 2 + 0.02, -dep / 2 + 0.04, 0.0), (w / 2 - 0.02, dep / 2 - 0.02, 0.02), f.BLACK)
        if top_loader:
            d.box((-w / 2, dep / 2 - 0.1, h), (w / 2, dep / 2, h + 0.14), strip)
            d.box((-w / 2 + 0.06, -dep / 2 + 0.05, h), (w / 2 - 0.06, dep / 2 - 0.13, h + 0.012), door)
            return
        d.box((-w / 2, -dep / 2, h - 0.13), (w / 2, -dep / 2 + 0.02, h), strip)
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
            panel(d, x, (0.1, split), front, face, f.STEEL, "right" if k % 2 == 0 else "left")
            if drawers_too:
                panel(d, x, (split, h - 0.04), front, face, f.STEEL)

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
            panel(d, (-w / 2 + 0.02, 0.0), (0.04, low), -dep / 2 + 0.03, cabinet, f.STEEL, "right")
            panel(d, (0.0, w / 2 - 0.02), (0.04, low), -dep / 2 + 0.03, cabinet, f.STEEL, "left")
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
        panel(d, (-w / 2 + 0.005, 0.0), (0.1, low), front, body, f.STEEL, "right")
        panel(d, (0.0, w / 2 - 0.005), (0.1, low), front, body, f.STEEL, "left")
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
