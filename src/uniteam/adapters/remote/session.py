"""One agent's visit: it is welcomed and plays episodes, one after the other, until none is left or the line breaks."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from threading import Lock

import uniteam
from uniteam.adapters.remote.desk import Desk, Notice
from uniteam.adapters.remote.line import Line, LineError
from uniteam.adapters.remote.messages import PROTOCOL, Done, Hello, Next, Over, Welcome
from uniteam.evaluation.backends.processes import Lost
from uniteam.evaluation.backends.serving import Charging
from uniteam.evaluation.results.result import EpisodeResult, measures_to_data
from uniteam.evaluation.worker import Attempt

HELLO_SECONDS = 10.0
"""s; an agent that connects says hello within them."""

Player = Callable[[Attempt], EpisodeResult | Lost]
"""Plays an attempt with the agent of one line."""


class OtherProtocolError(LineError):
    """The agent speaks another version of the messages."""


@dataclass(frozen=True)
class Stage:
    """What all sessions share.

    Attributes:
        split: name of the split.
        desk: where attempts are taken and results are brought.
        player_for: makes what plays attempts with a line's agent; it is given what lets go of `lock` meanwhile.
        answer_seconds: how long an agent may take to ask for the next episode.
        lock: held by the session whose simulator is at work; the others' agents think meanwhile.
    """

    split: str
    desk: Desk
    player_for: Callable[[Line, Charging], Player]
    answer_seconds: float
    lock: Lock


def play_session(line: Line, stage: Stage) -> None:
    """Play with the agent at the other end; raises LineError where the line breaks."""
    desk = stage.desk
    hello = line.hear(Hello, HELLO_SECONDS)
    if hello.protocol != PROTOCOL:
        raise OtherProtocolError(
            f"the agent speaks version {hello.protocol} of the messages, and this server (uniteam "
            f"{uniteam.__version__}) version {PROTOCOL}; give the agent the uniteam_client.py of this uniteam"
        )
    line.tell(Welcome(PROTOCOL, uniteam.__version__, stage.split, desk.left))
    player, group = stage.player_for(line, lambda: _without(stage.lock)), ""
    while (attempt := _next(line, stage, group)) is not None:
        group = desk.group_of(attempt)
        with stage.lock:
            value = player(attempt)
        desk.bring(attempt, value)
        if line.fault is not None:
            raise line.fault
        line.tell(_over(value))
    line.tell(Done())


def _next(line: Line, stage: Stage, group: str) -> Attempt | None:
    """Return what is to be played next, once the agent asks for it; None where nothing is left."""
    line.hear(Next, stage.answer_seconds)
    return stage.desk.take(group)


@contextmanager
def _without(lock: Lock) -> Iterator[None]:
    """Let go of a lock for a while."""
    lock.release()
    try:
        yield
    finally:
        lock.acquire()


def _over(value: EpisodeResult | Lost) -> Over:
    if isinstance(value, Lost):
        return Over("", {}, f"not counted, by no fault of the agent: {value.reason}")
    return Over(value.episode, measures_to_data(value.measures), value.failure)


def notice_of(fault: LineError, peer: str) -> Notice:
    """Return what is told of a session that has broken off."""
    return Notice(f"{peer} is hung up on: {fault}")
