"""What is released, falls or is pushed: a home's collision shapes in MuJoCo.

Furniture, decor, doors, walls and the floor are static; graspable objects are free bodies of the catalogue's mass.
Bodies that have come to rest sleep, so a home in which nothing moves costs nothing. The robot has no body here: it
holds and releases, it does not push.
"""

import copy
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import UnknownNameError
from uniteam.geometry import Point3, pose_matrices, pose_matrix
from uniteam.world.homes.home import Home
from uniteam.world.physics.physics_model import TIMESTEP, HomeModel, compile_home

SETTLED_STEPS = 50
"""A body is at rest when it has been slow for so many physics steps, or sleeps."""
REST_LINEAR_SPEED = 0.005
"""m/s."""
REST_ANGULAR_SPEED = 0.05
"""rad/s."""

_SHELF_HEIGHT = 50.0
_SLEEP = int(mujoco.mjtEnableBit.mjENBL_SLEEP)


@dataclass(frozen=True)
class Contact:
    """Where a body touches something.

    Attributes:
        other: the instance it touches, or "wall" or "floor".
        point: m, world; its third value is the height above the floor.
        penetration: how deep they overlap (m); negative where they are a little apart.
    """

    other: str
    point: Point3
    penetration: float


@dataclass(frozen=True)
class PhysicsState:
    """Everything that decides how a `Physics` goes on."""

    data: Any
    slow_steps: NDArray[np.int64]
    removed: frozenset[str]
    is_disturbed: bool


