"""The command `uniteam`: one subcommand a file, imported only when it is called."""

import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from inspect import cleandoc
from types import ModuleType
from typing import NoReturn
from unicodedata import category

from rich.console import Console

from uniteam import __version__
from uniteam.cli.terminal import (
    Interrupted,
    interruptible,
    make_console,
    show_warnings,
    shown,
    write_what_can_be_written,
)
from uniteam.errors import InvalidInputError, UniteamError, UnknownNameError
from uniteam.kernel_cache import check_environment


@dataclass(frozen=True)
class Command:
    """A subcommand: what it is for, and one line that shows it at work."""

    purpose: str
    example: str


COMMANDS = {
    "evaluate": Command(
        "play a split's episodes with one or more agents and print the challenge's table",
        "uniteam evaluate --agents baseline uniteam-plus --split minival",
    ),
    "compare": Command(
        "compare agents on the episodes that all have played, with intervals and tests of the paired differences",
        "uniteam compare runs/val-learned-half-challenge:baseline runs/val-learned-half-challenge:uniteam",
    ),
    "explain": Command(
        "say why each episode failed, and count the causes from all episodes down to overall success",
        "uniteam explain runs/val-learned-half-challenge --figure why.png",
    ),
    "merge": Command(
        "make one run of the shards of a run",
        "uniteam merge runs/val-learned-half-challenge-shard-* --out runs/val-learned-half-challenge",
    ),
    "verify": Command(
        "play some of a run's episodes again from their recorded actions, and compare every measure",
        "uniteam verify runs/val-learned-half-challenge --episodes 20",
    ),
    "scale": Command(
        "say what a run of many episodes would take, from one that was played",
        "uniteam scale results/val-truth-half-challenge --episodes 1000 100000",
    ),
    "ablate": Command(
        "measure what each improvement is worth, alone, taken away and one after the other",
        "uniteam ablate --split val --perception truth --episodes 100",
    ),
    "swap": Command(
        "replace one module at a time by the truth, and count the failures that this heals",
        "uniteam swap --split val --agents uniteam-plus --modules exploration pick place --episodes 100",
    ),
    "leaderboard": Command(
        "score results anew from the line of each episode, by style and by seen and unseen",
        "uniteam leaderboard results/val-truth-half-challenge",
    ),
    "report": Command(
        "make one page of runs: tables, success by tag, every episode with why it failed and its replay",
        "uniteam report runs/val-learned-half-challenge --out report.html",
    ),
    "dial": Command(
        "play a split at several levels of perception's noise and draw success against noise",
        "uniteam dial --split minival --agents baseline uniteam-plus --levels 0 0.5 1",
    ),
    "run": Command(
        "play one episode, narrated, and film it",
        "uniteam run --agent uniteam-plus --split minival --episode 0 --video episode.mp4",
    ),
    "replay": Command(
        "make one page of a recording, or of two of the same episode beside each other, for any browser",
        "uniteam replay episode.zip --out episode.html",
    ),
    "export": Command(
        "write recordings for other programs: a dataset for LeRobot, or one for the viewer of Rerun",
        "uniteam export lerobot runs/val-learned-half-challenge:oracle --out demonstrations",
    ),
    "figures": Command(
        "draw the figures of the UniTeam report from runs of our agents", "uniteam figures --out figures"
    ),
    "replay-check": Command(
        "ask an agent again upon what a recording saw, and name the first step that differs",
        "uniteam replay-check episode.zip --without edge_margin",
    ),
    "robot": Command(
        "let an agent act on a real Stretch, with --dry-run at first",
        "uniteam robot 192.168.1.20 --object cup --start table --goal cabinet --dry-run",
    ),
    "fake-robot": Command(
        "put a simulated Stretch behind the network ports of a real one",
        "uniteam fake-robot --split minival --episode 0 --latency 0.1 --drift 0.02",
    ),
    "rehearse": Command(
        "measure what a robot's drift and latency cost, on fake robots",
        "uniteam rehearse --split minival --episodes 2 --drift 0 0.02 --latency 0 0.1",
    ),
    "serve": Command(
        "serve a split's episodes to an agent of another program, Python, container or machine, over gRPC",
        "uniteam serve my-agent --split minival --port 8085",
    ),
    "serve-perception": Command(
        "serve a perception to agents on other machines", "uniteam serve-perception owlv2 --port 8712"
    ),
    "home": Command("generate a home and draw it", "uniteam home 7 --out home_7"),
    "episodes": Command(
        "generate certified episodes of your own", "uniteam episodes --homes 9000:9010 --per-home 5 --out mine.jsonl.gz"
    ),
    "data": Command(
        "say what of the challenge's own data is in a folder, and whether it can be played",
        "uniteam data check data/datasets/ovmm/val",
    ),
    "perception": Command(
        "measure what perception `learned` finds and names in a split's homes",
        "uniteam perception --split val --homes 40 --out perception.md",
    ),
    "train": Command(
        "make the networks of perception `learned`: render training homes, train, judge, write",
        "uniteam train segmenter --work training --homes 200",
    ),
    "agents": Command(
        "list agents, perceptions, improvements and sources of homes, and where each is from", "uniteam agents"
    ),
    "assets": Command(
        "list the models and draw contact sheets of them", "uniteam assets --category chair --sheet sheets"
    ),
    "bench": Command("measure where a step's time goes", "uniteam bench --out bench.json"),
    "doctor": Command("check that this installation is whole", "uniteam doctor"),
}

