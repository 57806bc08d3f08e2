"""Families of cutlery and what one cooks with by hand; sizes in m."""

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.family import Family
from assets_build.primitives import Drawing
from assets_build.variation import Variation


def knife_block(d: Drawing, v: Variation) -> None:
    w, h = v.between(0.09, 0.13), v.between(0.18, 0.23)
    body = p.wood(v) if v.pick((True, True, False), (True, False)) else p.paint(v, p.DARK)
    lean = v.between(0.05, 0.09)
    part = Drawing()
    part.prism(
        [
            (-0.07, 0),
            (0.07, 0),
            (0.07 + lean * 0.2, 0.45 * h),
            (lean * 0.6 - 0.005, h),
            (-0.075 + lean * 0.4, 0.75 * h),
        ],
        -w / 2,
        w / 2,
        body,
    )
    d.place(part, turn=(90, 0, 90))
    grip = p.paint(v, p.DARK)
    rows = v.pick((2, 3), (1,))
    for row in range(rows):
        for k in range(v.pick((3, 4), (5,))):
            count = 4
            x = (k - (count - 1) / 2) * w / (count + 0.6)
            y = -0.045 + 0.03 * row + lean * 0.4
            z = 0.77 * h + 0.085 * h * row + 0.01
            d.tube([(x, y, z), (x, y - 0.04, z + 0.085)], 0.009, grip, 6)


def cutlery(kind: str):  # type: ignore[no-untyped-def]
    """Return the drawer of a fork, knife or spoon that lies on its back."""

    def draw(d: Drawing, v: Variation) -> None:
        half, wide = v.between(0.09, 0.115), v.between(0.85, 1.25)
        steel, grip = p.metal(v), v.pick((p.metal(v), p.wood(v), p.paint(v)), (p.paint(v), p.wood(v)))
        tail = v.pick((0.006, 0.009), (0.013, 0.0045))
        d.prism([(-tail, -half), (tail, -half), (0.006, -0.05 * half), (-0.006, -0.05 * half)], 0.001, 0.008, grip)
        d.box((-0.004, -0.06 * half, 0.002), (0.004, 0.42 * half, 0.006), steel)
        if kind == "spoon":
            d.soft_block(
                (0, 0.7 * half, 0.006), (0.042 * wide, 0.62 * half, 0.012), v.pick((1.0, 0.9), (0.65, 1.2)), steel, 8
            )
        elif kind == "fork":
            side, tines = 0.012 * wide, v.pick((4, 4), (3,))
            d.prism(
                [
                    (-0.004, 0.3 * half),
                    (0.004, 0.3 * half),
                    (side, 0.52 * half),
                    (side, 0.62 * half),
                    (-side, 0.62 * half),
                    (-side, 0.52 * half),
                ],
                0.002,
                0.006,
                steel,
            )
            for k in range(tines):
                x = -side + 2 * side * k / (tines - 1)
                d.box((x - 0.0018, 0.6 * half, 0.002), (x + 0.0018, half, 0.006), steel)
        else:
            tip = v.pick((0.7, 0.9), (0.45, 1.0))
            d.prism(
                [
                    (-0.006, -0.06 * half),
                    (0.008 * wide, 0.0),
                    (0.017 * wide, 0.06 * half),
                    (0.016 * wide, tip * half),
                    (-0.002, half),
                    (-0.006, half),
                ],
                0.002,
                0.0045,
                steel,
            )

    return draw


def spatula(d: Drawing, v: Variation) -> None:
    half, w = v.between(0.13, 0.165), v.between(0.032, 0.05)
    head = v.pick((p.metal(v), p.paint(v, p.DARK), p.wood(v)), (p.paint(v), p.metal(v)))
    grip = v.pick((p.wood(v), p.paint(v)), (p.paint(v),))
    top = v.pick((1.0, 1.25), (0.7, 1.45))
    outline = [(-w * 0.75, 0.4 * half), (w * 0.75, 0.4 * half), (w * top, half), (-w * top, half)]
    slots = v.pick((3, 0, 4), (2, 5))
    if slots:
        step = 1.5 * w / (2 * slots + 1)
        d.prism(
            [(-0.75 * w, 0.4 * half), (0.75 * w, 0.4 * half), (0.75 * w, 0.5 * half), (-0.75 * w, 0.5 * half)],
            0.004,
            0.007,
            head,
        )
        d.prism(
            [(-0.75 * w, 0.9 * half), (0.75 * w, 0.9 * half), (0.75 * w, half), (-0.75 * w, half)], 0.004, 0.007, head
        )
        for k in range(slots + 1):
            x = -0.75 * w + 2 * k * step
            d.box((x, 0.5 * half, 0.004), (x + step, 0.9 * half, 0.007), head)
    else:
        d.prism(outline, 0.004, 0.007, head)
    d.tube([(0, 0.42 * half, 0.0065), (0, 0.1 * half, 0.009), (0, -0.2 * half, 0.009)], 0.0045, head, 6)
    d.soft_block((0, -0.6 * half, 0.009), (0.024, 0.85 * half, 0.017), 0.5, grip, 6)


def rolling_pin(d: Drawing, v: Variation) -> None:
    half, radius = v.between(0.18, 0.235), v.between(0.02, 0.032)
    body, grip = (
        v.pick((p.wood(v), f.MARBLE, p.wood(v)), (p.wood(v), p.paint(v))),
        v.pick((p.wood(v), p.paint(v)), (p.wood(v),)),
    )
    if v.pick((False, False, True), (True, False)):
        d.tube(
            [(-half, 0, radius), (-0.5 * half, 0, radius), (0.5 * half, 0, radius), (half, 0, radius)],
            [0.5 * radius, radius, radius, 0.5 * radius],
            body,
            14,
        )
        return
    share = v.between(0.55, 0.7)
    for side in (-1, 1):
        d.tube(
            [
                (side * share * half, 0, radius),
                (side * (share + 0.08) * half, 0, radius),
                (side * 0.85 * half, 0, radius),
                (side * half, 0, radius),
            ],
            [0.3 * radius, 0.4 * radius, 0.6 * radius, 0.4 * radius],
            grip,
            10,
        )
    d.tube([(-share * half, 0, radius), (share * half, 0, radius)], radius, body, 14)


def ladle(d: Drawing, v: Variation) -> None:
    steel = p.metal(v)
    r = v.between(0.035, 0.05)
    d.soft_block((0, 0, 0.6 * r), (2 * r, 2 * r, 1.2 * r), 1.0, steel, 8)
    d.lathe([(0.9 * r, 0.99 * r), (0, 0.985 * r)], f.BLACK)
    d.tube(
        [(0, 0.9 * r, 0.9 * r), (0, 0.14, 0.05), (0, v.between(0.24, 0.3), 0.035)],
        [0.005, 0.005, 0.009],
        v.pick((steel,), (steel, f.BLACK)),
        6,
    )


FAMILIES = (
    Family("knife_block", "knife block", knife_block, 280),
    Family("fork", "fork", cutlery("fork"), 900),
    Family("knife", "knife", cutlery("knife"), 1400),
    Family("spoon", "spoon", cutlery("spoon"), 600),
    Family("spatula", "spatula", spatula, 260),
    Family("rolling_pin", "rolling pin", rolling_pin, 480),
    Family("ladle", "ladle", ladle, 110, train=0, test=3),
)
