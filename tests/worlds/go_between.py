"""Somebody between a robot and whoever drives it: passes everything on, until it is told to spoil it."""

import pickle
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import zmq
from worlds.fake_robot import free_ports

Spoil = Callable[[str, bytes], list[list[bytes]]]
"""From the name of a port ("state", "observation") and a message to the messages that go on, each in its parts."""
NAMES = ("observation", "action", "state", "servo")


def pass_on(name: str, message: bytes) -> list[list[bytes]]:
    """Spoil nothing."""
    return [[message]]


class GoBetween:
    """The four ports of a robot, once more.

    Attributes:
        first: the first of them.
        actions: what was sent to the robot, and when.
        spoil: what is done to what the robot sends.
        spoils_from: at which time that began; endless before it has.
        spoil_once_driving: what to begin with once the base is driven.
    """

    def __init__(self, robot_first: int) -> None:
        self.first = free_ports()
        self.actions: list[tuple[float, dict[str, Any]]] = []
        self.spoil: Spoil = pass_on
        self.spoil_once_driving: Spoil | None = None
        self.spoils_from = float("inf")
        self._context = zmq.Context()
        self._from_robot, self._to_driver = {}, {}
        for offset, name in enumerate(NAMES):
            if name != "action":
                self._from_robot[name] = self._socket(zmq.SUB, f"tcp://127.0.0.1:{robot_first + offset}", False)
                self._to_driver[name] = self._socket(zmq.PUB, f"tcp://127.0.0.1:{self.first + offset}", True)
        self._to_robot = self._socket(zmq.PUB, f"tcp://127.0.0.1:{robot_first + 1}", False)
        self._from_driver = self._socket(zmq.SUB, f"tcp://127.0.0.1:{self.first + 1}", True)

    def run(self, done: threading.Event) -> None:
        """Pass messages on until told to end."""
        poller = zmq.Poller()
        for socket in (*self._from_robot.values(), self._from_driver):
            poller.register(socket, zmq.POLLIN)
        while not done.is_set():
            ready = dict(poller.poll(10))
            if self._from_driver in ready:
                self._pass_action()
            for name, socket in self._from_robot.items():
                if socket in ready:
                    for parts in self.spoil(name, socket.recv()):
                        self._to_driver[name].send_multipart(parts)
        self._context.destroy(linger=0)

    def last_velocity(self) -> dict[str, float]:
        """Return the velocity that was sent last."""
        return next(action["base_velocity"] for _, action in reversed(self.actions) if "base_velocity" in action)

    def _pass_action(self) -> None:
        message = self._from_driver.recv()
        action = pickle.loads(message)
        self.actions.append((time.monotonic(), action))
        self._to_robot.send(message)
        if self.spoil_once_driving is not None and action.get("base_velocity", {}).get("v", 0.0) > 0.0:
            self.spoil, self.spoil_once_driving = self.spoil_once_driving, None
            self.spoils_from = time.monotonic()

    def _socket(self, kind: int, address: str, binds: bool) -> Any:
        socket = self._context.socket(kind)
        if kind == zmq.SUB:
            socket.setsockopt(zmq.SUBSCRIBE, b"")
        (socket.bind if binds else socket.connect)(address)
        return socket


@contextmanager
def between(robot_first: int) -> Iterator[GoBetween]:
    """Stand between a robot and whoever drives it, in a thread."""
    go_between, done = GoBetween(robot_first), threading.Event()
    thread = threading.Thread(target=go_between.run, args=(done,))
    thread.start()
    try:
        yield go_between
    finally:
        done.set()
        thread.join()