_COLUMN = max(map(len, COMMANDS)) + 2

TAKING_NAMES = ("evaluate", "ablate", "dial", "run", "replay-check", "robot", "rehearse")
"""Commands whose help lists the agents, the perceptions and the improvements."""

USER_ERROR = 2
INTERRUPTED = 130
SIGNALLED = 128
"""A command that a signal ended exits with this and the signal's number, as shells have it."""
BROKEN_PIPE = 141

DEBUG = "UNITEAM_DEBUG"
"""An environment variable: where it is set, an error shows its traceback."""


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run `uniteam` with the given arguments, or those of the command line, and exit."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    write_what_can_be_written()
    try:
        with interruptible():
            code = _dispatch(given)
            if sys.stdout is not None:
                sys.stdout.flush()
        sys.exit(code)
    except BrokenPipeError:  # whoever read our output has read enough
        _forget_output()
        sys.exit(BROKEN_PIPE)
    except Interrupted as signal:
        _forget_output()  # the terminal may be gone
        sys.exit(SIGNALLED + signal.number)
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    except (UniteamError, OSError, MemoryError, RecursionError) as error:
        if os.environ.get(DEBUG):
            raise
        _complain(_sentence(error))
        sys.exit(USER_ERROR)


def _sentence(error: Exception) -> str:
    """Return what is wrong, in words."""
    if isinstance(error, UniteamError):
        return str(error)
    if isinstance(error, OSError):
        where = f" ({error.filename})" if error.filename is not None else ""
        return f"the system refused what was to be done: {error.strerror or error}{where}"
    if isinstance(error, MemoryError):
        return "there is not enough memory for this; close other programs, or choose something smaller"
    return "what was given is nested too deeply to be read"


def _complain(sentence: str) -> None:
    with suppress(OSError):  # nobody is there to read it
        make_console(stderr=True).print(f"[bold red]uniteam:[/] {shown(sentence)}", soft_wrap=True)


def _forget_output() -> None:
    """Have what is still to be written go nowhere, so that Python does not stumble over it at its end."""
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())


def _dispatch(given: list[str]) -> int:
    if not given or given[0] in ("-h", "--help", "help"):
        _print_overview(make_console())
        return 0
    if given[0] in ("-V", "--version"):
        make_console().print(f"uniteam {__version__}")
        return 0
    show_warnings()
    check_environment()
    _import_from_here()
    name, *rest = given
    if name not in COMMANDS:
        raise UnknownNameError("command", name, COMMANDS)
    for argument in rest:
        if any(category(character) == "Cc" for character in argument):
            raise InvalidInputError(f"'{argument}' holds a control character; leave it out")
    return _call(name, rest)


def _call(name: str, arguments: list[str]) -> int:
    import tyro

    function = function_of(name)
    summary = cleandoc(function.__doc__ or "").split("\n\nArgs:")[0]
    description = f"{summary}\n\nExample: {COMMANDS[name].example}"
    if name in TAKING_NAMES and {"-h", "--help"} & set(arguments):
        description += f"\n\n{_load('agents').names_help()}"
    tyro.cli(function, prog=f"uniteam {name}", description=description, args=arguments)
    return 0


def function_of(name: str) -> Callable[..., None]:
    """Return the function that a command calls; its module, and what that needs, are imported."""
    name = name.replace("-", "_")
    function: Callable[..., None] = getattr(_load(name), name)
    return function


def _load(name: str) -> ModuleType:
    """Import a command's module, and what it needs."""
    try:
        return import_module(f"uniteam.cli.{name}")
    except Exception as error:  # a package is missing or broken, or finds something in the environment that it refuses
        raise UniteamError(
            f"what '{name}' needs cannot be imported ({type(error).__name__}: {error}); mend that, or reinstall uniteam"
        ) from error


def _import_from_here() -> None:
    """Let "my_agent:Spinner" be found in the folder that the command is given in, by worker processes too."""
    with suppress(OSError):  # the folder has been removed
        here = os.getcwd()  # noqa: PTH109 - sys.path holds strings
        if not {"", here} & set(sys.path):
            sys.path.append(here)


def _print_overview(console: Console) -> None:
    console.print(f"[bold]uniteam[/] {__version__}: simulated homes, a Stretch robot, and agents that tidy up.\n")
    console.print("Usage: uniteam COMMAND [OPTIONS]; 'uniteam COMMAND --help' explains the options.\n")
    for name, command in COMMANDS.items():
        console.print(f"  [bold]{name:<{_COLUMN}}[/]{command.purpose}", soft_wrap=True)
        console.print(f"  {'':<{_COLUMN}}[dim]{command.example}[/]", soft_wrap=True)
    console.print("\nBegin with [bold]uniteam evaluate[/]: ten episodes, three agents, one table.")


if __name__ == "__main__":
    main()
