"""A folder of results with recorded actions, as somebody hands it in."""

import json
from collections.abc import Callable
from pathlib import Path

from worlds.recorded import Reciter

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_loop import play_episode
from uniteam.evaluation.recording.order import ACTIONS_ALONE, EVERYTHING, RECORDINGS, recording_path
from uniteam.evaluation.recording.provenance import provenance_of
from uniteam.evaluation.results.result import result_to_line
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split

AGENT = "random"
SCRIPT: tuple[Action, ...] = (
    *(DiscreteAction.MOVE_FORWARD,) * 4,
    DiscreteAction.TURN_LEFT,
    BaseDisplacement(0.1, 0.0, 1.0 / 3.0),
    JointDisplacement(Joints(lift=0.1, arm=0.01, head_pan=0.3), BaseDisplacement(0.0, 0.0, -0.1)),
    *(DiscreteAction.MOVE_FORWARD,) * 4,
)


def write_submission(folder: Path) -> Path:
    """Play two episodes of minival by a script, the second recorded in full, and return the folder of the run."""
    split, spec = load_split("minival"), AgentSpec(AGENT, "truth")
    configuration = resolve(Run("minival", {AGENT: spec}, "truth", "half"), split)
    lines = []
    for episode, kind in ((split.episodes[0], ACTIONS_ALONE), (split.episodes[5], EVERYTHING)):
        environment = Environment(split.homes[episode.home], episode)
        recorder = kind.begin(environment, provenance_of(AGENT, spec, "minival", configuration))
        result = play_episode(environment, Reciter(SCRIPT), recorder)
        recorder.write(recording_path(folder / RECORDINGS, AGENT, episode.id, kind.suffix), result)
        lines.append(result_to_line(AGENT, result))
    (folder / "config.json").write_text(json.dumps(configuration))
    (folder / "results.jsonl").write_text("".join(lines))
    return folder


def alter(path: Path, change: Callable[[str], str]) -> None:
    """Write a text file anew; it must differ afterwards."""
    before = path.read_text()
    assert change(before) != before
    path.write_text(change(before))
