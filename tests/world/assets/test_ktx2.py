"""Pictures in KTX2, made by another program's encoder."""

import sys

import numpy as np
import pytest

from uniteam.errors import UnavailableError
from uniteam.world.assets.image import decode_image
from uniteam.world.assets.ktx2 import LARGEST_SIDE, MAGIC

alktx2 = pytest.importorskip("alktx2", reason="the encoder has wheels for Linux only")


def coded(picture: np.ndarray, **options: object) -> bytes:
    """Return a picture's KTX2 file."""
    height, width = picture.shape[:2]
    rgba = np.dstack([picture, np.full((height, width), 255, np.uint8)]).tobytes()
    file: bytes = alktx2.encode_raw_rgba_to_ktx2(rgba, width, height, effort=0, threads=1, **options)
    return file


def halves(height: int, width: int) -> np.ndarray:
    """Return a picture whose upper half is red and whose lower half is blue."""
    picture = np.zeros((height, width, 3), np.uint8)
    picture[: height // 2, :, 0] = 200
    picture[height // 2 :, :, 2] = 100
    return picture


@pytest.mark.parametrize("codec", ["uastc", "etc1s"])
def test_a_picture_comes_back_upright_and_in_its_colours(codec: str) -> None:
    picture = halves(64, 40)
    decoded = decode_image(coded(picture, codec=codec))
    assert decoded.shape == picture.shape
    assert np.abs(decoded.astype(int) - picture).max() <= 8


def test_of_a_large_picture_a_smaller_level_is_taken() -> None:
    decoded = decode_image(coded(halves(8, 2 * LARGEST_SIDE), codec="etc1s", mipmaps=True))
    assert decoded.shape == (4, LARGEST_SIDE, 3)


@pytest.mark.parametrize("content", [MAGIC, MAGIC + bytes(200), coded(np.zeros((8, 8, 3), np.uint8))[:90]])
def test_damaged_pictures_are_refused_in_a_sentence(content: bytes) -> None:
    with pytest.raises(ValueError, match=r".+"):
        decode_image(content)


def test_without_the_extra_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    content = coded(np.zeros((8, 8, 3), np.uint8))
    monkeypatch.setitem(sys.modules, "opengl_basisu", None)
    with pytest.raises(UnavailableError, match=r"uniteam\[hssd\]"):
        decode_image(content)
