"""A recording holds what was seen, decided and true, and plays it again to the bit."""

import json
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from worlds.filled import filled
from worlds.recorded import Brief, Played, Reciter, record

from uniteam.errors import DamagedFileError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.body import OtherActionError, OtherFrameError, RecordedBody
from uniteam.evaluation.recording.depth_code import RELATIVE_ERROR, STRIDE
from uniteam.evaluation.recording.header import NewerFormatError
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.evaluation.recording.replay import first_difference
from uniteam.interface import DiscreteAction, Observation
from uniteam.testing.body import SCRIPT, check_body

PLUS = AgentSpec("uniteam-plus", "truth")
STEPS = 30


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Played:
    """The first steps of uniteam-plus, and a stop."""
    return record(tmp_path_factory.mktemp("recordings") / "brief.zip", Brief(PLUS.make(None), STEPS), PLUS)


@pytest.fixture(scope="module")
def recording(played: Played) -> Recording:
    return read_recording(played.path)


def rewritten(path: Path, to: Path, **changed: bytes | None) -> Path:
    """Return a copy of a recording in which members, named by the last part of their names, differ or are missing."""
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(to, "w") as new:
        for name in old.namelist():
            content = changed.get(Path(name).stem, old.read(name))
            if content is not None:
                new.writestr(name, content)
    return to


def test_it_says_what_was_asked_decided_and_achieved(played: Played, recording: Recording) -> None:
    assert recording.episode == played.environment.episode
    assert recording.home.instances == played.environment.home.instances
    assert recording.result == played.result
    assert recording.header.spec == PLUS
    assert [step.decision for step in recording.steps] == [step.decision for step in played.steps]
    assert [step.events for step in recording.steps] == [step.events for step in played.steps]
    assert [step.measures for step in recording.steps] == [step.measures for step in played.steps]


def test_what_perception_answered_comes_back_exactly_colour_and_depth_nearly(
    played: Played, recording: Recording
) -> None:
    frames = list(recording.frames())
    assert len(frames) == len(played.steps) + 1
    for frame, step in filled(zip(frames[:-1], played.steps, strict=True)):
        answered, depth = step.explanation.segmentation, step.observation.depth[::STRIDE, ::STRIDE]
        assert frame.segmentation is not None and answered is not None
        assert np.array_equal(frame.segmentation.instances, answered.instances)
        assert [d.candidates for d in frame.segmentation.detections] == [d.candidates for d in answered.detections]
        assert np.array_equal(frame.depth == 0.0, depth == 0.0)
        assert np.allclose(frame.depth, np.maximum(depth, 0.1 * (depth > 0)), rtol=RELATIVE_ERROR, atol=0.0)
        assert np.abs(frame.rgb.astype(float) - step.observation.rgb).mean() < 8.0
    assert frames[-1].segmentation is None


def test_maps_come_back_exactly_and_their_points_to_a_millimetre(played: Played, recording: Recording) -> None:
    for shown, step in filled(zip(recording.maps(), played.steps, strict=True)):
        overlay = step.explanation.overlay
        assert shown is not None and overlay is not None
        assert np.array_equal(shown.labels, overlay.labels)
        assert (shown.origin, shown.cell_size) == (overlay.origin, overlay.cell_size)
        assert np.allclose(shown.goal, overlay.goal, atol=1e-3) and np.allclose(shown.path, overlay.path, atol=1e-3)
        assert shown.short_term_goal == overlay.short_term_goal


def test_it_holds_the_truth_at_every_moment(played: Played, recording: Recording) -> None:
    environment = played.environment
    observation = environment.reset()
    names = [instance.name for instance in environment.home.instances]
    for moment, step in filled(enumerate(played.steps)):
        simulator = environment.simulator
        assert recording.base_to_world(moment) == simulator.base
        assert recording.base_to_start(moment) == observation.base_to_start
        poses = recording.objects.at(moment)
        assert all(np.array_equal(poses[name], simulator.object_pose(name)) for name in filled(simulator.physics.names))
        frame = simulator.render().instances
        seen = {name: int(np.count_nonzero(frame == k)) for k, name in enumerate(names) if k in frame}
        assert {n: int(p) for n in names if (p := recording.visible_pixels(n)[moment])} == seen
        observation = environment.step(step.decision.action)


