"""A file for Rerun: its own checker takes it, and what is read back from it is what the recording holds."""

import os
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.filled import filled
from worlds.recorded import Brief, record

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.visualization.colors import MAP_COLORS
from uniteam.visualization.rerun_file import paths
from uniteam.visualization.rerun_file.content import rerun_file
from uniteam.world.simulation.step_events import StepEvents

pytest.importorskip("rerun", reason="the extra 'rerun' is not installed")

STEPS, BLOCKED = 8, 3


class Read:
    """A file as Rerun's own reader has it: of each entity, what was logged at which step."""

    def __init__(self, path: Path) -> None:
        from rerun.chunk import RrdReader

        reader = RrdReader(path)
        self.recordings, self.blueprints = reader.recordings(), reader.blueprints()
        self._rows: dict[str, list[dict[str, Any]]] = {}
        for chunk in reader.stream():
            self._rows.setdefault(chunk.entity_path, []).extend(chunk.to_record_batch().to_pylist())

    def at(self, path: str) -> dict[int, dict[str, Any]]:
        """Return what was logged of an entity by step; what was logged once for all is at -1."""
        found: dict[int, dict[str, Any]] = {}
        for row in self._rows[f"/{path}"]:
            found.setdefault(row.get("step", -1), {}).update({name: x for name, x in row.items() if x is not None})
        return found


def points(row: dict[str, Any]) -> NDArray[np.float64]:
    return np.array(row["Points3D:positions"]).reshape(-1, 3)


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    spec = AgentSpec("uniteam-plus", "truth")
    played = record(tmp_path_factory.mktemp("recording") / "episode.zip", Brief(spec.make(None), STEPS), spec)
    return with_incidents(read_recording(played.path))


def with_incidents(recording: Recording) -> Recording:
    """Return a recording in which each step touched something, and one was blocked."""
    recording.steps = tuple(
        replace(
            step,
            measures=replace(step.measures, robot_scene_colls=step.step),
            events=StepEvents(blocked=step.step == BLOCKED),
        )
        for step in recording.steps
    )
    return recording


