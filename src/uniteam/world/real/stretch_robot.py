"""A real Stretch as a `uniteam.Body`: what an agent plays in the simulator it plays on the robot."""

import logging
from collections.abc import Callable, Iterable, Iterator

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, invert_transform
from uniteam.interface import Action, Joints, Observation
from uniteam.stretch import clamp_joints
from uniteam.world.real.link import RobotLink, RobotState, View
from uniteam.world.real.motions import Grip, Motion, MoveJoints, Translate, Turn, first_motions, motions_of
from uniteam.world.real.robot_errors import SilentRobotError
from uniteam.world.real.safety import Fence, SafetyLimits
from uniteam.world.task.check_action import checked_action

_log = logging.getLogger(__name__)

HOLDS_FROM = 0.01
"""Angle of a finger (rad) from which a closed gripper has something between its fingers: they are 3 mm apart."""

Watcher = Callable[[RobotState], None]
"""Sees every state during a motion; what it raises stops the robot."""


Announcer = Callable[[Motion, str], None]
"""Is told of every motion before it is begun, and why it will not be done; that is empty where it will be."""


def _say_nothing(motion: Motion, refusal: str) -> None:
    pass


class StretchRobot:
    """A Stretch, reached by a link.

    Whatever goes wrong while it moves, the base is told to stop before the exception goes on its way. A motion that
    would end outside the fence is not done; to an agent that looks as if something were in the way.

    Attributes:
        fence: within which the base stays; None before `reset`.
    """

    def __init__(
        self,
        link: RobotLink,
        limits: SafetyLimits,
        watchers: Iterable[Watcher] = (),
        announce: Announcer = _say_nothing,
    ) -> None:
        """Take a robot that has been connected to; nothing moves yet.

        Args:
            link: to the robot.
            limits: what it keeps to.
            watchers: what else looks at it while it moves.
            announce: is told of each motion before it begins.
        """
        self._link, self._limits = link, limits
        self._watchers, self._announce = tuple(watchers), announce
        self._joints, self._is_closed, self._is_holding, self._count = Joints(0.0, 0.0), False, False, 0
        self.fence: Fence | None = None

    def reset(self) -> Observation:
        """Open the gripper, take the navigation posture, and look; where the base stands now is the start.

        Raises:
            RobotError: the robot cannot go on; it has been told to stop.
        """
        with _Halting(self._link):
            state = self._link.glance().state
            self._start, self._count, self._is_closed = state.base, 0, False
            self.fence = Fence(self._start, self._limits.fence)
            self._do(first_motions(state.joints))
            view = self._look()
            self._start = view.state.base
            self.fence = Fence(self._start, self._limits.fence)
            return self._observation(view)

    def step(self, action: Action) -> Observation:
        """Do one action and look.

        Raises:
            InvalidActionError: it is no action; nothing has moved.
            InvalidInputError: `reset` was not called.
            RobotError: the robot cannot go on; it has been told to stop.
        """
        wanted = checked_action(action)
        if self.fence is None:
            raise InvalidInputError("the robot has not begun; call reset() before the first step")
        with _Halting(self._link):
            self._do(self._motions(wanted))
            self._count += 1
            return self._observation(self._look())

    def close(self) -> None:
        """Stop, and let go of the robot."""
        self._link.halt()
        self._link.close()

    def _motions(self, action: Action) -> tuple[Motion, ...]:
        """Return what an action comes to; a gripper that has closed on nothing is opened before it closes again."""
        motions = motions_of(action, self._joints)
        if motions == (Grip(closed=True),) and self._is_closed and not self._is_holding:
            return (Grip(closed=False), *motions)
        return motions

    def _do(self, motions: Iterable[Motion]) -> None:
        """Make motions; where the robot falls silent and comes back, what is left of them is not made."""
        try:
            for motion in motions:
                refusal = self._refusal(motion)
                self._announce(motion, refusal)
                if not refusal:
                    for state in self._motion(motion):
                        self._watch(state)
        except SilentRobotError as error:
            self._link.halt()
            _log.warning("%s; waiting for the robot", error)
            self._link.recover()
            self._link.halt()

    def _look(self) -> View:
        """Look; where the robot falls silent meanwhile and comes back, look once more, for nothing moves."""
        try:
            return self._link.look()
        except SilentRobotError as error:
            _log.warning("%s; waiting for the robot", error)
            self._link.recover()
            return self._link.look()

    def _refusal(self, motion: Motion) -> str:
        """Return why a motion must not be begun; empty where it may."""
        if not isinstance(motion, Translate) or self.fence is None:
            return ""
        base = self._link.glance().state.base
        if self.fence.allows(base.compose(BasePose(motion.distance, 0.0, 0.0))):
            return ""
        return f"it would leave the fence, {self.fence.radius:g} m around the start"

    def _motion(self, motion: Motion) -> Iterator[RobotState]:
        match motion:
            case Turn(angle):
                return self._link.turn(angle)
            case Translate(distance):
                return self._link.translate(distance)
            case Grip(closed):
                self._is_closed = closed
                return self._link.grip(closed)
            case MoveJoints(joints):
                return self._link.move_joints(joints)

    def _watch(self, state: RobotState) -> None:
        if self.fence is not None:
            self.fence.check(state)
        for watcher in self._watchers:
            watcher(state)

    def _observation(self, view: View) -> Observation:
        self._watch(view.state)
        self._joints = view.state.joints  # an agent reckons from what it saw
        self._is_holding = self._is_closed and view.state.gripper > HOLDS_FROM
        to_start = invert_transform(self._start.matrix()) @ view.camera_to_world
        to_start[3] = (0.0, 0.0, 0.0, 1.0)
        to_start.flags.writeable = False
        return Observation(
            rgb=view.rgb,
            depth=view.depth,
            camera=view.camera,
            camera_to_start=to_start,
            base_to_start=self._start.inverse().compose(view.state.base),
            joints=clamp_joints(view.state.joints),
            is_holding=self._is_holding,
            step=self._count,
            truth=view.truth,
        )


class _Halting:
    """Stops the robot where what it surrounds is left by an exception, Ctrl-C among them."""

    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is not None:
            self._link.halt()