def test_the_agent_decides_the_same_upon_it_and_another_is_told_by_its_first_step(recording: Recording) -> None:
    body = RecordedBody(recording)
    assert first_difference(recording, Brief(PLUS.make(None), STEPS), body) is None
    other = replace(PLUS, removed=("long_strides",))
    difference = first_difference(recording, Brief(other.make(None), STEPS), body)
    assert difference is not None
    assert difference.recorded == recording.steps[difference.step].decision
    assert str(difference).startswith(f"step {difference.step} was BaseDisplacement(")
    with pytest.raises(OtherActionError, match="step 0 was recorded with"):
        body.reset()
        body.step(DiscreteAction.SNAP_OBJECT)


def test_its_body_keeps_what_bodies_promise_with_the_arm_out_too(tmp_path: Path) -> None:
    script = record(tmp_path / "script.zip", Reciter(SCRIPT), AgentSpec("random", "truth"))
    check_body(lambda: RecordedBody(read_recording(script.path)))
    body = RecordedBody(read_recording(script.path))
    seen: list[Observation] = [body.reset()]
    seen += [body.step(step.decision.action) for step in script.steps]
    for again, once in filled(
        zip(seen, [*(s.observation for s in script.steps), script.steps[-1].outcome], strict=True)
    ):
        assert np.array_equal(again.rgb, once.rgb) and np.array_equal(again.depth, once.depth)
        assert again.truth is not None and once.truth is not None
        assert np.array_equal(again.truth.instances, once.truth.instances)
        assert np.array_equal(again.camera_to_start, once.camera_to_start)
        assert (again.joints, again.is_holding, again.step) == (once.joints, once.is_holding, once.step)


def test_pixels_that_are_not_those_that_were_seen_are_told(played: Played, tmp_path: Path) -> None:
    with zipfile.ZipFile(played.path) as archive:
        checksums = archive.read("robot/checksums.npy")
    other = rewritten(played.path, tmp_path / "other.zip", checksums=checksums[:-1] + bytes([checksums[-1] ^ 1]))
    body = RecordedBody(read_recording(other))
    body.reset()
    with pytest.raises(OtherFrameError, match=f"at step {len(played.steps)} the camera draws other pixels"):
        for step in played.steps:
            body.step(step.decision.action)


def test_a_damaged_or_newer_file_is_one_sentence(played: Played, tmp_path: Path) -> None:
    header = json.loads(zipfile.ZipFile(played.path).read("recording.json"))
    newer = rewritten(played.path, tmp_path / "a.zip", recording=json.dumps({**header, "format_version": 2}).encode())
    with pytest.raises(NewerFormatError, match="version 2 of the format"):
        read_recording(newer)
    (tmp_path / "half.zip").write_bytes(played.path.read_bytes()[:20_000])
    damages = {
        rewritten(played.path, tmp_path / "b.zip", steps=b""): "its steps are not those",
        rewritten(played.path, tmp_path / "c.zip", joints=None): "robot/joints.npy is missing",
        rewritten(played.path, tmp_path / "d.zip", base_to_world=b"no array"): "cannot be read",
        rewritten(played.path, tmp_path / "e.zip", recording=b"[]"): "does not say that it is a recording",
        tmp_path / "half.zip": "cannot be read",
        tmp_path / "none.zip": "No such file",
    }
    for path, sentence in damages.items():
        with pytest.raises(DamagedFileError, match=sentence):
            read_recording(path)
    film = rewritten(played.path, tmp_path / "f.zip", colour=b"no film")
    with pytest.raises(DamagedFileError, match="film"):
        list(read_recording(film).frames())


def test_the_same_episode_gives_the_same_bytes_but_for_its_seconds(played: Played, tmp_path: Path) -> None:
    again = record(tmp_path / "again.zip", Brief(PLUS.make(None), STEPS), PLUS)
    with zipfile.ZipFile(played.path) as one, zipfile.ZipFile(again.path) as other:
        differing = [name for name in one.namelist() if one.read(name) != other.read(name)]
        assert one.namelist() == other.namelist()
    assert differing == ["result.json"]


@pytest.mark.slow
def test_every_decision_of_a_whole_episode_is_the_same_upon_its_recording(tmp_path: Path) -> None:
    whole = record(tmp_path / "whole.zip", PLUS.make(None), PLUS)
    assert whole.result.measures.overall_success
    assert whole.path.stat().st_size < 5e6
    recording = read_recording(whole.path)
    assert first_difference(recording, PLUS.make(None), RecordedBody(recording)) is None
    difference = first_difference(
        recording, replace(PLUS, removed=("edge_margin",)).make(None), RecordedBody(recording)
    )
    assert difference is not None and difference.step > 50