@pytest.fixture(scope="module")
def file(recording: Recording, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("rerun") / "episode.rrd"
    path.write_bytes(rerun_file(recording))
    return path


@pytest.fixture(scope="module")
def read(file: Path) -> Read:
    return Read(file)


def test_reruns_own_checker_takes_it(file: Path) -> None:
    quiet = {**os.environ, "RERUN_ANALYTICS": "0"}
    checked = subprocess.run(
        [sys.executable, "-m", "rerun", "rrd", "verify", str(file)], capture_output=True, text=True, env=quiet
    )
    assert checked.returncode == 0, checked.stderr
    assert "1 file verified without error" in checked.stdout + checked.stderr


def test_it_is_one_recording_with_a_layout(read: Read, recording: Recording) -> None:
    (found,) = read.recordings
    assert found.recording_id == f"uniteam-plus {recording.episode.id}"
    assert len(read.blueprints) == 1
    (told,) = read.at(paths.EPISODE)[-1]["TextDocument:text"]
    assert str(recording.episode.instruction) in told


def test_the_pictures_are_those_of_the_recording(read: Read, recording: Recording) -> None:
    colour, depth, labels = (read.at(path) for path in (paths.COLOUR, paths.DEPTH, paths.SEGMENTATION))
    (context,) = read.at(paths.CAMERA)[-1]["AnnotationContext:context"]
    names = {one["class_id"]: one["class_description"]["info"]["label"] for one in context}
    assert set(colour) == set(depth) - {-1} == set(range(STEPS + 2))
    for moment, frame in filled(enumerate(recording.frames())):
        jpeg = np.array(colour[moment]["EncodedImage:blob"][0], np.uint8)
        shown = np.asarray(cv2.imdecode(jpeg, cv2.IMREAD_COLOR))[..., ::-1]
        assert np.abs(shown.astype(int) - frame.rgb).mean() < 3.0
        png = np.array(depth[moment]["EncodedDepthImage:blob"][0], np.uint8)
        metres = np.asarray(cv2.imdecode(png, cv2.IMREAD_UNCHANGED)) / depth[moment]["EncodedDepthImage:meter"][0]
        assert np.abs(metres - frame.depth).max() <= 0.0005 + 1e-6
        if frame.segmentation is not None:
            classes = np.frombuffer(bytes(labels[moment]["SegmentationImage:buffer"][0]), np.uint16)
            known = ["nothing", *(d.name for d in frame.segmentation.detections)]
            expected = [known[index + 1] for index in frame.segmentation.instances.ravel().tolist()]
            assert [names[number] for number in classes.tolist()] == expected
    assert STEPS + 1 not in labels


def test_a_pixel_of_depth_lies_where_the_camera_saw_it(read: Read, recording: Recording) -> None:
    """The middle of a pixel is half a pixel from its corner in Rerun, and depth has every second pixel."""
    camera = recording.header.camera
    for path, stride in ((paths.CAMERA, 1), (paths.DEPTH, 2)):
        matrix = np.array(read.at(path)[-1]["Pinhole:image_from_camera"][0]).reshape(3, 3).T
        u, v = camera.project(np.array([0.3, -0.2, 2.0]))
        found = matrix @ [0.15, -0.1, 1.0]
        assert found[:2] == pytest.approx([u / stride + 0.5, v / stride + 0.5], abs=1e-3)


def test_the_robot_and_its_camera_are_where_it_believed(read: Read, recording: Recording) -> None:
    robot, head = read.at(paths.ROBOT), read.at(paths.HEAD)
    for moment in range(STEPS + 2):
        base, camera = recording.base_to_start(moment), recording.camera_to_start(moment)
        assert robot[moment]["Transform3D:translation"][0] == pytest.approx([base.x, base.y, 0.0], abs=1e-6)
        assert head[moment]["Transform3D:translation"][0] == pytest.approx(camera[:3, 3], abs=1e-5)
        turned = np.array(head[moment]["Transform3D:mat3x3"][0]).reshape(3, 3).T  # column after column
        assert np.allclose(turned, camera[:3, :3], atol=1e-6)


def test_the_map_lies_in_the_scene_with_its_colours(read: Read, recording: Recording) -> None:
    grids, overlays = read.at(paths.MAP), list(recording.maps())
    last = max(grids)
    overlay, grid = overlays[last], grids[last]
    assert overlay is not None
    size = grid["GridMap:format"][0]
    picture = np.frombuffer(bytes(grid["GridMap:data"][0]), np.uint8).reshape(size["height"], size["width"], 4)
    assert grid["GridMap:translation"][0][:2] == pytest.approx(overlay.origin)
    known = overlay.labels > 0
    assert known.any()
    rows, columns = np.nonzero(known)
    assert picture[::-1][rows[0], columns[0]].tolist() == [*MAP_COLORS[overlay.labels[rows[0], columns[0]]], 255]
    assert np.array_equal(picture[::-1, :, 3] > 0, known)
    assert points(read.at(paths.GOAL)[last])[:, :2] == pytest.approx(overlay.goal, abs=1e-5)


def test_the_truth_is_in_the_frame_of_what_was_believed(read: Read, recording: Recording) -> None:
    start, believed = recording.base_to_world(0), recording.base_to_start(0)
    for moment in range(STEPS + 2):
        base = recording.base_to_world(moment)
        there = believed.compose(start.inverse()).compose(base)
        assert points(read.at(paths.TRUE_BASE)[moment])[0] == pytest.approx([there.x, there.y, 0.0], abs=1e-4)
    lay = points(read.at(paths.TRUE_OBJECTS)[0])
    assert len(lay) == len(recording.episode.objects)
    assert read.at(paths.TRUE_GOALS)[-1]["Points3D:labels"] == [g.name for g in recording.episode.goal_receptacles]


def test_decisions_and_measures_stand_at_their_steps(read: Read, recording: Recording) -> None:
    decisions, states = read.at(paths.DECISIONS), read.at(paths.STATE)
    success, collisions = read.at(paths.SUCCESS), read.at(paths.COLLISIONS)
    for step in filled(recording.steps):
        (text,) = decisions[step.step]["TextLog:text"]
        assert text.startswith(f"{step.decision.state}: ")
        assert text.endswith(step.decision.reason)
        after = success[step.step + 1]["Scalars:scalars"]
        assert after[0] == float(step.measures.find_object_phase_success)
        assert after[-1] == step.measures.partial_success
        assert collisions[step.step + 1]["Scalars:scalars"][0] == step.measures.robot_scene_colls
    assert read.at(paths.TROUBLE)[BLOCKED + 1]["TextLog:text"] == ["the base was blocked"]
    shown = [states[step]["StateChange:state"][0] for step in sorted(states)]
    assert shown[0] == recording.steps[0].decision.state
    assert all(one != other for one, other in pairwise(shown))
    assert shown[-1] == "DONE"


def test_a_recording_without_a_step_is_refused(recording: Recording) -> None:
    empty = read_recording(recording.path)
    empty.steps = ()
    with pytest.raises(InvalidInputError, match="no step was taken"):
        rerun_file(empty)
