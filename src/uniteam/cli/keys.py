"""Keys that are pressed while a command does something else."""

import contextlib
import queue
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO


class Keys:
    """Collects what comes from the standard input: single keys of a terminal, lines of anything else."""

    def __init__(self) -> None:
        self._pressed: queue.SimpleQueue[str] = queue.SimpleQueue()

    def pressed(self) -> str:
        """Return the next key or line that was not returned before; empty where there is none."""
        try:
            return self._pressed.get_nowait()
        except queue.Empty:
            return ""

    def listen(self, stream: TextIO) -> None:
        """Collect until the stream ends."""
        is_terminal = stream.isatty()
        with contextlib.suppress(OSError, ValueError):
            while key := stream.read(1) if is_terminal else stream.readline():
                self._pressed.put(key)


@contextmanager
def listening() -> Iterator[Keys]:
    """Listen to the keyboard meanwhile; a terminal hands over each key at once, and is put back in the end."""
    keys = Keys()
    with _single_keys():
        threading.Thread(target=keys.listen, args=(sys.stdin,), daemon=True).start()
        yield keys


@contextmanager
def _single_keys() -> Iterator[None]:
    """Have a terminal hand over keys as they are pressed, where it can; Ctrl-C still interrupts."""
    try:
        import termios
        import tty
    except ImportError:  # Windows: lines must do
        yield
        return
    if not sys.stdin.isatty():
        yield
        return
    before = termios.tcgetattr(sys.stdin)
    try:
        tty.setcbreak(sys.stdin)
        yield
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)
