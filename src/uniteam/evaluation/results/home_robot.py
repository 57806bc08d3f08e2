"""Results in the files of HomeRobot's evaluator, so that its tools read them (arXiv 2306.11565).

Each agent has a folder, as an experiment has there, with `episode_results.json` (measures by episode) and
`aggregated_results.json` (mean, least and largest of each measure over the episodes).
"""

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from statistics import fmean

from uniteam.evaluation.results.result import EpisodeResult
from uniteam.files import try_folder, write_whole

GOAL_NAME = "goal_name"
"""The one entry of an episode that is no measure: its instruction."""

Measured = dict[str, float | str]


def write_home_robot_results(folder: Path, results: Sequence[EpisodeResult], numbers: Mapping[str, int]) -> None:
    """Write an agent's two files.

    Args:
        folder: of the agent; made where it is missing.
        results: of the agent.
        numbers: by an episode's id, its place in the split, from 0; HomeRobot's episodes are numbered.

    Raises:
        UnwritableError: they cannot be written.
    """
    episodes = {f"{result.home}_{numbers[result.episode]}": measured(result) for result in results}
    try_folder(folder)
    for name, data in (("episode_results", episodes), ("aggregated_results", aggregated(list(episodes.values())))):
        write_whole(folder / f"{name}.json", (json.dumps(data, indent=4) + "\n").encode())


def measured(result: EpisodeResult) -> Measured:
    """Return an episode's measures at its end under the names that HomeRobot's evaluator writes.

    Its two measures of placing, before and after the object has lain still long enough, are both our `place_success`.
    """
    measures = result.measures
    values = {
        "ovmm_find_object_phase_success": measures.find_object_phase_success,
        "ovmm_pick_object_phase_success": measures.pick_object_phase_success,
        "ovmm_find_recep_phase_success": measures.find_recep_phase_success,
        "ovmm_place_object_phase_success": measures.place_success,
        "ovmm_place_success": measures.place_success,
        "robot_collisions.robot_scene_colls": measures.robot_scene_colls,
        "robot_collisions.robot_obj_colls": measures.robot_obj_colls,
        "robot_collisions.obj_scene_colls": measures.obj_scene_colls,
        "does_want_terminate": measures.does_want_terminate,
        "num_steps": measures.num_steps,
    }
    return {**{f"END.{name}": float(value) for name, value in values.items()}, GOAL_NAME: result.instruction}


def aggregated(episodes: Sequence[Measured]) -> dict[str, float]:
    """Return the mean, the least and the largest value of each measure, sorted by their names."""
    values: dict[str, list[float]] = {}
    for episode in episodes:
        for name, value in episode.items():
            if isinstance(value, float):
                values.setdefault(name, []).append(value)
    kinds: dict[str, Callable[[Sequence[float]], float]] = {"mean": fmean, "min": min, "max": max}
    return dict(sorted((f"{name}/total/{kind}", of(own)) for name, own in values.items() for kind, of in kinds.items()))
