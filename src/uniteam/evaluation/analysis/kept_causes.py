"""Causes that were decided once: each lies beside the recording that it is of, for as long as both stay as they are."""

import logging
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path

import msgspec

import uniteam
from uniteam.evaluation.causes.diagnosis import Diagnosis, diagnose
from uniteam.evaluation.configuration import source_digest
from uniteam.evaluation.recording.archive import damaged
from uniteam.evaluation.recording.recording import read_recording
from uniteam.files import UnwritableError, write_whole
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.task.measures import Measures

SUFFIX = ".cause.json"
"""Of the file beside a recording, behind the recording's own name."""

_DECIDING = ("causes", "recording")
"""Folders of the evaluation whose code decides, besides that upon which episodes depend."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class KeptCause:
    """What was decided of a recording, and from what.

    Attributes:
        recording: digest of the file.
        rules: digest of the code and the models that decided.
        measures: of the episode, as the recording has them.
        diagnosis: why it failed; None for an overall success.
    """

    recording: str
    rules: str
    measures: Measures
    diagnosis: Diagnosis | None


def cause_path(recording: Path) -> Path:
    """Return where the cause of a recording is kept."""
    return recording.with_name(f"{recording.name}{SUFFIX}")


def cause_of(recording: Path) -> KeptCause:
    """Return what is kept of a recording where that is of this file and of these rules; else decide, and keep it.

    In a folder that cannot be written into it is decided each time.

    Raises:
        DamagedFileError: the recording cannot be read.
    """
    path, known = cause_path(recording), _digest_of(recording)
    kept = _read(path)
    if kept is not None and (kept.recording, kept.rules) == (known, rules_digest()):
        return kept
    read = read_recording(recording)
    decided = KeptCause(known, rules_digest(), read.result.measures, diagnose(read))
    try:
        write_whole(path, msgspec.json.encode(decided))
    except UnwritableError as error:
        _log.debug("%s", error)
    return decided


@cache
def rules_digest() -> str:
    """Return a digest of all that a cause depends on besides its recording: code, and the models of homes."""
    own = deciding_code(Path(uniteam.__file__).parent / "evaluation")
    return _digest(text.encode() for text in (own, source_digest(), load_catalogue().digest))


def deciding_code(evaluation: Path) -> str:
    """Return a digest of the code that decides, of those in the folder of the evaluation that no episode depends on."""
    files = sorted(path for folder in _DECIDING for path in (evaluation / folder).rglob("*.py"))
    return _digest(path.read_bytes() for path in files)


def _digest_of(recording: Path) -> str:
    try:
        return _digest([recording.read_bytes()])
    except OSError as error:
        raise damaged(recording, error.strerror or str(error)) from error


def _digest(contents: Iterable[bytes]) -> str:
    together = sha256()
    for content in contents:
        together.update(sha256(content).digest())
    return together.hexdigest()


def _read(path: Path) -> KeptCause | None:
    try:
        return msgspec.json.decode(path.read_bytes(), type=KeptCause)
    except (OSError, msgspec.MsgspecError, RecursionError):
        return None
