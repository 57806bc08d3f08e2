"""The oracle: an agent that knows the truth, to show that an episode can be solved and the simulator is fair.

It drives along paths of the true navigable floor, looks at the object and at the goal receptacle from their view
points, and grasps and releases as the episode's certificate says. It looks at no image.
"""

import math
from collections.abc import Iterator

import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import Decision, DiscreteAction, Instruction, JointDisplacement, Observation
from uniteam.world.assets.catalogue import Point2
from uniteam.world.task.driving import to_point, turn
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Certificate
from uniteam.world.task.paths import PathField
from uniteam.world.task.stands import approach

LOOKING_DISTANCE = 1.1
"""From which (m) things of every height are well inside the head camera's view."""
MOST_LOOKS = 6
MOST_WAITING = 60


class Oracle:
    """Plays the episode of an environment by its certificate."""

    def __init__(self, environment: Environment) -> None:
        """Learn the home.

        Raises:
            InvalidInputError: the environment's episode has no certificate.
        """
        certificate = environment.episode.certificate
        if certificate is None:
            raise InvalidInputError(
                f"the oracle plays certified episodes, and episode '{environment.episode.id}' has no certificate; "
                "generate episodes with 'uniteam episodes'"
            )
        self._environment = environment
        self._certificate: Certificate = certificate
        self._script: Iterator[Decision] = iter(())

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin anew; the instruction is the episode's own, and nothing is left to chance."""
        self._script = self._play()

    def act(self, observation: Observation) -> Decision:
        """Return the next step of the script."""
        return next(self._script, Decision(DiscreteAction.STOP, "DONE", "The object has come to rest."))

    @property
    def _base(self) -> BasePose:
        return self._environment.simulator.base

    def _play(self) -> Iterator[Decision]:
        episode, certificate = self._environment.episode, self._certificate
        candidate = _candidate(episode.objects, certificate.object)
        yield from self._look("FIND_OBJECT", candidate, self._position(candidate.name))
        yield from self._stand("NAVIGATE_TO_OBJECT", certificate.grasp)
        yield from self._grasp()
        goal = _candidate(episode.goal_receptacles, certificate.receptacle)
        yield from self._look("FIND_RECEPTACLE", goal, self._release_point())
        yield from self._stand("NAVIGATE_TO_RECEPTACLE", certificate.release)
        yield from self._release()

    def _position(self, name: str) -> Point2:
        x, y = self._environment.simulator.object_pose(name)[:2, 3]
        return float(x), float(y)

    def _release_point(self) -> Point2:
        """Return a point half a metre ahead of the stand for releasing: on the goal receptacle."""
        stand = self._certificate.release
        return stand.x + 0.5 * math.cos(stand.heading), stand.y + 0.5 * math.sin(stand.heading)

    def _look(self, state: str, target: Candidate, at: Point2) -> Iterator[Decision]:
        """Face a target from one view point after the other until the measures say that it was found."""
        for point in _best_views(target, at)[:MOST_LOOKS]:
            yield from self._drive(state, point)
            for action in turn(self._base.bearing_to(*at)):
                yield Decision(action, state, f"Face {target.name}.")
            if self._is_found(state):
                return

    def _is_found(self, state: str) -> bool:
        measures = self._environment.measures
        return measures.find_object_phase_success if state == "FIND_OBJECT" else measures.find_recep_phase_success

    def _stand(self, state: str, stand: BasePose) -> Iterator[Decision]:
        yield from self._drive(state, (stand.x, stand.y))
        for action in turn(stand.heading - self._base.heading):
            yield Decision(action, state, "Turn as certified.")

    def _drive(self, state: str, goal: Point2) -> Iterator[Decision]:
        if self._base.distance_to(*goal) < 1e-3:
            return
        for point in PathField(self._environment.simulator.floor, goal).path_from(self._base.x, self._base.y):
            for action in to_point(self._base, point):
                yield Decision(action, state, f"Drive to ({point[0]:.2f}, {point[1]:.2f}).")

    def _grasp(self) -> Iterator[Decision]:
        yield Decision(DiscreteAction.MANIPULATION_MODE, "PICK", "Point the arm at the object.")
        yield Decision(DiscreteAction.SNAP_OBJECT, "PICK", "Grasp as certified.")
        yield Decision(DiscreteAction.NAVIGATION_MODE, "PICK", "Go on.")

    def _release(self) -> Iterator[Decision]:
        yield Decision(DiscreteAction.MANIPULATION_MODE, "PLACE", "Point the arm at the receptacle.")
        for joints in approach(self._certificate.release_joints):
            delta = joints - self._environment.simulator.joints
            yield Decision(JointDisplacement(delta), "PLACE", "Bring the object over the surface.")
        yield Decision(DiscreteAction.DESNAP_OBJECT, "PLACE", "Release as certified.")
        for _ in range(MOST_WAITING):
            if self._environment.measures.place_success:
                return
            yield Decision(DiscreteAction.EMPTY_ACTION, "PLACE", "Wait for the object to come to rest.")


def _candidate(candidates: tuple[Candidate, ...], name: str) -> Candidate:
    return next(candidate for candidate in candidates if candidate.name == name)


def _best_views(target: Candidate, at: Point2) -> list[Point2]:
    """Return a target's view points, those at the best distance for looking at a point (m, world) first."""
    distances = np.hypot(*(np.array(target.view_points) - at).T)
    return [target.view_points[i] for i in np.argsort(np.abs(distances - LOOKING_DISTANCE), kind="stable")]
