"""Textures with their mip levels in one flat array of texels, so that a compiled kernel can look any of them up."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError

MOST_TEXELS = 2**29
"""Of all textures of a scene, with their smaller levels: 2 GiB."""
MAX_LEVELS = 11
"""Mip levels a texture may have: 1024 texels and down to one."""


@dataclass(frozen=True)
class MipChain:
    """One texture with every level of its pyramid, ready to be packed.

    Attributes:
        texels: (K,) uint32 of 0x00BBGGRR, level after level, each row by row. A level has its first column and its
            first row once more at its end, so that a texel's neighbours always follow it.
        log2_width, log2_height: of level 0.
        starts: (MAX_LEVELS,) int32, where each level begins in `texels`; the last level repeats.
        last_level: index of the level that is one texel large.
    """

    texels: NDArray[np.uint32]
    log2_width: int
    log2_height: int
    starts: NDArray[np.int32]
    last_level: int


def build_mip_chain(image: NDArray[np.uint8]) -> MipChain:
    """Return the pyramid of a (H, W, 3) RGB image, resized to powers of two so that repeating is a bit mask."""
    log2_width, log2_height = (_log2_size(n) for n in (image.shape[1], image.shape[0]))
    last_level = max(log2_width, log2_height)
    level_image: NDArray[Any] = image
    levels = []
    for level in range(last_level + 1):
        size = (1 << max(log2_width - level, 0), 1 << max(log2_height - level, 0))
        if (level_image.shape[1], level_image.shape[0]) != size:
            level_image = cv2.resize(level_image, size, interpolation=cv2.INTER_AREA)
        levels.append(_pack(level_image))
    ends = np.cumsum([len(texels) for texels in levels])
    starts = np.concatenate([[0], ends[:-1]])
    starts = np.pad(starts, (0, MAX_LEVELS - len(starts)), mode="edge").astype(np.int32)
    return MipChain(np.concatenate(levels), log2_width, log2_height, starts, last_level)


def _log2_size(size: int) -> int:
    return min(int(np.ceil(np.log2(max(size, 1)) - 0.25)), MAX_LEVELS - 1)


def _pack(image: NDArray[Any]) -> NDArray[np.uint32]:
    rgb = np.pad(image, ((0, 1), (0, 1), (0, 0)), mode="wrap").reshape(-1, 3).astype(np.uint32)
    return np.asarray(rgb[:, 0] | (rgb[:, 1] << 8) | (rgb[:, 2] << 16), dtype=np.uint32)


WHITE = build_mip_chain(np.full((1, 1, 3), 255, dtype=np.uint8))
"""What a material without a texture looks up: its own colour comes from the tint."""


@dataclass(frozen=True)
class TextureAtlas:
    """Every texture of a scene in one array.

    Attributes:
        texels: (N,) uint32 of 0x00BBGGRR.
        layout: (M, 3 + MAX_LEVELS) int32 a texture: log2 of width and of height, last level, where each level starts.
    """

    texels: NDArray[np.uint32]
    layout: NDArray[np.int32]


class MipCache:
    """Builds the pyramid of an image once, however many meshes share the image."""

    def __init__(self) -> None:
        self._chains: dict[int, tuple[NDArray[np.uint8], MipChain]] = {}

    def __call__(self, image: NDArray[np.uint8]) -> MipChain:
        """Return the image's mip chain."""
        if id(image) not in self._chains:
            # The image is kept with its chain: its id stays its own as long as it lives.
            self._chains[id(image)] = (image, build_mip_chain(image))
        return self._chains[id(image)][1]


class AtlasBuilder:
    """Collects mip chains, each once, and packs them."""

    def __init__(self) -> None:
        self._chains: list[MipChain] = []
        self._index: dict[int, int] = {}

    def add(self, chain: MipChain) -> int:
        """Return the texture's index in the atlas."""
        key = id(chain)
        if key not in self._index:
            self._index[key] = len(self._chains)
            self._chains.append(chain)
        return self._index[key]

    def build(self) -> TextureAtlas:
        """Pack what was added."""
        return pack_atlas(self._chains)


def pack_atlas(chains: Sequence[MipChain]) -> TextureAtlas:
    """Return one atlas of the chains, in their order."""
    bases = np.concatenate([[0], np.cumsum([len(c.texels) for c in chains])])
    if bases[-1] > MOST_TEXELS:
        raise InvalidInputError(f"textures of {bases[-1]} texels are more than the {MOST_TEXELS} that a home may show")
    rows = [
        [c.log2_width, c.log2_height, c.last_level, *(c.starts + base)]
        for c, base in zip(chains, bases[:-1], strict=True)
    ]
    return TextureAtlas(np.concatenate([c.texels for c in chains]), np.array(rows, dtype=np.int32))
