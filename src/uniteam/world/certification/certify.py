"""Certifying an episode: finding a way to solve it, and playing that way in the simulator.

Geometry proposes where to stand; the simulator is the judge. A task is certified when a candidate object can be
grasped and, held, be released onto an instance of the goal class without a collision, and when the oracle, with these
two stands in the certificate, reaches overall success from the episode's start.
"""

from collections.abc import Iterator
from itertools import chain, islice, product, repeat

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import Action, DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.certification.candidate_tasks import CandidateTask
from uniteam.world.certification.release_poses import release_ways
from uniteam.world.certification.view_points import Viewpoints
from uniteam.world.homes.home import Home
from uniteam.world.oracle.base_stands import Release, grasp_stands
from uniteam.world.oracle.oracle import MOST_WAITING, Oracle
from uniteam.world.oracle.pilot import Pilot
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Certificate, Episode
from uniteam.world.task.grasp_rules import take_candidate
from uniteam.world.task.judge import rests_on

GRASP_TRIES = 6
RELEASE_TRIES = 12
EPISODE_TRIES = 4
"""How many proposals the simulator is asked about: for an object, for an object and a receptacle, for an episode."""
GRASP_STAND_RANGE = 0.9
RELEASE_STAND_RANGE = 0.7
"""How far from an instance a stand may be (m)."""


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

    def certify(self, task: CandidateTask, identifier: str, start: BasePose, seed: int) -> Episode | None:
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
                np.array(instance.position), self._views.standable(instance, GRASP_STAND_RANGE), HEAD_CAMERA_HALF
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
            held, goal = self.home.by_name[name], self.home.by_name[receptacle]
            ways = release_ways(self.home, held, goal, self._views.standable(goal, RELEASE_STAND_RANGE))
            tried = (way for way in islice(ways, RELEASE_TRIES) if self._can_release(way, name, grasp, receptacle))
            self._tried_releases[key] = next(tried, None)
        return self._tried_releases[key]

    def _can_release(self, release: Release, name: str, grasp: BasePose, receptacle: str) -> bool:
        self.simulator.reset(grasp)
        plan = chain(self._pilot.grasp(), self._pilot.stand(release.stand), self._pilot.release(release.joints))
        return self._goes_well(plan, name) and self._comes_to_rest(name, receptacle)

    def _goes_well(self, plan: Iterator[Action], name: str) -> bool:
        """Do a plan as long as nothing is touched and nothing is in the way."""
        rule = take_candidate(self.home.by_name[name].category, {name})
        events = (self.simulator.apply(action, rule) for action in plan)
        return not any(event.hit is not None or event.blocked for event in events)

    def _comes_to_rest(self, name: str, receptacle: str) -> bool:
        nothing = repeat(DiscreteAction.EMPTY_ACTION, MOST_WAITING)
        return self._goes_well(nothing, name) and rests_on(self.simulator, name, {receptacle})

    def _is_solved(self, episode: Episode) -> bool:
        environment = Environment(self.home, episode)
        oracle = Oracle(environment)
        oracle.reset(episode.instruction, episode.seed)
        observation = environment.reset()
        while not environment.is_over:
            observation = environment.step(oracle.act(observation).action)
        return environment.measures.overall_success
