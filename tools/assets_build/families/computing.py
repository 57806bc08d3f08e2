"""Families of computers, telephones and their parts; sizes in m."""

import math

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing, Finish
from assets_build.variation import Variation

SCREENS = (((0.12, 0.16, 0.24), (0.08, 0.08, 0.1), (0.2, 0.36, 0.5)), ((0.3, 0.2, 0.4), (0.14, 0.3, 0.26)))


def keyboard(d: Drawing, v: Variation) -> None:
    w, dep = v.between(0.29, 0.45), v.between(0.115, 0.138)
    body = v.pick((p.paint(v, p.DARK), p.metal(v), f.WHITE), (p.paint(v), p.paint(v, p.DARK)))
    keys = v.pick((p.paint(v, p.DARK), f.WHITE), (p.paint(v, p.PALE), p.paint(v, p.DARK)))
    power = v.pick((0.1, 0.14), (0.25,))
    d.loft([(0, w / 2, dep / 2, power, 0, 0), (0.014, w / 2, dep / 2, power, 0, 0)], body)
    split = v.pick((0.0, 0.0), (0.03, 0.0))
    columns, rows = int(w / 0.026), v.pick((5, 5), (4, 6))
    step, deep = (w - 0.024) / columns, (dep - 0.02) / rows
    for row in range(rows):
        y = dep / 2 - 0.01 - (row + 1) * deep
        for column in range(columns):
            x = -w / 2 + 0.012 + column * step
            if (split and abs(x + step / 2) < split / 2) or (row == rows - 1 and 2 < column < 8):
                continue
            d.box((x + 0.0015, y + 0.0015, 0.014), (x + step - 0.0015, y + deep - 0.0015, 0.019), keys)
    x = -w / 2 + 0.012
    d.box(
        (x + 3 * step, -dep / 2 + 0.0115, 0.014), (x + 8 * step - 0.0015, -dep / 2 + 0.01 + deep - 0.0015, 0.019), keys
    )


def mouse(d: Drawing, v: Variation) -> None:
    w, length, h = v.between(0.052, 0.07), v.between(0.095, 0.12), v.between(0.03, 0.042)
    body, dark = v.pick((p.paint(v, p.DARK), f.WHITE, p.metal(v)), (p.paint(v), p.paint(v, p.PALE))), f.BLACK
    waist = v.pick((1.0, 0.9), (0.8, 1.12))
    d.loft(
        [
            (0, 0.48 * w, 0.49 * length, 0.8, 0, 0),
            (0.3 * h, 0.5 * w * waist, 0.5 * length, 0.8, 0, 0),
            (0.72 * h, 0.45 * w * waist, 0.44 * length, 0.85, 0, 0),
            (0.94 * h, 0.32 * w, 0.3 * length, 0.9, 0, 0),
            (h, 0.14 * w, 0.14 * length, 1, 0, 0),
        ],
        body,
    )
    d.tube([(-0.004, -0.3 * length, 0.84 * h), (0.004, -0.3 * length, 0.84 * h)], 0.009, dark, 10)
    d.block((0, -0.3 * length, 0.75 * h), (0.0018, 0.3 * length, 0.2 * h), dark)
    d.box((-0.5 * w * waist, -0.1 * length, 0.3 * h), (0.5 * w * waist, -0.094 * length, 0.76 * h), dark)


def laptop(d: Drawing, v: Variation) -> None:
    w, dep = v.between(0.29, 0.37), v.between(0.2, 0.25)
    body = v.pick((p.metal(v),), (p.metal(v), p.paint(v, p.DARK)))
    d.loft([(0, 0.485 * w, 0.48 * dep, 0.12, 0, 0), (0.011, w / 2, dep / 2, 0.12, 0, 0)], body)
    d.loft([(0.0125, w / 2, dep / 2, 0.12, 0, 0), (0.02, 0.495 * w, 0.49 * dep, 0.12, 0, 0)], body)
    d.soft_block((0, 0, 0.02), (0.035, 0.035, 0.002), 1.0, p.paint(v), 6)
    d.box((-0.3 * w, 0.47 * dep, 0.004), (0.3 * w, 0.505 * dep, 0.017), f.BLACK)


