"""Pictures, mirrors, rugs, curtains, clocks and door leaves: what makes rooms look lived in."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from assets_build import finishes as f
from assets_build.drawn import Drawn
from assets_build.images import encode_jpeg
from assets_build.primitives import Color, Drawing, Finish

Draw = Callable[[Drawing], None]

SIDE = 256


def _panel(d: Drawing, low: tuple[float, float], high: tuple[float, float], y: float, finish: Finish) -> None:
    """An upright rectangle that faces -y and shows its texture once."""
    p = np.array([[low[0], y, low[1]], [high[0], y, low[1]], [high[0], y, high[1]], [low[0], y, high[1]]])
    uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    d.add(np.array([p[[0, 1, 2]], p[[0, 2, 3]]]), finish, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))


def _painting(pixels: NDArray[np.float64]) -> Finish:
    return Finish((1.0, 1.0, 1.0), encode_jpeg(np.clip(255 * pixels, 0, 255).astype(np.uint8), 85))


def landscape(sky: Color, land: Color, seed: int) -> Finish:
    """Return a painting of hills under a sky."""
    rng = np.random.default_rng(seed)
    rows, columns = np.linspace(0, 1, SIDE)[:, None], np.linspace(0, 1, SIDE)[None, :]
    pixels = np.ones((SIDE, SIDE, 3)) * (np.array(sky) * (0.85 + 0.25 * rows)[..., None])
    for k in range(4):
        crest = 0.4 + 0.14 * k + 0.07 * np.sin(2 * math.pi * (columns * rng.uniform(0.6, 2) + rng.uniform()))
        pixels[np.broadcast_to(rows > crest, (SIDE, SIDE))] = np.array(land) * (1.15 - 0.2 * k)
    sun = (rows - 0.22) ** 2 + (columns - rng.uniform(0.2, 0.8)) ** 2 < 0.006
    pixels[sun] = (0.98, 0.9, 0.65)
    return _painting(pixels)


def shapes_of_colour(ground: Color, seed: int) -> Finish:
    """Return an abstract painting of discs and bars."""
    rng = np.random.default_rng(seed)
    rows, columns = np.linspace(0, 1, SIDE)[:, None], np.linspace(0, 1, SIDE)[None, :]
    pixels = np.ones((SIDE, SIDE, 3)) * np.array(ground)
    for k in range(9):
        x, y, r = rng.uniform(0.1, 0.9), rng.uniform(0.1, 0.9), rng.uniform(0.05, 0.22)
        disc = (rows - y) ** 2 + (columns - x) ** 2 < r * r
        bar = (np.abs(rows - y) < r) & (np.abs(columns - x) < 0.3 * r)
        pixels[disc if k % 2 else bar] = rng.uniform(0.1, 0.9, 3)
    return _painting(pixels)


def woven(first: Color, second: Color, third: Color, style: str) -> Finish:
    """Return a rug's pattern: a border round "lattice", "bands" or "medallion"."""
    i, j = np.meshgrid(np.linspace(-1, 1, SIDE), np.linspace(-1, 1, SIDE), indexing="ij")
    edge = np.maximum(np.abs(i), np.abs(j))
    if style == "lattice":
        inner = (np.abs(np.sin(5 * math.pi * (i + j) / 2)) < 0.18) | (np.abs(np.sin(5 * math.pi * (i - j) / 2)) < 0.18)
    elif style == "bands":
        inner = np.sin(9 * math.pi * j) > 0.3
    else:
        inner = ((np.abs(i) + np.abs(j)) % 0.4 < 0.12) | (np.hypot(i, j) < 0.2)
    pixels = np.where(inner[..., None], np.array(second), np.array(first))
    pixels = np.where(((edge > 0.82) & (edge < 0.94))[..., None], np.array(third), pixels)
    pixels = pixels * (1 + 0.05 * np.random.default_rng(4).standard_normal((SIDE, SIDE, 1)))
    return _painting(pixels)


