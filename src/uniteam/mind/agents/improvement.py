"""An improvement: a named change of a configuration, which puts something in the place of what the baseline does."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from uniteam.errors import UniteamError
from uniteam.mind.agents.config import BASELINE, AgentConfig


class ImprovementError(UniteamError):
    """An improvement that does not fit the configuration it is applied to."""


@dataclass(frozen=True)
class Improvement:
    """One change of a configuration.

    Attributes:
        name: by which it is switched on and off.
        summary: what changes, in half a sentence.
        apply: returns the changed configuration; raises ImprovementError where it does not fit.
    """

    name: str
    summary: str
    apply: Callable[[AgentConfig], AgentConfig]


@dataclass(frozen=True)
class Replacement:
    """Puts values in the place of the baseline's.

    Attributes:
        name: of the improvement, for the error's sentence.
        slots: each a path of fields through the configuration ("search.approach"), and what is put there.
    """

    name: str
    slots: tuple[tuple[str, object], ...]

    def __call__(self, config: AgentConfig) -> AgentConfig:
        """Return the changed configuration; raises ImprovementError where a slot holds something else."""
        for path, ours in self.slots:
            self._check(path, config)
            config = _filled(config, path.split("."), ours)
        return config

    def _check(self, path: str, config: AgentConfig) -> None:
        held, theirs = _held(config, path), _held(BASELINE, path)
        if held != theirs:
            raise ImprovementError(
                f"improvement '{self.name}' replaces the baseline's '{path}' ({_words(theirs)}), but this "
                f"configuration has {_words(held)} there; leave the improvement out"
            )


def _held(config: AgentConfig, path: str) -> object:
    part: object = config
    for slot in path.split("."):
        part = getattr(part, slot, None)
    return part


def _filled(part: Any, path: list[str], ours: object) -> Any:
    slot, *rest = path
    return replace(part, **{slot: _filled(getattr(part, slot), rest, ours) if rest else ours})


def _words(value: object) -> str:
    return str(getattr(value, "__qualname__", value))


def replacing(name: str, summary: str, **slots: object) -> Improvement:
    """Return the improvement that fills slots; in their paths "__" stands for a dot."""
    paths = ((path.replace("__", "."), ours) for path, ours in slots.items())
    return Improvement(name, summary, Replacement(name, tuple(paths)))
