"""Generate the splits that ship with the package; run when models, homes or rules have changed.

    python tools/build_splits.py WORK_DIRECTORY [SPLIT ...] [--homes N]

Half of a split's homes are tidy, half are lived in; half of the episodes of each style ask for an unseen category,
where the split has any. Every home's episodes are kept in the work directory, in a folder of their own for each state
of the code and of the models, so that the command goes on where it was interrupted and never mixes what different
states have made. `--homes` makes so many homes only, and writes the split into the work directory: to try, and to
see how long it takes.
"""

import argparse
import json
import time
from dataclasses import dataclass, field
from hashlib import sha256
from itertools import chain, count, zip_longest
from pathlib import Path

import uniteam
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.model import Pool
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.certification.rejection import Cause, Proposals
from uniteam.world.generation.generate import generate_home
from uniteam.world.generation.style import STYLES
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import SPLIT_DIRECTORY, SUFFIX, load_split, write_split

VERSION = 2
"""Of the splits; grows whenever they are built anew for a release."""


@dataclass(frozen=True)
class Plan:
    """What a split holds: homes of each style from a first seed on, so many of them, so many episodes in each."""

    pool: Pool
    first_seed: int
    homes: int
    per_home: int


PLANS = {
    "minival": Plan("test", 1_000, 10, 1),
    "val": Plan("test", 2_000, 40, 10),
    "test-standard": Plan("test", 3_000, 50, 20),
    "test-challenge": Plan("test", 4_000, 25, 10),
    "train": Plan("train", 5_000, 80, 5),
}


@dataclass
class Half:
    """The homes of one style made so far, each with its episodes."""

    style: str
    parts: list[Split] = field(default_factory=list)
    tally: Tally = field(default_factory=Tally)
    proposals: Proposals = field(default_factory=Proposals)


def build(name: str, work: Path, homes: int, folder: Path) -> None:
    """Generate a split of so many homes, home by home, and write it into a folder."""
    halves = [Half(style) for style in STYLES]
    for number, half in enumerate(halves):
        fill(half, name, work, (homes + 1 - number) // 2)
    split = together(name, halves)
    write_split(split, folder / f"{name}{SUFFIX}")
    unseen = sum(episode.unseen for episode in split.episodes)
    print(f"{name}: {len(split.episodes)} episodes in {len(split.homes)} homes, {unseen} unseen, in {folder}")
    for half in halves:
        print(f" {half.style}: goals {dict(half.tally.goals)}")
        print("\n".join(f"  {line}" for line in half.proposals.lines()), flush=True)


def fill(half: Half, name: str, work: Path, wanted: int) -> None:
    """Add homes of a style until there are as many as wanted; a home that offers too few episodes is left out."""
    plan = PLANS[name]
    for seed in count(plan.first_seed):
        begun = time.monotonic()
        part = made(half, name, seed, work)
        if len(part.episodes) == plan.per_home:
            half.parts.append(part)
            for episode in part.episodes:
                half.tally.add(episode.instruction, episode.unseen)
        print(
            f"{name}, {half.style}: seed {seed}, {len(part.episodes)} episodes, {len(half.parts)} homes of {wanted}, "
            f"{time.monotonic() - begun:.0f} s",
            flush=True,
        )
        if len(half.parts) == wanted:
            return


def made(half: Half, name: str, seed: int, work: Path) -> Split:
    """Return the episodes of one home, made now or before, and count what was rejected for them."""
    plan = PLANS[name]
    path = work / f"{name}-{half.style}-{seed}{SUFFIX}"
    notes = path.with_name(f"{name}-{half.style}-{seed}.json")
    if not notes.exists():
        home = generate_home(seed, plan.pool, STYLES[half.style])
        maker = EpisodeMaker(home, half.tally.copy(), half.style)
        episodes = tuple(maker.episodes(plan.per_home))
        if episodes:
            write_split(Split(name, episodes, {home.name: home}), path)
        rejected = {cause.name: number for cause, number in maker.proposals.rejected.items()}
        notes.write_text(json.dumps({"certified": maker.proposals.certified, "rejected": rejected}))
    counts = json.loads(notes.read_text())
    half.proposals.certified += counts["certified"]
    half.proposals.rejected.update({Cause[cause]: number for cause, number in counts["rejected"].items()})
    return load_split(path) if path.exists() else Split(name, (), {})


def together(name: str, halves: list[Half]) -> Split:
    """Return the split: homes of the two styles in turn."""
    in_turn = chain.from_iterable(zip_longest(*(half.parts for half in halves)))
    parts = [part for part in in_turn if part is not None]
    episodes = tuple(episode for part in parts for episode in part.episodes)
    return Split(name, episodes, {key: home for part in parts for key, home in part.homes.items()}, VERSION)


def state() -> str:
    """Return a digest of what decides which episodes are made: the code of the world, and the models."""
    together = sha256(load_catalogue().digest.encode())
    root = Path(uniteam.__file__).parent
    for path in sorted((*(root / "world").rglob("*.py"), *root.glob("*.py"))):
        together.update(path.read_bytes())
    return together.hexdigest()[:12]


def main() -> None:
    """Build the splits named on the command line, or all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("splits", nargs="*", metavar="SPLIT", help=" ".join(PLANS))
    parser.add_argument("--homes", type=int, help="so many only, and into the work directory")
    arguments = parser.parse_args()
    work = arguments.work / state()
    work.mkdir(parents=True, exist_ok=True)
    SPLIT_DIRECTORY.mkdir(exist_ok=True)
    for name in arguments.splits or PLANS:
        trial = arguments.homes is not None
        build(name, work, arguments.homes if trial else PLANS[name].homes, work if trial else SPLIT_DIRECTORY)


if __name__ == "__main__":
    main()
