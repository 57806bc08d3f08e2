"""Agents that answer wrongly, late, too much or not at all: they lose an episode, and the run goes on."""

import math
import pickle
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

grpc = pytest.importorskip("grpc", reason="the extra 'serve' is not installed")

import uniteam_client  # noqa: E402
from worlds.served import (  # noqa: E402
    NEXT,
    READY,
    Client,
    Gone,
    Offer,
    Rude,
    Served,
    Turner,
    decide,
    playing,
    say,
    serve,
    write_episodes,
)

from uniteam.adapters.remote import agent_server, session  # noqa: E402
from uniteam.adapters.remote.agent_server import Place  # noqa: E402

OTHER_HELLO = say("hello", protocol=99)
TURN = {"kind": "discrete", "name": "turn_left"}


@pytest.fixture(scope="module")
def two(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_episodes(tmp_path_factory.mktemp("split") / "two.jsonl.gz", 2)


def one_after_the_other(*clients: Client) -> Sequence[Client]:
    return [lambda address: [client(address) for client in clients]]


def check_first_lost(served: Served, sentence: str, steps: int = 0) -> None:
    """Check that the first episode failed for this reason, and that the second one was played to its end."""
    assert sentence in served.results["e0"].failure
    assert served.results["e0"].state == "CRASHED"
    assert served.results["e0"].measures.num_steps == steps
    assert not served.results["e1"].crashed
    assert served.results["e1"].measures.does_want_terminate


class Exploding:
    """Would leave a mark if it were unpickled."""

    def __reduce__(self) -> Any:
        return (Path.touch, (Path("unpickled"),))


@pytest.mark.parametrize(
    ("sayings", "sentence"),
    [
        ((b"",), "what is no message"),
        ((b"<html>hello</html>",), "what is no message"),
        ((b"\x91" * 60_000,), "what is no message"),
        ((pickle.dumps(Exploding()),), "what is no message"),
        ((say("reayd"),), "what is no message"),
        ((say("ready", more=1),), "what is no message"),
        ((READY, READY), "sent the message 'ready', expected was 'decide'"),
        ((decide(**TURN),), "sent the message 'decide', expected was 'ready'"),
        ((READY, decide(kind="base", x="1", y=0.0, heading=0.0)), "what is no message"),
        ((READY, decide(kind="arm", delta=[0.0] * 6, base=[0.0] * 3)), "what is no message"),
        ((READY, b"\0" * 100_000), "sent 100000 bytes, and an answer has at most 65536"),
    ],
)
def test_an_answer_that_is_none_costs_the_episode_and_the_line(
    two: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, sayings: tuple[bytes, ...], sentence: str
) -> None:
    monkeypatch.chdir(tmp_path)
    served = serve(Offer(two, tmp_path / "out"), one_after_the_other(Rude(*sayings), playing(Turner())))
    check_first_lost(served, sentence)
    ((status, told), _) = served.returned[0]
    assert status == "INVALID_ARGUMENT"
    assert sentence in told
    assert any(sentence in notice for notice in served.notices)
    assert not Path("unpickled").exists()


def test_a_message_that_grpc_does_not_take_in_costs_the_episode(two: Path, tmp_path: Path) -> None:
    rude = Rude(READY, b"\0" * 5_000_000)
    served = serve(Offer(two, tmp_path), one_after_the_other(rude, playing(Turner())))
    check_first_lost(served, "the agent hung up before it had answered")
    assert served.returned[0][0][0] == "RESOURCE_EXHAUSTED"


def test_an_agent_that_says_nothing_is_hung_up_on(two: Path, tmp_path: Path) -> None:
    offer = Offer(two, tmp_path, answer_seconds=0.5)
    served = serve(offer, one_after_the_other(Rude(READY, decide(**TURN)), playing(Turner())))
    check_first_lost(served, "the agent did not answer in 0.5 s", steps=1)
    assert served.returned[0][0] == ("DEADLINE_EXCEEDED", "the agent did not answer in 0.5 s")


def test_an_agent_that_hangs_up_in_mid_episode_loses_that_one_only(two: Path, tmp_path: Path) -> None:
    gone = Gone(READY, decide(**TURN), decide(**TURN))
    served = serve(Offer(two, tmp_path), one_after_the_other(gone, playing(Turner())))
    assert "the agent hung up" in served.results["e0"].failure
    check_first_lost(served, "with HungUpError", steps=served.results["e0"].measures.num_steps)


def test_an_agent_that_answers_before_it_is_asked_is_hung_up_on(two: Path, tmp_path: Path) -> None:
    def flood(address: str) -> tuple[str, str]:
        with grpc.insecure_channel(address) as channel:
            sayings = iter([say("hello", protocol=1), NEXT, *[READY] * 1000])
            try:
                list(channel.stream_stream("/uniteam.Environment/Play")(sayings))
            except grpc.RpcError as error:
                return error.code().name, error.details()
        return "OK", ""

    served = serve(Offer(two, tmp_path), one_after_the_other(flood, playing(Turner())))
    status, words = served.returned[0][0]
    assert status == "INVALID_ARGUMENT" and "answered before it was asked" in words
    first = served.results["e0"]  # a flood that comes before the episode begins costs none
    assert "answered before it was asked" in first.failure or first.measures.does_want_terminate
    assert served.results["e1"].measures.does_want_terminate


def test_an_agent_that_greets_wrongly_or_never_is_hung_up_on_and_costs_no_episode(
    two: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session, "HELLO_SECONDS", 0.3)
    greetings = ((b"", "DEADLINE_EXCEEDED"), (READY, "INVALID_ARGUMENT"), (OTHER_HELLO, "FAILED_PRECONDITION"))
    for hello, status in greetings:
        served = serve(Offer(two, tmp_path / status), one_after_the_other(Rude(hello=hello), playing(Turner())))
        assert served.returned[0][0][0] == status
        assert not served.results["e0"].crashed and not served.results["e1"].crashed
    assert "version 99 of the messages" in served.returned[0][0][1]


class Misbehaving(Turner):
    """Turns, and does something wrong in the first episode."""

    def __init__(self, wrong: Any) -> None:
        super().__init__()
        self._wrong = wrong

    def act(self, observation: uniteam_client.Observation) -> Any:
        return self._wrong() if len(self.asked) == 1 and observation.step == 1 else super().act(observation)


def stumble() -> None:
    raise ZeroDivisionError("of course")


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        (lambda: uniteam_client.BaseDisplacement(math.nan), "BaseDisplacement.x is not a finite number"),
        (
            lambda: uniteam_client.JointDisplacement(uniteam_client.Joints(lift=math.inf)),
            "JointDisplacement.delta.lift is not a finite number",
        ),
        (lambda: "forwards", "there is no action 'forwards'; the discrete actions are stop, move_forward"),
        (lambda: 7, "act must return one of stop, move_forward"),
        (stumble, "AgentRaisedError: the agent raised ZeroDivisionError: of course"),
    ],
)
def test_a_wrong_action_costs_the_episode_and_the_next_one_begins(
    two: Path, tmp_path: Path, wrong: Any, sentence: str
) -> None:
    agent = Misbehaving(wrong)
    served = serve(Offer(two, tmp_path), [playing(agent)])
    check_first_lost(served, sentence, steps=1)
    assert [episode.id for episode in served.returned[0]] == ["e0", "e1"]
    assert sentence in served.returned[0][0].failure
    assert sum("has connected" in notice for notice in served.notices) == 1


