"""Which agents an ablation plays, and which two of them tell what an improvement is worth."""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.report import REPORT

GROUPS = {
    "whole": "all improvements at once",
    "alone": "each of the report's alone on baseline",
    "removed": "each of the report's taken from uniteam",
    "ladder": "the report's one after the other, from baseline to uniteam",
    "beyond-added": "each of those beyond the report added to uniteam",
    "beyond-removed": "each of those beyond the report taken from uniteam-plus",
}
"""The questions that an ablation answers, in words."""

LADDER = "ladder"
BASELINE, UNITEAM, PLUS = "baseline", "uniteam", "uniteam-plus"

_REPORT = tuple(improvement.name for improvement in REPORT)
_BEYOND = tuple(improvement.name for improvement in BEYOND)


@dataclass(frozen=True)
class Effect:
    """Two agents that differ in one improvement.

    Attributes:
        group: of which question, a key of `GROUPS`.
        improvement: its name.
        without, with_: the two agents' labels.
    """

    group: str
    improvement: str
    without: str
    with_: str


@dataclass(frozen=True)
class AblationPlan:
    """What is to be played and to be compared.

    Attributes:
        agents: by their labels, each configuration once.
        effects: in the order of the questions and of the improvements.
    """

    agents: dict[str, AgentSpec]
    effects: tuple[Effect, ...]


def plan_ablation(perception: str, groups: Iterable[str]) -> AblationPlan:
    """Return the plan for some of the questions; agents with one configuration are one agent."""
    wanted = tuple(groups)
    labels: dict[str, str] = {}
    agents: dict[str, AgentSpec] = {}

    def labelled(label: str, spec: AgentSpec) -> str:
        seeing = replace(spec, perception=perception)
        first = labels.setdefault(json.dumps(seeing.describe()["config"]), label)
        agents.setdefault(first, seeing)
        return first

    pairs = [pair for group in GROUPS if group in wanted for pair in _PAIRS[group]()]
    bases = {BASELINE: AgentSpec(BASELINE, ""), UNITEAM: AgentSpec(UNITEAM, ""), PLUS: AgentSpec(PLUS, "")}
    used = {label for pair in pairs for label, _ in pair[2:]}
    for label, spec in bases.items():
        if label in used:
            labelled(label, spec)
    effects = [Effect(group, name, labelled(*without), labelled(*with_)) for group, name, without, with_ in pairs]
    return AblationPlan(agents, tuple(effects))


Labelled = tuple[str, AgentSpec]
Pair = tuple[str, str, Labelled, Labelled]
"""A group, an improvement, and the agents without and with it."""


def _base(name: str) -> Labelled:
    return name, AgentSpec(name, "")


def _with(name: str, improvement: str) -> Labelled:
    return f"{name} with {improvement}", AgentSpec(name, "", added=(improvement,))


def _less(name: str, improvement: str) -> Labelled:
    return f"{name} without {improvement}", AgentSpec(name, "", removed=(improvement,))


def _rung(count: int) -> Labelled:
    """Return the baseline with the first of the report's improvements."""
    if count in (0, 1, len(_REPORT)):
        return {0: _base(BASELINE), 1: _with(BASELINE, _REPORT[0])}.get(count, _base(UNITEAM))
    return f"{BASELINE} up to {_REPORT[count - 1]}", AgentSpec(BASELINE, "", added=_REPORT[:count])


def _whole() -> Iterator[Pair]:
    yield "whole", f"the report's {len(_REPORT)}", _base(BASELINE), _base(UNITEAM)
    yield "whole", f"the {len(_BEYOND)} beyond", _base(UNITEAM), _base(PLUS)


def _alone() -> Iterator[Pair]:
    return (("alone", name, _base(BASELINE), _with(BASELINE, name)) for name in _REPORT)


def _removed() -> Iterator[Pair]:
    return (("removed", name, _less(UNITEAM, name), _base(UNITEAM)) for name in _REPORT)


def _ladder() -> Iterator[Pair]:
    return ((LADDER, name, _rung(k), _rung(k + 1)) for k, name in enumerate(_REPORT))


def _beyond_added() -> Iterator[Pair]:
    return (("beyond-added", name, _base(UNITEAM), _with(UNITEAM, name)) for name in _BEYOND)


def _beyond_removed() -> Iterator[Pair]:
    return (("beyond-removed", name, _less(PLUS, name), _base(PLUS)) for name in _BEYOND)


_PAIRS = {
    "whole": _whole,
    "alone": _alone,
    "removed": _removed,
    LADDER: _ladder,
    "beyond-added": _beyond_added,
    "beyond-removed": _beyond_removed,
}
