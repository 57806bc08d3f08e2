"""A fake robot whose time passes only while somebody waits: the bridge without ports, exact and repeatable."""

from uniteam.geometry import PinholeCamera
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import Moment, TruthOf, moment_of, observation_message, state_message
from uniteam.world.fake.delayed import Delayed
from uniteam.world.fake.fake_stretch import TICK


class Lockstep:
    """A clock and a wire in one: to sleep is to let the robot's time pass."""

    def __init__(self, bridge: FakeBridge, camera: PinholeCamera, truth_of: TruthOf) -> None:
        """Join a fake bridge; `truth_of` says what of the truth its pictures carry."""
        self._bridge, self._camera, self._truth_of = bridge, camera, truth_of
        latency = bridge.robot.dials.latency
        self._actions: Delayed[bytes] = Delayed(latency)
        self._states: Delayed[bytes] = Delayed(latency)
        self._moments: Delayed[Moment] = Delayed(latency)

    def now(self) -> float:
        """Return the robot's time (s)."""
        return self._bridge.robot.time

    def sleep(self, seconds: float) -> None:
        """Let the robot's time pass, in whole ticks."""
        for _ in range(max(1, round(seconds / TICK))):
            if not self._bridge.is_busy:
                action = self._actions.newest(self.now())
                if action is not None:
                    self._bridge.receive(action)
            if self._bridge.tick():
                self._moments.put(self.now(), moment_of(self._bridge))
        self._states.put(self.now(), state_message(self._bridge))

    def newest_state(self) -> bytes | None:
        """Return the newest message of state."""
        return self._states.newest(self.now())

    def newest_observation(self) -> bytes | None:
        """Return the newest message of observation; its images are packed now."""
        moment = self._moments.newest(self.now())
        return None if moment is None else observation_message(moment, self._camera, self._truth_of)

    def send(self, action: bytes) -> None:
        """Send an action."""
        self._actions.put(self.now(), action)

    def close(self) -> None:
        """Do nothing: there is nothing to let go of."""
