"""Which agents a swap plays: each as it is, and with one module at a time replaced by the truth."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec

TRUTH = "truth"

MODULES: Mapping[str, str] = {
    "perception": "what is seen is what is there",
    "map": "where something stands is what stands there, as far as the agent has seen",
    "exploration": "the agent is told where the objects and the goal receptacles that count are",
    "navigation": "it drives along the oracle's paths over the true floor, with exact motions",
    "pick": "once it is at the object, it is grasped as the episode's certificate says",
    "place": "once it is at the receptacle, the object is put down as the certificate says",
}
"""The modules that can be replaced, and what then happens."""

_FAMILIES = {module: f"true-{module}" for module in MODULES if module != "perception"}


@dataclass(frozen=True)
class Swap:
    """Two agents that differ in one module.

    Attributes:
        module: a key of `MODULES`.
        as_it_is, swapped: the agents' labels.
    """

    module: str
    as_it_is: str
    swapped: str


@dataclass(frozen=True)
class SwapPlan:
    """What is to be played, and which pairs are compared."""

    agents: Mapping[str, AgentSpec]
    swaps: tuple[Swap, ...]


def plan_swaps(agents: Sequence[str], perception: str, modules: Sequence[str]) -> SwapPlan:
    """Return the plan for some agents.

    Raises:
        InvalidInputError: perception is to be replaced, and is the truth already.
        UniteamError: an agent of which a part cannot be replaced.
    """
    if perception == TRUTH and "perception" in modules:
        raise InvalidInputError(
            "perception is the truth already; give another with --perception, such as --perception learned, or leave "
            "it out of --modules"
        )
    specs, swaps = {agent: AgentSpec(agent, perception) for agent in agents}, []
    for agent in agents:
        for module in dict.fromkeys(modules):
            label = f"{agent}, {module} by the truth"
            specs[label] = _swapped(agent, perception, module)
            swaps.append(Swap(module, agent, label))
    for spec in specs.values():
        spec.describe()
    return SwapPlan(specs, tuple(swaps))


def _swapped(agent: str, perception: str, module: str) -> AgentSpec:
    family = _FAMILIES.get(module)
    return AgentSpec(agent, TRUTH) if family is None else AgentSpec(f"{family}:{agent}", perception)
