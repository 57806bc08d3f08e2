"""Other light, another camera: what images of a home could have looked like."""

import cv2
import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

Image = NDArray[np.uint8]


def relit(rgb: Image, rng: Generator) -> Image:
    """Return an (H, W, 3) image under another light, exposure and white balance, with noise, blur or JPEG's marks."""
    levels = np.linspace(0.0, 1.0, 256, dtype=np.float32)
    gamma, gain = np.exp(rng.normal(0.0, 0.25)), np.exp(rng.normal(0.0, 0.22))
    lift = rng.uniform(0.0, 0.06) * rng.integers(2)
    balance = np.exp(rng.normal(0.0, 0.08, 3)).astype(np.float32)
    table = np.clip((levels[:, None] ** gamma * gain + lift) * balance, 0.0, 1.0) * 255.0
    image: Image = np.asarray(cv2.LUT(rgb, table[None].astype(np.uint8)), dtype=np.uint8)
    if rng.random() < 0.4:
        image = _resaturated(image, float(rng.uniform(0.3, 1.4)), float(rng.uniform(-8.0, 8.0)))
    if rng.random() < 0.2:
        image = np.asarray(cv2.GaussianBlur(image, (0, 0), float(rng.uniform(0.4, 1.2))), dtype=np.uint8)
    if rng.random() < 0.5:
        noise = rng.standard_normal(image.shape, dtype=np.float32) * np.float32(rng.uniform(1.0, 9.0))
        image = np.clip(image + noise, 0.0, 255.0).astype(np.uint8)
    if rng.random() < 0.15:
        quality = [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(30, 85))]
        image = np.asarray(cv2.imdecode(cv2.imencode(".jpg", image, quality)[1], cv2.IMREAD_COLOR), dtype=np.uint8)
    return image


def _resaturated(image: Image, factor: float, turn: float) -> Image:
    """Return an image with its colours stronger or weaker, and turned (degrees of hue halved, as OpenCV counts)."""
    hsv = cv2.cvtColor(image, cv2.COLOR_RGB2HSV).astype(np.int16)
    hsv[..., 0] = (hsv[..., 0] + int(turn)) % 180
    hsv[..., 1] = np.clip(hsv[..., 1] * factor, 0, 255)
    return np.asarray(cv2.cvtColor(hsv.astype(np.uint8), cv2.COLOR_HSV2RGB), dtype=np.uint8)


def holed(depth: NDArray[np.float32], rng: Generator) -> NDArray[np.float32]:
    """Return an (H, W) depth image (m) as a real camera's: noise that grows with the square, holes at edges."""
    noisy = depth + rng.standard_normal(depth.shape, dtype=np.float32) * (
        np.float32(rng.uniform(0.0, 0.004)) * depth**2
    )
    if rng.random() < 0.5:
        edges = np.abs(cv2.Laplacian(depth, cv2.CV_32F)) > 0.2
        noisy[edges & (rng.random(depth.shape) < 0.7)] = 0.0
    return np.where(depth > 0, np.maximum(noisy, 0.0), np.float32(0.0)).astype(np.float32)
