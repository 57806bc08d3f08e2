"""Textures of the sources, made opaque, small, and JPEG."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image

GLASS = np.array([0.74, 0.81, 0.83])


def read_texture(path: Path, limit: int) -> NDArray[np.uint8] | None:
    """Return the (H, W, 3) RGB image of at most `limit` pixels a side; holes take the mean of what is opaque."""
    try:
        image = Image.open(path).convert("RGBA")
    except OSError:
        return None
    scale = limit / max(image.size)
    if scale < 1:
        image = image.resize((max(1, round(image.width * scale)), max(1, round(image.height * scale))), Image.LANCZOS)
    pixels = np.asarray(image, dtype=np.float64)
    alpha = pixels[..., 3:] / 255
    mean = (pixels[..., :3] * alpha).sum((0, 1)) / max(alpha.sum(), 1e-9)
    return np.round(pixels[..., :3] * alpha + mean * (1 - alpha)).astype(np.uint8)


def encode_jpeg(image: NDArray[np.uint8], quality: int = 82) -> bytes:
    """Return the JPEG bytes of an RGB image."""
    return cv2.imencode(".jpg", image[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, quality])[1].tobytes()


def as_opaque(color: tuple[float, float, float], opacity: float) -> tuple[float, float, float]:
    """Return the colour that a see-through material shows when it must be opaque: that of glass, tinted."""
    mixed = np.array(color) * (0.35 + 0.65 * opacity) + GLASS * (0.65 * (1 - opacity))
    r, g, b = (float(round(min(v, 1.0), 4)) for v in mixed)
    return (r, g, b)