def picture(w: float, h: float, border: Finish, art: Finish) -> Draw:
    """A framed picture that hangs with its back (+y) on the wall."""

    def draw(d: Drawing) -> None:
        t, b = 0.025, 0.03
        d.box((-w / 2, -t, 0), (w / 2, 0, b), border)
        d.box((-w / 2, -t, h - b), (w / 2, 0, h), border)
        d.box((-w / 2, -t, b), (-w / 2 + b, 0, h - b), border)
        d.box((w / 2 - b, -t, b), (w / 2, 0, h - b), border)
        _panel(d, (-w / 2 + b, b), (w / 2 - b, h - b), -0.01, art)

    return draw


def rug(w: float, dep: float, pattern: Finish, round_rug: bool = False) -> Draw:
    """A flat rug."""

    def draw(d: Drawing) -> None:
        t = 0.008
        if round_rug:
            angles = 2 * math.pi * np.arange(32) / 32
            rim = np.column_stack([np.cos(angles), np.sin(angles)])
            after = np.roll(rim, -1, axis=0)
            flat = np.stack([np.zeros_like(rim), rim, after], axis=1)
            d.add(np.concatenate([flat * w / 2, np.full((32, 3, 1), t)], axis=2), pattern, 0.5 + flat / 2)
            d.lathe([(0, 0), (w / 2, 0), (w / 2, t)], f.CREAM, segments=32)
            return
        d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, t - 0.001), f.CREAM)
        p = np.array([[-w / 2, -dep / 2, t], [w / 2, -dep / 2, t], [w / 2, dep / 2, t], [-w / 2, dep / 2, t]])
        uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
        d.add(np.array([p[[0, 1, 2]], p[[0, 2, 3]]]), pattern, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))

    return draw


def curtain(w: float, h: float, finish: Finish) -> Draw:
    """A pair of drawn-back curtains on a rod; the wall is behind (+y)."""

    def draw(d: Drawing) -> None:
        d.tube([(-w / 2, 0, h - 0.02), (w / 2, 0, h - 0.02)], 0.012, f.DARK_STEEL)
        for side in (-1, 1):
            x = side * np.linspace(w / 2 - 0.04, w / 2 - 0.04 - 0.3 * w, 19)
            y = 0.035 * np.sin(np.arange(19) * math.pi / 2)
            strip = []
            for k in range(18):
                a, b = (x[k], y[k]), (x[k + 1], y[k + 1])
                p = np.array([[*a, 0.02], [*b, 0.02], [*b, h - 0.03], [*a, h - 0.03]])
                p = p if side < 0 else p[[1, 0, 3, 2]]
                q = p + np.array([0.0, 0.006, 0.0])
                strip += [p[[0, 1, 2]], p[[0, 2, 3]], q[[0, 2, 1]], q[[0, 3, 2]]]
            d.add(np.array(strip), finish)

    return draw


def wall_clock(radius: float, rim: Finish) -> Draw:
    """A round clock for the wall."""

    def draw(d: Drawing) -> None:
        d.tube([(0, 0, radius), (0, -0.03, radius)], radius, rim, 28)
        d.tube([(0, -0.028, radius), (0, -0.032, radius)], 0.9 * radius, f.WHITE, 28)
        for hour in range(12):
            a = hour * math.pi / 6
            d.block(
                (0.78 * radius * math.sin(a), -0.033, radius + 0.78 * radius * math.cos(a)),
                (0.012, 0.003, 0.012),
                f.BLACK,
            )
        d.tube([(0, -0.035, radius), (0.45 * radius, -0.035, radius + 0.2 * radius)], 0.006, f.BLACK, 5)
        d.tube([(0, -0.035, radius), (-0.1 * radius, -0.035, radius + 0.7 * radius)], 0.005, f.BLACK, 5)

    return draw


