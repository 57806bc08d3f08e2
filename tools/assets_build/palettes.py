"""Finishes to choose from; an instance that tests has colours and patterns that training never shows."""

import cv2
import numpy as np

from assets_build import finishes as f
from assets_build.images import encode_jpeg
from assets_build.primitives import Color, Finish
from assets_build.variation import Variation

COLORS: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.74, 0.15, 0.14), (0.16, 0.33, 0.62), (0.20, 0.48, 0.30), (0.93, 0.76, 0.22), (0.10, 0.52, 0.55),
     (0.13, 0.13, 0.15), (0.90, 0.90, 0.88), (0.55, 0.57, 0.60), (0.62, 0.42, 0.26)),
    ((0.90, 0.45, 0.12), (0.46, 0.25, 0.56), (0.50, 0.72, 0.88), (0.44, 0.48, 0.20), (0.88, 0.55, 0.62),
     (0.26, 0.28, 0.33), (0.94, 0.89, 0.78)),
)  # fmt: skip
PALE: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.93, 0.93, 0.91), (0.80, 0.87, 0.92), (0.93, 0.85, 0.72), (0.78, 0.86, 0.76), (0.72, 0.73, 0.75)),
    ((0.95, 0.91, 0.86), (0.90, 0.78, 0.78), (0.84, 0.82, 0.92)),
)
CERAMIC: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.95, 0.95, 0.94), (0.91, 0.89, 0.83), (0.84, 0.86, 0.88)),
    ((0.97, 0.94, 0.88), (0.88, 0.93, 0.93), (0.80, 0.80, 0.78)),
)
DARK: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.10, 0.10, 0.11), (0.30, 0.31, 0.33), (0.14, 0.20, 0.36), (0.32, 0.12, 0.12), (0.12, 0.26, 0.20)),
    ((0.20, 0.17, 0.15), (0.24, 0.16, 0.30), (0.10, 0.24, 0.30)),
)
METALS: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.72, 0.74, 0.76), (0.30, 0.31, 0.33), (0.78, 0.62, 0.30), (0.58, 0.60, 0.62)),
    ((0.82, 0.82, 0.80), (0.72, 0.45, 0.30), (0.44, 0.44, 0.42)),
)
GLASSES: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.74, 0.81, 0.83), (0.62, 0.74, 0.66), (0.70, 0.60, 0.42)),
    ((0.66, 0.76, 0.86), (0.80, 0.78, 0.72)),
)
WOODS = (
    (f.OAK, f.WALNUT, f.PINE, f.GREY_WOOD),
    (f.CHERRY, f.wood((0.80, 0.64, 0.50), 16), f.wood((0.28, 0.2, 0.16), 17)),
)
LEATHERS: tuple[tuple[Color, ...], tuple[Color, ...]] = (
    ((0.42, 0.26, 0.16), (0.12, 0.12, 0.13), (0.66, 0.46, 0.28), (0.36, 0.10, 0.12)),
    ((0.54, 0.32, 0.20), (0.20, 0.24, 0.22), (0.76, 0.66, 0.52)),
)


def paint(v: Variation, palette: tuple[tuple[Color, ...], tuple[Color, ...]] = COLORS) -> Finish:
    """Return a plain colour of a palette."""
    return Finish(v.pick(*palette))


def wood(v: Variation) -> Finish:
    """Return a wood."""
    return v.pick(*WOODS)


def metal(v: Variation) -> Finish:
    """Return a metal."""
    return paint(v, METALS)


def leather(v: Variation) -> Finish:
    """Return a leather."""
    return f.speckled(v.pick(*LEATHERS), 0.05, 1 + v.seed() % 97)


def speckle(v: Variation, grain: float = 0.05) -> Finish:
    """Return a speckled colour: stoneware, felt, foam."""
    return f.speckled(v.pick(*COLORS), grain, 1 + v.seed() % 97)


def cloth(v: Variation) -> Finish:
    """Return a cloth: plain or striped where it trains, checked or dotted where it tests."""
    first, second = v.pick(*COLORS), v.pick(*PALE)
    kind = v.pick(("plain", "striped", "plain", "wide"), ("checked", "dotted"))
    if kind == "plain":
        return f.cloth(first, 2 + v.seed() % 97)
    if kind in ("striped", "wide"):
        return f.striped(first, second, 5 if kind == "striped" else 2)
    return pattern(first, second, kind)


def pattern(first: Color, second: Color, kind: str) -> Finish:
    """Return a checked or dotted cloth."""
    i, j = np.meshgrid(np.arange(f.SIDE), np.arange(f.SIDE), indexing="ij")
    if kind == "checked":
        mix = 0.5 * ((i // 16 % 2) + (j // 16 % 2))
    else:
        mix = ((i % 32 - 16) ** 2 + (j % 32 - 16) ** 2 < 60).astype(float)
    pixels = 255 * (mix[..., None] * np.array(second) + (1 - mix[..., None]) * np.array(first))
    return Finish((1.0, 1.0, 1.0), encode_jpeg(pixels.astype(np.uint8), 85), 0.14)


def label(v: Variation) -> Finish:
    """Return a printed label: a band and a block where it trains, a disc or a slanting bar where it tests."""
    paper, ink, seed = v.pick(*PALE), v.pick(*COLORS), v.seed()
    kind = v.pick(("block", "inverse"), ("disc", "slant"))
    if kind == "inverse":
        paper, ink = ink, paper
    if kind in ("block", "inverse"):
        return f.printed(paper, ink, seed)
    pixels = np.tile(np.array(paper) * 255, (f.SIDE, f.SIDE, 1)).astype(np.uint8)
    colour = [int(255 * c) for c in ink]
    if kind == "disc":
        cv2.circle(pixels, (64, 52), 36, colour, -1, cv2.LINE_AA)
        cv2.circle(pixels, (64, 52), 22, [int(255 * c) for c in paper], -1, cv2.LINE_AA)
    else:
        cv2.fillConvexPoly(pixels, np.array([[0, 84], [127, 30], [127, 66], [0, 120]]), colour, cv2.LINE_AA)
    for row in (100, 110, 118):
        cv2.line(pixels, (18, row), (60 + seed % 50, row), colour, 3)
    return Finish((1.0, 1.0, 1.0), encode_jpeg(pixels, 85), 0.25)
