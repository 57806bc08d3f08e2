"""The file of an episode's actions alone, from which the episode can be played again; a few kilobytes.

It is a gzip file of JSON lines: a line that says what it is of, then a line for each action.
"""

import gzip
import zlib
from collections.abc import Sequence
from pathlib import Path

import msgspec
import numpy as np

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.recording.action_data import ActionData, action_from_data, action_to_data
from uniteam.files import try_folder, write_whole
from uniteam.interface import Action
from uniteam.world.task.episode import MAXIMUM_STEPS

FORMAT = "uniteam actions"
VERSION = 1
"""Of the format."""

MOST_BYTES = 4096 * MAXIMUM_STEPS
"""Of a file unpacked; a line of joints has some 300."""


class _Head(msgspec.Struct, forbid_unknown_fields=True):
    format: str
    format_version: int
    agent: str
    episode: str


def _plain(value: object) -> object:
    """Return a number of NumPy, which agents hand on, as Python's own."""
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"an action cannot hold a {type(value).__name__}")


_ENCODER = msgspec.json.Encoder(enc_hook=_plain)


def write_actions(path: Path, agent: str, episode: str, actions: Sequence[Action]) -> None:
    """Write the actions of an agent's episode; the same ones give the same bytes.

    Raises:
        UnwritableError: as the system says; what was there before is still there.
    """
    try_folder(path.parent)
    lines = [_Head(FORMAT, VERSION, agent, episode), *map(action_to_data, actions)]
    write_whole(path, gzip.compress(_ENCODER.encode_lines(lines), mtime=0))


def read_actions(path: Path, agent: str, episode: str) -> tuple[Action, ...]:
    """Return the actions of an agent's episode.

    Raises:
        DamagedFileError: the file cannot be read, or is of another agent or episode.
    """
    try:
        first, *lines = _unpacked(path).splitlines()
        head = msgspec.json.decode(first, type=_Head)
        if head != _Head(FORMAT, VERSION, agent, episode):
            raise ValueError(f"it is {head.format} {head.format_version} of {head.agent}'s episode '{head.episode}'")
        return tuple(action_from_data(msgspec.json.decode(line, type=ActionData)) for line in lines)
    except (OSError, EOFError, zlib.error, ValueError, RecursionError, InvalidInputError) as error:
        raise DamagedFileError(
            f"the actions '{path}' cannot be read ({error}); play {agent}'s episode '{episode}' again with "
            "'uniteam evaluate --record actions'"
        ) from error


def _unpacked(path: Path) -> bytes:
    with gzip.open(path) as file:
        content: bytes = file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise ValueError(f"unpacked it has more than {MOST_BYTES} bytes")
    return content
