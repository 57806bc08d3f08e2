"""A simulated robot that moves in time, as a Stretch does, and keeps the episode's measures meanwhile."""

import math

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import BaseDisplacement, Joints
from uniteam.stretch import gripper_to_base, head_camera_to_base
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.motors import Motors
from uniteam.world.fake.odometry import Odometry
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.simulator import STEP_SECONDS, Simulator
from uniteam.world.simulation.step_events import NOTHING
from uniteam.world.task.episode import Episode
from uniteam.world.task.grasp_rules import EpisodeGraspRule, challenge
from uniteam.world.task.judge import Judge
from uniteam.world.task.measures import Measures

TICK = 0.01
"""How much time passes at once (s)."""
HELD_ANGLE = 0.1
"""Angle of the fingers around what they hold (rad)."""
CLOSING = 0.1
"""A gripper that is sent below this angle (rad) is to close."""


class FakeStretch:
    """A Stretch in a home.

    Attributes:
        simulator: the home, with the truth.
        motors: what moves it.
        is_run_stopped: whether somebody has pressed its button.
        time: that has passed (s).
        frame: what its camera saw last.
    """

    def __init__(
        self, simulator: Simulator, episode: Episode, dials: Dials, grasp: EpisodeGraspRule = challenge
    ) -> None:
        """Put the robot at the start of an episode.

        Args:
            simulator: of the episode's home.
            episode: that is judged.
            dials: how the robot errs.
            grasp: which object its gripper takes.
        """
        self.simulator, self._episode, self.dials = simulator, episode, dials
        self._rule = grasp(episode)
        self.reset()

    def reset(self) -> None:
        """Begin the episode anew."""
        self.simulator.reset(self._episode.start)
        self.rng = np.random.default_rng(self.dials.seed)
        self.motors = Motors(self.dials.agility)
        self._odometry = Odometry(self.dials.drift, self.rng)
        self._judge = Judge(self.simulator.home, self._episode)
        self._events, self._is_closed, self._is_run_stopped = NOTHING, True, False
        self.time, self._until_physics, self._until_picture = 0.0, 0.0, 0.0
        self.picture_count = 0
        self.frame: Frame = self.simulator.render()

    @property
    def base(self) -> BasePose:
        """Where it believes that it is."""
        return self._odometry.pose

    @property
    def joints(self) -> Joints:
        """Where its joints are."""
        return self.motors.joints

    @property
    def measures(self) -> Measures:
        """What the episode has come to."""
        return self._judge.measures

    @property
    def is_run_stopped(self) -> bool:
        """Whether the run-stop is engaged."""
        return self._is_run_stopped

    def press_run_stop(self) -> None:
        """Stop all motors, until the button is held."""
        self._is_run_stopped = True
        self.motors.freeze()

    def release_run_stop(self) -> None:
        """Let the motors move again; what they were to do is forgotten."""
        self._is_run_stopped = False
        self.motors.freeze()

    def camera_to_world(self) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        """Return the (4, 4) pose of the head camera in the frame of the odometry."""
        return np.asarray(self.base.matrix() @ head_camera_to_base(self.joints))

    def gripper_to_world(self) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        """Return the (4, 4) pose of the gripper in the frame of the odometry."""
        return np.asarray(self.base.matrix() @ gripper_to_base(self.joints))

    def send_gripper(self, angle: float) -> None:
        """Send the fingers to an angle (rad); what they close on is held, by the challenge's rule or another."""
        closed = angle < CLOSING
        if closed != self._is_closed:
            self._is_closed = closed
            self._events = self._events.then(self.simulator.grip(closed, self._rule))
            self.motors.gripper_stop = HELD_ANGLE if self.simulator.held is not None else -math.inf
        self.motors.send_gripper(angle)

    def tick(self) -> bool:
        """Let `TICK` pass and return whether a picture was taken."""
        self.time += TICK
        if not self._is_run_stopped and not self.motors.is_at_rest:
            self._move()
        self._until_physics -= TICK
        if self._until_physics <= 0.0:
            self._until_physics += STEP_SECONDS
            self.simulator.wait(STEP_SECONDS)
        self._until_picture -= TICK
        if self._until_picture > 1e-9:
            return False
        self._until_picture += 1.0 / self.dials.image_hz
        self._take_picture()
        return True

    def _move(self) -> None:
        distance, angle = self.motors.advance(TICK, self.base)
        before = self.simulator.base
        events = self.simulator.creep(BaseDisplacement(distance, 0.0, 0.0), self.joints)
        self._events = self._events.then(events)
        if angle != 0.0:
            self._events = self._events.then(self.simulator.creep(BaseDisplacement(heading=angle), self.joints))
        self._odometry.move(before, self.simulator.base)

    def _take_picture(self) -> None:
        self.frame = self.simulator.render()
        self._judge.update(self.simulator, self._events, self.frame, stopped=False)
        self._events = NOTHING
        self.picture_count += 1
