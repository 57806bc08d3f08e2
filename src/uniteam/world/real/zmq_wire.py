"""The four ports of a bridge over TCP; the client connects, the robot binds."""

from importlib import import_module
from typing import Any

from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.world.real.restricted_pickle import MOST_BYTES

OBSERVATION_PORT, ACTION_PORT, STATE_PORT, SERVO_PORT = 4401, 4402, 4403, 4404
EXTRA = "robot"


def import_zmq() -> Any:
    """Return the package `zmq`; raises UnavailableError with the command that installs it."""
    try:
        return import_module("zmq")
    except ImportError as error:
        raise UnavailableError(
            f"a robot on the network is reached by the package pyzmq, which cannot be imported ({error}); install it "
            f"with: pip install 'uniteam[{EXTRA}]'"
        ) from error


class ZmqWire:
    """Sockets to a robot; ZeroMQ connects them, and connects them again, by itself."""

    def __init__(self, host: str, first_port: int = OBSERVATION_PORT) -> None:
        """Begin to connect; whether anybody is there only messages tell.

        Args:
            host: the robot's name or address.
            first_port: of the four in a row: observations, actions, state, servo.

        Raises:
            UnavailableError: pyzmq is not installed.
            InvalidInputError: the host or port is none.
        """
        zmq = import_zmq()
        self._nothing_yet = zmq.Again
        self._flags = zmq.NOBLOCK
        self._context = zmq.Context()
        try:
            self._observations = self._newest_of(zmq, f"tcp://{host}:{first_port}")
            self._states = self._newest_of(zmq, f"tcp://{host}:{first_port + STATE_PORT - OBSERVATION_PORT}")
            self._actions = self._context.socket(zmq.PUB)
            self._actions.setsockopt(zmq.SNDHWM, 1)
            self._actions.setsockopt(zmq.LINGER, 200)
            self._actions.connect(f"tcp://{host}:{first_port + ACTION_PORT - OBSERVATION_PORT}")
        except (zmq.ZMQError, OverflowError, TypeError) as error:
            self._context.destroy(linger=0)
            raise InvalidInputError(
                f"'{host}', ports {first_port} and following, cannot be connected to ({error}); give the robot's name "
                "or address"
            ) from error

    def newest_state(self) -> bytes | None:
        """Return the newest message of state."""
        return self._receive(self._states)

    def newest_observation(self) -> bytes | None:
        """Return the newest message of observation."""
        return self._receive(self._observations)

    def send(self, action: bytes) -> None:
        """Send an action; what cannot be sent at once is dropped."""
        self._actions.send(action, self._flags)

    def close(self) -> None:
        """Close the sockets, after what was sent last."""
        self._context.destroy(linger=200)

    def _newest_of(self, zmq: Any, address: str) -> Any:
        """Return a socket that keeps one message, and drops the connection to whoever sends one that is too large."""
        socket = self._context.socket(zmq.SUB)
        socket.setsockopt(zmq.MAXMSGSIZE, MOST_BYTES)
        socket.setsockopt(zmq.RCVHWM, 1)
        socket.setsockopt(zmq.CONFLATE, 1)
        socket.setsockopt(zmq.SUBSCRIBE, b"")
        socket.connect(address)
        return socket

    def _receive(self, socket: Any) -> bytes | None:
        try:
            return bytes(socket.recv(self._flags))
        except self._nothing_yet:
            return None
