"""What an agent's episodes come to: each of the challenge's measures with its 95 % interval."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from uniteam.evaluation.results.intervals import Estimate, estimate_mean, estimate_proportion
from uniteam.evaluation.results.result import EpisodeResult, measures_to_data
from uniteam.world.task.episode import MAXIMUM_STEPS

PROPORTIONS = (
    "find_object_phase_success",
    "pick_object_phase_success",
    "find_recep_phase_success",
    "place_success",
    "overall_success",
    "does_want_terminate",
)
"""Measures that are true or false: Wilson's interval."""

MEANS = {
    "partial_success": (0.0, 1.0),
    "robot_scene_colls": (0.0, float(MAXIMUM_STEPS)),
    "obj_scene_colls": (0.0, float(MAXIMUM_STEPS)),
    "robot_obj_colls": (0.0, float(MAXIMUM_STEPS)),
    "num_steps": (0.0, float(MAXIMUM_STEPS)),
}
"""Measures that are numbers, with the bounds that they cannot leave: Student's interval."""


@dataclass(frozen=True)
class Summary:
    """One agent's figures.

    Attributes:
        episode_count: how many episodes they are from, crashed ones included.
        crash_count: how many of them crashed.
        estimates: by the challenge's name of a measure.
    """

    episode_count: int
    crash_count: int
    estimates: Mapping[str, Estimate]

    def to_data(self) -> dict[str, Any]:
        """Return the summary as plain JSON data."""
        estimates = {name: asdict(estimate) for name, estimate in self.estimates.items()}
        return {"episode_count": self.episode_count, "crash_count": self.crash_count, **estimates}


SOURCE = ("split", "split_version", "split_digest", "perception", "camera", "grasp", "version")
"""What a run's configuration says that its figures must not be read without."""


def summarize_run(
    configuration: Mapping[str, Any], results: Mapping[str, Sequence[EpisodeResult]], episodes_asked: int
) -> dict[str, Any]:
    """Return what `summary.json` holds: each agent's figures and what they are from, whatever order it played in.

    Args:
        configuration: of the run.
        results: by agent, in the order in which they are to stand; agents without any are left out.
        episodes_asked: how many episodes the run asks for.
    """
    source = {**{name: configuration[name] for name in SOURCE}, "episodes_asked": episodes_asked}
    return {agent: {**source, **summarize(own).to_data()} for agent, own in results.items() if own}


def summarize(results: Sequence[EpisodeResult]) -> Summary:
    """Return the figures of one agent's results; at least one."""
    rows = [measures_to_data(result.measures) for result in results]
    estimates = {name: estimate_proportion(sum(bool(row[name]) for row in rows), len(rows)) for name in PROPORTIONS}
    for name, bounds in MEANS.items():
        estimates[name] = estimate_mean([float(row[name]) for row in rows], bounds)
    return Summary(len(rows), sum(result.crashed for result in results), estimates)
