"""The oracle: an agent that knows the truth, to show that an episode can be solved and the simulator is fair.

It drives along paths of the true navigable floor, looks at the object and at the goal receptacle from their view
points, and grasps and releases as the episode's certificate says. It looks at no image.
"""

import math
from collections.abc import Iterator

import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.geometry import Point2
from uniteam.interface import Action, Decision, DiscreteAction, Instruction, Observation
from uniteam.world.oracle.pilot import Pilot
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Certificate, Episode

LOOKING_DISTANCE = 1.1
"""From which (m) things of every height are well inside the head camera's view."""
MOST_LOOKS = 6
FARTHER_APART = 0.6
"""Where the first looks are in vain, the next are from points so far apart (m), with the head tilted too."""
TILTS = (math.radians(22.0), -math.radians(22.0))
"""By how much higher and lower than in navigation the head looks then (rad)."""
MOST_WAITING = 150


class Oracle:
    """Plays the episode of an environment by its certificate."""

    def __init__(self, environment: Environment) -> None:
        """Learn the home.

        Raises:
            InvalidInputError: the environment's episode has no certificate.
        """
        self._environment = environment
        self._certificate = _certificate(environment.episode)
        self._pilot = Pilot(environment.simulator)
        self._script: Iterator[Decision] = iter(())

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin anew with the environment's present episode; nothing is left to chance.

        Raises:
            InvalidInputError: the episode has no certificate.
        """
        self._certificate = _certificate(self._environment.episode)
        self._script = self._play()

    def act(self, observation: Observation) -> Decision:
        """Return the next step of the script."""
        return next(self._script, Decision(DiscreteAction.STOP, "DONE", "The object has come to rest."))

    def _play(self) -> Iterator[Decision]:
        episode, certificate, pilot = self._environment.episode, self._certificate, self._pilot
        candidate = _candidate(episode.objects, certificate.object)
        yield from self._look("FIND_OBJECT", candidate, self._position(candidate.name))
        yield from _decide("NAVIGATE_TO_OBJECT", "Drive to the stand.", pilot.stand(certificate.grasp))
        yield from _decide("PICK", "Grasp as certified.", pilot.grasp(certificate.grasp_joints))
        goal = _candidate(episode.goal_receptacles, certificate.receptacle)
        yield from self._look("FIND_RECEPTACLE", goal, self._release_point())
        yield from _decide("NAVIGATE_TO_RECEPTACLE", "Drive to the stand.", pilot.stand(certificate.release))
        release = pilot.release(certificate.release_joints, certificate.release_rise)
        yield from _decide("PLACE", "Release as certified.", release)
        yield from _decide("PLACE", "Wait for the object to come to rest.", self._wait())

    def _position(self, name: str) -> Point2:
        x, y = self._environment.simulator.object_pose(name)[:2, 3]
        return float(x), float(y)

    def _release_point(self) -> Point2:
        """Return a point half a metre ahead of the stand for releasing: on the goal receptacle."""
        stand = self._certificate.release
        return stand.x + 0.5 * math.cos(stand.heading), stand.y + 0.5 * math.sin(stand.heading)

    def _look(self, state: str, target: Candidate, at: Point2) -> Iterator[Decision]:
        """Face a target from one view point after the other until the measures say that it was found."""
        views = _best_views(target, at)
        for point in views[:MOST_LOOKS]:
            yield from self._face(state, target, at, point)
            if self._is_found(state):
                return
        for point in _spread(views, FARTHER_APART)[:MOST_LOOKS]:
            yield from self._face(state, target, at, point)
            for tilt in (0.0, *TILTS):
                yield from _decide(state, "Look higher or lower.", self._pilot.tilt_head(tilt))
                if self._is_found(state):
                    break
            yield from _decide(state, "Look ahead again.", self._pilot.tilt_head(0.0))
            if self._is_found(state):
                return

    def _face(self, state: str, target: Candidate, at: Point2, point: Point2) -> Iterator[Decision]:
        yield from _decide(state, f"Drive to a view point of {target.name}.", self._pilot.drive(point))
        yield from _decide(state, f"Face {target.name}.", self._pilot.face(at))

    def _is_found(self, state: str) -> bool:
        measures = self._environment.measures
        return measures.find_object_phase_success if state == "FIND_OBJECT" else measures.find_recep_phase_success

    def _wait(self) -> Iterator[Action]:
        for _ in range(MOST_WAITING):
            if self._environment.measures.place_success:
                return
            yield DiscreteAction.EMPTY_ACTION


def _decide(state: str, reason: str, actions: Iterator[Action]) -> Iterator[Decision]:
    return (Decision(action, state, reason) for action in actions)


def _certificate(episode: Episode) -> Certificate:
    if episode.certificate is None:
        raise InvalidInputError(
            f"the oracle plays certified episodes, and episode '{episode.id}' has no certificate; "
            "generate episodes with 'uniteam episodes'"
        )
    return episode.certificate


def _candidate(candidates: tuple[Candidate, ...], name: str) -> Candidate:
    return next(candidate for candidate in candidates if candidate.name == name)


def _best_views(target: Candidate, at: Point2) -> list[Point2]:
    """Return a target's view points, those at the best distance for looking at a point (m, world) first."""
    distances = np.hypot(*(np.array(target.view_points) - at).T)
    return [target.view_points[i] for i in np.argsort(np.abs(distances - LOOKING_DISTANCE), kind="stable")]


def _spread(points: list[Point2], distance: float) -> list[Point2]:
    """Return of some points those that are not near (m) one before them."""
    kept: list[Point2] = []
    for point in points:
        if all(math.dist(point, other) >= distance for other in kept):
            kept.append(point)
    return kept
