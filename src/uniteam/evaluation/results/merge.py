"""Make one run of the shards of a run: the same folder that one process would have written."""

import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.differences import differences
from uniteam.evaluation.results.result import EpisodeResult, result_to_line
from uniteam.evaluation.results.run_folder import RunFolder, read_run
from uniteam.evaluation.results.summary import summarize_run
from uniteam.files import UnwritableError, try_folder, write_json, write_whole

SHARD = "shard"
"""Field of a configuration that says which part of a run it is of."""


@dataclass(frozen=True)
class Merged:
    """What a merge came to.

    Attributes:
        attempts: how many results there are.
        missing: a phrase for each thing that the whole run has and the shards have not.
    """

    attempts: int
    missing: tuple[str, ...]


Bring = Callable[[RunFolder, Path], None]
"""Brings what else a shard's folder holds into the merged one."""


def merge_shards(folders: Sequence[Path], out: Path, bring: Bring = lambda run, folder: None) -> Merged:
    """Write the folder of the run that these are shards of; `summary.json` is the unsharded run's, to the byte.

    Args:
        folders: of the shards.
        out: of the run.
        bring: is called for each shard with the folder that is being written.

    Raises:
        InvalidInputError: they are no shards of one run, or `out` holds something already.
        DamagedFileError: a file cannot be read.
        UnwritableError: `out` cannot be written; nothing of it is there then.
    """
    shards = sorted((read_run(folder) for folder in folders), key=_number)
    _check_belong_together(shards)
    if out.exists() and not (out.is_dir() and not any(out.iterdir())):
        raise InvalidInputError(f"'{out}' holds something already; choose another --out, or remove it")
    part = out.with_name(f"{out.name}.partial")
    shutil.rmtree(part, ignore_errors=True)
    try_folder(part)
    try:
        attempts = _write(shards, part)
        for run in shards:
            bring(run, part)
        if out.exists():
            out.rmdir()
        part.rename(out)
    except OSError as error:
        raise UnwritableError(out, error) from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
    return Merged(attempts, tuple(_missing(shards)))


def _write(shards: Sequence[RunFolder], folder: Path) -> int:
    whole = _without_shard(shards[0].configuration)
    lines: list[str] = []
    results: dict[str, list[EpisodeResult]] = {agent: [] for agent in whole["agents"]}
    for run in shards:
        for episode in _told(run)["episodes"]:
            for agent, own in run.results.items():
                if episode in own:
                    results[agent].append(own[episode])
                    lines.append(result_to_line(agent, own[episode]))
    write_json(folder / "config.json", whole)
    write_whole(folder / "results.jsonl", "".join(lines).encode())
    write_whole(folder / "lost.jsonl", b"".join(map(_lost, shards)))
    write_json(folder / "summary.json", summarize_run(whole, results, _told(shards[0])["asked"]))
    return len(lines)


def _lost(run: RunFolder) -> bytes:
    path = run.directory / "lost.jsonl"
    return path.read_bytes() if path.exists() else b""


def _check_belong_together(shards: Sequence[RunFolder]) -> None:
    if not shards:
        raise InvalidInputError("nothing is to be merged; give the folders of a run's shards")
    first = shards[0]
    for run in shards[1:]:
        found = differences(_of_whole(first), _of_whole(run))
        if found:
            raise InvalidInputError(
                f"'{first.directory}' and '{run.directory}' are shards of different runs ({'; '.join(found[:5])}); "
                "merge shards that one command made, but for its --shard and --out"
            )
    owners: dict[str, RunFolder] = {}
    for run in shards:
        for episode in _told(run)["episodes"]:
            other = owners.setdefault(episode, run)
            if other is not run:
                raise InvalidInputError(
                    f"episode '{episode}' is in '{other.directory}' and in '{run.directory}'; give each shard once"
                )
        _check_own(run)


def _check_own(run: RunFolder) -> None:
    own = set(_told(run)["episodes"])
    for agent, results in run.results.items():
        strange = next((episode for episode in results if episode not in own), None)
        if strange is not None:
            raise DamagedFileError(f"'{run.directory}' has a result of {agent}'s '{strange}', which its shard has not")


def _missing(shards: Sequence[RunFolder]) -> list[str]:
    there = {_number(run) for run in shards}
    count = _told(shards[0])["count"]
    phrases = [f"shard {number} of {count}" for number in range(1, count + 1) if number not in there]
    for run in shards:
        for agent in run.configuration["agents"]:
            lacking = [e for e in _told(run)["episodes"] if e not in run.results.get(agent, {})]
            if lacking:
                some = ", ".join(lacking[:3]) + (", ..." if len(lacking) > 3 else "")
                phrases.append(f"{len(lacking)} of {agent}'s episodes in shard {_number(run)} of {count} ({some})")
    return phrases


def _number(run: RunFolder) -> int:
    number: int = _told(run)["number"]
    return number


def _told(run: RunFolder) -> Mapping[str, Any]:
    """Return what the configuration says of the shard; raises InvalidInputError where it says nothing."""
    told = run.configuration.get(SHARD)
    if told is None:
        raise InvalidInputError(f"'{run.directory}' is no shard: it was played without --shard, and is whole")
    kinds = {"number": int, "count": int, "asked": int, "episodes": list}
    if not isinstance(told, dict) or {name: type(value) for name, value in told.items()} != kinds:
        raise DamagedFileError(f"{run.directory / 'config.json'} does not say which shard it is of ({str(told)[:80]})")
    return told


def _without_shard(configuration: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in configuration.items() if name != SHARD}


def _of_whole(run: RunFolder) -> dict[str, Any]:
    """Return what all shards of a run must agree in."""
    told = _told(run)
    return {**_without_shard(run.configuration), "shards": told["count"], "episodes": told["asked"]}