class Physics:
    """The moving half of a home.

    Attributes:
        names: the movable instances, in the home's order.
        version: grows whenever a body may have moved.
    """

    def __init__(self, home: Home) -> None:
        """Build the home's bodies where they stand; raises DamagedFileError where its mesh or a shape is not usable."""
        self.model: HomeModel = compile_home(home)
        self.names = self.model.bodies
        self.version = 0
        self._index = {name: k for k, name in enumerate(self.names)}
        self._owners = np.array(self.model.owners)
        self._data = mujoco.MjData(self.model.mujoco)
        self._still = mujoco.MjData(self.model.mujoco)
        self._slow_steps = np.zeros(len(self.names), np.int64)
        self._removed: frozenset[str] = frozenset()
        self._is_disturbed = True
        mujoco.mj_forward(self.model.mujoco, self._data)

    @property
    def is_moving(self) -> bool:
        """Whether any body is awake."""
        return self._is_disturbed or self._data.ntree_awake > 0

    def advance(self, seconds: float) -> None:
        """Let time pass; stops early once every body sleeps."""
        for _ in range(round(seconds / TIMESTEP)):
            if not self.is_moving:
                break
            self._step()

    def settle(self, names: Iterable[str] | None = None, seconds: float = 3.0) -> bool:
        """Let time pass until the named bodies (or all) are at rest, and say whether they are; at most `seconds`."""
        waiting = self.names if names is None else tuple(names)
        for _ in range(round(seconds / TIMESTEP)):
            if not self.is_moving or all(self.is_at_rest(name) for name in waiting):
                break
            self._step()
        return all(self.is_at_rest(name) for name in waiting)

    def pose(self, name: str) -> NDArray[np.float64]:
        """Return the (4, 4) transform from the model's frame to the world."""
        return _matrix(self._state(self._data, name))

    def poses(self) -> NDArray[np.float64]:
        """Return the (N, 4, 4) poses of all bodies in the order of `names`."""
        return pose_matrices(self._data.qpos.reshape(-1, 7))

    def set_pose(self, name: str, model_to_world: NDArray[np.float64]) -> None:
        """Put a body somewhere, at standstill and awake; it is back if it had been taken away."""
        start = self._start(name)
        self._data.qpos[start : start + 3] = model_to_world[:3, 3]
        mujoco.mju_mat2Quat(
            self._data.qpos[start + 3 : start + 7], np.ascontiguousarray(model_to_world[:3, :3]).ravel()
        )
        self._stop(name)
        self._weigh(name, True)
        self._removed -= {name}

    def remove(self, name: str) -> None:
        """Take a body away until `set_pose` brings it back; what lay on it wakes."""
        start = self._start(name)
        self._data.qpos[start : start + 3] = (10.0 * self._index[name], 0.0, _SHELF_HEIGHT)
        self._stop(name)
        self._weigh(name, False)
        self._removed |= {name}

    def is_at_rest(self, name: str) -> bool:
        """Return whether a body sleeps, or has been slower than 5 mm/s and 0.05 rad/s for 50 physics steps."""
        k = self._number(name)
        if self._is_disturbed:
            return False
        return bool(self._slow_steps[k] >= SETTLED_STEPS or not self._data.tree_awake[k])

    def is_still(self, name: str) -> bool:
        """Return whether a body sleeps, or was slower than 5 mm/s and 0.05 rad/s after the last physics step."""
        k = self._number(name)
        return not self._is_disturbed and bool(self._slow_steps[k] > 0 or not self._data.tree_awake[k])

    def contacts(self, name: str) -> tuple[Contact, ...]:
        """Return where a body touches others, walls or the floor now."""
        self._number(name)
        data = self.still_data()
        with self._sleepless():
            mujoco.mj_collision(self.model.mujoco, data)
        return self._contacts_of(name, data.contact)

    def all_contacts(self) -> dict[str, tuple[Contact, ...]]:
        """Return what `contacts` returns, for every body at once."""
        data = self.still_data()
        with self._sleepless():
            mujoco.mj_collision(self.model.mujoco, data)
        return {name: tuple(found) for name, found in self._found(data.contact, range(data.ncon)).items()}

    def touching(self, name: str) -> frozenset[str]:
        """Return what a body touches: names of instances, "wall", "floor"."""
        return frozenset(contact.other for contact in self.contacts(name))

    def save(self) -> PhysicsState:
        """Return the present state, for `restore`."""
        return PhysicsState(copy.copy(self._data), self._slow_steps.copy(), self._removed, self._is_disturbed)

    def restore(self, state: PhysicsState) -> None:
        """Return to a saved state; what follows is the same to the bit each time."""
        mujoco.mj_copyData(self._data, self.model.mujoco, state.data)
        self._slow_steps[:] = state.slow_steps
        self._removed = state.removed
        for name in self.names:
            self._weigh(name, name not in self._removed)
        self._is_disturbed = state.is_disturbed
        self.version += 1

    def still_data(self) -> Any:
        """Return MuJoCo's data with every geom where it is now, the sleeping ones too; callers may change it."""
        with self._sleepless():
            self._still.qpos[:] = self._data.qpos
            mujoco.mj_kinematics(self.model.mujoco, self._still)
        return self._still

    def _step(self) -> None:
        mujoco.mj_step(self.model.mujoco, self._data)
        self._is_disturbed = False
        self.version += 1
        speeds = self._data.qvel.reshape(-1, 6)
        linear, angular = np.linalg.norm(speeds[:, :3], axis=1), np.linalg.norm(speeds[:, 3:], axis=1)
        is_slow = (linear < REST_LINEAR_SPEED) & (angular < REST_ANGULAR_SPEED)
        self._slow_steps = np.where(is_slow, self._slow_steps + 1, 0)

    @contextmanager
    def _sleepless(self) -> Iterator[None]:
        options = self.model.mujoco.opt
        options.enableflags &= ~_SLEEP
        yield
        options.enableflags |= _SLEEP

    def _contacts_of(self, name: str, contacts: Any) -> tuple[Contact, ...]:
        is_own = self._owners[contacts.geom] == name
        return tuple(self._found(contacts, np.flatnonzero(is_own.any(axis=1)))[name])

    def _found(self, contacts: Any, wanted: Iterable[int]) -> dict[str, list[Contact]]:
        """Return some of MuJoCo's contacts by the bodies that they are of, in the given order."""
        found: dict[str, list[Contact]] = {name: [] for name in self.names}
        geoms, points, distances = contacts.geom, contacts.pos, contacts.dist
        for k in wanted:
            one, two = (self.model.owners[geom] for geom in geoms[k])
            (x, y, z), distance = points[k], distances[k]
            for name, other in ((one, two), (two, one)):
                if name in found:
                    found[name].append(Contact(other, (float(x), float(y), float(z)), -float(distance)))
        return found

    def _number(self, name: str) -> int:
        try:
            return self._index[name]
        except KeyError:
            raise UnknownNameError("movable instance", name, self.names) from None

    def _start(self, name: str) -> int:
        return 7 * self._number(name)

    def _state(self, data: Any, name: str) -> NDArray[np.float64]:
        start = self._start(name)
        return np.asarray(data.qpos[start : start + 7])

    def _stop(self, name: str) -> None:
        k = self._number(name)
        self._data.qvel[6 * k : 6 * k + 6] = 0.0
        self._slow_steps[k] = 0
        self._is_disturbed = True
        self.version += 1

    def _weigh(self, name: str, has_weight: bool) -> None:
        self.model.mujoco.body_gravcomp[self._number(name) + 1] = 0.0 if has_weight else 1.0


def _matrix(state: NDArray[np.float64]) -> NDArray[np.float64]:
    return pose_matrix(state[:3], state[3:])
