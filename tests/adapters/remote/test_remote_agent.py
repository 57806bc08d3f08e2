"""Agents that play through a server: they see, decide and are judged as in the same process."""

import ast
import subprocess
import sys
from dataclasses import astuple, replace
from pathlib import Path
from threading import Barrier
from typing import Any

import numpy as np
import pytest

pytest.importorskip("grpc", reason="the extra 'serve' is not installed")

import uniteam_client
from worlds.filled import filled
from worlds.served import LABEL, READY, Offer, Rude, Turner, decide, playing, serve, write_episodes

from uniteam.adapters.remote.agent_server import Place
from uniteam.adapters.remote.messages import decision_of, decode_answer
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import Step, play_episode
from uniteam.evaluation.recording.recording import read_recording
from uniteam.evaluation.results.result import measures_to_data
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import (
    Agent,
    BaseDisplacement,
    Decision,
    Detection,
    DiscreteAction,
    Instruction,
    Joints,
    Observation,
    Segmentation,
)
from uniteam.mind.agents.registry import make_agent
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split

CLIENT = Path(uniteam_client.__file__)


class Abroad:
    """An agent of uniteam's own at the client's end, in the client's words; notes what it saw and decided."""

    def __init__(self, agent: Agent) -> None:
        self._agent = agent
        self.seen: list[Observation] = []
        self.decided: list[Decision] = []

    def reset(self, instruction: uniteam_client.Instruction, seed: int) -> None:
        self._agent.reset(Instruction(*astuple(instruction)), seed)

    def act(self, observation: uniteam_client.Observation) -> uniteam_client.Decision:
        self.seen.append(ours(observation))
        decision = self._agent.act(self.seen[-1])
        self.decided.append(decision)
        return uniteam_client.Decision(theirs(decision.action), decision.state, decision.reason)


def ours(observation: uniteam_client.Observation) -> Observation:
    assert observation.truth is not None
    return Observation(
        rgb=observation.rgb,
        depth=observation.depth,
        camera=PinholeCamera(*astuple(observation.camera)),
        camera_to_start=observation.camera_to_start,
        base_to_start=BasePose(*astuple(observation.base_to_start)),
        joints=Joints(*astuple(observation.joints)),
        is_holding=observation.is_holding,
        step=observation.step,
        truth=Segmentation(
            observation.truth.instances, tuple(Detection(((name, 1.0),)) for name in observation.truth.names)
        ),
    )


def theirs(action: Any) -> uniteam_client.Action:
    if isinstance(action, DiscreteAction):
        return action.value
    if isinstance(action, BaseDisplacement):
        return uniteam_client.BaseDisplacement(*astuple(action))
    delta, base = uniteam_client.Joints(*astuple(action.delta)), uniteam_client.BaseDisplacement(*astuple(action.base))
    return uniteam_client.JointDisplacement(delta, base)


