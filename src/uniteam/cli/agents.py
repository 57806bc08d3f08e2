"""`uniteam agents`: what can be named on the command line, and where it is from."""

import inspect
from functools import partial
from typing import Any

from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import UniteamError
from uniteam.evaluation.agent_spec import AGENTS
from uniteam.mind.agents.improvements import IMPROVEMENTS
from uniteam.mind.perception.registry import PERCEPTIONS
from uniteam.registry import Registry
from uniteam.world.generation.registry import HOMES

SECTIONS: dict[str, Registry[Any]] = {
    "agents": AGENTS,
    "perceptions": PERCEPTIONS,
    "improvements": IMPROVEMENTS,
    "sources of homes": HOMES,
}


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
            table.add_row(f"[bold]{shown(name)}[/]", _summary(registry, name), f"[dim]{shown(source)}[/]")
        console.print(table)
        console.print()


def names_help() -> str:
    """Return the names that the options of `evaluate` and `run` take, for their help."""
    listed = [f"{title.capitalize()}: {', '.join(SECTIONS[title].names())}." for title in ("agents", "perceptions")]
    listed += ["Improvements:", *(f"  {name}: {_summary(IMPROVEMENTS, name)}" for name in IMPROVEMENTS.names())]
    return "\n".join(listed)


def _summary(registry: Registry[Any], name: str) -> str:
    """Return a value's own summary or the first line of its docstring, or why it cannot be had."""
    try:
        value = registry.get(name)
    except UniteamError as error:
        return f"[red]{shown(error)}[/]"
    told = value.func if isinstance(value, partial) else value
    return shown(getattr(told, "summary", None) or (inspect.getdoc(told) or "").partition("\n")[0])
