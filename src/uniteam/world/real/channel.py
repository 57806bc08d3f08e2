"""The ports of the bridge as one conversation: the newest of what the robot says, and actions that it acknowledges.

The robot names in every message the highest action that it has done, which is the only acknowledgement there is. It
ignores an action whose number is not above that, so that one which is sent again is not done again.
"""

import pickle
from collections.abc import Iterator, Mapping
from typing import Any, Protocol

from uniteam.world.real.link import Clock
from uniteam.world.real.messages import ObservationMessage, StateMessage, observation_message, state_message
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.restricted_pickle import read_pickle
from uniteam.world.real.robot_errors import RobotError, SilentRobotError
from uniteam.world.real.safety import check_run_stop

_PROTOCOL = 4
"""Of the pickles: what the bridge sends itself."""


class Wire(Protocol):
    """What carries messages; it keeps the newest of each kind only."""

    def newest_state(self) -> bytes | None:
        """Return the newest message of port 4403 that was not returned before; None where there is none."""

    def newest_observation(self) -> bytes | None:
        """Return the newest message of port 4401 that was not returned before; None where there is none."""

    def send(self, action: bytes) -> None:
        """Send a message to port 4402; whether it arrives nobody says."""

    def close(self) -> None:
        """Send and receive nothing more."""


class Channel:
    """A conversation with a robot's bridge.

    Attributes:
        state: the newest message of state.
        observation: the newest message of observation.
        observation_count: how many of these have come.
    """

    state: StateMessage
    observation: ObservationMessage

    def __init__(self, wire: Wire, clock: Clock, stale: float, pace: Pace, patience: Patience) -> None:
        """Wait until the robot has shown its state and a picture.

        Raises:
            SilentRobotError: it does not.
            RobotError: what it sends is no message of a Stretch, or it is not ready to move.
        """
        self._wire, self._clock, self._stale = wire, clock, stale
        self._pace, self._patience = pace, patience
        self.observation_count, self._state_count = 0, 0
        self._state_at = self._observation_at = -1e9
        self._wait_for_both(patience.connect, "connected to")
        self._step = self.state.step
        check_run_stop(self.state.state)
        if not self.state.is_homed:
            raise RobotError(
                "the robot is not homed, so its lift and arm would not move; run stretch_robot_home.py on it"
            )

    def now(self) -> float:
        """Return the time (s)."""
        return self._clock.now()

    @property
    def is_uncertain(self) -> bool:
        """Whether the newest state is so old that a base had better wait for the next."""
        return self.now() - self._state_at > self._stale / 2

    def tick(self) -> StateMessage:
        """Let a moment pass and return the newest state.

        Raises:
            SilentRobotError: what the robot sends is too old to move by.
            RobotError: the robot is run-stopped, obeys somebody else, or sends what is no message of a Stretch.
        """
        self._clock.sleep(self._pace.poll)
        self._read()
        now = self.now()
        for name, at in (("state", self._state_at), ("picture", self._observation_at)):
            if now - at > self._stale:
                raise SilentRobotError(
                    f"the robot's newest {name} is {now - at:.1f} s old, and may be {self._stale:g} s; the base was "
                    "told to stop"
                )
        self._check()
        return self.state

    def refresh(self) -> StateMessage:
        """Forget what came while nobody looked, and return the state that comes now; raises what `tick` does."""
        self._wait_for_both(self._patience.recover, "heard again by")
        self._check()
        return self.state

    def send(self, action: Mapping[str, Any]) -> int:
        """Send an action once, under the next number, and return that."""
        self._step += 1
        self._wire.send(pickle.dumps({**action, "step": self._step}, protocol=_PROTOCOL))
        return self._step

    def ask(self, action: Mapping[str, Any]) -> Iterator[StateMessage]:
        """Send an action until the robot says that it has done it, and yield its states meanwhile.

        Raises:
            SilentRobotError: it does not say so in time, or says nothing at all.
            RobotError: as `tick` does.
        """
        step, began = self.send(action), self.now()
        message, sent_at = pickle.dumps({**action, "step": step}, protocol=_PROTOCOL), began
        while self.state.step < step:
            if self.now() - began > self._patience.acknowledge:
                raise SilentRobotError(
                    f"the robot did not acknowledge {next(iter(action))} in {self._patience.acknowledge:g} s; see "
                    "that its bridge still runs, and that port 4402 is not barred"
                )
            if self.now() - sent_at >= self._pace.resend:
                self._wire.send(message)
                sent_at = self.now()
            yield self.tick()

    def blurt(self, action: Mapping[str, Any]) -> None:
        """Send an action some times, whatever the robot answers, if anything; it never raises."""
        try:
            self._step += 1
            message = pickle.dumps({**action, "step": self._step}, protocol=_PROTOCOL)
            for _ in range(5):
                self._wire.send(message)
                self._clock.sleep(self._pace.poll)
        except Exception:  # there is nothing more that could be done
            return

    def close(self) -> None:
        """Let go of the robot."""
        self._wire.close()

    def _wait_for_both(self, seconds: float, what: str) -> None:
        self._wire.newest_state(), self._wire.newest_observation()  # it may have waited here for long
        states, observations, began = self._state_count, self.observation_count, self.now()
        while self._state_count == states or self.observation_count == observations:
            if self.now() - began > seconds:
                lacking = "state (port 4403)" if self._state_count == states else "picture (port 4401)"
                raise SilentRobotError(
                    f"the robot was not {what} this program: no {lacking} came in {seconds:g} s; see that the bridge "
                    "of stretch_ai runs on it (ros2 launch stretch_ros2_bridge server.launch.py), at this address"
                )
            self._clock.sleep(self._pace.poll)
            self._read()

    def _read(self) -> None:
        """Take in the newest of what came; raises StrangeMessageError."""
        packed = self._wire.newest_state()
        if packed is not None:
            self.state = state_message(read_pickle(packed))
            self._state_at, self._state_count = self.now(), self._state_count + 1
        packed = self._wire.newest_observation()
        if packed is not None:
            self.observation = observation_message(read_pickle(packed))
            self._observation_at, self.observation_count = self.now(), self.observation_count + 1

    def _check(self) -> None:
        check_run_stop(self.state.state)
        if self.state.step > self._step:
            raise RobotError(
                "the robot obeys another program as well, whose actions it acknowledges; end that one, and start again"
            )