@pytest.fixture(scope="module")
def two(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_episodes(tmp_path_factory.mktemp("split") / "two.jsonl.gz", 2)


@pytest.mark.slow
def test_an_agent_sees_decides_and_achieves_the_same_to_the_bit_as_in_process(tmp_path: Path) -> None:
    minival = load_split("minival")
    episodes = tuple(minival.episodes[k] for k in (1, 8))
    homes = {episode.home: minival.homes[episode.home] for episode in episodes}
    write_split(Split("pair", episodes, homes), tmp_path / "pair.jsonl.gz")
    abroad = Abroad(make_agent("uniteam-plus", "truth"))
    served = serve(Offer(tmp_path / "pair.jsonl.gz", tmp_path / "out", "truth"), [playing(abroad)])
    steps: list[Step] = []
    for episode in episodes:
        environment = Environment(homes[episode.home], episode, give_truth=True)
        result = play_episode(environment, AgentSpec("uniteam-plus", "truth").make(environment), steps.append)
        assert result.measures == served.results[episode.id].measures
        assert (result.state, result.failure) == (served.results[episode.id].state, served.results[episode.id].failure)
    assert all(served.results[episode.id].measures.overall_success for episode in episodes)
    assert [step.decision for step in steps] == abroad.decided
    assert all(same(step.observation, seen) for step, seen in filled(zip(steps, abroad.seen, strict=True)))


def same(one: Observation, other: Observation) -> bool:
    """Return whether two observations are equal to the bit."""
    assert one.truth is not None and other.truth is not None
    plain = ("camera", "base_to_start", "joints", "is_holding", "step")
    arrays = ("rgb", "depth", "camera_to_start")
    return (
        all(getattr(one, name) == getattr(other, name) for name in plain)
        and all(getattr(one, name).tobytes() == getattr(other, name).tobytes() for name in arrays)
        and one.truth.instances.tobytes() == other.truth.instances.tobytes()
        and [d.name for d in one.truth.detections] == [d.name for d in other.truth.detections]
    )


@pytest.mark.parametrize(
    "action",
    [
        *uniteam_client.DISCRETE_ACTIONS,
        uniteam_client.BaseDisplacement(0.5, -0.25, 0.125),
        uniteam_client.JointDisplacement(
            uniteam_client.Joints(*np.arange(1.0, 8.0)), uniteam_client.BaseDisplacement(8.0, 9.0, 10.0)
        ),
    ],
)
def test_an_action_arrives_as_it_was_sent(action: uniteam_client.Action) -> None:
    decided = decode_answer(uniteam_client._pack_decision(action))
    assert theirs(decision_of(decided).action) == action  # type: ignore[arg-type]


def test_the_client_knows_every_discrete_action() -> None:
    assert tuple(action.value for action in DiscreteAction) == uniteam_client.DISCRETE_ACTIONS


def test_the_truth_is_sent_only_in_a_run_that_says_so(two: Path, tmp_path: Path) -> None:
    truths: dict[str, list[object]] = {"own": [], "truth": []}
    for perception, seen in truths.items():

        class Looker(Turner):
            def act(self, observation: uniteam_client.Observation, seen: list[object] = seen) -> Any:
                seen.append(observation.truth)
                return super().act(observation)

        serve(Offer(two, tmp_path / perception, perception), [playing(Looker())])
    assert set(truths["own"]) == {None}
    assert len(truths["truth"]) == 6
    assert all(isinstance(truth, uniteam_client.Segmentation) and truth.names for truth in filled(truths["truth"]))
    assert '"perception": "truth"' in (tmp_path / "truth" / "config.json").read_text()


def test_nothing_of_the_judge_is_told_before_the_episode_is_over(two: Path, tmp_path: Path) -> None:
    stop = {"kind": "discrete", "name": "stop"}
    rude = Rude(READY, decide(kind="discrete", name="turn_left"), decide(**stop), READY, decide(**stop))
    served = serve(Offer(two, tmp_path), [rude])

    def told(kind: str) -> list[dict[str, Any]]:
        return [message for message in rude.heard if message["kind"] == kind]

    kinds = [message["kind"] for message in rude.heard]
    assert kinds == ["welcome", "reset", "observe", "observe", "over", "reset", "observe", "over", "done"]
    assert all(set(message) == {"kind", "instruction", "seed"} for message in filled(told("reset")))
    looks = told("observe")
    assert all(set(message) == {"kind", "frame", "truth"} and message["truth"] is None for message in filled(looks))
    frame = {"session", "instruction", "seed", "step", "width", "height", "rgb", "depth", "intrinsics"}
    assert all(
        set(message["frame"]) == frame | {"camera_to_start", "base_to_start", "joints", "is_holding"}
        for message in filled(looks)
    )
    assert rude.heard[4]["measures"] == measures_to_data(served.results["e0"].measures)
    assert served.returned == [("OK", "")]


def test_two_agents_at_once_share_the_episodes(tmp_path: Path) -> None:
    both_there = Barrier(2, timeout=30.0)

    class Waiting(Turner):
        def act(self, observation: uniteam_client.Observation) -> Any:
            if self.looks == 0:
                both_there.wait()  # neither begins without the other
            return super().act(observation)

    split = write_episodes(tmp_path / "four.jsonl.gz", 4)
    one, other = Waiting(3), Waiting(5)
    served = serve(Offer(split, tmp_path / "out", place=Place(seats=2)), [playing(one), playing(other)])
    assert set(served.results) == {"e0", "e1", "e2", "e3"}
    assert len(one.asked) + len(other.asked) == 4 and one.asked and other.asked
    steps = sorted(result.measures.num_steps for result in served.results.values())
    assert steps == sorted([4] * len(one.asked) + [6] * len(other.asked))


def test_a_run_goes_on_where_it_was_and_its_recordings_can_be_read(two: Path, tmp_path: Path) -> None:
    offer = Offer(two, tmp_path, record="all")
    first = serve(offer, [playing(Turner(4))])
    assert set(serve(offer, []).results) == {"e0", "e1"}
    results = tmp_path / "results.jsonl"
    results.write_text(results.read_text().splitlines(keepends=True)[0])
    again = serve(offer, [playing(Turner(4))])
    assert [episode.id for episode in again.returned[0]] == ["e1"]
    assert again.results["e1"].measures == first.results["e1"].measures
    recording = read_recording(tmp_path / "recordings" / LABEL / "e1.zip")
    assert recording.header.spec == AgentSpec("guest", "own")
    assert [step.decision.action for step in recording.steps] == [DiscreteAction.TURN_LEFT] * 4 + [DiscreteAction.STOP]
    assert recording.steps[0].decision == Decision(DiscreteAction.TURN_LEFT, "TURN", "why not")


def test_an_agent_that_leaves_between_two_episodes_loses_none(two: Path, tmp_path: Path) -> None:
    class LeavingError(Exception):
        pass

    def leave(episode: uniteam_client.Episode) -> None:
        raise LeavingError

    def twice(address: str) -> Any:
        with pytest.raises(LeavingError):
            uniteam_client.play(Turner(), address, wait=20.0, on_episode=leave)
        return uniteam_client.play(Turner(), address, wait=20.0)

    served = serve(Offer(two, tmp_path), [twice])
    assert [episode.id for episode in served.returned[0]] == ["e1"]
    assert not served.results["e0"].crashed and not served.results["e1"].crashed


def test_the_client_needs_no_more_than_it_says_and_speaks_an_old_python() -> None:
    ast.parse(CLIENT.read_text(), feature_version=(3, 8))
    allowed = {"numpy", "msgpack", "grpc", "uniteam_client"}
    script = (
        "import sys; sys.path.insert(0, sys.argv[1]); before = set(sys.modules); import uniteam_client; "
        "print(*sorted({name.split('.')[0] for name in set(sys.modules) - before}))"
    )
    environment = {"PATH": "/usr/bin:/bin"}
    command = [sys.executable, "-I", "-c", script, str(CLIENT.parent)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=True)
    outside = {name for name in done.stdout.split() if name not in sys.stdlib_module_names and not name.startswith("_")}
    assert outside - {"cython_runtime", "typing_extensions"} <= allowed  # grpcio's own
    assert allowed <= outside


def test_offers_are_independent_of_each_other(two: Path, tmp_path: Path) -> None:
    agent = Turner()
    serve(Offer(two, tmp_path / "one"), [playing(agent)])
    served = serve(replace(Offer(two, tmp_path / "other")), [playing(agent)])
    assert set(served.results) == {"e0", "e1"}
    assert agent.asked[:2] == agent.asked[2:]