def test_where_an_agent_raised_stands_in_the_result(two: Path, tmp_path: Path) -> None:
    served = serve(Offer(two, tmp_path), [playing(Misbehaving(stumble))])
    assert "On the agent's side:" in served.results["e0"].traceback
    assert "in stumble" in served.results["e0"].traceback


def test_a_slow_agent_loses_the_episode_and_comes_back_by_itself(two: Path, tmp_path: Path) -> None:
    def sleep() -> str:
        time.sleep(1.5)
        return "turn_left"

    served = serve(Offer(two, tmp_path, answer_seconds=0.5), [playing(Misbehaving(sleep))])
    check_first_lost(served, "the agent did not answer in 0.5 s", steps=1)
    assert [episode.id for episode in served.returned[0]] == ["e1"]


def test_the_time_of_an_episode_is_counted_over_all_its_answers(two: Path, tmp_path: Path) -> None:
    class Slow(Turner):
        def act(self, observation: uniteam_client.Observation) -> Any:
            time.sleep(0.3 if len(self.asked) == 1 else 0.0)
            return super().act(observation)

    served = serve(Offer(two, tmp_path, episode_seconds=0.7), [playing(Slow(8))])
    check_first_lost(served, "the agent took more than 0.7 s for the episode", steps=2)


def test_a_token_keeps_strangers_out(two: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("UNITEAM_TOKEN", raising=False)

    def stranger_then_friend(address: str) -> Any:
        with pytest.raises(uniteam_client.ServerError, match="set UNITEAM_TOKEN to what it is on the server"):
            uniteam_client.play(Turner(), address, wait=10.0)
        return uniteam_client.play(Turner(), address, token="secret")

    served = serve(Offer(two, tmp_path, place=Place(token="secret")), [stranger_then_friend])
    assert [episode.id for episode in served.returned[0]] == ["e0", "e1"]
    assert not served.results["e0"].crashed


def test_a_second_agent_is_told_that_there_is_no_seat(
    two: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(agent_server, "SEAT_SECONDS", 0.3)
    refused: list[uniteam_client.ServerError] = []

    class Host(Turner):
        """Lets another one knock in the middle of an episode."""

        def act(self, observation: uniteam_client.Observation) -> Any:
            if not refused:
                with pytest.raises(uniteam_client.ServerError) as told:
                    uniteam_client.play(Turner(), self.address, wait=10.0)
                refused.append(told.value)
            return super().act(observation)

        def __call__(self, address: str) -> Any:
            self.address = address
            return uniteam_client.play(self, address, wait=20.0)

    served = serve(Offer(two, tmp_path), [Host()])
    assert "as many agents play already as this server lets in at once" in str(refused[0])
    assert [episode.id for episode in served.returned[0]] == ["e0", "e1"]


def test_nobody_there_is_told_in_a_sentence() -> None:
    with pytest.raises(uniteam_client.ServerError, match=r"nobody answers at 127\.0\.0\.1:9 in 0\.5 s; see that"):
        uniteam_client.play(Turner(), "127.0.0.1:9", wait=0.5)
