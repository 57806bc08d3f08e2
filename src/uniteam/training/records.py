"""What is kept of views on the disk: frames for the segmenter, crops for the namer, a file of each a home."""

from collections.abc import Iterable
from pathlib import Path

import cv2
import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.files import write_whole
from uniteam.training.views import View
from uniteam.world.homes.home import Home

JPEG_QUALITY = 95


class Thing(msgspec.Struct, frozen=True):
    """An instance of a home: what it is for, what it is called, and of which model it is."""

    role: str
    category: str
    model: str


class FrameRecord(msgspec.Struct, frozen=True):
    """A half-size frame; images are JPEG or PNG, depth in millimetres, instances plus one."""

    rgb: bytes
    depth: bytes
    instances: bytes
    camera_to_start: list[float]


class CropRecord(msgspec.Struct, frozen=True):
    """A region of a full-size frame with what is around it.

    Attributes:
        rgb: JPEG of (STORED_SIZE, STORED_SIZE, 3).
        mask: PNG of (STORED_SIZE, STORED_SIZE).
        side: of the square in pixels of the full-size frame.
        shape: of the region, as `region_shape` gives it.
        thing: what it shows; None where it is no whole thing.
        pixels: of the region in the half-size frame.
    """

    rgb: bytes
    mask: bytes
    side: float
    shape: list[float]
    thing: Thing | None
    pixels: int


class Frames(msgspec.Struct, frozen=True):
    """The frames of a home."""

    things: list[Thing]
    frames: list[FrameRecord]


class Crops(msgspec.Struct, frozen=True):
    """The crops of a home."""

    crops: list[CropRecord]


def things_of(home: Home) -> list[Thing]:
    """Return what a home's instances are, in its order."""
    return [Thing(home.model_of(i).role, i.category, i.model) for i in home.instances]


def frame_record(view: View) -> FrameRecord:
    """Return a view's half-size frame as it is kept."""
    millimetres = np.clip(view.half.depth * 1000.0 + 0.5, 0, 65535).astype(np.uint16)
    labels = (view.half.instances.astype(np.int32) + 1).astype(np.uint16)
    return FrameRecord(
        jpeg(view.half.rgb), png(millimetres), png(labels), [float(v) for v in view.camera_to_start.ravel()]
    )


def jpeg(rgb: NDArray[np.uint8]) -> bytes:
    """Return an (H, W, 3) image as JPEG."""
    options = [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY]
    return bytes(cv2.imencode(".jpg", cv2.cvtColor(rgb, cv2.COLOR_RGB2BGR), options)[1])


def png(image: NDArray[np.uint8] | NDArray[np.uint16]) -> bytes:
    """Return an (H, W) image as PNG, packed lightly."""
    return bytes(cv2.imencode(".png", image, [cv2.IMWRITE_PNG_COMPRESSION, 3])[1])


def from_jpeg(content: bytes) -> NDArray[np.uint8]:
    """Return the (H, W, 3) RGB image of a JPEG."""
    image = np.asarray(cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR), dtype=np.uint8)
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2RGB), dtype=np.uint8)


def from_png(content: bytes) -> NDArray[np.uint16]:
    """Return the (H, W) image of a PNG."""
    return np.asarray(cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_UNCHANGED))


def write_records(path: Path, records: Frames | Crops) -> None:
    """Write the records of a home; raises UnwritableError."""
    write_whole(path, msgspec.msgpack.encode(records))


def read_frames(path: Path) -> Frames:
    """Read the frames of a home."""
    return msgspec.msgpack.decode(path.read_bytes(), type=Frames)


def read_crops(paths: Iterable[Path]) -> list[CropRecord]:
    """Read the crops of homes, one home after the other."""
    return [crop for path in paths for crop in msgspec.msgpack.decode(path.read_bytes(), type=Crops).crops]
