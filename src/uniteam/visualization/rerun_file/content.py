"""A recording as a file for the viewer of Rerun: everything that it holds, along the line of its steps.

What is logged at step k is what there was once k steps had been taken: what was seen then, what was decided upon it,
and the measures so far. Nothing is drawn again, so it needs no models.
"""

from collections.abc import Callable
from itertools import chain
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.recording import Recording
from uniteam.evaluation.recording.step_line import RecordedStep
from uniteam.stretch import BASE_RADIUS, ROBOT_HEIGHT
from uniteam.visualization.captions import MILESTONES, describe_action
from uniteam.visualization.colors import ROBOT
from uniteam.visualization.rerun_file import paths
from uniteam.visualization.rerun_file.frames import Frames
from uniteam.visualization.rerun_file.layout import layout
from uniteam.visualization.rerun_file.library import load_rerun
from uniteam.visualization.rerun_file.map_layer import MapLayer
from uniteam.visualization.rerun_file.truth_layer import TruthLayer

APPLICATION = "uniteam"

_SUCCESSES = (*MILESTONES, "partial_success")
_COLLISIONS = ("robot_scene_colls", "obj_scene_colls", "robot_obj_colls")


def rerun_file(recording: Recording, advance: Callable[[], None] = lambda: None) -> bytes:
    """Return the content of a file that `rerun FILE.rrd` opens; `advance` is called after each moment.

    Raises:
        UnavailableError: rerun-sdk is not installed.
        InvalidInputError: no step was taken, so that there is nothing to show.
    """
    if not recording.steps:
        raise InvalidInputError(f"in '{recording.path}' no step was taken, so that there is nothing to show")
    rerun = load_rerun()
    with TemporaryDirectory() as folder:
        path = Path(folder) / "recording.rrd"
        _write(rerun, path, recording, advance)
        return path.read_bytes()


def _write(rerun: ModuleType, path: Path, recording: Recording, advance: Callable[[], None]) -> None:
    name = f"{recording.header.agent} {recording.episode.id}"
    stream = rerun.RecordingStream(APPLICATION, recording_id=name, send_properties=False)
    stream.set_log_time_enabled(False)  # when the file was written says nothing of the episode
    stream.set_log_tick_enabled(False)
    stream.save(str(path), default_blueprint=layout(rerun, _way(recording)))
    stream.send_recording_name(name)
    _log(rerun, stream, recording, advance)
    stream.flush()
    stream.disconnect()


def _log(rerun: ModuleType, stream: Any, recording: Recording, advance: Callable[[], None]) -> None:
    _log_episode(rerun, stream, recording)
    frames, maps = Frames(rerun, stream, recording), MapLayer(rerun, stream)
    truth, words = TruthLayer(rerun, stream, recording), _Words(rerun, stream)
    steps = chain(recording.steps, [None])
    for moment, (frame, overlay, step) in enumerate(
        zip(recording.frames(), chain(recording.maps(), [None]), steps, strict=True)
    ):
        stream.set_time(paths.TIMELINE, sequence=moment)
        base = recording.base_to_start(moment).matrix()
        stream.log(paths.ROBOT, rerun.Transform3D(translation=base[:3, 3], mat3x3=base[:3, :3]))
        frames.log(moment, frame)
        maps.log(overlay)
        truth.log(moment)
        if step is not None:
            words.decided(step)
        if moment > 0:
            words.came_of(recording.steps[moment - 1])
        advance()
    frames.finish()


def _way(recording: Recording) -> NDArray[np.float64]:
    """Return where the robot believed to be at each moment, (M, 2) (m)."""
    bases = (recording.base_to_start(moment) for moment in range(len(recording.steps) + 1))
    return np.array([(base.x, base.y) for base in bases])


def _log_episode(rerun: ModuleType, stream: Any, recording: Recording) -> None:
    """Log what does not change: the axes, the robot's size, what was asked, and the names of the measures."""
    stream.log(paths.WORLD, rerun.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    middle = [(0.0, 0.0, ROBOT_HEIGHT / 2)]
    body = rerun.Cylinders3D(
        lengths=[ROBOT_HEIGHT], radii=[BASE_RADIUS], centers=middle, colors=[ROBOT], fill_mode="solid"
    )
    stream.log(f"{paths.ROBOT}/body", body, static=True)
    ahead = rerun.Arrows3D(vectors=[(0.6, 0.0, 0.0)], origins=[(0.0, 0.0, 0.05)], colors=[ROBOT])
    stream.log(f"{paths.ROBOT}/ahead", ahead, static=True)
    for path, names in ((paths.SUCCESS, _SUCCESSES), (paths.COLLISIONS, _COLLISIONS)):
        stream.log(path, rerun.SeriesLines(names=list(names)), static=True)
    ended = recording.result.failure or "overall success"
    told = f"# {recording.episode.instruction}\n\n{recording.header.agent}, {recording.episode.id}: {ended}\n"
    stream.log(paths.EPISODE, rerun.TextDocument(told, media_type="text/markdown"), static=True)


class _Words:
    """Logs what was decided and what came of it."""

    def __init__(self, rerun: ModuleType, stream: Any) -> None:
        self._rerun, self._stream = rerun, stream
        self._state: str | None = None

    def decided(self, step: RecordedStep) -> None:
        """Log a step's decision, and its state where that is another than before."""
        decision = step.decision
        text = f"{decision.state}: {describe_action(decision.action)}. {decision.reason}"
        self._stream.log(paths.DECISIONS, self._rerun.TextLog(text, level=self._rerun.TextLogLevel.INFO))
        if decision.state != self._state:
            self._stream.log(paths.STATE, self._rerun.StateChange(state=decision.state))
        self._state = decision.state

    def came_of(self, step: RecordedStep) -> None:
        """Log the measures after a step, and what the robot ran into."""
        for path, names in ((paths.SUCCESS, _SUCCESSES), (paths.COLLISIONS, _COLLISIONS)):
            values = [float(getattr(step.measures, name)) for name in names]
            self._stream.log(path, self._rerun.Scalars(values))
        if step.events.hit:
            self._trouble(f"touched {step.events.hit}")
        if step.events.blocked:
            self._trouble("the base was blocked")

    def _trouble(self, words: str) -> None:
        self._stream.log(paths.TROUBLE, self._rerun.TextLog(words, level=self._rerun.TextLogLevel.WARN))
