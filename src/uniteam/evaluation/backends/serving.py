"""What runs inside a worker process: it does the jobs it is sent, and ends when its parent does."""

import logging
import os
import pickle
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from logging.handlers import QueueHandler
from multiprocessing import parent_process
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnContext
from threading import Lock, Thread
from typing import Any, Protocol

from uniteam.errors import UniteamError

Charging = Callable[[], AbstractContextManager[None]]
"""Gives a context manager: the time spent inside is charged to what a job tries."""

SIGNALS_LEFT_TO_PARENT = {getattr(signal, name) for name in ("SIGINT", "SIGHUP", "SIGTERM") if hasattr(signal, name)}
"""Signals that reach a whole process group: the parent decides what comes of them."""


class Charged(Protocol):
    """Shared with the parent: whether the time that passes is charged to what the job tries."""

    value: bool


def new_charged(context: SpawnContext) -> Charged:
    """Return a flag that both processes see."""
    flag: Charged = context.RawValue("b", False)
    return flag


def serve(pipe: Connection, recipe: bytes, charged: Charged, log_level: int) -> None:
    """Do jobs until the pipe closes, then end at once, whatever threads the jobs have left behind.

    Sends ("ready", None), ("outcome", outcome), ("log", record), and ("error", sentence) before it gives up.

    Args:
        pipe: jobs come in and messages go out.
        recipe: pickled; called with a `Charging`, it returns the function that does a job. It is unpickled here and
            not on the way, so that what cannot be imported is told in a sentence.
        charged: set while time is charged to what the job tries.
        log_level: records below it are not sent.
    """
    _end_with_parent()
    say = _speaker(pipe)
    _send_logs(say, log_level)
    _leave_signals_to_parent()
    try:
        _do_jobs(pipe, recipe, charged, say)
    except UniteamError as error:
        with suppress(OSError):
            say("error", str(error))
    except (EOFError, OSError):  # the parent has closed the pipe, or is gone
        pass
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0)


def _do_jobs(pipe: Connection, recipe: bytes, charged: Charged, say: Callable[[str, Any], None]) -> None:
    player = _make_player(recipe, charged)
    say("ready", None)
    while True:
        job = pipe.recv()
        charged.value = False
        say("outcome", player(job))


def _make_player(recipe: bytes, charged: Charged) -> Callable[[Any], Any]:
    @contextmanager
    def charging() -> Iterator[None]:
        charged.value = True
        try:
            yield
        finally:
            charged.value = False

    try:
        player: Callable[[Any], Any] = pickle.loads(recipe)(charging)
    except UniteamError:
        raise
    except (Exception, SystemExit) as error:
        raise UniteamError(
            f"a worker process cannot import or set up what it is to play ({type(error).__name__}: {error})"
        ) from error
    return player


def _speaker(pipe: Connection) -> Callable[[str, Any], None]:
    """Return the function that sends a message; threads of an agent that log at the same time take turns."""
    lock = Lock()

    def say(kind: str, content: Any) -> None:
        with lock:
            pipe.send((kind, content))

    return say


class _Outbox:
    """Where a `QueueHandler` puts its records: into the pipe, since the parent knows where they can be shown."""

    def __init__(self, say: Callable[[str, Any], None]) -> None:
        self._say = say

    def put_nowait(self, record: logging.LogRecord) -> None:
        """Send a record, unless nobody is left to hear it."""
        with suppress(OSError):
            self._say("log", record)


def _send_logs(say: Callable[[str, Any], None], level: int) -> None:
    logging.captureWarnings(True)
    logging.getLogger().setLevel(level)
    logging.getLogger().addHandler(QueueHandler(_Outbox(say)))  # type: ignore[arg-type]


def _leave_signals_to_parent() -> None:
    """Do nothing at Ctrl-C and when the terminal closes, and die at SIGTERM without a traceback.

    Handlers, not SIG_IGN: what an agent itself starts in a process of its own gets the system's defaults.
    """
    for number in SIGNALS_LEFT_TO_PARENT - {signal.SIGTERM}:
        signal.signal(number, _ignore)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS_LEFT_TO_PARENT)


def _ignore(number: int, frame: object) -> None:
    pass


def _end_with_parent() -> None:
    """End this process as soon as the parent is gone, in the middle of a job too."""
    parent = parent_process()
    if parent is None:  # called in no worker process
        return

    def watch() -> None:
        wait([parent.sentinel])
        os._exit(1)

    Thread(target=watch, name="watch the parent", daemon=True).start()
