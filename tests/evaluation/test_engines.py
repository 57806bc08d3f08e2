"""A run on a Ray cluster of two nodes, of which one is killed: what one process would have written."""

import json
import threading
from pathlib import Path

import pytest

from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.engines import on_ray
from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.recording.order import ACTION_SUFFIX
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split

ray = pytest.importorskip("ray", reason="Ray is not installed (extra `ray`)")

EPISODES = 4
MEASURED_ANEW = ("seconds", "peak_memory")
"""Of a line, what no second run has the same."""


def ignore(*outcome: object) -> None:
    """Hear of a result or a loss and do nothing."""


def lines_of(folder: Path) -> list[str]:
    """Return the lines of the results in the order of their episodes, without what was measured of the machine."""
    rows = [json.loads(line) for line in (folder / "results.jsonl").read_text().splitlines()]
    return sorted(json.dumps({name: row[name] for name in row if name not in MEASURED_ANEW}) for row in rows)


def recordings_of(folder: Path) -> dict[str, bytes]:
    root = folder / "recordings"
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in root.rglob("*") if path.is_file()}


@pytest.mark.slow
def test_a_cluster_that_loses_a_node_gives_what_one_process_gives(tmp_path: Path) -> None:
    from ray.cluster_utils import Cluster

    minival = load_split("minival")
    chosen = [minival.episodes[k] for k in choose_episodes(minival.episodes, EPISODES)]
    homes = {episode.home: minival.homes[episode.home] for episode in chosen}
    assert len(homes) == EPISODES  # a task each
    write_split(Split("four", tuple(chosen), homes), tmp_path / "four.jsonl.gz")
    run = Run(str(tmp_path / "four.jsonl.gz"), label_agents(("random",), "truth"), "truth", "half")

    with Evaluation(run, tmp_path / "one") as evaluation:
        evaluation.play(1, ignore, ignore, record="actions")
        evaluation.write_summary()

    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    node = cluster.add_node(num_cpus=1)
    lost: list[object] = []
    killed = threading.Event()
    try:
        cluster.wait_for_nodes()
        ray.init(address=cluster.address, log_to_driver=False)

        def kill_once(agent: str, result: EpisodeResult) -> None:
            if not killed.is_set():
                killed.set()
                assert len(evaluation.remaining) == EPISODES - 1
                cluster.remove_node(node, allow_graceful=False)

        with Evaluation(run, tmp_path / "two") as evaluation:
            evaluation.play(EPISODES, kill_once, lambda *outcome: lost.append(outcome), record="actions", engine=on_ray)
            evaluation.write_summary()
        assert sum(told["Alive"] for told in ray.nodes()) == 1
    finally:
        ray.shutdown()
        cluster.shutdown()

    assert killed.is_set()
    assert lost == []
    assert (tmp_path / "two" / "summary.json").read_bytes() == (tmp_path / "one" / "summary.json").read_bytes()
    assert lines_of(tmp_path / "two") == lines_of(tmp_path / "one")
    assert recordings_of(tmp_path / "two") == recordings_of(tmp_path / "one")
    assert [name.endswith(ACTION_SUFFIX) for name in recordings_of(tmp_path / "one")] == [True] * EPISODES
