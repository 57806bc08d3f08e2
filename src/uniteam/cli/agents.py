"""`uniteam agents`: what can be named on the command line, and where it is from."""

import inspect
from functools import partial
from typing import Any

from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import UniteamError
from uniteam.evaluation.agent_spec import AGENTS
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.improvements import IMPROVEMENTS, improved
from uniteam.mind.agents.report import REPORT
from uniteam.mind.perception.registry import PERCEPTIONS
from uniteam.registry import Family, Registry
from uniteam.world.generation.registry import HOMES

SECTIONS: dict[str, Registry[Any]] = {
    "agents": AGENTS,
    "perceptions": PERCEPTIONS,
    "improvements": IMPROVEMENTS,
    "sources of homes": HOMES,
}


_NAMED = ("agents", "perceptions")


def agents() -> None:
    """List the agents, the perceptions, the improvements and the sources of homes, and where each is from.

    A package brings its own by entry points in the groups uniteam.agents, uniteam.perceptions, uniteam.improvements and
    uniteam.homes; without a package, name yours as MODULE:ATTRIBUTE.
    """
    console = make_console()
    for title, registry in SECTIONS.items():
        table = Table(title=title, title_justify="left", box=None, padding=(0, 2, 0, 0))
        table.add_column("name", overflow="fold")
        table.add_column("what it is", overflow="fold")
        table.add_column("from", overflow="fold")
        for name, source in registry.sources().items():
            table.add_row(
                f"[bold]{shown(_form(registry, name))}[/]", shown(_summary(registry, name)), f"[dim]{shown(source)}[/]"
            )
        console.print(table)
        console.print()


def names_help() -> str:
    """Return the names that the options of `evaluate` and `run` take, for their help."""
    forms = {title: (_form(SECTIONS[title], name) for name in SECTIONS[title].names()) for title in _NAMED}
    named = [f"{title.capitalize()}: {', '.join(own)}." for title, own in forms.items()]
    explained = "\n".join(f"  {name}: {_summary(IMPROVEMENTS, name)}" for name in IMPROVEMENTS.names())
    return "\n\n".join([*named, f"Improvements:\n{explained}"])


def _summary(registry: Registry[Any], name: str) -> str:
    """Return what a value is: in its own words, by what it has, or why it cannot be had."""
    try:
        value = registry.look_up(name)
    except UniteamError as error:
        return f"cannot be used: {error}"
    if isinstance(value, AgentConfig):
        return f"the heuristic agent {_difference(value)}"
    if isinstance(value, partial):
        return f"{_first_line(value.func)} ({', '.join(f'{key} {word}' for key, word in value.keywords.items())})"
    return str(getattr(value, "summary", None) or _first_line(value))


def _form(registry: Registry[Any], name: str) -> str:
    """Return how a name is given: with what stands for its argument where it takes one."""
    try:
        value = registry.look_up(name)
    except UniteamError:
        return name
    return f"{name}:{value.argument}" if isinstance(value, Family) else name


def _difference(config: AgentConfig) -> str:
    """Return in words what a configuration has that the baseline has not."""
    for improvements in ((), REPORT, (*REPORT, *BEYOND)):
        if config == improved(BASELINE, improvements):
            return f"with {len(improvements)} improvements" if improvements else "as HomeRobot has it"
    return "with values of its own"


def _first_line(value: object) -> str:
    return (inspect.getdoc(value) or "").partition("\n")[0]
