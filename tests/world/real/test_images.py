"""Pictures come out as they were packed; those that lie about their size are refused before they are decoded."""

import struct

import cv2
import numpy as np
import pytest

from uniteam.world.real.images import decode_depth, decode_rgb, encode_depth, encode_rgb
from uniteam.world.real.robot_errors import StrangeMessageError

SHAPE = (96, 128)
RED = np.full((*SHAPE, 3), (200, 30, 40), np.uint8)
RAMP = np.linspace(0.3, 9.9, SHAPE[0] * SHAPE[1], dtype=np.float32).reshape(SHAPE)


def test_colours_come_out_in_their_order_though_the_picture_has_them_exchanged() -> None:
    packed = encode_rgb(RED)
    assert np.abs(decode_rgb(packed.tobytes(), SHAPE).astype(int) - RED).max() <= 3
    as_others_see_it = np.asarray(cv2.imdecode(packed, cv2.IMREAD_COLOR))[..., ::-1]
    assert as_others_see_it[0, 0, 2] > 190


def test_depth_is_exact_to_half_a_millimetre_and_nothing_beyond_the_range() -> None:
    depth = RAMP.copy()
    depth[:8] = 0.0
    depth[8:12] = 12.0
    noisy = depth + np.random.default_rng(0).normal(0.0, 0.01, SHAPE).astype(np.float32) * (depth > 0)
    seen = decode_depth(encode_depth(noisy).tobytes(), SHAPE)
    assert seen.dtype == np.float32
    np.testing.assert_allclose(seen[12:], np.where(noisy[12:] > 10.0, 0.0, noisy[12:]), atol=0.00051)
    assert not seen[:12].any()


def with_jpeg_size(rows: int, columns: int) -> bytes:
    data = bytearray(encode_rgb(RED).tobytes())
    at = data.index(b"\xff\xc0")
    data[at + 5 : at + 9] = struct.pack(">HH", rows, columns)
    return bytes(data)


def with_jpeg2000_size(rows: int, columns: int) -> bytes:
    data = bytearray(encode_depth(RAMP).tobytes())
    at = data.index(b"\xff\x4f\xff\x51")
    data[at + 8 : at + 16] = struct.pack(">II", columns, rows)
    return bytes(data)


@pytest.mark.parametrize(
    ("decode", "data", "shape"),
    [
        (decode_rgb, with_jpeg_size(60_000, 60_000), SHAPE),
        (decode_rgb, with_jpeg_size(60_000, 60_000), (60_000, 60_000)),
        (decode_depth, with_jpeg2000_size(2**31, 2**31), SHAPE),
        (decode_depth, with_jpeg2000_size(2**31, 2**31), (2**31, 2**31)),
        (decode_rgb, encode_rgb(RED).tobytes(), SHAPE[::-1]),
        (decode_depth, encode_depth(RAMP).tobytes(), SHAPE[::-1]),
        (decode_rgb, encode_rgb(RED).tobytes()[:-400], SHAPE),
        (decode_depth, encode_depth(RAMP).tobytes()[:-400], SHAPE),
        (decode_rgb, encode_depth(RAMP).tobytes(), SHAPE),
        (decode_depth, encode_rgb(RED).tobytes(), SHAPE),
        (decode_rgb, b"", SHAPE),
        (decode_depth, b"\xff\xd9", SHAPE),
        (decode_depth, cv2.imencode(".jp2", np.zeros(SHAPE, np.uint8))[1].tobytes(), SHAPE),
    ],
)  # fmt: skip
def test_a_picture_that_is_none_is_refused(decode: object, data: bytes, shape: tuple[int, int]) -> None:
    with pytest.raises(StrangeMessageError, match=r"cut short|cannot be decoded"):
        decode(data, shape)  # type: ignore[operator]


@pytest.mark.parametrize(("decode", "data"), [(decode_rgb, encode_rgb(RED)), (decode_depth, encode_depth(RAMP))])
def test_no_spoiled_picture_brings_anything_down(decode: object, data: np.ndarray) -> None:
    rng = np.random.default_rng(1)
    refused = 0
    for _ in range(150):
        spoiled = data.copy()
        spoiled[rng.integers(0, len(data), 5)] = rng.integers(0, 256, 5)
        try:
            decode(spoiled.tobytes(), SHAPE)  # type: ignore[operator]
        except StrangeMessageError:
            refused += 1
    assert 0 < refused < 150
