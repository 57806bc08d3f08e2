"""Pictures as files: a path that is told as written holds the whole picture."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.files import write_whole


def write_png(path: Path, rgb: NDArray[np.uint8]) -> None:
    """Write an (H, W, 3) RGB picture as PNG; raises UnwritableError."""
    _, encoded = cv2.imencode(".png", rgb[..., ::-1])
    write_whole(path, encoded.tobytes())
