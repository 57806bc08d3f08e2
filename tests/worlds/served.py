"""Episodes served over real sockets on loopback, to agents in threads of the same process."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from queue import SimpleQueue
from threading import Thread
from typing import Any

import grpc
import msgpack
import uniteam_client

from uniteam.adapters.remote.agent_server import Place
from uniteam.adapters.remote.messages import PROTOCOL
from uniteam.adapters.remote.served_episodes import RemoteSpec, ServedEpisodes, label_of
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split

LABEL = label_of("guest")
LONGEST_TEST = 90.0
"""s; a run that takes longer has come to a standstill."""

Client = Callable[[str], object]
"""An agent's side: it is given the address."""


def write_episodes(path: Path, count: int) -> Path:
    """Write a split of one short episode, so many times."""
    minival = load_split("minival")
    episode = minival.episodes[8]
    episodes = tuple(replace(episode, id=f"e{number}") for number in range(count))
    write_split(Split("served", episodes, {episode.home: minival.homes[episode.home]}), path)
    return path


@dataclass
class Served:
    """What a run came to: results by episode, sentences that were told, and what the agents' sides returned."""

    results: dict[str, EpisodeResult] = field(default_factory=dict)
    notices: list[str] = field(default_factory=list)
    returned: list[Any] = field(default_factory=list)


@dataclass(frozen=True)
class Offer:
    """What is served, and how."""

    split: Path
    folder: Path
    perception: str = "own"
    place: Place = field(default_factory=Place)
    answer_seconds: float = 20.0
    episode_seconds: float = 60.0
    record: str | None = None


def serve(offer: Offer, clients: Sequence[Client]) -> Served:
    """Serve until every episode has a result; each client runs in a thread of its own."""
    served = Served()
    spec = RemoteSpec("guest", offer.perception)
    run = Run(str(offer.split), {LABEL: spec}, offer.perception, "half", episode_seconds=offer.episode_seconds)
    episodes = ServedEpisodes(offer.place, offer.answer_seconds, served.notices.append)
    with Evaluation(run, offer.folder) as evaluation:
        engine = episodes.engine(evaluation.split)

        def call(client: Client) -> None:
            try:
                served.returned.append(client(episodes.address))
            except uniteam_client.ServerError as error:
                served.returned.append(error)

        threads = [Thread(target=call, args=(client,), daemon=True) for client in clients]

        def play() -> None:
            evaluation.play(1, _ignore, _ignore, record=offer.record, engine=engine)

        playing = Thread(target=play, daemon=True)
        for thread in (playing, *threads):
            thread.start()
        for thread in (playing, *threads):
            thread.join(LONGEST_TEST)
            assert not thread.is_alive(), served
        served.results.update(evaluation.store.results.get(LABEL, {}))
    return served


def playing(agent: Any) -> Client:
    """Return the client that plays with the module that users have."""
    return lambda address: uniteam_client.play(agent, address, wait=20.0)


def _ignore(*outcome: object) -> None:
    pass


class Turner:
    """Turns so many times, then stops; notes what it was asked and how often it looked."""

    def __init__(self, turns: int = 2) -> None:
        self.turns = turns
        self.asked: list[tuple[str, int]] = []
        self.looks = 0

    def reset(self, instruction: uniteam_client.Instruction, seed: int) -> None:
        self.asked.append((str(instruction), seed))

    def act(self, observation: uniteam_client.Observation) -> Any:
        self.looks += 1
        return uniteam_client.Decision("turn_left" if observation.step < self.turns else "stop", "TURN", "why not")


class Rude:
    """A client without manners: it answers each question with the next of its sayings, and is silent after the last."""

    def __init__(self, *sayings: bytes, hello: bytes | None = None) -> None:
        self.sayings, self.heard = list(sayings), list[dict[str, Any]]()
        self.hello = say("hello", protocol=PROTOCOL) if hello is None else hello

    def __call__(self, address: str) -> tuple[str, str]:
        """Return the status and the sentence with which the server hung up."""
        answers: SimpleQueue[bytes | None] = SimpleQueue()
        with grpc.insecure_channel(address, options=[("grpc.enable_http_proxy", 0)]) as channel:
            grpc.channel_ready_future(channel).result(timeout=10.0)
            call = channel.stream_stream("/uniteam.Environment/Play")(iter(answers.get, None))
            if self.hello:
                answers.put(self.hello)
            try:
                for content in call:
                    self._hear(content, answers)
            except grpc.RpcError as error:
                return error.code().name, error.details()
            finally:
                answers.put(None)
        return "OK", ""

    def _hear(self, content: bytes, answers: "SimpleQueue[bytes | None]") -> None:
        self.heard.append(msgpack.unpackb(content))
        if self.heard[-1]["kind"] in ("welcome", "over"):
            answers.put(say("next"))
        if self.heard[-1]["kind"] in ("reset", "observe") and self.sayings:
            answers.put(self.sayings.pop(0))


class Gone(Rude):
    """A client that hangs up instead of answering, after its sayings."""

    def _hear(self, content: bytes, answers: "SimpleQueue[bytes | None]") -> None:
        super()._hear(content, answers)
        if not self.sayings:
            raise _HungUp


class _HungUp(grpc.RpcError):
    def code(self) -> grpc.StatusCode:
        return grpc.StatusCode.CANCELLED

    def details(self) -> str:
        return "it was me"


def say(kind: str, **content: Any) -> bytes:
    """Return a message as it is sent."""
    packed: bytes = msgpack.packb({"kind": kind, **content})
    return packed


NEXT, READY = say("next"), say("ready")


def decide(**action: Any) -> bytes:
    """Return a decision as it is sent."""
    return say("decide", action=action, state="RUDE", reason="")
