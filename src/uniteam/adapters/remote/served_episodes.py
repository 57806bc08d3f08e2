"""What plays an evaluation whose agent is somewhere else: the agents that connect."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from threading import Lock
from typing import Any

from uniteam.adapters.remote.agent_server import AgentServer, Place
from uniteam.adapters.remote.desk import Desk, Notice, Outcome
from uniteam.adapters.remote.line import Line
from uniteam.adapters.remote.remote_agent import Patience, RemoteAgent
from uniteam.adapters.remote.session import Player, Stage
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.backends.serving import Charging
from uniteam.evaluation.engines import Engine, Outcomes
from uniteam.evaluation.worker import Attempt, EpisodePlayer, PlayerSetup
from uniteam.world.task.episode import Split

OWN, TRUTH = "own", "truth"
"""What a remote agent sees with: networks of its own, or the simulator's segmentation, which it is then sent."""


@dataclass(frozen=True)
class RemoteSpec(AgentSpec):
    """An agent of which nothing is known here but its name."""

    def describe(self) -> dict[str, Any]:
        """Return its name and what it sees with: its code and its values are on its own side."""
        return {"agent": self.name, "perception": self.perception, "config": None, "code_from_outside": {}}

    @property
    def needs_truth(self) -> bool:
        """Whether it is sent the simulator's own segmentation."""
        return self.perception == TRUTH


def label_of(name: str) -> str:
    """Return the label under which a remote agent's results stand."""
    return f"{name} (remote)"


class ServedEpisodes:
    """Serves episodes to agents instead of playing them in processes.

    Attributes:
        address: HOST:PORT that agents connect to.
    """

    def __init__(self, place: Place, answer_seconds: float, on_notice: Callable[[str], None]) -> None:
        """Bind the address.

        Args:
            place: where to listen.
            answer_seconds: how long the agent may take for one answer (s).
            on_notice: is told, in a sentence, who connects and who is hung up on.

        Raises:
            UniteamError: the address cannot be had.
        """
        self._server = AgentServer(place)
        self.address = self._server.address
        self._answer_seconds, self._on_notice = answer_seconds, on_notice

    def engine(self, split: Split) -> Engine:
        """Return what plays a run of a split; as many agents play at once as there are seats."""
        return lambda setup, seats: _Serving(split, setup, self._server, self._answer_seconds, self._on_notice)


@dataclass(frozen=True)
class _Serving:
    """Lets the agents that connect play attempts."""

    split: Split
    setup: PlayerSetup
    server: AgentServer
    answer_seconds: float
    on_notice: Callable[[str], None]

    def do(self, jobs: Sequence[Attempt], group_of: Callable[[Attempt], str]) -> Outcomes:
        """Yield each attempt with its outcome; the agent goes on once that has been taken in."""
        desk = Desk(jobs, group_of)
        stage = Stage(self.split.name, desk, self._player, self.answer_seconds, Lock())
        with self.server:
            self.server.play(stage)
            for outcome in self._outcomes(desk, len(jobs)):
                yield outcome.attempt, outcome.value
                outcome.kept.set_result(None)

    def _outcomes(self, desk: Desk, count: int) -> Iterator[Outcome]:
        """Yield so many outcomes as sessions bring them, and pass notices on; raises what no agent is at fault for."""
        while count:
            event = desk.events.get()
            if isinstance(event, BaseException):
                raise event
            if isinstance(event, Notice):
                self.on_notice(event.sentence)
            else:
                count -= 1
                yield event

    def _player(self, line: Line, charging: Charging) -> Player:
        """Return what plays attempts with the agent at the other end of a line."""
        patience = Patience(self.answer_seconds, self.setup.run.episode_seconds)
        return EpisodePlayer(self.split, self.setup, charging, lambda spec, environment: RemoteAgent(line, patience))
