"""Keeping the challenge's measures: what a step of the simulator came to.

The measures are those of the challenge's evaluator (HomeRobot, arXiv 2306.11565): a phase counts once the phases
before it do; placing is judged anew after every step, so that an object that rolls off later is not placed.
"""

from collections.abc import Callable, Set
from dataclasses import dataclass, replace

import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Candidate, Episode
from uniteam.world.task.footprint import VIEW_DISTANCE, distance_to_footprint
from uniteam.world.task.measures import Measures

VIEW_POINT_TOLERANCE = 0.1
VIEW_COVERAGE = 0.001
LOWEST_CONTACT = 0.05
DEEPEST_CONTACT = 0.01

DistanceTo = Callable[[str, BasePose], float]


@dataclass(frozen=True)
class _Viewable:
    """A candidate as the judge looks for it: its index in the frame's instances and its view points (N, 2)."""

    name: str
    index: int
    view_points: np.ndarray


class Judge:
    """Watches one episode and keeps its `Measures`."""

    def __init__(self, home: Home, episode: Episode) -> None:
        """Begin with nothing achieved; raises InvalidInputError where the home lacks a candidate of the episode."""
        index = {instance.name: i for i, instance in enumerate(home.instances)}
        self._home = home
        self._objects = [_viewable(candidate, index) for candidate in episode.objects]
        self._receptacles = [_viewable(candidate, index) for candidate in episode.goal_receptacles]
        self._object_names = {candidate.name for candidate in episode.objects}
        self._receptacle_names = {candidate.name for candidate in episode.goal_receptacles}
        self._released: str | None = None
        self.measures = Measures()

    def update(self, simulator: Simulator, events: StepEvents, frame: Frame, stopped: bool) -> None:
        """Take in what one step came to: the simulator after it, its events, what the camera sees, the agent's STOP."""
        measures = self.measures
        found = measures.find_object_phase_success or self._sees_object(simulator, frame)
        picked = measures.pick_object_phase_success or (found and events.grasped in self._object_names)
        found_receptacle = measures.find_recep_phase_success or (picked and self._sees_receptacle(simulator, frame))
        if events.released in self._object_names:
            self._released = events.released
        self.measures = replace(
            measures,
            find_object_phase_success=found,
            pick_object_phase_success=picked,
            find_recep_phase_success=found_receptacle,
            place_success=found_receptacle and self._is_placed(simulator),
            robot_scene_colls=measures.robot_scene_colls + (events.hit is not None),
            num_steps=measures.num_steps + 1,
            does_want_terminate=measures.does_want_terminate or stopped,
        )

    def _sees_object(self, simulator: Simulator, frame: Frame) -> bool:
        def distance(name: str, base: BasePose) -> float:
            x, y = simulator.object_pose(name)[:2, 3]
            return base.distance_to(x, y)

        return any(_is_found(target, simulator.base, frame, distance) for target in self._objects)

    def _sees_receptacle(self, simulator: Simulator, frame: Frame) -> bool:
        def distance(name: str, base: BasePose) -> float:
            return float(distance_to_footprint(self._home, self._home.by_name[name], np.array([base.x, base.y])))

        return any(_is_found(target, simulator.base, frame, distance) for target in self._receptacles)

    def _is_placed(self, simulator: Simulator) -> bool:
        if self._released is None or simulator.held is not None:
            return False
        return rests_on(simulator, self._released, self._receptacle_names)


def rests_on(simulator: Simulator, name: str, receptacles: Set[str]) -> bool:
    """Return whether an object is at rest and touches one of the receptacles above the floor without sinking in."""
    return simulator.physics.is_at_rest(name) and any(
        contact.other in receptacles and contact.point[2] >= LOWEST_CONTACT and contact.penetration <= DEEPEST_CONTACT
        for contact in simulator.physics.contacts(name)
    )


def _viewable(candidate: Candidate, index: dict[str, int]) -> _Viewable:
    if candidate.name not in index:
        raise InvalidInputError(f"the home holds no '{candidate.name}' to judge by; name one of its instances")
    return _Viewable(candidate.name, index[candidate.name], np.array(candidate.view_points).reshape(-1, 2))


def _is_found(target: _Viewable, base: BasePose, frame: Frame, distance_to: DistanceTo) -> bool:
    from_view_points = np.hypot(target.view_points[:, 0] - base.x, target.view_points[:, 1] - base.y)
    if not np.any(from_view_points <= VIEW_POINT_TOLERANCE) or distance_to(target.name, base) > VIEW_DISTANCE:
        return False
    return bool(np.count_nonzero(frame.instances == target.index) >= VIEW_COVERAGE * frame.instances.size)
