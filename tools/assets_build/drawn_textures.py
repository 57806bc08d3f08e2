"""Plain floors and walls drawn here: plaster, parquet, planks, carpet, tiles, wallpaper; they tile seamlessly."""

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

SIDE = 512

Image = NDArray[np.uint8]
Color = tuple[int, int, int]


@dataclass(frozen=True)
class DrawnTexture:
    """How to draw a texture, what it suits, and the side (m) of the square it covers."""

    draw: Callable[[np.random.Generator], Image]
    kinds: tuple[str, ...]
    size: float


def _noise(rng: np.random.Generator, scale: tuple[float, float]) -> NDArray[np.float64]:
    """Return (SIDE, SIDE) seamless noise of unit deviation, blurred by `scale` pixels (down, across)."""
    spectrum = np.fft.rfft2(rng.standard_normal((SIDE, SIDE)))
    down, across = np.fft.fftfreq(SIDE)[:, None], np.fft.rfftfreq(SIDE)[None, :]
    blurred = np.fft.irfft2(spectrum * np.exp(-2 * (np.pi**2) * ((down * scale[0]) ** 2 + (across * scale[1]) ** 2)))
    return (blurred - blurred.mean()) / blurred.std()


def _shade(color: Color, light: NDArray[np.float64]) -> Image:
    return np.clip(np.array(color)[None, None] * light[..., None], 0, 255).astype(np.uint8)


def plaster(color: Color, grain: float) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of painted plaster."""
    return lambda rng: _shade(color, 1 + grain * (0.6 * _noise(rng, (2, 2)) + 0.4 * _noise(rng, (30, 30))))


def carpet(color: Color) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of a short-pile carpet."""
    return lambda rng: _shade(color, 1 + 0.07 * _noise(rng, (0.8, 0.8)) + 0.03 * _noise(rng, (12, 12)))


def planks(color: Color, rows: int, contrast: float) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of floor boards, staggered, with grain along them."""

    def draw(rng: np.random.Generator) -> Image:
        light = 1 + 0.05 * _noise(rng, (1.2, 40)) + 0.03 * _noise(rng, (4, 90))
        height = SIDE // rows
        for row in range(rows):
            band = slice(row * height, (row + 1) * height)
            cut = int(rng.integers(0, SIDE))
            for start, length in ((cut, SIDE // 2), (cut + SIDE // 2, SIDE - SIDE // 2)):
                columns = np.arange(start, start + length) % SIDE
                light[band, columns] *= 1 + contrast * rng.uniform(-1, 1)
                light[band, columns[:2]] *= 0.72
            light[row * height : row * height + 2] *= 0.72
        return _shade(color, light)

    return draw


def mosaic(color: Color) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of mosaic parquet."""

    def draw(rng: np.random.Generator) -> Image:
        unit = SIDE // 16
        light = np.ones((SIDE, SIDE))
        fine = 0.05 * _noise(rng, (1, 20))
        for i in range(-4, 20):
            for j in range(-20, 24):
                if (i + j) % 4:
                    continue
                shade = 1 + 0.1 * rng.uniform(-1, 1)
                for k, (width, height) in enumerate(((4, 1), (1, 4))):
                    x, y = (j * unit, i * unit) if k == 0 else ((j + 4) * unit, (i - 3) * unit)
                    rows = np.arange(y, y + height * unit) % SIDE
                    columns = np.arange(x, x + width * unit) % SIDE
                    patch = shade * (1 - 0.06 * k) * (1 + (fine if k == 0 else fine.T)[np.ix_(rows, columns)])
                    patch[:2] *= 0.75
                    patch[:, :2] *= 0.75
                    light[np.ix_(rows, columns)] = patch
        return _shade(color, light)

    return draw


