"""Everything that results depend on, as plain JSON data: what is written beside them, and what must not change."""

import json
import platform
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from hashlib import sha256
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from itertools import chain
from pathlib import Path
from typing import Any

import uniteam
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_choice import Shard, choose_episodes, deal
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.serialization import home_digest
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import split_files

PACKAGES = ("numpy", "numba", "llvmlite", "mujoco", "cv2")
"""Modules of others whose version can change a figure in its last bits, and so an episode."""

_READ_BY_THE_MIND = frozenset((".py", ".json", ".npz", ".onnx", ".gz"))

DIGITS = 12
"""How much of a digest is kept: enough to tell any two runs apart that somebody has."""


@dataclass(frozen=True)
class Run:
    """What to evaluate.

    Attributes:
        split: a built-in split's name or a split file's path.
        agents: by the label they have in the results.
        perception: the kind of perception that the agents see with.
        camera: "half" or "full".
        grasp: name of the rule by which the gripper takes objects.
        episode_count: how many episodes to play; None for all of the split.
        episode_seconds: how long an episode may take.
        shard: which part of the episodes to play; None for all.
    """

    split: str
    agents: Mapping[str, AgentSpec]
    perception: str
    camera: str
    grasp: str = "challenge"
    episode_count: int | None = None
    episode_seconds: float = 3600.0
    shard: Shard | None = None


def wanted_episodes(run: Run, split: Split) -> list[int]:
    """Return the indices of the episodes that a run plays; raises InvalidInputError where a shard would have none."""
    chosen = choose_episodes(split.episodes, run.episode_count)
    return chosen if run.shard is None else deal(split.episodes, chosen, run.shard)


def resolve(run: Run, split: Split) -> dict[str, Any]:
    """Return the configuration of a run over a split that was loaded; two runs with equal ones have equal results.

    Raises:
        UniteamError: an unknown name, or a file of a home's library that cannot be read.
    """
    configuration = {
        "version": uniteam.__version__,
        "code": source_digest(),
        "split": split.name,
        "split_version": split.version,
        "split_digest": _digest(split_files(run.split)),
        "homes_digest": _text_digest("".join(home_digest(split.homes[name]) for name in split.homes)),
        "models_digest": load_catalogue().digest[:DIGITS],
        "software": software(),
        "perception": run.perception,
        "camera": run.camera,
        "grasp": run.grasp,
        "episode_seconds": run.episode_seconds,
        "agents": {label: spec.describe() for label, spec in run.agents.items()},
    }
    if run.shard is not None:
        configuration["shard"] = _described(run, run.shard, split)
    plain: dict[str, Any] = json.loads(json.dumps(configuration))  # tuples are lists, as they will be read back
    return plain


def _described(run: Run, shard: Shard, split: Split) -> dict[str, Any]:
    """Return what the merging of shards must know of one."""
    own = [split.episodes[index].id for index in wanted_episodes(run, split)]
    asked = len(choose_episodes(split.episodes, run.episode_count))
    return {"number": shard.number, "count": shard.count, "asked": asked, "episodes": own}


def software() -> dict[str, str]:
    """Return the versions, and the processor that is compiled for: on another one frames differ in their last bits."""
    from llvmlite import binding
    from numba import config

    name, features, is_off = (getattr(config, option) for option in ("CPU_NAME", "CPU_FEATURES", "DISABLE_JIT"))
    return {
        "python": platform.python_version(),
        **{package: str(import_module(package).__version__) for package in PACKAGES},
        "onnxruntime": _installed_version("onnxruntime"),
        "platform": f"{platform.system()} {platform.machine()}",
        "cpu": name or binding.get_host_cpu_name(),
        "cpu_features": _text_digest(features or binding.get_host_cpu_features().flatten()),
        "compiled": "no" if is_off else "yes",
    }


def _installed_version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "none"


def source_digest() -> str:
    """Return a digest of the source of world, mind and what plays episodes: other code has other results.

    What the mind reads beside its code counts as code: words, thresholds and the weights of its networks.
    """
    root = Path(uniteam.__file__).parent
    mind = (path for path in (root / "mind").rglob("*") if path.suffix in _READ_BY_THE_MIND)
    folders = chain((root / "world").rglob("*.py"), mind, (root / "evaluation").glob("*.py"))
    return _digest(chain(root.glob("*.py"), folders))


def _digest(paths: Iterable[Path]) -> str:
    """Return a digest of files' contents in the order of their paths, each content apart from the next."""
    together = sha256()
    for path in sorted(paths):
        together.update(sha256(path.read_bytes()).digest())
    return together.hexdigest()[:DIGITS]


def _text_digest(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:DIGITS]
