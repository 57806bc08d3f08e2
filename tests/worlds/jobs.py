"""What worker processes do in the tests: here, where they can import it."""

import logging
import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

from uniteam.errors import UniteamError, UnknownNameError
from uniteam.evaluation.backends.serving import Charging

FOREVER = 600.0


def square_or_die(charging: Charging) -> Callable[[int], tuple[int, int]]:
    """Return a function that squares; a negative number kills its process, 99 is a user's error."""

    def play(number: int) -> tuple[int, int]:
        if number < 0:
            os.kill(os.getpid(), signal.SIGKILL)
        if number == 99:
            raise UnknownNameError("number", "99", ["98"])
        return number * number, os.getpid()

    return play


def report_threads(charging: Charging) -> Callable[[str], str | None]:
    return os.environ.get


def fail_at_once(charging: Charging) -> Callable[[int], int]:
    raise UniteamError("the pack is damaged")


def import_nothing(charging: Charging) -> Callable[[int], int]:
    raise ModuleNotFoundError("No module named 'my_agent'")


def die_while_starting(charging: Charging) -> Callable[[int], int]:
    os._exit(3)


def hang(charging: Charging) -> Callable[[str], str]:
    """Return a function that hangs, by its own fault ("own") or by the world's ("world"), or does not hang."""

    def play(whose: str) -> str:
        if whose == "own":
            with charging():
                time.sleep(FOREVER)
        if whose == "world":
            time.sleep(FOREVER)
        return whose

    return play


def hang_and_report(charging: Charging) -> Callable[[str], None]:
    """Return a function that writes this process's number into a file and hangs."""

    def play(path: str) -> None:
        Path(path).write_text(str(os.getpid()))
        time.sleep(FOREVER)

    return play


def log(charging: Charging) -> Callable[[str], str]:
    def play(sentence: str) -> str:
        logging.getLogger("a_module").warning("%s", sentence)
        return sentence

    return play


def leave_threads(charging: Charging) -> Callable[[int], int]:
    """Return a function that leaves a thread behind that never ends."""

    def play(number: int) -> int:
        threading.Thread(target=time.sleep, args=(FOREVER,)).start()
        return number

    return play


def fork_and_die(charging: Charging) -> Callable[[int], int]:
    """Return a function whose process dies while a child of it keeps the pipe to the parent open for 30 s."""

    def play(number: int) -> int:
        if os.fork() == 0:
            time.sleep(30.0)
            os._exit(0)
        os._exit(4)

    return play


class CountStarts:
    """Writes a file a start, named by how many others had started before."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory

    def __call__(self, charging: Charging) -> Callable[[int], int]:
        started = len(list(self.directory.glob("started_*")))
        finished = len(list(self.directory.glob("finished_*")))
        (self.directory / f"started_{os.getpid()}").write_text(f"{started} {finished}")
        (self.directory / f"finished_{os.getpid()}").touch()
        return abs


def _play_until_killed(path: str) -> None:
    from uniteam.evaluation.backends.processes import WorkerProcesses

    workers: WorkerProcesses[str, None] = WorkerProcesses(hang_and_report, 1, FOREVER)
    list(workers.do([path], str))


if __name__ == "__main__":
    _play_until_killed(sys.argv[1])
