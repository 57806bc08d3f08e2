"""Open-vocabulary mobile manipulation: simulated homes, a Stretch robot, and the agents that tidy them.

The names in `__all__` are the stable interface; each is imported when it is first used. Everything else may change from
one version to the next.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from uniteam.kernel_cache import ensure_cache

if TYPE_CHECKING:
    __version__: str

ensure_cache()

_MODULE_OF = {
    "ACTION_LIMITS": "uniteam.interface",
    "AGENTS": "uniteam.evaluation.agent_spec",
    "Action": "uniteam.interface",
    "Agent": "uniteam.interface",
    "AgentConfig": "uniteam.mind.agents.config",
    "AgentContext": "uniteam.mind.agents.registry",
    "BASELINE": "uniteam.mind.agents.config",
    "BaseDisplacement": "uniteam.interface",
    "BasePose": "uniteam.geometry",
    "Body": "uniteam.interface",
    "Decision": "uniteam.interface",
    "Detection": "uniteam.interface",
    "DiscreteAction": "uniteam.interface",
    "Environment": "uniteam.world.task.environment",
    "Explanation": "uniteam.interface",
    "Home": "uniteam.world.homes.home",
    "Improvement": "uniteam.mind.agents.improvement",
    "Instruction": "uniteam.interface",
    "JointDisplacement": "uniteam.interface",
    "Joints": "uniteam.interface",
    "Observation": "uniteam.interface",
    "Perception": "uniteam.interface",
    "Segmentation": "uniteam.interface",
    "UniteamError": "uniteam.errors",
    "generate_home": "uniteam.world.generation.generate",
    "load_split": "uniteam.world.task.splits",
    "make_agent": "uniteam.mind.agents.registry",
    "play_episode": "uniteam.evaluation.episode_loop",
    "read_recording": "uniteam.evaluation.recording.recording",
}

__all__ = ["__version__", *sorted(_MODULE_OF)]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return _version()
    if name not in _MODULE_OF:
        raise AttributeError(f"module 'uniteam' has no attribute '{name}'")
    return getattr(import_module(_MODULE_OF[name]), name)


def __dir__() -> list[str]:
    return __all__


def _version() -> str:
    from importlib.metadata import PackageNotFoundError, version  # half of the time that the package takes to import

    try:
        return version("uniteam")
    except PackageNotFoundError:  # a source tree that was never installed
        return "0+unknown"
