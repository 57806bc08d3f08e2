"""Whether the arm, the wrist, the gripper or what it holds meets the scene anywhere along a motion.

Robot and scene are compared at the samples of the motion: first by bounding boxes, all at once, then pair by pair by
MuJoCo's exact distance of convex shapes.
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import pose_matrix
from uniteam.interface import Joints
from uniteam.stretch import gripper_to_base, link_motions
from uniteam.world.physics.arm_shapes import ARM_BOXES, FINGER_GAP, ArmBox
from uniteam.world.physics.physics import Physics
from uniteam.world.simulation.held_object import HeldObject
from uniteam.world.simulation.robot_state import RobotState
from uniteam.world.simulation.touches import Touches

TOUCH_DEPTH = 0.005
"""A contact counts as a collision when it is deeper than this (m)."""

_ROBOT_SCENE, _OBJ_SCENE, _ROBOT_OBJ = range(3)
"""The kinds of collisions, as `Touches` has them."""


class ArmCollider:
    """Compares the arm with a home as its physics has it now."""

    def __init__(self, physics: Physics) -> None:
        """Take the shapes of a home's physics."""
        self._physics = physics
        self._model = physics.model
        self._bodies = np.array(self._model.mujoco.geom_bodyid)
        self._owners = np.array(self._model.owners)
        self._geom_to_body = _geom_frames(self._model.mujoco)
        is_thing = ~np.isin(np.arange(len(self._owners)), self._model.arm)
        self._things = np.flatnonzero(is_thing)
        self._is_small = self._bodies > 0
        self._low, self._high = self._model.low.copy(), self._model.high.copy()
        self._version = -1
        self._gripped: str | None = None

    def touches(self, path: Sequence[RobotState], held: HeldObject | None) -> Touches:
        """Return what the arm and the held object meet along a path, the first thing of each kind.

        What the gripper has let go of is no part of the scene until it is clear of the fingers.
        """
        geoms = self._moving_geoms(held)
        postures = {(state.joints, state.opening) for state in path}
        frames = {posture: _frames(*posture, held, len(geoms)) for posture in postures}
        to_world = np.array([state.base.matrix() @ frames[state.joints, state.opening] for state in path])
        low, high = _boxes(to_world, self._model.low[geoms], self._model.high[geoms])
        things = self._things_near(low.min(axis=(0, 1)), high.max(axis=(0, 1)), held)
        near = _overlap(low[:, :, None], high[:, :, None], self._low[things], self._high[things])
        self._gripped = self._still_gripped(near[0], things, held)
        near[:, :, self._owners[things] == self._gripped] = False
        kinds, first = self._kinds(len(geoms), things), dict[int, str]()
        for sample in np.flatnonzero(near.any(axis=(1, 2))):
            open_pairs = near[sample] & ~np.isin(kinds, list(first))
            for mover, thing in self._met(geoms, to_world[sample], things, open_pairs):
                first.setdefault(int(kinds[mover, thing]), str(self._owners[things[thing]]))
        return Touches(*(first.get(kind) for kind in (_ROBOT_SCENE, _OBJ_SCENE, _ROBOT_OBJ)))

    def finger_depths(self, state: RobotState, drawn_back: float = 0.0) -> tuple[dict[str, float], ...]:
        """Return how deep each finger would be in each thing that it meets (m), by the things' names.

        Args:
            state: of the robot.
            drawn_back: by how much (m) the fingers are shorter than they are.
        """
        base, frames = state.base.matrix(), _arm_frames(state.joints, state.opening)
        back = np.eye(4)
        back[1, 3] = drawn_back
        fingers = [number for number, part in enumerate(ARM_BOXES) if part.side != 0]
        return tuple(self._depths(self._model.arm[number], base @ frames[number] @ back) for number in fingers)

    def is_small(self, name: str) -> bool:
        """Return whether an instance is one that physics moves."""
        return bool(self._is_small[self._owners == name].all())

    def _depths(self, geom: int, to_world: NDArray[np.float64]) -> dict[str, float]:
        """Return how deep a geom of the arm would be in each thing (m), by the things' names."""
        low, high = _boxes(to_world[None], self._model.low[[geom]], self._model.high[[geom]])
        depths = dict[str, float]()
        for thing in self._things_near(low[0] - TOUCH_DEPTH, high[0] + TOUCH_DEPTH, None):
            depth = -self._distance(geom, int(thing), to_world @ self._geom_to_body[geom])
            name = str(self._owners[thing])
            depths[name] = max(depth, depths.get(name, 0.0))
        return depths

    def _distance(self, geom: int, thing: int, pose: NDArray[np.float64]) -> float:
        """Return the distance (m) of a geom of the arm at a pose (world) from a thing; 0 where they do not meet."""
        data = self._physics.still_data()
        data.geom_xpos[geom], data.geom_xmat[geom] = pose[:3, 3], pose[:3, :3].reshape(9)
        return float(mujoco.mj_geomDistance(self._model.mujoco, data, geom, thing, 0.0, None))

    def _kinds(self, count: int, things: NDArray[np.int64]) -> NDArray[np.int64]:
        """Return the kind of collision that each of `count` moving geoms would have with each thing, (count, T)."""
        kinds = np.full((count, len(things)), _ROBOT_SCENE)
        kinds[:, self._is_small[things]] = _ROBOT_OBJ
        kinds[len(self._model.arm) :] = _OBJ_SCENE
        return kinds

    def _still_gripped(self, near: NDArray[np.bool_], things: NDArray[np.int64], held: HeldObject | None) -> str | None:
        """Return what is held, or was and is still between the fingers; near is (B, T), whether boxes meet."""
        if held is not None:
            return held.name
        return self._gripped if near[:, self._owners[things] == self._gripped].any() else None

    def _moving_geoms(self, held: HeldObject | None) -> NDArray[np.int64]:
        """Return the geoms of the arm, and after them those of the held object."""
        arm = np.array(self._model.arm)
        return arm if held is None else np.concatenate([arm, np.flatnonzero(self._owners == held.name)])

    def _things_near(
        self, low: NDArray[np.float64], high: NDArray[np.float64], held: HeldObject | None
    ) -> NDArray[np.int64]:
        """Return the scene's geoms whose bounding box meets a box (m, world)."""
        self._refresh()
        things = self._things
        things = things[_overlap(low, high, self._low[things], self._high[things])]
        return things if held is None else things[self._owners[things] != held.name]

    def _refresh(self) -> None:
        """Bring the bounding boxes of movable geoms up to date with the physics."""
        if self._version == self._physics.version:
            return
        self._version = self._physics.version
        geoms = np.flatnonzero(self._bodies > 0)
        if len(geoms):
            poses = self._physics.poses()[self._bodies[geoms] - 1]
            self._low[geoms], self._high[geoms] = _boxes(poses, self._model.low[geoms], self._model.high[geoms])

    def _met(
        self,
        geoms: NDArray[np.int64],
        to_world: NDArray[np.float64],
        things: NDArray[np.int64],
        near: NDArray[np.bool_],
    ) -> Iterator[tuple[int, int]]:
        """Yield the pairs, of those marked in near (B, T), of a moving geom and a thing deeper in it than a touch."""
        if not near.any():
            return
        poses = to_world @ self._geom_to_body[geoms]
        data = self._physics.still_data()
        data.geom_xpos[geoms] = poses[:, :3, 3]
        data.geom_xmat[geoms] = poses[:, :3, :3].reshape(-1, 9)
        for mover, thing in zip(*np.nonzero(near), strict=True):
            pair = int(geoms[mover]), int(things[thing])
            if mujoco.mj_geomDistance(self._model.mujoco, data, *pair, 0.0, None) < -TOUCH_DEPTH:
                yield int(mover), int(thing)


