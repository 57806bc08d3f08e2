"""What the commands have in common where they meet a terminal: its encoding, hostile text, warnings, and signals."""

import codecs
import logging
import os
import signal
import sys
import threading
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import FrameType

from rich.console import Console
from rich.markup import escape

from uniteam.errors import InvalidInputError

_SUBSTITUTES = {"–": "-", "—": "-", "…": "...", "·": "|", "°": " deg", "│": "|", "─": "-", "•": "*", "━": "-"}

_LEVELS = ("debug", "info", "warning", "error")


class Interrupted(KeyboardInterrupt):
    """The system asks this process to end, as Ctrl-C does; `number` is the signal's."""

    def __init__(self, number: int) -> None:
        super().__init__(signal.Signals(number).name)
        self.number = number


def make_console(stderr: bool = False) -> Console:
    """Return a console that takes no word for an emoji's name and colours nothing by its own guess."""
    return Console(stderr=stderr, emoji=False, highlight=False)


def shown(text: object) -> str:
    """Return text from outside as it may be shown: no markup of rich has an effect, and no control character.

    Escape sequences, line feeds and marks that reverse the direction of writing are shown by their codes.
    """
    return escape("".join(c if _is_harmless(c) else c.encode("unicode_escape").decode() for c in str(text)))


def _is_harmless(character: str) -> bool:
    category = unicodedata.category(character)
    return category[0] != "C" and category not in ("Zl", "Zp")


def write_what_can_be_written() -> None:
    """Have characters that the output's encoding lacks replaced by the nearest, instead of losing the output."""
    codecs.register_error("uniteam", _substitute)
    for stream in (sys.stdout, sys.stderr):
        with suppress(AttributeError):  # closed, or a test's own
            stream.reconfigure(errors="uniteam")  # type: ignore[union-attr]


def _substitute(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    lost = error.object[error.start : error.end]
    return "".join(_SUBSTITUTES.get(c, "?") for c in lost), error.end


class _LogLines(logging.Handler):
    """Prints records on the error stream; above the progress bar where there is one, which rich looks after."""

    def emit(self, record: logging.LogRecord) -> None:
        """Print the record's message, and its traceback where it has one."""
        style = "yellow" if record.levelno >= logging.WARNING else "dim"
        lines = "\n".join(shown(line) for line in self.format(record).splitlines())
        with suppress(OSError):  # the terminal is gone
            make_console(stderr=True).print(f"[{style}]{record.levelname.lower()}:[/] {lines}", soft_wrap=True)


def show_warnings() -> None:
    """Show what the package logs from the level that the environment variable UNITEAM_LOG names; warnings by default.

    Raises:
        InvalidInputError: UNITEAM_LOG names no level.
    """
    level = os.environ.get("UNITEAM_LOG", "warning").lower()
    if level not in _LEVELS:
        raise InvalidInputError(f"UNITEAM_LOG is '{level}'; it must be one of {', '.join(_LEVELS)}, or unset")
    root = logging.getLogger()
    if not any(isinstance(handler, _LogLines) for handler in root.handlers):
        root.addHandler(_LogLines())
    root.setLevel(level.upper())
    logging.captureWarnings(True)


@contextmanager
def interruptible() -> Iterator[None]:
    """Raise `Interrupted` at SIGTERM and SIGHUP, so that they end a command as cleanly as Ctrl-C.

    A second signal of the kind is ignored: what the first one started takes a moment, and must not be cut short.
    """
    numbers = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def interrupt(number: int, frame: FrameType | None) -> None:
        for other in numbers:
            signal.signal(other, signal.SIG_IGN)
        raise Interrupted(number)

    before = {number: signal.getsignal(number) for number in numbers}
    for number, handler in before.items():
        if handler is not signal.SIG_IGN:  # as nohup has it
            signal.signal(number, interrupt)
    try:
        yield
    finally:
        for number, handler in before.items():
            if handler is not None:  # not Python's own
                signal.signal(number, handler)
