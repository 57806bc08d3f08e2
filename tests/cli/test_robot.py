"""`uniteam robot` on a fake Stretch: it asks first, says what it does, and stops when it is told to."""

import io
import os
import sys
import threading
from collections.abc import Iterator

import pytest
from worlds.fake_robot import Ports, bridge, served, simulator

from uniteam.cli.main import main
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.visible_truth import truth_maker

pytest.importorskip("zmq", reason="the extra 'robot' is not installed")

TASK = ("--object", "cup", "--start", "sink", "--goal", "table", "--agent", "baseline", "--turn-speed", "1")


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> Simulator:
    return simulator(tmp_path_factory.mktemp("models"))


@pytest.fixture
def side(world: Simulator) -> FakeBridge:
    return bridge(world)


@pytest.fixture
def ports(side: FakeBridge, world: Simulator) -> Iterator[Ports]:
    with served(side, truth_maker(world.home)) as ports:
        yield ports


def call(*arguments: str) -> int:
    with pytest.raises(SystemExit) as ended:
        main(["robot", *arguments])
    return int(ended.value.code or 0)


def called(ports: Ports, *arguments: str) -> int:
    return call("127.0.0.1", "--port", str(ports.first), *TASK, "--perception", "truth", *arguments)


def test_it_moves_once_it_is_told_to_and_says_what_it_does(
    side: FakeBridge, ports: Ports, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO("go\n"))
    monkeypatch.setenv("COLUMNS", "300")
    assert called(ports, "--steps", "2") == 0
    told = capsys.readouterr().out
    assert "Move cup from sink to table" in told
    assert "It will begin thus: open the gripper; then move the lift to 0.78 m" in told
    assert "up to 0.15 m/s and 1 rad/s, within 3 m" in told
    assert "turn the base right by 30 degrees" in told
    assert "The steps are used up after 2 steps." in told
    assert abs(side.robot.base.heading) == pytest.approx(2 * 0.5236, abs=0.05)
    assert side.refusals == []


@pytest.mark.parametrize("answer", ["", "no\n", "\n", "gone\n"])
def test_without_consent_nothing_is_sent(
    answer: str,
    side: FakeBridge,
    ports: Ports,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO(answer))
    assert called(ports) == 0
    assert "Nothing was moved." in capsys.readouterr().out
    assert side.step == -1


def test_a_dry_run_sends_nothing(side: FakeBridge, ports: Ports, capsys: pytest.CaptureFixture[str]) -> None:
    assert called(ports, "--dry-run", "--steps", "3") == 0
    told = capsys.readouterr().out
    assert told.count("would turn the base right by 30 degrees") == 3
    assert "after 3 steps that were not taken" in told
    assert side.step == -1


def test_a_key_stops_it(
    side: FakeBridge, ports: Ports, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    reading, writing = os.pipe()
    with os.fdopen(reading) as keyboard, os.fdopen(writing, "w") as finger:
        finger.write("go\n")
        finger.flush()
        monkeypatch.setattr(sys, "stdin", keyboard)
        press = threading.Timer(4.0, lambda: print("", file=finger, flush=True))
        press.start()
        assert called(ports) == 2
        press.join()
    assert "a key was pressed, so the robot was told to stop" in capsys.readouterr().err
    assert side.robot.motors._wanted == (0.0, 0.0)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("127.0.0.1", *TASK, "--speed", "0.5"), "--speed must be above 0 and at most 0.3, got 0.5"),
        (("127.0.0.1", *TASK, "--speed", "nan"), "--speed must be above 0"),
        (("127.0.0.1", *TASK, "--turn-speed", "-1"), "--turn-speed must be above 0 and at most 1"),
        (("127.0.0.1", *TASK, "--fence", "0"), "the limit fence must be above 0"),
        (("127.0.0.1", *TASK, "--steps", "0"), "--steps must be at least 1"),
        (("127.0.0.1", *TASK, "--port", "65535"), "it is the first of four"),
        (("not an address", *TASK), "'not an address', ports 4401 and following, cannot be connected to"),
        (("127.0.0.1", *TASK, "--agent", "oracle"), "must be told the truth, which no robot knows"),
        (("127.0.0.1", *TASK, "--perception", "truht"), "did you mean 'truth'"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(
    arguments: tuple[str, ...], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call(*arguments) == 2
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert sentence in line


def test_the_truth_is_not_to_be_had_from_a_robot(side: FakeBridge, capsys: pytest.CaptureFixture[str]) -> None:
    with served(side) as ports:
        assert called(ports) == 2
    assert "needs the truth, which no robot knows" in capsys.readouterr().err
