"""Record an episode while it is played."""

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.episode_loop import Step
from uniteam.evaluation.recording.archive import write_archive
from uniteam.evaluation.recording.camera_films import CameraFilms
from uniteam.evaluation.recording.header import header_to_json, make_header
from uniteam.evaluation.recording.map_track import MapWriter
from uniteam.evaluation.recording.provenance import Provenance
from uniteam.evaluation.recording.robot_track import RobotTrack
from uniteam.evaluation.recording.step_line import MapLine, RecordedStep, step_to_line
from uniteam.evaluation.recording.truth_track import TruthTrack
from uniteam.evaluation.results.result import EpisodeResult, result_to_line
from uniteam.interface import MapOverlay, Observation
from uniteam.world.task.check_action import checked_action
from uniteam.world.task.encode_split import encode_split
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split


class Recorder:
    """An observer that keeps an episode, in memory until `write`.

    It is about as large there as the file will be: images are packed as they come.
    """

    def __init__(self, environment: Environment, provenance: Provenance) -> None:
        """Begin with an environment whose episode has not begun, or was reset."""
        self._environment, self._provenance = environment, provenance
        self._films = CameraFilms(environment.camera.height, environment.camera.width)
        self._robot, self._truth, self._map = RobotTrack(), TruthTrack(environment), MapWriter()
        self._lines: list[bytes] = []
        self._last: Observation | None = None
        self._truth.look()

    def __call__(self, step: Step) -> None:
        """Take a step in."""
        seen, shown = step.observation, step.explanation
        self._films.add(seen, shown.segmentation)
        self._robot.add(seen)
        self._last = step.outcome
        self._truth.look()
        decision = replace(step.decision, action=checked_action(step.decision.action))
        recorded = RecordedStep(
            step=seen.step,
            decision=decision,
            detections=None if shown.segmentation is None else shown.segmentation.detections,
            map=None if shown.overlay is None else self._place(shown.overlay),
            events=step.events,
            measures=step.measures,
            held=self._environment.simulator.held,
            resting_on=self._truth.resting_on(step.events.released),
        )
        self._lines.append(step_to_line(recorded))

    def write(self, path: Path, result: EpisodeResult) -> None:
        """Write the recording with what the episode came to; afterwards nothing can be added.

        Raises:
            UnwritableError: as the system says; what was there before is still there.
        """
        if self._last is not None:
            self._films.add(self._last, None)
            self._robot.add(self._last)
        members = {
            "recording.json": self._header(),
            "result.json": result_to_line(self._provenance.agent, result).encode(),
            **self._episode(path.parent),
            "steps.jsonl": b"".join(self._lines),
            **self._films.members(),
            **_packed("robot", self._robot.arrays()),
            **_packed("map", self._map.arrays()),
            **_packed("truth", self._truth.arrays()),
        }
        write_archive(path, members)

    def _header(self) -> bytes:
        environment = self._environment
        instances = tuple(instance.name for instance in environment.home.instances)
        objects = tuple(environment.simulator.physics.names)
        return header_to_json(make_header(self._provenance, environment.camera, len(self._lines), objects, instances))

    def _episode(self, folder: Path) -> dict[str, bytes]:
        """Return the episode with its home; nothing for a home that no file can say: the header names its split."""
        home, episode = self._environment.home, self._environment.episode
        if home.library.folder is None:
            return {}
        return {"episode.jsonl": encode_split(Split(episode.id, (episode,), {home.name: home}), folder)}

    def _place(self, overlay: MapOverlay) -> MapLine:
        rows, columns = overlay.labels.shape
        changed = self._map.add(overlay)
        goals = (len(overlay.goal), len(overlay.path))
        return MapLine(overlay.origin, overlay.cell_size, (rows, columns), changed, *goals, overlay.short_term_goal)


def _packed(folder: str, arrays: dict[str, NDArray[np.generic]]) -> dict[str, bytes]:
    """Return the arrays as members of an archive, each a file of NumPy's own format."""
    members = {}
    for name, array in arrays.items():
        content = io.BytesIO()
        np.save(content, array, allow_pickle=False)
        members[f"{folder}/{name}.npy"] = content.getvalue()
    return members
