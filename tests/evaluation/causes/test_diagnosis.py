"""Real episodes that fail for a reason which is known: the oracle, led astray, in the simulator."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import repeat
from pathlib import Path

import numpy as np
import pytest
from worlds.recorded import record_made
from worlds.saboteur import Saboteur, Spoil, until, until_state

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.diagnosis import diagnose, diagnose_result
from uniteam.evaluation.causes.reading.grasps import grasp_steps, moment_before_grasp
from uniteam.evaluation.causes.reading.read_story import read_story
from uniteam.evaluation.causes.reading.targets import moments_to_look
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.interface import Action, Decision, Detection, DiscreteAction
from uniteam.stretch import JOINT_LIMITS

WAIT = DiscreteAction.EMPTY_ACTION
Decisions = Iterator[Decision]


def stop_at_once(decisions: Decisions) -> Iterator[Action]:
    yield DiscreteAction.STOP


def grasp_blindly(decisions: Decisions) -> Iterator[Action]:
    yield DiscreteAction.SNAP_OBJECT


def grasp_from_afar(decisions: Decisions) -> Iterator[Action]:
    yield from until_state(decisions, "NAVIGATE_TO_OBJECT")
    yield DiscreteAction.SNAP_OBJECT


def drop_at_once(decisions: Decisions) -> Iterator[Action]:
    yield from until(decisions, DiscreteAction.SNAP_OBJECT)
    yield DiscreteAction.DESNAP_OBJECT
    yield from repeat(WAIT, 30)


def drop_short(decisions: Decisions) -> Iterator[Action]:
    yield from until_state(decisions, "PLACE")
    yield DiscreteAction.MANIPULATION_MODE
    yield DiscreteAction.DESNAP_OBJECT
    yield from repeat(WAIT, 30)


def stop_early(decisions: Decisions) -> Iterator[Action]:
    yield from until(decisions, DiscreteAction.DESNAP_OBJECT)
    yield from repeat(WAIT, 30)


def turn_for_ever(decisions: Decisions) -> Iterator[Action]:
    yield from until_state(decisions, "FIND_RECEPTACLE")
    yield from repeat(DiscreteAction.TURN_LEFT, 260)


CASES: dict[str, tuple[Spoil, Cause, str]] = {
    "stops at once": (stop_at_once, Cause.GAVE_UP, "find object"),
    "grasps blindly": (grasp_blindly, Cause.OUT_OF_VIEW, "find object"),
    "grasps from afar": (grasp_from_afar, Cause.OUT_OF_REACH, "pick object"),
    "drops it at once": (drop_at_once, Cause.WRONG_RECEPTACLE, "find receptacle"),
    "drops it short": (drop_short, Cause.BESIDE, "place"),
    "stops early": (stop_early, Cause.STOPPED_EARLY, "place"),
    "turns for ever": (turn_for_ever, Cause.STUCK, "place"),
}


def played(path: Path, spoil: Spoil) -> Recording:
    record_made(path, lambda environment: Saboteur(environment, spoil), AgentSpec("random", "truth"))
    return read_recording(path)


@pytest.mark.parametrize(("spoil", "cause", "phase"), CASES.values(), ids=CASES)
def test_an_episode_that_is_spoilt_has_the_cause_that_spoilt_it(
    spoil: Spoil, cause: Cause, phase: str, tmp_path: Path
) -> None:
    recording = played(tmp_path / "spoilt.zip", spoil)
    found = diagnose(recording)
    assert found is not None
    assert (found.cause, found.phase, found.is_recorded) == (cause, phase, True), found.evidence
    assert 0 <= found.step < len(recording.steps)


def test_the_story_says_where_the_object_hung_and_what_it_lies_on(tmp_path: Path) -> None:
    recording = played(tmp_path / "early.zip", stop_early)
    release, certificate = read_story(recording).release, recording.episode.certificate
    assert release is not None and certificate is not None
    assert (release.name, release.goal) == (certificate.object, certificate.receptacle)
    assert recording.steps[release.step].decision.action is DiscreteAction.DESNAP_OBJECT
    assert release.to_goal == 0.0 and release.arm == pytest.approx(certificate.release_joints.arm)
    assert release.bottom > release.goal_lowest and not release.is_wall_between
    assert release.is_over_goal and release.is_on_goal and release.stay_steps < 30
    room = JOINT_LIMITS[1].lift - certificate.release_joints.lift
    assert release.highest == pytest.approx(release.bottom + room) and release.goal_highest > release.goal_lowest
    assert not release.has_fallen_through


def test_a_gripper_that_hangs_down_could_have_lifted_the_object_by_its_wrist_too(tmp_path: Path) -> None:
    recording = played(tmp_path / "short.zip", drop_short)
    release = read_story(recording).release
    assert release is not None
    joints = recording.true_joints(release.step)
    assert joints.wrist_pitch < -1.0
    assert release.highest > release.bottom + JOINT_LIMITS[1].lift - joints.lift + 0.1


def test_pictures_with_little_of_a_thing_are_looked_into_where_there_are_no_better_ones(tmp_path: Path) -> None:
    recording = played(tmp_path / "early.zip", stop_early)
    name = recording.episode.objects[0].name
    pixels = recording.visible_pixels(name)
    least = 0.001 * recording.header.camera.width * recording.header.camera.height
    first_clear = int(np.argmax(pixels >= least))
    faint = set(np.flatnonzero(pixels[:first_clear]).tolist())
    assert faint and moments_to_look(recording, [name], first_clear) == faint
    assert not faint & moments_to_look(recording, [name], len(pixels))


def test_a_grasp_is_at_what_was_believed_a_few_steps_before(tmp_path: Path) -> None:
    recording = played(tmp_path / "afar.zip", grasp_from_afar)
    (step,) = grasp_steps(recording)
    seen = (Detection(((recording.episode.instruction.object_category, 0.9),)),)
    assert step > 5 and moment_before_grasp(recording, step) == step
    steps = list(recording.steps)
    steps[step - 5] = replace(steps[step - 5], detections=seen)
    recording.steps = tuple(steps)
    assert moment_before_grasp(recording, step) == step - 5


def test_without_a_recording_little_is_said_and_said_to_be_so(tmp_path: Path) -> None:
    recording = played(tmp_path / "stop.zip", stop_at_once)
    found = diagnose_result(recording.result)
    assert found is not None
    assert (found.cause, found.phase, found.is_recorded) == (Cause.NOT_RECORDED, "find object", False)
    assert found.words == recording.result.failure
