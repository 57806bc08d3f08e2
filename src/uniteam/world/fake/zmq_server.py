"""A fake robot behind the four ports of the bridge of stretch_ai."""

import math
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from uniteam.errors import UnavailableError
from uniteam.geometry import PinholeCamera
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import (
    TruthOf,
    moment_of,
    observation_message,
    servo_message,
    state_message,
)
from uniteam.world.fake.delayed import Delayed
from uniteam.world.fake.fake_stretch import TICK
from uniteam.world.real.restricted_pickle import MOST_BYTES
from uniteam.world.real.zmq_wire import ACTION_PORT, OBSERVATION_PORT, SERVO_PORT, STATE_PORT, import_zmq

LONGEST_LAG = 0.1
"""By how much (s) the robot's time may fall behind before it is let go: a slow machine makes a slow robot."""

Wait = Callable[[float], None]
"""Is shown the robot's time (s) and returns once the robot's next moment may come."""


class RealTime:
    """Waits until the machine's time is as far as the robot's."""

    def __init__(self) -> None:
        """Begin at the first moment that is waited for."""
        self._began = -math.inf

    def __call__(self, robot_time: float) -> None:
        """Wait until a moment (s) has come; of a robot that has fallen behind, let time go."""
        self._began = max(self._began, time.monotonic() - robot_time - LONGEST_LAG)
        behind = time.monotonic() - robot_time - self._began
        if behind < TICK:
            time.sleep(TICK - behind)


class ZmqServer:
    """Binds the four ports and lets a robot live behind them."""

    def __init__(self, bridge: FakeBridge, camera: PinholeCamera, truth_of: TruthOf, address: tuple[str, int]) -> None:
        """Bind the ports; nothing is sent before `serve`.

        Args:
            bridge: that answers.
            camera: the head camera's intrinsics.
            truth_of: what of the truth its pictures carry.
            address: host, and the first of four ports in a row.

        Raises:
            UnavailableError: pyzmq is not installed, or a port cannot be bound.
        """
        self._bridge, self._camera, self._truth_of = bridge, camera, truth_of
        self._zmq = import_zmq()
        host, first_port = address
        self._context = self._zmq.Context()
        self._sockets: dict[int, Any] = {}
        for port in (OBSERVATION_PORT, ACTION_PORT, STATE_PORT, SERVO_PORT):
            self._sockets[port] = self._bind(host, first_port + port - OBSERVATION_PORT, port == ACTION_PORT)
        latency = bridge.robot.dials.latency
        self._actions: Delayed[bytes] = Delayed(latency)
        self._messages: dict[int, Delayed[bytes]] = {
            port: Delayed(latency) for port in (OBSERVATION_PORT, STATE_PORT, SERVO_PORT)
        }

    def serve(self, goes_on: Callable[[], bool], wait: Wait) -> None:
        """Let the robot live until `goes_on` is false, each moment of it after `wait`, and close the ports."""
        try:
            while goes_on():
                wait(self._bridge.robot.time)
                self._tick()
        finally:
            self._context.destroy(linger=0)

    def _tick(self) -> None:
        now = self._bridge.robot.time
        self._receive(now)
        if self._bridge.tick():
            moment = moment_of(self._bridge)
            self._messages[OBSERVATION_PORT].put(now, observation_message(moment, self._camera, self._truth_of))
            self._messages[SERVO_PORT].put(now, servo_message(moment, self._camera))
        self._messages[STATE_PORT].put(now, state_message(self._bridge))
        for port, line in self._messages.items():
            message = line.newest(self._bridge.robot.time)
            if message is not None:
                self._sockets[port].send(message, self._zmq.NOBLOCK)

    def _receive(self, now: float) -> None:
        """Take the newest action; while the robot does one that must be ended, those that come are not looked at."""
        with suppress(self._zmq.Again):
            self._actions.put(now, bytes(self._sockets[ACTION_PORT].recv(self._zmq.NOBLOCK)))
        if not self._bridge.is_busy:
            action = self._actions.newest(now)
            if action is not None:
                self._bridge.receive(action)

    def _bind(self, host: str, port: int, receives: bool) -> Any:
        socket = self._context.socket(self._zmq.SUB if receives else self._zmq.PUB)
        socket.setsockopt(self._zmq.SNDHWM, 1)
        socket.setsockopt(self._zmq.RCVHWM, 1)
        socket.setsockopt(self._zmq.LINGER, 0)
        if receives:
            socket.setsockopt(self._zmq.SUBSCRIBE, b"")
            socket.setsockopt(self._zmq.CONFLATE, 1)
            socket.setsockopt(self._zmq.MAXMSGSIZE, MOST_BYTES)
        try:
            socket.bind(f"tcp://{host}:{port}")
        except self._zmq.ZMQError as error:
            self._context.destroy(linger=0)
            raise UnavailableError(
                f"port {port} of {host} cannot be bound ({error}); end what uses it, or choose another with --port"
            ) from error
        return socket
