"""The thresholds of `uniteam train`: from which score on an agent should believe what the networks say."""

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from uniteam.cli.calibrate import trained_networks
from uniteam.cli.progress import counting
from uniteam.cli.terminal import shown

if TYPE_CHECKING:
    from uniteam.training.first_beliefs import Beliefs
    from uniteam.world.task.episode import Episode, Split

AGENT = "uniteam-plus"
"""The one that is told the truth, and whose way the searches go."""


def fit_thresholds(work: Path, episodes: int, camera: str, console: Console) -> None:
    """Fit the thresholds to searches in training homes for models that no network has seen; write `thresholds.json`."""
    from uniteam.training.first_beliefs import best_thresholds, write_thresholds
    from uniteam.world.task.splits import load_split

    weights = trained_networks(work)
    split = load_split("train")
    chosen = episodes_of_held_out_models(split)[:episodes]
    watched: list[Beliefs] = []
    with counting(console, "episodes", len(chosen)) as advance:
        for episode in chosen:
            watched.append(_watch(split, episode, weights, camera))
            advance()
    found = best_thresholds(watched)
    table = Table("role", "threshold", "right first", box=None, title=f"{len(chosen)} episodes")
    for role, (threshold, share) in found.items():
        table.add_row(role.name.lower(), f"{threshold:.3f}", f"{share:.2f}")
    console.print(table)
    write_thresholds(weights / "thresholds.json", found)
    console.print(f"Written: {shown(weights / 'thresholds.json')}", soft_wrap=True)


def episodes_of_held_out_models(split: "Split") -> "list[Episode]":
    """Return the episodes of a split in which an object is of a model that is kept from training."""
    from uniteam.training.namer_data import is_held_out

    def is_new(episode: "Episode") -> bool:
        model_of = {instance.name: instance.model for instance in split.homes[episode.home].instances}
        return any(is_held_out(model_of[thing.name]) for thing in episode.objects)

    return [episode for episode in split.episodes if is_new(episode)]


def _watch(split: "Split", episode: "Episode", weights: Path, camera: str) -> "Beliefs":
    from uniteam.evaluation.worker import camera_named
    from uniteam.mind.agents.registry import agent_config
    from uniteam.mind.perception.learned.learned_perception import LearnedPerception
    from uniteam.training.first_beliefs import watch_search
    from uniteam.world.task.environment import Environment

    environment = Environment(split.homes[episode.home], episode, camera_named(camera), give_truth=True)
    config = agent_config(AGENT)
    assert config is not None
    return watch_search(environment, config, LearnedPerception(weights), config.remember())
