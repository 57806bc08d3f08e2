"""What a perception and its server say to each other: observations out, segmentations back, as MessagePack.

Arrays go as their bytes, little-endian and row by row. A message is checked as it is read; nothing in it can be run.
"""

from dataclasses import astuple
from typing import TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Detection, Instruction, Joints, Observation, Segmentation

PROTOCOL = 1
"""Of these messages; two sides of different ones do not understand each other."""
LARGEST_SIDE = 8192
"""Pixels of a frame's side."""

Scalar = TypeVar("Scalar", bound=np.generic)


class Health(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a server says of itself: the messages it understands, what it serves, and the package's version."""

    protocol: int
    perception: str
    version: str


class Problem(msgspec.Struct, frozen=True):
    """What went wrong, in one sentence."""

    sentence: str


class Frame(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One observation, without the truth, and of which episode of whom it is."""

    session: str
    instruction: tuple[str, str, str]
    seed: int
    step: int
    width: int
    height: int
    rgb: bytes
    depth: bytes
    intrinsics: tuple[float, float, float, float]
    camera_to_start: tuple[float, ...]
    base_to_start: tuple[float, float, float]
    joints: tuple[float, float, float, float, float, float, float]
    is_holding: bool


class Thing(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One detection."""

    candidates: tuple[tuple[str, float], ...]
    embedding: bytes | None = None


class Seen(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One segmentation."""

    width: int
    height: int
    instances: bytes
    detections: tuple[Thing, ...]


def frame_of(session: str, instruction: Instruction, seed: int, observation: Observation) -> Frame:
    """Return an observation as it is sent."""
    camera = observation.camera
    return Frame(
        session=session,
        instruction=(instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle),
        seed=seed,
        step=observation.step,
        width=camera.width,
        height=camera.height,
        rgb=observation.rgb.tobytes(),
        depth=observation.depth.astype("<f4", copy=False).tobytes(),
        intrinsics=(camera.fx, camera.fy, camera.cx, camera.cy),
        camera_to_start=tuple(observation.camera_to_start.ravel().tolist()),
        base_to_start=astuple(observation.base_to_start),
        joints=astuple(observation.joints),
        is_holding=observation.is_holding,
    )


def observation_of(frame: Frame) -> Observation:
    """Return the observation that a message holds; raises InvalidInputError where it makes no sense."""
    shape = _shape(frame.width, frame.height)
    if len(frame.camera_to_start) != 16:
        raise InvalidInputError(f"a pose has 16 numbers, got {len(frame.camera_to_start)}")
    return Observation(
        rgb=_array(frame.rgb, np.uint8, (*shape, 3), "rgb"),
        depth=_array(frame.depth, np.float32, shape, "depth"),
        camera=PinholeCamera(frame.width, frame.height, *frame.intrinsics),
        camera_to_start=np.array(frame.camera_to_start).reshape(4, 4),
        base_to_start=BasePose(*frame.base_to_start),
        joints=Joints(*frame.joints),
        is_holding=frame.is_holding,
        step=frame.step,
    )


def seen_of(segmentation: Segmentation) -> Seen:
    """Return a segmentation as it is sent."""
    height, width = segmentation.instances.shape
    things = tuple(
        Thing(tuple(d.candidates), None if d.embedding is None else d.embedding.astype("<f4").tobytes())
        for d in segmentation.detections
    )
    return Seen(width, height, segmentation.instances.astype("<i2", copy=False).tobytes(), things)


def segmentation_of(seen: Seen) -> Segmentation:
    """Return the segmentation that a message holds; raises InvalidInputError where it makes no sense."""
    instances = _array(seen.instances, np.int16, _shape(seen.width, seen.height), "instances")
    return Segmentation(instances, tuple(_detection(thing) for thing in seen.detections))


def _detection(thing: Thing) -> Detection:
    embedding = None
    if thing.embedding is not None:
        embedding = _array(thing.embedding, np.float32, (len(thing.embedding) // 4,), "an embedding")
    return Detection(tuple(sorted(thing.candidates, key=lambda one: -one[1])), embedding)


def _shape(width: int, height: int) -> tuple[int, int]:
    if not (0 < width <= LARGEST_SIDE and 0 < height <= LARGEST_SIDE):
        raise InvalidInputError(f"a frame's sides are 1 to {LARGEST_SIDE} pixels, got {width} x {height}")
    return height, width


def _array(data: bytes, kind: type[Scalar], shape: tuple[int, ...], what: str) -> NDArray[Scalar]:
    wanted = int(np.prod(shape)) * np.dtype(kind).itemsize
    if len(data) != wanted:
        raise InvalidInputError(f"{what} of shape {shape} has {wanted} bytes, got {len(data)}")
    return np.frombuffer(data, dtype=np.dtype(kind).newbyteorder("<")).reshape(shape).astype(kind)
