"""Certifying an episode: finding a way to solve it, and playing that way in the simulator.

Geometry proposes where to stand; the simulator is the judge. A task is certified when a candidate object can be
grasped and, held, be released onto an instance of the goal class without a collision that counts, and when the oracle,
with these two stands in the certificate, reaches overall success from the episode's start. A way that touches nothing
is taken before one that only brushes small objects.
"""

from collections.abc import Iterator
from dataclasses import replace
from enum import IntEnum
from itertools import islice, product, zip_longest

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import Action, DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.certification.candidate_tasks import CandidateTask
from uniteam.world.certification.measure_tags import measure_tags
from uniteam.world.certification.rejection import Cause, Rejected
from uniteam.world.certification.release_poses import release_ways
from uniteam.world.certification.view_points import Viewpoints
from uniteam.world.homes.home import Home
from uniteam.world.oracle.base_stands import Grasp, Release, Way, grasps
from uniteam.world.oracle.oracle import MOST_WAITING, Oracle
from uniteam.world.oracle.pilot import Pilot
from uniteam.world.simulation.simulator import Moment, Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Certificate, Episode
from uniteam.world.task.grasp_rules import take_candidate
from uniteam.world.task.judge import rests_on

GRASP_TRIES = 180
RELEASE_TRIES = 60
WAYS_KEPT = 3
"""How many ways to release are found for an object and a receptacle, so that another is there where one fails."""
EPISODE_TRIES = 6
"""How many proposals the simulator is asked about: for an object, for an object and a receptacle, for an episode."""
GRASP_STAND_RANGE = 1.6
RELEASE_STAND_RANGE = 0.8
"""How far from an instance a stand may be (m)."""


class _Course(IntEnum):
    """How it went; the larger, the better."""

    FAILS = 0
    BRUSHES = 1
    IS_CLEAN = 2