def door_leaf(finish: Finish, panels: int) -> Draw:
    """A door's leaf, 0.86 x 2.02 m, with a handle on either face; its hinges are at -x."""

    def draw(d: Drawing) -> None:
        w, h, t = 0.86, 2.02, 0.04
        d.box((-w / 2, -t / 2, 0), (w / 2, t / 2, h), finish)
        for k in range(panels):
            low, high = 0.14 + k * (h - 0.2) / panels, 0.14 + (k + 1) * (h - 0.2) / panels - 0.1
            for y in (-t / 2 - 0.006, t / 2):
                d.box((-w / 2 + 0.13, y, low), (w / 2 - 0.13, y + 0.006, high), finish)
        for side in (-1, 1):
            y = side * (t / 2 + 0.035)
            d.tube(
                [(w / 2 - 0.06, side * t / 2, 1.0), (w / 2 - 0.06, y, 1.0), (w / 2 - 0.17, y, 1.0)], 0.01, f.STEEL, 6
            )

    return draw


def _decor(category: str, slug: str, draw: Draw, collision: str = "none", name: str = "") -> Drawn:
    return Drawn("decor", category, slug, name or category.replace("_", " "), draw, collision, 6, 0.0, 2000)


DECOR: tuple[Drawn, ...] = (
    _decor("picture", "hills_oak", picture(0.8, 0.55, f.OAK, landscape((0.62, 0.78, 0.9), (0.38, 0.52, 0.3), 1))),
    _decor("picture", "dusk_black", picture(0.6, 0.45, f.BLACK, landscape((0.9, 0.62, 0.48), (0.36, 0.28, 0.42), 2))),
    _decor("picture", "desert_white", picture(1.0, 0.6, f.WHITE, landscape((0.7, 0.82, 0.85), (0.76, 0.56, 0.36), 3))),
    _decor("picture", "abstract_black", picture(0.5, 0.7, f.BLACK, shapes_of_colour((0.92, 0.9, 0.84), 4))),
    _decor("picture", "abstract_brass", picture(0.7, 0.7, f.BRASS, shapes_of_colour((0.18, 0.26, 0.36), 5))),
    _decor("mirror", "oak", picture(0.6, 0.9, f.OAK, Finish((0.80, 0.86, 0.89)))),
    _decor("mirror", "steel", picture(0.8, 0.7, f.STEEL, Finish((0.80, 0.86, 0.89)))),
    _decor("mirror", "tall_black", picture(0.5, 1.5, f.BLACK, Finish((0.80, 0.86, 0.89)))),
    _decor(
        "rug", "blue_lattice", rug(2.0, 1.4, woven((0.25, 0.36, 0.5), (0.86, 0.84, 0.78), (0.68, 0.6, 0.42), "lattice"))
    ),
    _decor(
        "rug", "grey_bands", rug(2.3, 1.6, woven((0.62, 0.61, 0.6), (0.82, 0.81, 0.79), (0.45, 0.44, 0.44), "bands"))
    ),
    _decor(
        "rug",
        "red_medallion",
        rug(1.8, 1.2, woven((0.55, 0.16, 0.14), (0.84, 0.72, 0.5), (0.16, 0.2, 0.34), "medallion")),
    ),
    _decor(
        "rug",
        "round_sage",
        rug(1.6, 1.6, woven((0.62, 0.68, 0.58), (0.88, 0.87, 0.8), (0.42, 0.5, 0.42), "medallion"), True),
    ),
    _decor("bath_mat", "white", rug(0.7, 0.45, f.cloth((0.85, 0.88, 0.9)))),
    _decor("curtain", "cream", curtain(1.6, 2.2, f.cloth((0.88, 0.84, 0.74)))),
    _decor("curtain", "blue", curtain(1.4, 2.2, f.cloth((0.42, 0.52, 0.62)))),
    _decor("curtain", "green", curtain(1.8, 2.2, f.cloth((0.5, 0.56, 0.44)))),
    _decor("wall_clock", "black", wall_clock(0.16, f.BLACK)),
    _decor("wall_clock", "oak", wall_clock(0.14, f.OAK)),
    Drawn("door", "door", "leaf_white", "door", door_leaf(f.WHITE, 2), "boxes", 1),
    Drawn("door", "door", "leaf_oak", "oak door", door_leaf(f.OAK, 3), "boxes", 1),
    Drawn("door", "door", "leaf_walnut", "walnut door", door_leaf(f.WALNUT, 2), "boxes", 1),
)
