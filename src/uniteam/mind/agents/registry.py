"""The agents by name."""

import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, cast

from uniteam.errors import InvalidInputError
from uniteam.interface import Agent, Body, Perception
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.describe import describe
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.agents.improvement import ImprovementError
from uniteam.mind.agents.improvements import IMPROVEMENTS, improved
from uniteam.mind.agents.random_agent import RandomAgent
from uniteam.mind.agents.report import REPORT
from uniteam.mind.perception.registry import PERCEPTIONS, make_perception
from uniteam.registry import Registry


@dataclass(frozen=True)
class AgentContext:
    """What an agent may be made of.

    Attributes:
        perception: name of the kind of perception that the run asks for.
        environment: what the agent will act in; None unless its factory has the attribute `needs_truth = True`, for it
            tells the truth to whoever asks.
    """

    perception: str
    environment: Body | None

    def make_perception(self) -> Perception:
        """Return a new perception of the kind that the run asks for."""
        return make_perception(self.perception)


AgentFactory = Callable[[AgentContext], Agent] | Callable[[], Agent]
"""Builds an agent from a context, or from nothing."""


def _checked(name: str, value: object) -> AgentConfig | AgentFactory:
    if isinstance(value, AgentConfig):
        return value
    if not callable(value):
        raise InvalidInputError(
            f"agent '{name}' must be an AgentConfig, or a class or function that makes an agent of an AgentContext "
            f"or of nothing, got {type(value).__name__}"
        )
    return cast(AgentFactory, value)


AGENTS: Registry[AgentConfig | AgentFactory] = Registry("agent", "uniteam.agents", _checked)
AGENTS.register("baseline", BASELINE)
AGENTS.register("uniteam", improved(BASELINE, REPORT))
AGENTS.register("uniteam-plus", improved(BASELINE, (*REPORT, *BEYOND)))
AGENTS.register("random", RandomAgent)

_OWN = {"uniteam": REPORT, "uniteam-plus": (*REPORT, *BEYOND)}
"""The improvements that built-in agents have, which can be taken away from them."""


def make_agent(
    name: str,
    perception: str = "truth",
    with_: Iterable[str] = (),
    without: Iterable[str] = (),
    environment: Body | None = None,
) -> Agent:
    """Return a new agent.

    Args:
        name: of an agent, or a reference "module:attribute".
        perception: name or reference of the kind of perception; an agent that does not look makes nothing of it.
        with_: names of improvements to add to what the agent has.
        without: names of improvements to take away from it.
        environment: what it will act in; shown only to an agent whose factory has `needs_truth = True`.

    Raises:
        UnknownNameError: an agent, a perception or an improvement that there is none of, with the nearest valid name.
        ImprovementError: an improvement that does not fit the agent's configuration.
        InvalidInputError: what the factory makes is no agent, or an improvement cannot be added to it or taken away.
    """
    entry = _entry(name, with_, without)
    PERCEPTIONS.get(perception)
    return build_agent(name, entry, AgentContext(perception, environment if is_told_the_truth(name) else None))


def build_agent(name: str, entry: AgentConfig | AgentFactory, context: AgentContext) -> Agent:
    """Return a new agent of a configuration or a factory.

    Args:
        name: what to call it where something is wrong.
        entry: what it is made by.
        context: what it may be made of.

    Raises:
        InvalidInputError: what the factory makes is no agent.
    """
    if isinstance(entry, AgentConfig):
        return HeuristicAgent(entry, context.make_perception())
    return _checked_agent(name, _call(entry, context))


def agent_config(name: str, with_: Iterable[str] = (), without: Iterable[str] = ()) -> AgentConfig | None:
    """Return the configuration of an agent; None for one that has none. Takes and raises what `make_agent` does."""
    entry = _entry(name, with_, without)
    return entry if isinstance(entry, AgentConfig) else None


def describe_agent(
    name: str, perception: str = "truth", with_: Iterable[str] = (), without: Iterable[str] = ()
) -> dict[str, Any]:
    """Return everything that an agent's results depend on, as JSON data. Takes and raises what `make_agent` does."""
    code = {name: AGENTS.outside_code(name), perception: PERCEPTIONS.outside_code(perception)}
    code |= {improvement: IMPROVEMENTS.outside_code(improvement) for improvement in (*with_, *without)}
    return {
        "agent": name,
        "perception": perception,
        "config": describe(agent_config(name, with_, without)),
        "code_from_outside": {key: digest for key, digest in code.items() if digest},
    }


def is_told_the_truth(name: str) -> bool:
    """Return whether an agent is shown the environment itself. Raises UnknownNameError."""
    return bool(getattr(AGENTS.get(name), "needs_truth", False))


def _entry(name: str, with_: Iterable[str], without: Iterable[str]) -> AgentConfig | AgentFactory:
    entry = AGENTS.get(name)
    added, removed = tuple(with_), tuple(without)
    for improvement in (*added, *removed):
        IMPROVEMENTS.get(improvement)
    if not (added or removed):
        return entry
    if not isinstance(entry, AgentConfig):
        raise InvalidInputError(
            f"agent '{name}' is not made of a configuration, so no improvement can be added to it or taken away "
            f"({', '.join((*added, *removed))}); name it without any, in a command of its own"
        )
    if name in _OWN:
        own = [improvement.name for improvement in _OWN[name]]
        return improved(BASELINE, [each for each in (*own, *added) if each not in removed])
    for improvement in removed:
        _check_lacks(name, entry, improvement)
    return improved(entry, [each for each in added if each not in removed])


def _check_lacks(name: str, config: AgentConfig, improvement: str) -> None:
    """Refuse to take away what a configuration seems to have: only what it would change is certainly not in it."""
    try:
        lacks = improved(config, [improvement]) != config
    except ImprovementError:
        lacks = False
    if not lacks:
        raise InvalidInputError(
            f"improvement '{improvement}' cannot be taken away from agent '{name}', whose configuration does not say "
            f"of what it is made; bring a configuration without it, to which --with {improvement} adds it"
        )


def _call(factory: AgentFactory, context: AgentContext) -> Agent:
    """Give a factory its context if it takes one."""
    try:
        parameters = tuple(inspect.signature(factory).parameters.values())
    except (TypeError, ValueError):  # some built-in callables do not say what they take
        parameters = ()
    takes_one = any(p.default is p.empty and p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) for p in parameters)
    return cast(Callable[..., Agent], factory)(*([context] if takes_one else []))


def _checked_agent(name: str, made: Agent) -> Agent:
    missing = [method for method in ("reset", "act") if not callable(getattr(made, method, None))]
    if missing:
        raise InvalidInputError(
            f"agent '{name}' needs reset(instruction, seed) and act(observation); "
            f"{type(made).__name__} has no {' and no '.join(missing)}"
        )
    return made
