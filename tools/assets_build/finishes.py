"""Finishes of the models drawn here: woods, cloths, wicker, cardboard, metals, paints."""

import numpy as np
from numpy.typing import NDArray

from assets_build.images import encode_jpeg
from assets_build.primitives import Color, Finish

SIDE = 128


def _fold(rng: np.random.Generator, scale: tuple[float, float]) -> NDArray[np.float64]:
    spectrum = np.fft.rfft2(rng.standard_normal((SIDE, SIDE)))
    down, across = np.fft.fftfreq(SIDE)[:, None], np.fft.rfftfreq(SIDE)[None, :]
    soft = np.fft.irfft2(spectrum * np.exp(-20 * ((down * scale[0]) ** 2 + (across * scale[1]) ** 2)))
    return (soft - soft.mean()) / soft.std()


def _image(color: Color, light: NDArray[np.float64], tile: float) -> Finish:
    pixels = np.clip(255 * np.array(color) * light[..., None], 0, 255).astype(np.uint8)
    return Finish((1.0, 1.0, 1.0), encode_jpeg(pixels, 85), tile)


def wood(color: Color, seed: int = 1) -> Finish:
    """Return a grained wood."""
    rng = np.random.default_rng(seed)
    return _image(color, 1 + 0.07 * _fold(rng, (0.8, 22)) + 0.04 * _fold(rng, (5, 60)), 0.6)


def cloth(color: Color, seed: int = 2) -> Finish:
    """Return a woven cloth."""
    rng = np.random.default_rng(seed)
    i, j = np.meshgrid(np.arange(SIDE), np.arange(SIDE), indexing="ij")
    weave = 0.05 * np.sign(np.sin(np.pi * i / 4) * np.sin(np.pi * j / 4))
    return _image(color, 1 + weave + 0.04 * _fold(rng, (1, 1)), 0.12)


def striped(first: Color, second: Color, count: int = 4) -> Finish:
    """Return a cloth with stripes."""
    wave = ((np.arange(SIDE) * 2 * count // SIDE) % 2)[None, :, None]
    pixels = np.broadcast_to(255 * (wave * np.array(first) + (1 - wave) * np.array(second)), (SIDE, SIDE, 3))
    return Finish((1.0, 1.0, 1.0), encode_jpeg(np.ascontiguousarray(pixels.astype(np.uint8)), 85), 0.16)


def wicker(color: Color) -> Finish:
    """Return a basket weave."""
    i, j = np.meshgrid(np.arange(SIDE), np.arange(SIDE), indexing="ij")
    over = ((i // 16 + j // 32) % 2) == 0
    light = 0.82 + 0.25 * np.abs(np.sin(np.pi * i / 16)) * np.where(over, 1.0, 0.75)
    return _image(color, light, 0.12)


def speckled(color: Color, grain: float, seed: int = 3) -> Finish:
    """Return a speckled surface such as cardboard, cork or stone."""
    rng = np.random.default_rng(seed)
    return _image(color, 1 + grain * _fold(rng, (1, 1)), 0.3)


def printed(paper: Color, ink: Color, seed: int) -> Finish:
    """Return a label or cover: a band, a block and lines as of print."""
    rng = np.random.default_rng(seed)
    pixels = np.tile(np.array(paper), (SIDE, SIDE, 1))
    pixels[10:34, 8:-8] = ink
    pixels[44:96, 14 + int(rng.integers(0, 20)) : 84 + int(rng.integers(0, 30))] = 0.5 * np.array(
        ink
    ) + 0.5 * rng.random(3)
    for row in range(102, 122, 6):
        pixels[row : row + 2, 12 : 70 + int(rng.integers(0, 45))] = 0.6 * np.array(ink)
    return Finish((1.0, 1.0, 1.0), encode_jpeg(np.clip(255 * pixels, 0, 255).astype(np.uint8), 85), 0.25)


OAK = wood((0.74, 0.57, 0.38), 11)
WALNUT = wood((0.42, 0.28, 0.19), 12)
PINE = wood((0.86, 0.73, 0.52), 13)
CHERRY = wood((0.58, 0.30, 0.18), 14)
GREY_WOOD = wood((0.58, 0.55, 0.51), 15)
WHITE = Finish((0.93, 0.93, 0.91))
CREAM = Finish((0.92, 0.88, 0.78))
BLACK = Finish((0.10, 0.10, 0.11))
STEEL = Finish((0.72, 0.74, 0.76))
DARK_STEEL = Finish((0.30, 0.31, 0.33))
BRASS = Finish((0.78, 0.62, 0.30))
GREY_PAINT = Finish((0.55, 0.57, 0.60))
GRAPHITE = Finish((0.36, 0.37, 0.39))
NAVY = Finish((0.14, 0.20, 0.36))
SAGE = Finish((0.56, 0.66, 0.55))
RED = Finish((0.74, 0.16, 0.14))
TERRACOTTA = Finish((0.76, 0.42, 0.29))
CARDBOARD = speckled((0.70, 0.55, 0.37), 0.03)
MARBLE = speckled((0.88, 0.87, 0.85), 0.04, 5)
GRANITE = speckled((0.32, 0.32, 0.34), 0.12, 6)
NATURAL_WICKER = wicker((0.76, 0.60, 0.38))
DARK_WICKER = wicker((0.45, 0.31, 0.20))
WHITE_WICKER = wicker((0.92, 0.90, 0.86))
