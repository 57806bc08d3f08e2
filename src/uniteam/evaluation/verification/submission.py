"""A folder of results that somebody hands in, opened together with the split that it was played on."""

import logging
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.recording.actions_kept import has_actions
from uniteam.evaluation.results.differences import differences
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.run_folder import RunFolder, read_run
from uniteam.evaluation.worker import camera_named
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.measures import Measures
from uniteam.world.task.splits import load_split

MUST_AGREE = ("split", "split_version", "split_digest", "homes_digest", "models_digest")
"""What of a configuration decides which episodes were played."""

MAY_DIFFER = ("version", "code", "software")
"""What of a configuration can change what comes of an action, and need not."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Claim:
    """What an episode is said to have come to.

    Attributes:
        agent: the agent's label in the run.
        episode: what was played.
        result: what it is said to have come to.
    """

    agent: str
    episode: Episode
    result: EpisodeResult


@dataclass(frozen=True)
class Submission:
    """Results that can be checked.

    Attributes:
        run: the folder.
        split: whose episodes were played.
        claims: an agent's turn at an episode each, crashed ones left out: they claim nothing.
    """

    run: RunFolder
    split: Split
    claims: tuple[Claim, ...]

    def sample(self, count: int, seed: int) -> list[Claim]:
        """Return some claims, drawn at random, or all where there are no more; those in one home stand together."""
        drawn = Random(seed).sample(self.claims, min(count, len(self.claims)))
        return sorted(drawn, key=lambda claim: (claim.episode.home, claim.episode.id, claim.agent))


def open_submission(folder: Path, split: str | None = None) -> Submission:
    """Read a folder of results, and check all that can be checked without playing anything.

    Args:
        folder: of a run, with recordings of all its episodes.
        split: the split that was played, for a run of a file of episodes or of "ovmm:FOLDER"; None for the built-in
            split that the run names.

    Raises:
        InvalidInputError: it is no run, was played on other episodes than those of the split, holds no result, or
            lacks recordings.
        DamagedFileError: a file cannot be read, or a result contradicts its episode.
        UnknownNameError: there is no such split, camera or grasp rule.
    """
    run = read_run(folder)
    name = str(run.configuration.get("split", "")) if split is None else split
    opened = load_split(name)
    _check_configuration(run, name, opened)
    episodes = {episode.id: episode for episode in opened.episodes}
    claims = tuple(
        _claim(folder, agent, result, episodes) for agent, own in run.results.items() for result in own.values()
    )
    if not claims:
        raise InvalidInputError(f"'{folder}' holds no result; play something into it with 'uniteam evaluate'")
    played = tuple(claim for claim in claims if not claim.result.crashed)
    _check_recorded(folder, played)
    return Submission(run, opened, played)


def _check_configuration(run: RunFolder, split: str, opened: Split) -> None:
    told = run.configuration
    camera, grasp = str(told.get("camera", "")), str(told.get("grasp", ""))
    camera_named(camera)
    grasp_rule_named(grasp)
    now = resolve(Run(split, {}, str(told.get("perception", "")), camera, grasp), opened)
    found = differences(_some(told, MUST_AGREE), _some(now, MUST_AGREE))
    if found:
        raise InvalidInputError(
            f"'{run.directory}' was not played on the episodes that are here ({'; '.join(found)}); check it with the "
            "uniteam that played it, or name the file of its episodes with --split"
        )
    other = differences(_some(told, MAY_DIFFER), _some(now, MAY_DIFFER))
    if other:
        _log.warning("%s was played by other software, which can be why a measure differs: %s", run.directory, other[0])


def _some(configuration: Mapping[str, Any], names: tuple[str, ...]) -> dict[str, Any]:
    return {name: configuration.get(name, "nothing") for name in names}


def _claim(folder: Path, agent: str, result: EpisodeResult, episodes: Mapping[str, Episode]) -> Claim:
    """Return what a result claims; raises DamagedFileError where it is no result of its episode."""
    episode = episodes.get(result.episode)
    if episode is None:
        raise DamagedFileError(f"'{folder}' has a result of episode '{result.episode}', which the split has not")
    said = {"home": result.home, "instruction": result.instruction, "unseen": result.unseen}
    true = {"home": episode.home, "instruction": str(episode.instruction), "unseen": episode.unseen}
    found = differences(said, true)
    if result.crashed:
        crashed = Measures(num_steps=result.measures.num_steps)
        found += [] if result.measures == crashed else ["it crashed, and has measures of one that did not"]
    if found:
        raise DamagedFileError(
            f"'{folder}' has a result of {agent}'s '{episode.id}' that cannot be: {'; '.join(found)}"
        )
    return Claim(agent, episode, result)


def _check_recorded(folder: Path, claims: tuple[Claim, ...]) -> None:
    without = [claim for claim in claims if not has_actions(folder, claim.agent, claim.episode.id)]
    if without:
        first = without[0]
        raise InvalidInputError(
            f"'{folder}' has no recording of {len(without)} of its {len(claims)} results, such as {first.agent}'s "
            f"'{first.episode.id}', so that they cannot be checked; play them with 'uniteam evaluate --record actions'"
        )