class Certifier:
    """Certifies tasks in one home; what it learns of an object or a receptacle serves every task."""

    def __init__(self, home: Home, style: str) -> None:
        """Compile a home, which was made in a style, and survey its floor."""
        self.home = home
        self._style = style
        self.simulator = Simulator(home, HEAD_CAMERA_HALF)
        self._views = Viewpoints(home, self.simulator.floor, self.simulator.physics.model)
        self._pilot = Pilot(self.simulator)
        self._grasps: dict[str, Grasp | Cause] = {}
        self._moments: dict[str, Moment] = {}
        self._releases: dict[tuple[str, str], tuple[Release, ...] | Cause] = {}
        self._environments: list[Environment] = []

    def certify(self, task: CandidateTask, identifier: str, start: BasePose, seed: int) -> Episode | Rejected:
        """Return the episode of a task with its certificate, or why no way was found to solve it."""
        objects, goals = self._candidates(task.objects), self._candidates(task.goals)
        if not objects or not goals:
            return Rejected(Cause.GOAL_UNSEEN if objects else Cause.OBJECT_UNSEEN)
        certificates, cause = self._proposals(objects, goals)
        for certificate in certificates[:EPISODE_TRIES]:
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
                tags = measure_tags(episode, certificate, self.simulator, self._style)
                return replace(episode, tags=tags)
        return Rejected(cause)

    def _candidates(self, names: tuple[str, ...]) -> tuple[Candidate, ...]:
        candidates = (Candidate(name, self._views.of(name)) for name in names)
        return tuple(candidate for candidate in candidates if candidate.view_points)

    def _proposals(
        self, objects: tuple[Candidate, ...], goals: tuple[Candidate, ...]
    ) -> tuple[list[Certificate], Cause]:
        """Return ways to solve the task, one with each object and each goal first, and how far the best one came."""
        by_pair: list[list[Certificate]] = []
        farthest = Cause.OBJECT_OUT_OF_REACH
        for candidate, goal in product(objects, goals):
            grasp = self._grasp(candidate.name)
            found = grasp if isinstance(grasp, Cause) else self._ways(candidate.name, grasp, goal.name)
            if isinstance(grasp, Cause) or isinstance(found, Cause):
                farthest = max(farthest, found if isinstance(found, Cause) else farthest)
                continue
            farthest = Cause.NOT_SOLVED
            by_pair.append([_certificate(candidate.name, grasp, goal.name, release) for release in found])
        in_turn = (certificate for ways in zip_longest(*by_pair) for certificate in ways if certificate is not None)
        return list(in_turn), farthest

    def _grasp(self, name: str) -> Grasp | Cause:
        """Return a way in which an object was grasped in the simulator, or why there is none."""
        if name not in self._grasps:
            self._grasps[name] = self._find_grasp(name)
        return self._grasps[name]

    def _find_grasp(self, name: str) -> Grasp | Cause:
        instance = self.home.by_name[name]
        x, y, z = instance.position
        middle = np.array([x, y, z + self.home.model_of(instance).size[2] / 2])
        ways = list(grasps(middle, self._views.standable(instance, GRASP_STAND_RANGE), HEAD_CAMERA_HALF))
        best = _best(((way, self._try_grasp(way, name)) for way in ways[:GRASP_TRIES]), 1)
        if best:
            return best[0]
        return Cause.GRASP_TOUCHES if ways else Cause.OBJECT_OUT_OF_REACH

    def _try_grasp(self, grasp: Grasp, name: str) -> _Course:
        self.simulator.reset(grasp.stand)
        course = self._follow(self._pilot.grasp(grasp.joints), name)
        return course if self.simulator.held == name else _Course.FAILS

    def _ways(self, name: str, grasp: Grasp, receptacle: str) -> tuple[Release, ...] | Cause:
        """Return ways in which a held object was put on a receptacle in the simulator, or why there is none."""
        key = (name, receptacle)
        if key not in self._releases:
            held, goal = self.home.by_name[name], self.home.by_name[receptacle]
            ways = list(release_ways(self.home, held, goal, self._views.standable(goal, RELEASE_STAND_RANGE)))
            holding = self._holding(name, grasp)
            tried = ((way, self._try_release(way, name, holding, receptacle)) for way in ways[:RELEASE_TRIES])
            none = Cause.RELEASE_FAILS if ways else Cause.GOAL_OUT_OF_REACH
            self._releases[key] = _best(tried, WAYS_KEPT) or none
        return self._releases[key]

    def _holding(self, name: str, grasp: Grasp) -> Moment:
        """Return the moment after an object was grasped."""
        if name not in self._moments:
            self._try_grasp(grasp, name)
            self._moments[name] = self.simulator.moment()
        return self._moments[name]

    def _try_release(self, release: Release, name: str, holding: Moment, receptacle: str) -> _Course:
        """Say how a release goes for a robot that stands there with the object; the way there is tried later."""
        self.simulator.return_to(holding, release.stand)
        course = self._follow(self._pilot.release(release.joints, release.rise), name)
        return course if course and self._comes_to_rest(name, receptacle) else _Course.FAILS

    def _follow(self, plan: Iterator[Action], name: str) -> _Course:
        """Do a plan until something is in the way of the base or the robot touches what is no small object."""
        rule = take_candidate(self.home.by_name[name].category, {name})
        course = _Course.IS_CLEAN
        for action in plan:
            events = self.simulator.apply(action, rule)
            if events.blocked or events.touches.robot_scene is not None:
                return _Course.FAILS
            if events.hit is not None:
                course = _Course.BRUSHES
        return course

    def _comes_to_rest(self, name: str, receptacle: str) -> bool:
        for _ in range(MOST_WAITING):
            if not self._follow(iter([DiscreteAction.EMPTY_ACTION]), name):
                return False
            if rests_on(self.simulator, name, {receptacle}):
                return True
            if not self.simulator.physics.is_moving:
                return False
        return False

    def _is_solved(self, episode: Episode) -> bool:
        environment = self._environment_of(episode)
        observation = environment.reset(episode)
        oracle = Oracle(environment)
        oracle.reset(episode.instruction, episode.seed)
        while not environment.is_over:
            observation = environment.step(oracle.act(observation).action)
        return environment.measures.overall_success

    def _environment_of(self, episode: Episode) -> Environment:
        """Return the home's one environment, made for its first episode."""
        if not self._environments:
            self._environments.append(Environment(self.home, episode))
        return self._environments[0]


def _best(tried: Iterator[tuple[Way, _Course]], wanted: int) -> tuple[Way, ...]:
    """Return so many ways that went well: the first clean ones, or the first ones where none is clean."""
    brushing: list[Way] = []

    def clean() -> Iterator[Way]:
        for way, course in tried:
            if course is _Course.IS_CLEAN:
                yield way
            elif course is _Course.BRUSHES:
                brushing.append(way)

    return tuple(islice(clean(), wanted)) or tuple(brushing[:wanted])


def _certificate(name: str, grasp: Grasp, receptacle: str, release: Release) -> Certificate:
    return Certificate(name, grasp.stand, receptacle, release.stand, release.joints, grasp.joints, release.rise)
