"""A split as the lines of its file; `splits` reads them."""

import json
from dataclasses import MISSING, asdict, fields
from pathlib import Path
from typing import Any

from uniteam.world.homes.serialization import home_to_data
from uniteam.world.task.episode import Certificate, Episode, Split
from uniteam.world.task.lattice import points_to_runs


def encode_split(split: Split, folder: Path) -> bytes:
    """Return the lines of a file in `folder` that says a split; the same split gives the same bytes.

    What has the value that a file without it is read with is left out, so that a file of before stays as it is.
    """
    lines: list[dict[str, Any]] = [] if split.version == 1 else [{"split": {"version": split.version}}]
    for name, home in split.homes.items():
        episodes = [e for e in split.episodes if e.home == name]
        candidates = [c for e in episodes for c in (*e.objects, *e.goal_receptacles)]
        runs = {c.name: points_to_runs(c.view_points) for c in sorted(candidates, key=lambda c: c.name)}
        lines.append({"home": home_to_data(home, folder)})
        lines.append({"view_points": {"home": name, "instances": runs}})
        lines += ({"episode": _encode_episode(episode)} for episode in episodes)
    return "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines).encode()


def _encode_episode(episode: Episode) -> dict[str, Any]:
    return {
        "id": episode.id,
        "home": episode.home,
        "start": asdict(episode.start),
        "instruction": asdict(episode.instruction),
        "objects": [candidate.name for candidate in episode.objects],
        "start_receptacles": list(episode.start_receptacles),
        "goal_receptacles": [candidate.name for candidate in episode.goal_receptacles],
        "unseen": episode.unseen,
        "seed": episode.seed,
        "certificate": _encode_certificate(episode.certificate) if episode.certificate else None,
        **({"tags": asdict(episode.tags)} if episode.tags else {}),
    }


def _encode_certificate(certificate: Certificate) -> dict[str, Any]:
    defaults = {f.name: f.default for f in fields(Certificate) if f.default is not MISSING}
    told = {f.name for f in fields(Certificate) if getattr(certificate, f.name) != defaults.get(f.name, MISSING)}
    return {name: value for name, value in asdict(certificate).items() if name in told}
