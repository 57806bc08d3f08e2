"""Where an open gripper can close around an object: poses by what is seen of it and of all else."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.arm_reach import HANGING_WRIST
from uniteam.mind.skills.view import Points
from uniteam.stretch import FULL_OPENING


@dataclass(frozen=True)
class FingerShape:
    """The open gripper, and what it keeps to (m), measured on Stretch's.

    Attributes:
        opening: between the fingertips.
        thickness: of a finger, to the side to which it opens.
        width: of a finger, across that.
        tip: how far the fingertips reach beyond the grasp centre.
        palm: how far behind the grasp centre the hand begins.
        wrist: how far behind it the hand ends.
        hand: half of its width and height.
        margin: between the gripper and what is seen.
    """

    opening: float = FULL_OPENING
    thickness: float = 0.04
    width: float = 0.03
    tip: float = 0.02
    palm: float = 0.12
    wrist: float = 0.27
    hand: float = 0.045
    margin: float = 0.01


@dataclass(frozen=True)
class GraspPose:
    """Where the grasp centre is to be, and how the gripper is turned.

    Attributes:
        centre: (x, y, z) (m, base frame).
        pitch: of the wrist (rad).
        turn: of the line along which the fingers close, from the base's x axis (rad, left-positive), within a quarter.
        span: how wide the object is along that line (m).
        bottom: height of the object's lowest point that is seen (m).
    """

    centre: tuple[float, float, float]
    pitch: float
    turn: float
    span: float
    bottom: float

    @property
    def axes(self) -> NDArray[np.float64]:
        """(3, 3): the rows are the gripper's axes in the base frame: along the fingers, along their closing, across."""
        along = np.array([0.0, -math.cos(self.pitch), math.sin(self.pitch)])
        closing = np.array([math.cos(self.turn), math.sin(self.turn), 0.0])
        return np.array([along, closing, np.cross(along, closing)])


DEPTHS = (0.05, 0.035, 0.02, 0.012)
"""How far below the object's top the grasp centre is to be, tried in this order (m)."""
TURNS = 6
"""A hanging gripper's fingers are tried in so many directions, besides those of the object's own sides."""
OFFSETS = (0.0, 0.03, -0.03)
"""How far from the object's middle it is taken, across the closing of the fingers, tried in this order (m)."""
SLICE = 0.02
"""m; between the fingers is what is so near to the line along which they close, seen from above."""
MOST_HIDDEN = 0.08
"""How deep an object is taken to be at most, of which less is seen (m)."""
STRAY = 0.02
"""Share of the lowest and the highest points that may be another thing's."""


def grasp_poses(points: Points, surroundings: Points, pitch: float, shape: FingerShape) -> Iterator[GraspPose]:
    """Yield where the fingers have room on either side of an object; the narrowest of the deepest grasps first.

    Args:
        points: (N, 3) of the object (m, base frame).
        surroundings: (M, 3) of all else that was seen (m, base frame).
        pitch: of the wrist (rad); only a gripper that hangs can turn its fingers.
        shape: of the gripper.
    """
    if len(points) == 0:
        return
    bottom, top = (float(z) for z in np.quantile(points[:, 2], (STRAY, 1.0 - STRAY)))
    flat = points[:, :2].astype(np.float64)
    turns = tuple(_turns(flat)) if pitch <= HANGING_WRIST else (0.0,)
    for depth in DEPTHS:
        if top - depth <= bottom and depth != DEPTHS[-1]:
            continue
        for offset in OFFSETS:
            slices = (_slice(flat, turn, offset) for turn in turns)
            slices = slices if pitch <= HANGING_WRIST else (_deeper(flat, *each) for each in slices)
            poses = (GraspPose((*xy, top - depth), pitch, turn, span, bottom) for xy, turn, span in slices)
            yield from sorted((pose for pose in poses if _has_room(pose, points, surroundings, shape)), key=_span)


def _span(pose: GraspPose) -> float:
    return pose.span


def _turns(points: NDArray[np.float64]) -> Iterator[float]:
    """Yield the directions of an object's sides, by its (N, 2) points, and others all around (rad)."""
    corners = cv2.boxPoints(cv2.minAreaRect(points.astype(np.float32)))
    for x, y in np.diff(corners[:3], axis=0):
        yield math.remainder(math.atan2(y, x), math.pi)
    for number in range(TURNS):
        yield math.remainder(math.pi * number / TURNS, math.pi)


def _slice(points: NDArray[np.float64], turn: float, offset: float) -> tuple[tuple[float, float], float, float]:
    """Return the middle of what is near a line past (N, 2) points, the line's direction, and how wide that is.

    That is infinitely wide where the line does not meet them.
    """
    axes = np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    turned = points @ axes.T
    low, high = np.quantile(turned, (STRAY, 1.0 - STRAY), axis=0)
    across = (low[1] + high[1]) / 2 + offset
    near = turned[np.abs(turned[:, 1] - across) < SLICE, 0]
    if not low[1] <= across <= high[1] or len(near) == 0:
        return (float(points[0, 0]), float(points[0, 1])), turn, math.inf
    first, last = np.quantile(near, (STRAY, 1.0 - STRAY))
    x, y = np.array([(first + last) / 2, across]) @ axes
    return (float(x), float(y)), turn, float(last - first)


def _deeper(
    points: NDArray[np.float64], middle: tuple[float, float], turn: float, span: float
) -> tuple[tuple[float, float], float, float]:
    """Return a slice moved away from the base where little is seen of the object's depth: it is as deep as wide."""
    near = float(np.quantile(points[:, 1], 1.0 - STRAY))
    return (middle[0], min(middle[1], near - min(span, MOST_HIDDEN) / 2.0)), turn, span


def _has_room(pose: GraspPose, points: Points, surroundings: Points, shape: FingerShape) -> bool:
    """Return whether the object fits between the open fingers, and nothing is where they or the hand are to be."""
    if pose.span + 2.0 * shape.margin > shape.opening:
        return False
    everything = (np.concatenate([surroundings, points]) - np.array(pose.centre)) @ pose.axes.T
    along, aside, across = everything[:, 0], np.abs(everything[:, 1]), np.abs(everything[:, 2])
    inner, outer = shape.opening / 2.0 - shape.margin, shape.opening / 2.0 + shape.thickness + shape.margin
    fingers = (along > -shape.wrist) & (along < shape.tip + shape.margin / 2.0) & (aside > inner) & (aside < outer)
    hand = (along > -shape.wrist) & (along < shape.margin - shape.palm) & (aside < shape.hand + shape.margin)
    in_fingers = fingers & (across < shape.width / 2.0 + shape.margin)
    in_hand = hand & (across < shape.hand + shape.margin)
    return not bool((in_fingers | in_hand).any())
