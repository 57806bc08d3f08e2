"""A perception behind HTTP: a real server on loopback, and servers that do everything wrong."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import msgspec
import numpy as np
import pytest
from worlds.box_world import Box, observe

from uniteam.errors import InvalidInputError
from uniteam.evaluation.backends.serving import Charging
from uniteam.evaluation.charged_agent import ChargedAgent
from uniteam.geometry import BasePose
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.perception.detectors import remote
from uniteam.mind.perception.detectors.remote import Patience, RemotePerception, ServerError
from uniteam.mind.perception.detectors.remote_messages import (
    PROTOCOL,
    Frame,
    Health,
    Seen,
    Thing,
    frame_of,
    observation_of,
    seen_of,
    segmentation_of,
)
from uniteam.mind.perception.perception_server import PerceptionServer, Sessions
from uniteam.mind.perception.registry import make_perception
from uniteam.mind.perception.truth import visible_truth
from uniteam.testing import check_perception
from uniteam.testing.depth_bands import DepthBands

pytest.importorskip("httpx", reason="the extra 'remote' is not installed")

SERVED = f"{DepthBands.__module__}:DepthBands"
FRAME = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))
CUP = Instruction("cup", "table", "bed")
HASTY = Patience(connect=0.5, answer=0.5, tries=2, pause=0.01)


@contextmanager
def running(server: ThreadingHTTPServer) -> Iterator[str]:
    """Run a server in a thread and give its address."""
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with running(PerceptionServer(("127.0.0.1", 0), SERVED, "test")) as address:
        yield address


Answer = Callable[[BaseHTTPRequestHandler], None]


@contextmanager
def answering(perceive: Answer, protocol: int = PROTOCOL) -> Iterator[tuple[str, list[str]]]:
    """Run a server that is in good health and answers frames as it is told to; give its address and what was asked."""
    asked: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            send(self, msgspec.msgpack.encode(Health(protocol, "any", "9.9")))

        def do_POST(self) -> None:
            asked.append(self.path)
            self.rfile.read(int(self.headers["Content-Length"]))
            perceive(self)

        def log_message(self, *arguments: object) -> None:
            pass

    with running(ThreadingHTTPServer(("127.0.0.1", 0), Handler)) as address:
        yield address, asked


def send(handler: BaseHTTPRequestHandler, content: bytes, status: int = 200) -> None:
    handler.send_response(status)
    handler.send_header("Content-Length", str(len(content)))
    handler.end_headers()
    handler.wfile.write(content)


def sending(content: bytes, status: int = 200) -> Answer:
    return lambda handler: send(handler, content, status)


def seen(width: int, height: int, value: int = -1, things: tuple[Thing, ...] = ()) -> bytes:
    instances = np.full((height, width), value, "<i2").tobytes()
    return msgspec.msgpack.encode(Seen(width, height, instances, things))


def test_it_passes_the_check_and_sees_what_the_served_perception_sees(url: str) -> None:
    check_perception(f"remote:{url}", steps=6)
    far, near = make_perception(f"remote:{url}/"), DepthBands()
    for perception in (far, near):
        perception.reset(CUP, 5)
    one, other = far.perceive(FRAME), near.perceive(FRAME)
    assert np.array_equal(one.instances, other.instances)
    assert [d.candidates for d in one.detections] == [d.candidates for d in other.detections]


def test_a_frame_arrives_as_it_was_sent_but_for_the_truth() -> None:
    sent = frame_of("s", CUP, 3, FRAME)
    arrived = observation_of(msgspec.msgpack.decode(msgspec.msgpack.encode(sent), type=Frame))
    for name in ("rgb", "depth", "camera_to_start"):
        assert np.array_equal(getattr(arrived, name), getattr(FRAME, name))
    for name in ("camera", "base_to_start", "joints", "is_holding", "step"):
        assert getattr(arrived, name) == getattr(FRAME, name)
    assert arrived.truth is None


def test_a_segmentation_with_embeddings_arrives_as_it_was_sent() -> None:
    things = (Thing((("cup", 0.9), ("bowl", 0.2)), np.arange(3, dtype="<f4").tobytes()),)
    sent = segmentation_of(msgspec.msgpack.decode(seen(240, 320, 0, things), type=Seen))
    again = segmentation_of(seen_of(sent))
    assert np.array_equal(again.instances, sent.instances)
    assert again.detections[0].candidates == (("cup", 0.9), ("bowl", 0.2))
    assert again.detections[0].embedding is not None and again.detections[0].embedding.tolist() == [0.0, 1.0, 2.0]
    assert seen_of(visible_truth(FRAME)).detections[0].embedding is None


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"", "sent no Seen"),
        (b"<html>hello</html>", "sent no Seen"),
        (msgspec.msgpack.encode({"width": 240}), "sent no Seen"),
        (b"\x91" * 100_000, "sent no Seen"),
        (seen(120, 160), r"segmentation of \(160, 120\) for a frame of \(320, 240\)"),
        (msgspec.msgpack.encode(Seen(240, 320, b"\0" * 7, ())), "has 153600 bytes, got 7"),
        (msgspec.msgpack.encode(Seen(10**6, 10**6, b"", ())), "1000000 x 1000000"),
        (seen(240, 320, value=3), "indices of its 0 detections"),
        (seen(240, 320, 0, (Thing((("cup", 7.0),)),)), r"score in \[0, 1\]"),
        (seen(240, 320, 0, (Thing(()),)), "at least one"),
        (seen(240, 320, 0, (Thing((("cup", 0.5),), b"abc"),)), "has 0 bytes, got 3"),
    ],
)
def test_an_answer_that_makes_no_sense_is_told_in_a_sentence_and_not_asked_for_again(
    content: bytes, sentence: str
) -> None:
    with answering(sending(content)) as (address, asked):
        perception = RemotePerception(address, HASTY)
        with pytest.raises(ServerError, match=sentence):
            perception.perceive(FRAME)
        assert len(asked) == 1


def test_an_answer_that_is_too_long_is_not_read_to_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(remote, "MOST_BYTES", 1_000_000)
    with answering(sending(b"\0" * 4_000_000)) as (address, _), pytest.raises(ServerError, match="more than 1000000 "):
        RemotePerception(address, HASTY).perceive(FRAME)


def test_a_server_that_says_nothing_is_given_up_after_the_tries() -> None:
    with answering(lambda handler: time.sleep(1.0)) as (address, asked):
        began = time.monotonic()
        with pytest.raises(ServerError, match=r"did not answer in 2 tries \(ReadTimeout"):
            RemotePerception(address, HASTY).perceive(FRAME)
        assert len(asked) == 2 and time.monotonic() - began < 3.0


def test_a_server_that_answers_drop_by_drop_is_given_up_too() -> None:
    def drip(handler: BaseHTTPRequestHandler) -> None:
        handler.send_response(200)
        handler.send_header("Content-Length", "1000")
        handler.end_headers()
        for _ in range(20):
            try:
                handler.wfile.write(b"x")
                handler.wfile.flush()
            except OSError:
                return
            time.sleep(0.1)

    with answering(drip) as (address, _):
        began = time.monotonic()
        with pytest.raises(ServerError, match=r"its answer took more than 0\.5 s"):
            RemotePerception(address, HASTY).perceive(FRAME)
        assert time.monotonic() - began < 3.0


def test_a_server_that_hangs_up_or_is_overloaded_once_is_asked_again() -> None:
    count = 0

    def twice_bad(handler: BaseHTTPRequestHandler) -> None:
        nonlocal count
        count += 1
        if count == 1:
            handler.connection.close()
        else:
            send(handler, b"", 503) if count == 2 else send(handler, seen(240, 320))

    with answering(twice_bad) as (address, asked):
        patient = Patience(connect=1.0, answer=2.0, tries=3, pause=0.01)
        assert RemotePerception(address, patient).perceive(FRAME).detections == ()
        assert len(asked) == 3


def test_nobody_there_is_told_at_once_with_what_to_do() -> None:
    with pytest.raises(ServerError, match=r"did not answer in 2 tries \(ConnectError.*serve-perception"):
        RemotePerception("http://127.0.0.1:9", HASTY)


def test_a_server_of_other_messages_is_refused() -> None:
    with answering(sending(b""), protocol=99) as (address, _), pytest.raises(ServerError, match="version 99"):
        RemotePerception(address, HASTY)


class Stumbling(DepthBands):
    """Stumbles over every frame."""

    def perceive(self, observation: object) -> None:  # type: ignore[override]
        raise ZeroDivisionError("of course")


def test_what_a_served_perception_raises_is_told_to_whoever_asked_and_the_server_goes_on() -> None:
    server = PerceptionServer(("127.0.0.1", 0), f"{__name__}:Stumbling", "test")
    with running(server) as address:
        perception = RemotePerception(address, HASTY)
        for _ in range(2):
            with pytest.raises(
                ServerError, match="status 500: the perception failed with ZeroDivisionError: of course"
            ):
                perception.perceive(FRAME)


@pytest.mark.parametrize(
    ("path", "headers", "body", "status"),
    [
        ("/perceive", {}, b"garbage", 400),
        ("/perceive", {}, b"\x91" * 100_000, 400),
        ("/perceive", {}, msgspec.msgpack.encode({"session": "x"}), 400),
        ("/elsewhere", {}, b"", 404),
        ("/perceive", {"Content-Length": "99999999999"}, b"", 413),
        ("/perceive", {"Content-Length": "many"}, b"", 411),
    ],
)
def test_a_server_refuses_what_is_no_frame_and_goes_on(
    url: str, path: str, headers: dict[str, str], body: bytes, status: int
) -> None:
    host = url.removeprefix("http://")
    connection = HTTPConnection(host, timeout=5.0)
    connection.putrequest("POST", path)
    for name, value in ({"Content-Length": str(len(body))} | headers).items():
        connection.putheader(name, value)
    connection.endheaders(body)
    assert connection.getresponse().status == status
    connection.close()
    again = HTTPConnection(host, timeout=5.0)
    again.request("GET", "/health")
    assert again.getresponse().status == 200
    again.close()


def test_a_frame_of_another_size_than_it_says_is_refused(url: str) -> None:
    frame = frame_of("s", CUP, 0, FRAME)
    broken = msgspec.structs.replace(frame, rgb=b"\0" * 10)
    with pytest.raises(InvalidInputError, match=r"rgb of shape \(320, 240, 3\) has 230400 bytes, got 10"):
        observation_of(broken)
    with pytest.raises(InvalidInputError, match="a pose has 16 numbers"):
        observation_of(msgspec.structs.replace(frame, camera_to_start=(1.0,)))


def test_a_token_keeps_strangers_out(monkeypatch: pytest.MonkeyPatch) -> None:
    with running(PerceptionServer(("127.0.0.1", 0), SERVED, "test", token="secret")) as address:
        with pytest.raises(ServerError, match="status 401: set UNITEAM_TOKEN"):
            RemotePerception(address, HASTY)
        monkeypatch.setenv("UNITEAM_TOKEN", "secret")
        assert RemotePerception(address, HASTY).health.perception == SERVED


class Counting:
    """Sees as many things as it has seen frames of the episode."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        self.count = 0

    def perceive(self, observation: Observation) -> Segmentation:
        self.count += 1
        nothing = np.full(observation.depth.shape, -1, np.int16)
        return Segmentation(nothing, (Detection((("cup", 0.5),)),) * self.count)


def test_each_episode_has_a_perception_of_its_own() -> None:
    sessions = Sessions(f"{__name__}:Counting")
    counts = [len(sessions.perceive(frame_of(name, CUP, 0, FRAME)).detections) for name in "aabaab"]
    assert counts == [1, 2, 1, 3, 4, 2]


def test_what_needs_the_truth_is_not_served() -> None:
    with pytest.raises(InvalidInputError, match="needs the simulator's truth"):
        Sessions("noisy:0.5")


@pytest.mark.parametrize("argument", ["gpu-machine", "ftp://gpu", "http://", "http://a b"])
def test_an_address_that_is_none_is_refused(argument: str) -> None:
    with pytest.raises(InvalidInputError, match="needs the address of a server"):
        make_perception(f"remote:{argument}")


def test_a_server_that_is_gone_is_not_the_agents_failure() -> None:
    with answering(sending(seen(240, 320))) as (address, _):
        perception = RemotePerception(address, HASTY)
    charging: Charging = _free
    agent = ChargedAgent(lambda: HeuristicAgent(BASELINE, perception), charging)
    agent.reset(CUP, 0)
    with pytest.raises(ServerError):
        agent.act(FRAME)


@contextmanager
def _free() -> Iterator[None]:
    yield
