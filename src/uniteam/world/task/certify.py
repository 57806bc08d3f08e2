"""Certifying an episode: finding a way to solve it, and playing that way in the simulator.

Geometry proposes where to stand; the simulator is the judge. A task is certified when a candidate object can be
grasped and, held, be released onto an instance of the goal class without a collision, and when the oracle, with these
two stands in the certificate, reaches overall success from the episode's start.
"""

from collections.abc import Iterator
from itertools import chain, islice, product, repeat, zip_longest

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import Action, DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF, MANIPULATION_POSTURE
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.drop_points import DropPoints, drop_points
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Certificate, Episode
from uniteam.world.task.judge import rests_on
from uniteam.world.task.oracle import MOST_WAITING, Oracle
from uniteam.world.task.pilot import Pilot
from uniteam.world.task.stands import Release, grasp_stands, releases
from uniteam.world.task.tasks import Task
from uniteam.world.task.view_points import Viewpoints

GRASP_TRIES = 6
RELEASE_TRIES = 12
EPISODE_TRIES = 4
"""How many proposals the simulator is asked about: for an object, for an object and a receptacle, for an episode."""
GRASP_RANGE = 0.9
RELEASE_RANGE = 0.7
"""How far from an instance a stand may be (m)."""
LEAST_DROP, MOST_DROP = 0.04, 0.75
"""How far above a surface an object's bottom is released (m); from higher where it must pass a rim."""
HEADROOM = {MANIPULATION_POSTURE.wrist_pitch: 0.35, 0.0: 0.12}
"""By the wrist's pitch (rad), what the arm needs above an object (m); level, it reaches higher and between boards."""
WAYS_FROM_A_HEIGHT, APART = 3, 0.12
"""How many points of a surface are tried from one height, and how far apart they are (m)."""
EDGE_MARGIN = 0.02
"""What an object keeps from a surface's edge, where the surface is large enough (m)."""


class Certifier:
    """Certifies tasks in one home; what it learns of an object or a receptacle serves every task."""

    def __init__(self, home: Home) -> None:
        """Compile the home and survey its floor."""
        self.home = home
        self.simulator = Simulator(home, HEAD_CAMERA_HALF)
        self._views = Viewpoints(home, self.simulator.floor, self.simulator.physics.model)
        self._pilot = Pilot(self.simulator)
        self._grasps: dict[str, BasePose | None] = {}
        self._tried_releases: dict[tuple[str, str], Release | None] = {}

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
        """Yield a way to solve the task with each object and each goal receptacle for which there is one."""
        for candidate, goal in product(objects, goals):
            grasp = self._grasp(candidate.name)
            release = None if grasp is None else self._release(candidate.name, grasp, goal.name)
            if grasp is not None and release is not None:
                yield Certificate(candidate.name, grasp, goal.name, release.stand, release.joints)

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
        return self._goes_well(self._pilot.grasp(), name) and self.simulator.held == name

    def _release(self, name: str, grasp: BasePose, receptacle: str) -> Release | None:
        """Return a way in which a held object was put on a receptacle in the simulator."""
        key = (name, receptacle)
        if key not in self._tried_releases:
            ways = islice(self._releases(name, receptacle), RELEASE_TRIES)
            tried = (way for way in ways if self._can_release(way, name, grasp, receptacle))
            self._tried_releases[key] = next(tried, None)
        return self._tried_releases[key]

    def _can_release(self, release: Release, name: str, grasp: BasePose, receptacle: str) -> bool:
        self.simulator.reset(grasp)
        plan = chain(self._pilot.grasp(), self._pilot.stand(release.stand), self._pilot.release(release.joints))
        return self._goes_well(plan, name) and self._comes_to_rest(name, receptacle)

    def _goes_well(self, plan: Iterator[Action], name: str) -> bool:
        """Do a plan as long as nothing is touched and nothing is in the way."""
        category = self.home.by_name[name].category
        events = (self.simulator.apply(action, category) for action in plan)
        return not any(event.scene_collision or event.base_blocked for event in events)

    def _comes_to_rest(self, name: str, receptacle: str) -> bool:
        nothing = repeat(DiscreteAction.EMPTY_ACTION, MOST_WAITING)
        return self._goes_well(nothing, name) and rests_on(self.simulator, name, {receptacle})

    def _releases(self, name: str, receptacle: str) -> Iterator[Release]:
        """Yield ways to hold an object over a receptacle, one of each surface, posture and height at a time."""
        instance = self.home.by_name[receptacle]
        floor_points = self._views.standable(instance, RELEASE_RANGE)
        width, depth, height = load_catalogue()[self.home.by_name[name].model].size
        margin = float(np.hypot(width, depth)) / 2.0 + EDGE_MARGIN
        top = instance.position[2] + load_catalogue()[instance.model].size[2]
        surfaces = sorted(drop_points(self.home, instance), key=lambda surface: -surface.margins.max())
        drops = [(surface, drop) for surface in surfaces for drop in _drops(surface, top)]
        ways = [
            islice(_ways(surface, floor_points, height + drop, pitch, margin), WAYS_FROM_A_HEIGHT)
            for (surface, drop), pitch in product(sorted(drops, key=lambda pair: pair[1] != LEAST_DROP), HEADROOM)
            if surface.clearance >= height + drop + HEADROOM[pitch]
        ]
        yield from (way for round_of_ways in zip_longest(*ways) for way in round_of_ways if way is not None)

    def _is_solved(self, episode: Episode) -> bool:
        environment = Environment(self.home, episode)
        oracle = Oracle(environment)
        oracle.reset(episode.instruction, episode.seed)
        observation = environment.reset()
        while not environment.is_over:
            observation = environment.step(oracle.act(observation).action)
        return environment.measures.overall_success


def _drops(surface: DropPoints, top: float) -> list[float]:
    """Return from how high above a surface to release (m): just above it, or just above the furniture's top."""
    over_the_top = top + LEAST_DROP - surface.height
    return [LEAST_DROP, over_the_top] if LEAST_DROP < over_the_top < MOST_DROP else [LEAST_DROP]


def _ways(
    surface: DropPoints, floor_points: np.ndarray, height: float, wrist_pitch: float, margin: float
) -> Iterator[Release]:
    """Yield ways to release at the surface's roomiest points; `height` is the gripper's above the surface (m)."""
    roominess = np.round(np.minimum(surface.margins, margin), 2)
    reach = np.linalg.norm(surface.points[:, None] - floor_points[None], axis=2).min(axis=1, initial=np.inf)
    tried = np.empty((0, 2))
    for i in np.lexsort((reach, -roominess)):
        if np.all(np.linalg.norm(tried - surface.points[i], axis=1) >= APART):
            yield from releases(surface.points[i], floor_points, surface.height + height, wrist_pitch)[:1]
            tried = np.vstack([tried, surface.points[i]])