def slate(w: tuple[float, float], h: tuple[float, float], is_phone: bool):  # type: ignore[no-untyped-def]
    """Return the drawer of a phone or a tablet that lies on its back."""

    def draw(d: Drawing, v: Variation) -> None:
        wide, high, thick = v.between(*w), v.between(*h), v.between(0.0075, 0.0115)
        body, power = (
            v.pick((p.paint(v, p.DARK), p.metal(v), p.paint(v)), (p.paint(v), p.metal(v))),
            v.pick((0.15, 0.22), (0.05, 0.32)),
        )
        d.loft(
            [
                (0, 0.49 * wide, 0.495 * high, power, 0, 0),
                (0.4 * thick, wide / 2, high / 2, power, 0, 0),
                (thick, wide / 2, high / 2, power, 0, 0),
            ],
            body,
        )
        edge = v.pick((0.004, 0.006), (0.002, 0.01))
        top = v.pick((0.01, 0.016), (0.022,)) if is_phone else edge + 0.006
        low = v.pick((0.01, 0.02), (0.026, 0.006)) if is_phone else edge + 0.006
        d.box(
            (-wide / 2 + edge, -high / 2 + low, thick),
            (wide / 2 - edge, high / 2 - top, thick + 0.0006),
            Finish(v.pick(*SCREENS)),
        )
        colors = (p.paint(v), p.paint(v, p.PALE), p.paint(v))
        rows, columns = (5, 4) if is_phone else (3, 5)
        for k in range(v.pick((rows * columns, 8), (rows * columns - 3, 6))):
            x = -wide / 2 + edge + (wide - 2 * edge) * (k % columns + 0.5) / columns
            y = high / 2 - top - (high - top - low) * (k // columns + 0.5) / rows
            d.block((x, y, thick + 0.0008), (0.5 * wide / columns, 0.5 * wide / columns, 0.0006), colors[k % 3])

    return draw


def remote_control(d: Drawing, v: Variation) -> None:
    w, length, h = v.between(0.038, 0.055), v.between(0.14, 0.22), v.between(0.016, 0.025)
    body, keys = (
        v.pick((p.paint(v, p.DARK), p.metal(v), f.WHITE), (p.paint(v, p.DARK), p.paint(v, p.PALE))),
        v.pick((p.paint(v, p.PALE), f.GREY_PAINT), (p.paint(v), f.GREY_PAINT)),
    )
    taper, power = v.pick((1.0, 0.9), (0.75, 0.8)), v.pick((0.2, 0.4), (0.6, 0.15))
    d.loft(
        [
            (0, 0.45 * w, 0.49 * length, power, 0, 0),
            (0.7 * h, 0.5 * w, 0.5 * length, power, 0, 0),
            (h, 0.46 * w * taper, 0.49 * length, power, 0, 0),
        ],
        body,
    )
    rows = v.pick((8, 7), (5, 9))
    for row in range(rows):
        for column in (-1, 0, 1):
            y = 0.34 * length - 0.72 * length * row / (rows - 1)
            d.block((0.27 * w * column, y, h), (0.17 * w, 0.4 * length / rows, 0.004), keys)
    d.block((-0.27 * w, 0.43 * length, h), (0.2 * w, 0.2 * w, 0.004), f.RED)
    if v.pick((True, False), (True,)):
        d.lathe([(0.3 * w, h), (0.3 * w, h + 0.003), (0.14 * w, h + 0.003)], keys, (0.0, 0.1 * length), 16)


def telephone(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.16, 0.21), v.between(0.18, 0.23), v.between(0.05, 0.075)
    body, hand = v.pick((p.paint(v, p.DARK), p.paint(v), f.CREAM), (p.paint(v), p.paint(v, p.PALE))), p.paint(v, p.DARK)
    part = Drawing()
    part.prism(
        [(-dep / 2, 0), (dep / 2, 0), (dep / 2, h), (-dep / 2, v.pick((0.3, 0.4), (0.6,)) * h)], -w / 2, w / 2, body
    )
    d.place(part, turn=(90, 0, 90))
    slope = math.degrees(math.atan2(0.65 * h, dep))
    pad = Drawing()
    if v.pick((False, False, True), (True, False)):
        pad.lathe([(0.05, 0), (0.05, 0.008), (0.02, 0.008)], f.STEEL, segments=20)
        for k in range(10):
            pad.lathe(
                [(0.007, 0.008), (0.007, 0.010), (0, 0.010)],
                f.BLACK,
                (0.036 * math.cos(0.55 * k), 0.036 * math.sin(0.55 * k)),
                8,
            )
    else:
        for row in range(4):
            for column in range(3):
                pad.block((0.022 * (column - 1), 0.02 * (row - 1.5), 0.003), (0.015, 0.012, 0.008), f.WHITE)
        pad.block((0, 0.06, 0.002), (0.07, 0.025, 0.006), Finish((0.6, 0.7, 0.58)))
    d.place(pad, (0.18 * w, -0.02, 0.68 * h), (slope, 0, 0))
    d.soft_block((-0.28 * w, 0, h + 0.012), (0.04, 0.9 * dep, 0.022), 0.5, hand, 8)
    for y in (-0.36 * dep, 0.36 * dep):
        d.soft_block((-0.28 * w, y, h + 0.0), (0.05, 0.055, 0.035), 0.7, hand, 7)


def game_console(d: Drawing, v: Variation) -> None:
    w, dep, h = v.between(0.22, 0.32), v.between(0.16, 0.24), v.between(0.045, 0.075)
    body, trim = v.pick((p.paint(v, p.DARK), f.WHITE, f.GREY_PAINT), (p.paint(v), p.paint(v, p.PALE))), p.paint(v)
    power = v.pick((0.1, 0.2), (0.45,))
    d.loft([(0, 0.48 * w, 0.48 * dep, power, 0, 0), (0.45 * h, w / 2, dep / 2, power, 0, 0)], body)
    d.loft([(0.45 * h, 0.49 * w, 0.49 * dep, power, 0, 0), (0.55 * h, 0.49 * w, 0.49 * dep, power, 0, 0)], trim)
    d.loft([(0.55 * h, w / 2, dep / 2, power, 0, 0), (h, 0.47 * w, 0.47 * dep, power, 0, 0)], body)
    d.box((-0.3 * w, -0.505 * dep, 0.62 * h), (0.1 * w, -0.47 * dep, 0.72 * h), f.BLACK)
    d.tube([(0.38 * w, -0.46 * dep, 0.68 * h), (0.38 * w, -0.51 * dep, 0.68 * h)], 0.01, trim, 10)
    if v.pick((False, True), (True,)):
        pad = Drawing()
        controller_body(pad, 0.13, trim, f.BLACK, p.paint(v))
        d.place(pad, (0.05, 0.0, h))


def controller_body(d: Drawing, w: float, body: Finish, dark: Finish, keys: Finish) -> None:
    """Draw a game controller of a width."""
    d.soft_block((0, 0.15 * w, 0.17 * w), (0.95 * w, 0.5 * w, 0.24 * w), 0.7, body, 7)
    for side in (-1, 1):
        d.tube(
            [
                (side * 0.33 * w, 0.15 * w, 0.17 * w),
                (side * 0.42 * w, -0.1 * w, 0.15 * w),
                (side * 0.4 * w, -0.3 * w, 0.11 * w),
            ],
            [0.16 * w, 0.13 * w, 0.08 * w],
            body,
            9,
        )
        d.lathe([(0.06 * w, 0.27 * w), (0.08 * w, 0.34 * w), (0, 0.34 * w)], dark, (side * 0.16 * w, 0.05 * w), 12)
    for x, y in ((0.3, 0.26), (0.38, 0.19), (0.3, 0.12), (0.22, 0.19)):
        d.block((x * w, y * w, 0.28 * w), (0.055 * w, 0.055 * w, 0.05 * w), keys)
    d.block((-0.3 * w, 0.19 * w, 0.28 * w), (0.17 * w, 0.05 * w, 0.04 * w), dark)
    d.block((-0.3 * w, 0.19 * w, 0.28 * w), (0.05 * w, 0.17 * w, 0.04 * w), dark)


def game_controller(d: Drawing, v: Variation) -> None:
    controller_body(
        d, v.between(0.13, 0.165), v.pick((f.BLACK,), (f.WHITE, p.paint(v), p.paint(v, p.DARK))), f.BLACK, p.paint(v)
    )


FAMILIES = (
    Family("keyboard", "keyboard", keyboard, 550),
    Family("computer_mouse", "computer mouse", mouse, 400),
    Family("laptop", "laptop", laptop, 950, train=0, test=2),
    Family("cellphone", "mobile phone", slate((0.058, 0.08), (0.12, 0.165), True), 1800),
    Family("tablet", "tablet", slate((0.13, 0.2), (0.19, 0.27), False), 1200),
    Family("remote_control", "remote control", remote_control, 600),
    Family("telephone", "telephone", telephone, 250),
    Family("game_console", "game console", game_console, 330),
    Family("game_controller", "game controller", game_controller, 280, train=0, test=3),
)
