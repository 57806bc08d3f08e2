"""The command `uniteam`: one subcommand a file, imported only when it is called."""

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from inspect import cleandoc
from typing import NoReturn

from rich.console import Console
from rich.markup import escape

from uniteam import __version__
from uniteam.errors import UniteamError, UnknownNameError


@dataclass(frozen=True)
class Command:
    """A subcommand: what it is for, and one line that shows it at work."""

    purpose: str
    example: str


COMMANDS = {
    "evaluate": Command(
        "play a split's episodes with one or more agents and print the challenge's table",
        "uniteam evaluate --agents baseline uniteam --split minival",
    ),
    "run": Command(
        "play one episode, narrated, and film it",
        "uniteam run --agent uniteam --split minival --episode 0 --video episode.mp4",
    ),
    "home": Command("generate a home and draw it", "uniteam home 7 --out home_7"),
    "episodes": Command(
        "generate certified episodes of your own", "uniteam episodes --homes 9000:9010 --per-home 5 --out mine.jsonl.gz"
    ),
    "assets": Command(
        "list the models and draw contact sheets of them", "uniteam assets --category chair --sheet sheets"
    ),
    "bench": Command("measure where a step's time goes", "uniteam bench --out bench.json"),
    "doctor": Command("check that this installation is whole", "uniteam doctor"),
}

USER_ERROR = 2
INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run `uniteam` with the given arguments, or those of the command line, and exit."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    try:
        sys.exit(_dispatch(given))
    except UniteamError as error:
        Console(stderr=True).print(f"[bold red]uniteam:[/] {escape(str(error))}", highlight=False, soft_wrap=True)
        sys.exit(USER_ERROR)
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)


def _dispatch(given: list[str]) -> int:
    if not given or given[0] in ("-h", "--help", "help"):
        _print_overview(Console())
        return 0
    if given[0] in ("-V", "--version"):
        Console().print(f"uniteam {__version__}", highlight=False)
        return 0
    name, *rest = given
    if name not in COMMANDS:
        raise UnknownNameError("command", name, COMMANDS)
    return _call(name, rest)


def _call(name: str, arguments: list[str]) -> int:
    import tyro

    function: Callable[..., None] = getattr(import_module(f"uniteam.cli.{name}"), name)
    summary = cleandoc(function.__doc__ or "").split("\n\nArgs:")[0]
    description = f"{summary}\n\nExample: {COMMANDS[name].example}"
    tyro.cli(function, prog=f"uniteam {name}", description=description, args=arguments)
    return 0


def _print_overview(console: Console) -> None:
    console.print(f"[bold]uniteam[/] {__version__}: simulated homes, a Stretch robot, and agents that tidy up.\n")
    console.print("Usage: uniteam COMMAND [OPTIONS]; 'uniteam COMMAND --help' explains the options.\n", highlight=False)
    for name, command in COMMANDS.items():
        console.print(f"  [bold]{name:<10}[/]{command.purpose}", highlight=False, soft_wrap=True)
        console.print(f"  {'':<10}[dim]{command.example}[/]", highlight=False, soft_wrap=True)
    console.print("\nBegin with [bold]uniteam evaluate[/]: ten episodes, two agents, one table.")


if __name__ == "__main__":
    main()
