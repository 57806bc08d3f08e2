"""Results under the names of HomeRobot's evaluator."""

import json
from pathlib import Path

from uniteam.evaluation.results.home_robot import write_home_robot_results
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.world.task.measures import Measures

DONE = Measures(True, True, True, True, 0, 310, True)
TOUCHED = Measures(True, True, False, False, 3, 1250, False)


def result(episode: str, measures: Measures) -> EpisodeResult:
    return EpisodeResult(episode, "kitchen_7", "Move cup from table to sink", False, measures, "DONE", "", 1.0, 300.0)


def test_episodes_and_their_means_bear_its_names(tmp_path: Path) -> None:
    numbers = {"kitchen-a": 0, "kitchen-b": 12}
    results = [result("kitchen-a", DONE), result("kitchen-b", TOUCHED)]
    write_home_robot_results(tmp_path / "uniteam", results, numbers)
    episodes = json.loads((tmp_path / "uniteam" / "episode_results.json").read_text())
    assert list(episodes) == ["kitchen_7_0", "kitchen_7_12"]
    assert [int(name.split("_")[-1]) for name in episodes] == [0, 12]  # as its summary reads the number of an episode
    assert episodes["kitchen_7_12"]["END.robot_collisions.robot_scene_colls"] == 3.0
    assert episodes["kitchen_7_0"]["goal_name"] == "Move cup from table to sink"
    needed = ("find_object_phase_success", "pick_object_phase_success", "find_recep_phase_success", "place_success")
    assert [episodes["kitchen_7_12"][f"END.ovmm_{name}"] for name in needed] == [1.0, 1.0, 0.0, 0.0]
    means = json.loads((tmp_path / "uniteam" / "aggregated_results.json").read_text())
    assert list(means) == sorted(means)
    steps = [means[f"END.num_steps/total/{kind}"] for kind in ("mean", "min", "max")]
    assert steps == [780.0, 310.0, 1250.0]
    assert not any("goal_name" in name for name in means)
