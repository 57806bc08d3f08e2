"""Keeping the challenge's measures: what a step of the simulator came to.

The measures are those of the challenge's evaluator (HomeRobot, arXiv 2306.11565; habitat-lab's OVMM branch): a phase
counts once the phases before it do, and what has been reached is not lost again. The steps for which an agent waits
until the object has lain still long enough are steps like others; it may stop as soon as they are over.
"""

from collections.abc import Iterable, Set
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.world.homes.home import Home
from uniteam.world.physics.physics import Contact
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Candidate, Episode
from uniteam.world.task.measures import Measures

VIEW_POINT_TOLERANCE = 0.1
"""How near to a view point the base stands at it (m)."""
VIEW_COVERAGE = 0.001
"""Share of the image that must show what is found."""
LOWEST_CONTACT = 0.05
"""Height above the floor of a point at which an object can lie on furniture (m)."""
DEEPEST_CONTACT = 0.01
"""How far what lies on furniture may be sunk in it (m)."""
REST_STEPS = 50
"""Steps in a row for which an object must lie on a goal receptacle."""


@dataclass(frozen=True)
class _Viewable:
    """A candidate as the judge looks for it: its index in the frame's instances and its view points (N, 2)."""

    index: int
    view_points: NDArray[np.float64]

    def is_found(self, base: BasePose, frame: Frame) -> bool:
        """Return whether the base stands at a view point, with enough of it in the frame."""
        distances = np.hypot(self.view_points[:, 0] - base.x, self.view_points[:, 1] - base.y)
        if not np.any(distances <= VIEW_POINT_TOLERANCE):
            return False
        return bool(np.count_nonzero(frame.instances == self.index) >= VIEW_COVERAGE * frame.instances.size)


class Judge:
    """Watches one episode and keeps its `Measures`."""

    def __init__(self, home: Home, episode: Episode) -> None:
        """Begin with nothing achieved; raises InvalidInputError where the home lacks a candidate of the episode."""
        index = {instance.name: i for i, instance in enumerate(home.instances)}
        self._objects = [_viewable(candidate, index) for candidate in episode.objects]
        self._receptacles = [_viewable(candidate, index) for candidate in episode.goal_receptacles]
        self._object_names = {candidate.name for candidate in episode.objects}
        self._receptacle_names = {candidate.name for candidate in episode.goal_receptacles}
        self._released: str | None = None
        self._steps_at_rest = 0
        self.measures = Measures()

    def update(self, simulator: Simulator, events: StepEvents, frame: Frame, stopped: bool) -> None:
        """Take in what one step came to: the simulator after it, its events, what the camera sees, the agent's STOP."""
        before, touches = self.measures, events.touches
        found = before.find_object_phase_success or _any_found(self._objects, simulator, frame)
        picked = before.pick_object_phase_success or (found and simulator.held in self._object_names)
        found_receptacle = before.find_recep_phase_success or (
            picked and _any_found(self._receptacles, simulator, frame)
        )
        if events.released in self._object_names:
            self._released = events.released
        self._steps_at_rest = self._steps_at_rest + 1 if self._lies_on_goal(simulator) else 0
        self.measures = replace(
            before,
            find_object_phase_success=found,
            pick_object_phase_success=picked,
            find_recep_phase_success=found_receptacle,
            place_success=before.place_success or (found_receptacle and self._steps_at_rest >= REST_STEPS),
            robot_scene_colls=before.robot_scene_colls + (touches.robot_scene is not None),
            obj_scene_colls=before.obj_scene_colls + (touches.obj_scene is not None),
            robot_obj_colls=before.robot_obj_colls + (touches.robot_obj is not None),
            num_steps=before.num_steps + 1,
            does_want_terminate=before.does_want_terminate or stopped,
        )

    def _lies_on_goal(self, simulator: Simulator) -> bool:
        """Return whether the gripper is empty and what it let go of lies still on a goal receptacle."""
        if self._released is None or simulator.held is not None:
            return False
        return rests_on(simulator, self._released, self._receptacle_names)


def rests_on(simulator: Simulator, name: str, receptacles: Set[str]) -> bool:
    """Return whether an object lies still on one of some receptacles."""
    return simulator.physics.is_still(name) and lies_on(simulator.physics.contacts(name), receptacles)


def lies_on(contacts: Iterable[Contact], receptacles: Set[str]) -> bool:
    """Return whether one of a body's contacts is with a receptacle, above the floor and without sinking in."""
    return any(
        contact.other in receptacles and contact.point[2] >= LOWEST_CONTACT and contact.penetration <= DEEPEST_CONTACT
        for contact in contacts
    )


def _viewable(candidate: Candidate, index: dict[str, int]) -> _Viewable:
    if candidate.name not in index:
        raise InvalidInputError(f"the home holds no '{candidate.name}' to judge by; name one of its instances")
    return _Viewable(index[candidate.name], np.array(candidate.view_points, np.float64).reshape(-1, 2))


def _any_found(targets: list[_Viewable], simulator: Simulator, frame: Frame) -> bool:
    return any(target.is_found(simulator.base, frame) for target in targets)
