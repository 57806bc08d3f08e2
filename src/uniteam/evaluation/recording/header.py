"""What a recording says of itself first: its format, what it is of, and the names that its arrays speak of."""

from collections.abc import Mapping
from typing import Any

import msgspec

import uniteam
from uniteam.errors import UniteamError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.provenance import Provenance
from uniteam.geometry import PinholeCamera

FORMAT = "uniteam recording"
VERSION = 1
"""Of the format; a reader reads its own version and those before."""


class NewerFormatError(UniteamError):
    """A recording of a later version of the format than this package reads."""


class Header(msgspec.Struct, frozen=True):
    """The first member of a recording; fields that a later version adds are passed over.

    Attributes:
        format: `FORMAT`.
        format_version: of the format.
        uniteam: version of the package that wrote it.
        agent: the agent's label in the run.
        spec: how to make the agent.
        camera: intrinsics of the head camera.
        steps: how many there are.
        objects: names of the movable instances, of which the poses are.
        instances: names of all instances of the home, of which the visible pixels are.
        configuration: all that the episode depended on.
        split: the split as it was named where it was played; the home is read from there where no file can say it, as
            of the challenge's own data.
    """

    format: str
    format_version: int
    uniteam: str
    agent: str
    spec: AgentSpec
    camera: PinholeCamera
    steps: int
    objects: tuple[str, ...]
    instances: tuple[str, ...]
    configuration: Mapping[str, Any]
    split: str = ""


def make_header(
    provenance: Provenance,
    camera: PinholeCamera,
    steps: int,
    objects: tuple[str, ...],
    instances: tuple[str, ...],
) -> Header:
    """Return the header of a recording that is written now."""
    return Header(
        FORMAT, VERSION, uniteam.__version__, provenance.agent, provenance.spec,
        camera, steps, objects, instances, provenance.configuration, provenance.split,
    )  # fmt: skip


def header_to_json(header: Header) -> bytes:
    """Return the header as JSON that people can read."""
    return msgspec.json.format(msgspec.json.encode(header), indent=1) + b"\n"


def header_from_json(content: bytes) -> Header:
    """Return the header.

    Raises:
        ValueError: the content is no header.
        NewerFormatError: it is of a later version of the format.
    """
    data = msgspec.json.decode(content)
    if not isinstance(data, dict) or data.get("format") != FORMAT or not isinstance(data.get("format_version"), int):
        raise ValueError("it does not say that it is a recording")
    if data["format_version"] > VERSION:
        raise NewerFormatError(
            f"the recording is of version {data['format_version']} of the format, made by uniteam "
            f"{data.get('uniteam')}; this one reads up to {VERSION}: install a later uniteam"
        )
    return msgspec.convert(data, Header)
