"""Generate the splits that ship with the package; run once, when models or homes have changed.

    python tools/build_splits.py WORK_DIRECTORY [SPLIT ...]

Every home's episodes are kept in the work directory, so that the command goes on where it was interrupted.
"""

import sys
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from uniteam.world.assets.model import Pool
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.generation.generate import generate_home
from uniteam.world.homes.home import Home
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import SPLIT_DIRECTORY, SUFFIX, load_split, write_split


@dataclass(frozen=True)
class Plan:
    """What a split holds: homes from a first seed on, so many of them, so many episodes in each."""

    pool: Pool
    first_seed: int
    home_count: int
    per_home: int


PLANS = {
    "minival": Plan("test", 1_000, 5, 2),
    "val": Plan("test", 2_000, 40, 10),
    "test-standard": Plan("test", 3_000, 50, 20),
    "test-challenge": Plan("test", 4_000, 25, 10),
    "train": Plan("train", 5_000, 40, 5),
}


def build(name: str, work: Path) -> None:
    """Generate a split home by home and write it into the package."""
    plan = PLANS[name]
    tally, homes, episodes = Tally(), dict[str, Home](), list[Episode]()
    for seed in count(plan.first_seed):
        part = _part(name, seed, work, tally)
        if len(part.episodes) == plan.per_home:
            homes.update(part.homes)
            episodes += part.episodes
            for episode in part.episodes:
                tally.add(episode.instruction, episode.unseen)
        print(
            f"{name}: seed {seed}, {len(part.episodes)} episodes, {len(homes)} homes of {plan.home_count}", flush=True
        )
        if len(homes) == plan.home_count:
            break
    write_split(Split(name, tuple(episodes), homes), SPLIT_DIRECTORY / f"{name}{SUFFIX}")
    print(f"{name}: {len(episodes)} episodes, {tally.unseen} unseen\n goals {tally.goals}\n objects {tally.objects}")


def _part(name: str, seed: int, work: Path, tally: Tally) -> Split:
    """Return the episodes of one home, made now or before; an empty file marks a home that offers too few."""
    plan = PLANS[name]
    path = work / f"{name}-{seed}{SUFFIX}"
    if not path.exists():
        home = generate_home(seed, plan.pool)
        made = tuple(EpisodeMaker(home, tally.copy()).episodes(plan.per_home))
        if len(made) < plan.per_home:
            path.touch()
        else:
            write_split(Split(name, made, {home.name: home}), path)
    return load_split(path) if path.stat().st_size else Split(name, (), {})


def main() -> None:
    """Build the splits named on the command line, or all."""
    work, names = Path(sys.argv[1]), sys.argv[2:] or list(PLANS)
    work.mkdir(parents=True, exist_ok=True)
    SPLIT_DIRECTORY.mkdir(exist_ok=True)
    for name in names:
        build(name, work)


if __name__ == "__main__":
    main()
