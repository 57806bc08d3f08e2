"""The pictures of a dataset: of which of the head camera's images, how filmed, and what their levels stand for."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.lerobot.depth_levels import FARTHEST, LEVELS, NEAREST, SHIFT, depth_levels, level_distances
from uniteam.adapters.lerobot.film_series import COLOUR, FilmKind
from uniteam.world.rendering.kernels.frame import Frame

DEPTH = FilmKind(
    "libx265",
    "hevc",
    "gray12le",
    "gray12le",
    1,
    {"preset": "ultrafast", "x265-params": "lossless=1:bframes=0:pools=1:frame-threads=1:log-level=error"},
    {
        "video.extra_options": {"x265-params": "lossless=1"},
        "video.depth_min": NEAREST,
        "video.depth_max": FARTHEST,
        "video.shift": SHIFT,
        "video.use_log": True,
        "is_depth_map": True,
        "depth_unit": "m",
    },
)
"""Every level comes back."""


@dataclass(frozen=True, eq=False)
class FilmedCamera:
    """One feature of pictures.

    Attributes:
        key: its name.
        kind: how it is filmed.
        read: the picture of a frame, (H, W, C) or (H, W).
        values: what each level of a pixel stands for in the statistics: shares of full brightness, or m.
    """

    key: str
    kind: FilmKind
    read: Callable[[Frame], NDArray[Any]]
    values: NDArray[np.float64]


HEAD = FilmedCamera("observation.images.head", COLOUR, lambda frame: frame.rgb, np.arange(256) / 255.0)
HEAD_DEPTH = FilmedCamera(
    "observation.images.head_depth", DEPTH, lambda frame: depth_levels(frame.depth), level_distances()
)
assert len(HEAD_DEPTH.values) == LEVELS, "a level each"
