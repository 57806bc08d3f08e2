"""Pictures as files: a path that is told as written holds the whole picture."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.files import write_whole


def write_png(path: Path, rgb: NDArray[np.uint8]) -> None:
    """Write an (H, W, 3) RGB picture as PNG, as small as may be; raises UnwritableError."""
    options = [cv2.IMWRITE_PNG_COMPRESSION, 9, cv2.IMWRITE_PNG_STRATEGY, cv2.IMWRITE_PNG_STRATEGY_DEFAULT]
    _write(path, ".png", rgb, options)


def write_jpeg(path: Path, rgb: NDArray[np.uint8], quality: int = 66) -> None:
    """Write an (H, W, 3) RGB picture as JPEG; raises UnwritableError."""
    options = [cv2.IMWRITE_JPEG_QUALITY, quality, cv2.IMWRITE_JPEG_OPTIMIZE, 1, cv2.IMWRITE_JPEG_PROGRESSIVE, 1]
    _write(path, ".jpg", rgb, options)


def _write(path: Path, suffix: str, rgb: NDArray[np.uint8], options: list[int]) -> None:
    _, encoded = cv2.imencode(suffix, rgb[..., ::-1], options)
    write_whole(path, encoded.tobytes())