def tiles(
    color: Color, grout: Color, count: tuple[int, int], brick: bool = False
) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of `count` (across, down) ceramic tiles, every other row shifted where laid as bricks."""

    def draw(rng: np.random.Generator) -> Image:
        image = _shade(color, 1 + 0.015 * _noise(rng, (8, 8)))
        width, height = SIDE // count[0], SIDE // count[1]
        for row in range(count[1]):
            shift = width // 2 if brick and row % 2 else 0
            for column in range(count[0]):
                columns = (np.arange(width) + column * width + shift) % SIDE
                rows = np.arange(row * height, (row + 1) * height)
                block = image[np.ix_(rows, columns)] * (1 + 0.03 * rng.uniform(-1, 1))
                block[:4], block[:, :4] = grout, grout
                image[np.ix_(rows, columns)] = np.clip(block, 0, 255).astype(np.uint8)
        return image

    return draw


def stripes(first: Color, second: Color, count: int) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of striped wallpaper."""

    def draw(rng: np.random.Generator) -> Image:
        wave = (np.arange(SIDE) * 2 * count // SIDE) % 2
        mix = (
            wave[None, :, None] * np.array(first)[None, None] + (1 - wave)[None, :, None] * np.array(second)[None, None]
        )
        return np.clip(mix * (1 + 0.01 * _noise(rng, (1, 1)))[..., None], 0, 255).astype(np.uint8)

    return draw


def diamonds(paper: Color, ink: Color, count: int) -> Callable[[np.random.Generator], Image]:
    """Return a drawer of wallpaper with a grid of small diamonds."""

    def draw(rng: np.random.Generator) -> Image:
        image = _shade(paper, 1 + 0.01 * _noise(rng, (1, 1)))
        step = SIDE // count
        for row in range(2 * count + 1):
            for column in range(-1, count + 1):
                centre = (column * step + (step // 2 if row % 2 else 0), row * step // 2)
                points = np.array([[centre[0] + dx, centre[1] + dy] for dx, dy in ((-9, 0), (0, -14), (9, 0), (0, 14))])
                for dx in (-SIDE, 0, SIDE):
                    cv2.fillConvexPoly(image, points + np.array([dx, 0]), ink)
        return image

    return draw


DRAWN: dict[str, DrawnTexture] = {
    "plaster_white": DrawnTexture(plaster((238, 236, 230), 0.012), ("wall",), 1.5),
    "plaster_rough": DrawnTexture(plaster((228, 222, 210), 0.035), ("wall",), 1.2),
    "paint_matt": DrawnTexture(plaster((232, 232, 232), 0.006), ("wall",), 1.5),
    "concrete": DrawnTexture(plaster((165, 163, 158), 0.05), ("floor", "wall"), 2.0),
    "linoleum": DrawnTexture(plaster((196, 178, 150), 0.04), ("floor",), 1.0),
    "carpet_grey": DrawnTexture(carpet((132, 130, 128)), ("floor",), 0.8),
    "carpet_beige": DrawnTexture(carpet((190, 174, 150)), ("floor",), 0.8),
    "carpet_blue": DrawnTexture(carpet((84, 102, 128)), ("floor",), 0.8),
    "planks_oak": DrawnTexture(planks((186, 146, 100), 8, 0.09), ("floor",), 1.2),
    "planks_walnut": DrawnTexture(planks((110, 76, 52), 8, 0.12), ("floor",), 1.2),
    "planks_pale": DrawnTexture(planks((212, 192, 162), 6, 0.05), ("floor",), 1.2),
    "planks_grey": DrawnTexture(planks((150, 142, 132), 6, 0.08), ("floor",), 1.2),
    "parquet_mosaic": DrawnTexture(mosaic((170, 122, 78)), ("floor",), 1.4),
    "tiles_white_metro": DrawnTexture(tiles((236, 238, 236), (190, 190, 188), (4, 8), brick=True), ("wall",), 0.8),
    "tiles_white_square": DrawnTexture(tiles((232, 234, 236), (196, 198, 200), (4, 4)), ("floor", "wall"), 0.8),
    "tiles_sage": DrawnTexture(tiles((158, 178, 160), (216, 218, 212), (6, 6)), ("wall",), 0.9),
    "tiles_terracotta": DrawnTexture(tiles((178, 100, 70), (150, 138, 124), (3, 3)), ("floor",), 0.9),
    "tiles_slate": DrawnTexture(tiles((86, 92, 98), (120, 122, 124), (2, 2)), ("floor",), 1.0),
    "wallpaper_stripes_blue": DrawnTexture(stripes((206, 216, 226), (224, 230, 236), 6), ("wall",), 0.9),
    "wallpaper_stripes_cream": DrawnTexture(stripes((236, 226, 204), (226, 214, 188), 8), ("wall",), 0.9),
    "wallpaper_diamonds": DrawnTexture(diamonds((226, 220, 212), (186, 170, 160), 6), ("wall",), 0.8),
}
