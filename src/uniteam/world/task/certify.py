"""Certifying an episode: finding a way to solve it, and playing that way in the simulator.

Geometry proposes where to stand; the simulator is the judge. A task is certified when a candidate object can be
grasped and, held, be released onto an instance of the goal class without a collision, and when the oracle, with these
two stands in the certificate, reaches overall success from the episode's start.
"""

from collections.abc import Iterator
from itertools import islice, product, zip_longest

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF, MANIPULATION_POSTURE
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.drop_points import DropPoints, drop_points
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Certificate, Episode
from uniteam.world.task.oracle import Oracle
from uniteam.world.task.stands import Release, grasp_stands, releases
from uniteam.world.task.tasks import Task
from uniteam.world.task.view_points import Viewpoints

GRASP_TRIES = 6
RELEASE_TRIES = 4
EPISODE_TRIES = 8
"""How many proposals the simulator is asked about: for an object, for an object and a receptacle, for an episode."""
GRASP_RANGE = 0.9
RELEASE_RANGE = 0.7
"""How far from an instance a stand may be (m)."""
DROP_HEIGHTS = (0.04, 0.15, 0.4)
"""How far above a surface an object's bottom is released (m); from higher where a rim is in the way."""
HEADROOM = {MANIPULATION_POSTURE.wrist_pitch: 0.35, 0.0: 0.12}
"""By the wrist's pitch (rad), what the arm needs above an object (m); level, it reaches higher and between boards."""
EDGE_MARGIN = 0.02
"""What an object keeps from a surface's edge, where the surface is large enough (m)."""


class Certifier:
    """Certifies tasks in one home; what it learns of an object or a receptacle serves every task."""

    def __init__(self, home: Home) -> None:
        """Compile the home and survey its floor."""
        self.home = home
        self.simulator = Simulator(home, HEAD_CAMERA_HALF)
        self._views = Viewpoints(home, self.simulator.floor, self.simulator.physics.model)
        self._grasps: dict[str, BasePose | None] = {}

    def certify(self, task: Task, identifier: str, start: BasePose, seed: int) -> Episode | None:
        """Return the episode of a task with its certificate, or None where no way was found to solve it."""
        objects = self._candidates(task.objects)
        goals = self._candidates(task.goals)
        for certificate in islice(self._proposals(objects, goals), EPISODE_TRIES):
            episode = Episode(
                id=identifier,
                home=self.home.name,
                start=start,
                instruction=task.instruction,
                objects=objects,
                start_receptacles=task.start_receptacles,
                goal_receptacles=goals,
                unseen=task.unseen,
                seed=seed,
                certificate=certificate,
            )
            if self._is_solved(episode):
                return episode
        return None

    def _candidates(self, names: tuple[str, ...]) -> tuple[Candidate, ...]:
        candidates = (Candidate(name, self._views.of(name)) for name in names)
        return tuple(candidate for candidate in candidates if candidate.view_points)

    def _proposals(self, objects: tuple[Candidate, ...], goals: tuple[Candidate, ...]) -> Iterator[Certificate]:
        """Yield what could be tried: every pair's best way to release, then every pair's second best, and so on."""
        grasps = {candidate.name: self._grasp(candidate.name) for candidate in objects}
        pairs = [(name, grasp, goal.name) for name, grasp in grasps.items() if grasp for goal in goals]
        ways = [islice(self._releases(name, goal), RELEASE_TRIES) for name, _, goal in pairs]
        for found in zip_longest(*ways):
            for (name, grasp, goal), release in zip(pairs, found, strict=True):
                if release is not None:
                    yield Certificate(name, grasp, goal, release.stand, release.joints)

    def _grasp(self, name: str) -> BasePose | None:
        """Return a stand from which an object was grasped in the simulator."""
        if name not in self._grasps:
            instance = self.home.by_name[name]
            stands = grasp_stands(
                np.array(instance.position), self._views.standable(instance, GRASP_RANGE), HEAD_CAMERA_HALF
            )
            tried = (stand for stand in islice(stands, GRASP_TRIES) if self._can_grasp(stand, name))
            self._grasps[name] = next(tried, None)
        return self._grasps[name]

    def _can_grasp(self, stand: BasePose, name: str) -> bool:
        self.simulator.reset(stand)
        category = self.home.by_name[name].category
        actions = (DiscreteAction.MANIPULATION_MODE, DiscreteAction.SNAP_OBJECT, DiscreteAction.NAVIGATION_MODE)
        events = [self.simulator.apply(action, category) for action in actions]
        return events[1].grasped == name and not any(event.scene_collision for event in events)

    def _releases(self, name: str, receptacle: str) -> Iterator[Release]:
        """Yield ways to hold an object over a receptacle, one of each surface, posture and height at a time."""
        instance = self.home.by_name[receptacle]
        floor_points = self._views.standable(instance, RELEASE_RANGE)
        width, depth, height = load_catalogue()[self.home.by_name[name].model].size
        margin = float(np.hypot(width, depth)) / 2.0 + EDGE_MARGIN
        surfaces = sorted(drop_points(self.home, instance), key=lambda surface: -surface.margins.max())
        for drop, surface, pitch in product(DROP_HEIGHTS, surfaces, HEADROOM):
            if surface.clearance >= height + drop + HEADROOM[pitch]:
                yield from islice(_ways(surface, floor_points, height + drop, pitch, margin), 1)

    def _is_solved(self, episode: Episode) -> bool:
        environment = Environment(self.home, episode)
        oracle = Oracle(environment)
        oracle.reset(episode.instruction, episode.seed)
        observation = environment.reset()
        while not environment.is_over:
            observation = environment.step(oracle.act(observation).action)
        return environment.measures.overall_success


def _ways(
    surface: DropPoints, floor_points: np.ndarray, height: float, wrist_pitch: float, margin: float
) -> Iterator[Release]:
    """Yield ways to release at the surface's roomiest points; `height` is the gripper's above the surface (m)."""
    roominess = np.round(np.minimum(surface.margins, margin), 2)
    reach = np.linalg.norm(surface.points[:, None] - floor_points[None], axis=2).min(axis=1, initial=np.inf)
    for i in np.lexsort((reach, -roominess)):
        yield from releases(surface.points[i], floor_points, surface.height + height, wrist_pitch)[:1]
