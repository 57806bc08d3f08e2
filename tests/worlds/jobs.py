"""What worker processes do in the tests: here, where they can import it."""

import os
import signal
from collections.abc import Callable
from pathlib import Path

from uniteam.errors import UniteamError, UnknownNameError


def square_or_die() -> Callable[[int], tuple[int, int]]:
    """Return a function that squares; a negative number kills its process, 99 is a user's error."""

    def play(number: int) -> tuple[int, int]:
        if number < 0:
            os.kill(os.getpid(), signal.SIGKILL)
        if number == 99:
            raise UnknownNameError("number", "99", ["98"])
        return number * number, os.getpid()

    return play


def report_threads() -> Callable[[str], str | None]:
    return os.environ.get


def fail_at_once() -> Callable[[int], int]:
    raise UniteamError("the pack is damaged")


class CountStarts:
    """Writes a file a start, named by how many others had started before."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory

    def __call__(self) -> Callable[[int], int]:
        started = len(list(self.directory.glob("started_*")))
        finished = len(list(self.directory.glob("finished_*")))
        (self.directory / f"started_{os.getpid()}").write_text(f"{started} {finished}")
        (self.directory / f"finished_{os.getpid()}").touch()
        return abs
