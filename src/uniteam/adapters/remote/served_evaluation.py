"""An evaluation whose agent is somewhere else: what remains is played by the agents that connect."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from threading import Lock
from typing import Any

from uniteam.adapters.remote.agent_server import AgentServer, Place
from uniteam.adapters.remote.desk import Desk, Notice, Outcome
from uniteam.adapters.remote.line import Line
from uniteam.adapters.remote.remote_agent import Patience, RemoteAgent
from uniteam.adapters.remote.session import Player, Stage
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.backends.serving import Charging
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation, OnLost, OnResult, home_of
from uniteam.evaluation.recording.order import RecordingOrder
from uniteam.evaluation.worker import EpisodePlayer, PlayerSetup
from uniteam.world.task.episode import Episode

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


class ServedEvaluation(Evaluation):
    """Serves episodes to agents instead of playing them in processes; all else is as in any evaluation.

    Attributes:
        address: HOST:PORT that agents connect to.
    """

    def __init__(
        self, run: Run, directory: Path, place: Place, answer_seconds: float, on_notice: Callable[[str], None]
    ) -> None:
        """Bind the address, open the split and take up what the directory holds.

        Args:
            run: of one agent, a `RemoteSpec`.
            directory: of the results.
            place: where to listen.
            answer_seconds: how long the agent may take for one answer (s).
            on_notice: is told, in a sentence, who connects and who is hung up on.

        Raises:
            UniteamError: as `Evaluation` does, or the address cannot be had.
        """
        self._server = AgentServer(place)
        self.address = self._server.address
        self._patience, self._on_notice = Patience(answer_seconds, run.episode_seconds), on_notice
        super().__init__(run, directory)

    def play(
        self,
        worker_count: int,
        on_result: OnResult,
        on_lost: OnLost,
        group_of: Callable[[Episode], str] = home_of,
        record: str | None = None,
    ) -> None:
        """Serve what remains until all of it has a result; as many agents play at once as there are seats."""
        open_count = len(self.remaining)
        desk = Desk(self.remaining, lambda attempt: group_of(self._episode(attempt)))
        orders = self.recordings(record)
        stage = Stage(
            self.split.name,
            desk,
            lambda line, charging: self._player(line, charging, orders),
            self._patience.answer,
            Lock(),
        )
        with self._server:
            self._server.play(stage)
            while open_count:
                event = desk.events.get()
                if isinstance(event, BaseException):
                    raise event
                if isinstance(event, Notice):
                    self._on_notice(event.sentence)
                    continue
                self._take_in(event, on_result, on_lost)
                open_count -= 1

    def _take_in(self, outcome: Outcome, on_result: OnResult, on_lost: OnLost) -> None:
        self.keep(outcome.attempt, outcome.value, on_result, on_lost)
        outcome.kept.set_result(None)

    def _player(self, line: Line, charging: Charging, orders: RecordingOrder) -> Player:
        """Return what plays attempts with the agent at the other end of a line."""
        setup = PlayerSetup(self.run, self._configuration, orders)
        return EpisodePlayer(self.split, setup, charging, lambda spec, environment: RemoteAgent(line, self._patience))