def _geom_frames(model: Any) -> NDArray[np.float64]:
    """Return the (G, 4, 4) transforms from each geom's frame to its body's."""
    return np.array([pose_matrix(p, q) for p, q in zip(model.geom_pos, model.geom_quat, strict=True)])


@lru_cache(maxsize=256)
def _arm_frames(joints: Joints, opening: float) -> NDArray[np.float64]:
    """Return how each of `ARM_BOXES` is displaced, (B, 4, 4), with the fingers so far apart (m)."""
    motions = link_motions(joints)
    return np.array([motions[part.group] @ _spread(part, opening) for part in ARM_BOXES])


def _spread(part: ArmBox, opening: float) -> NDArray[np.float64]:
    """Return the (4, 4) displacement of a box by the opening of the fingers, with every joint at zero."""
    motion = np.eye(4)
    motion[0, 3] = part.side * (opening - FINGER_GAP) / 2
    return motion


def _frames(joints: Joints, opening: float, held: HeldObject | None, count: int) -> NDArray[np.float64]:
    """Return the (count, 4, 4) transforms to the base frame of the arm's boxes and of each shape of the held object."""
    arm = _arm_frames(joints, opening)
    if held is None:
        return arm
    hanging = np.broadcast_to(held.to_base(gripper_to_base(joints)), (count - len(arm), 4, 4))
    return np.concatenate([arm, hanging])


def _boxes(
    to_world: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the corners (..., B, 3) of the world's bounding boxes of boxes (B, 3) in frames (..., B, 4, 4)."""
    center = np.einsum("...ij,...j->...i", to_world[..., :3, :3], (low + high) / 2) + to_world[..., :3, 3]
    half = np.einsum("...ij,...j->...i", np.abs(to_world[..., :3, :3]), (high - low) / 2)
    return center - half, center + half


def _overlap(
    low: NDArray[np.float64], high: NDArray[np.float64], other_low: NDArray[np.float64], other_high: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Return where two sets of boxes overlap by more than a touch, the last axis being x, y, z."""
    return np.asarray(((low + TOUCH_DEPTH < other_high) & (high - TOUCH_DEPTH > other_low)).all(axis=-1))
