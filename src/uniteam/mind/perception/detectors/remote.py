"""Perception `remote:URL`: another machine's perception, over HTTP; `uniteam serve-perception` is its server."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from time import monotonic, sleep
from typing import TypeVar
from uuid import uuid4

import msgspec

from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.interface import Instruction, Observation, Segmentation
from uniteam.mind.perception.detectors.remote_messages import (
    PROTOCOL,
    Health,
    Problem,
    Seen,
    frame_of,
    segmentation_of,
)
from uniteam.mind.perception.detectors.weights import import_library
from uniteam.registry import Family

EXTRA = "remote"
TOKEN = "UNITEAM_TOKEN"
"""An environment variable: what a server asks of those who call it, where it is set."""
MOST_BYTES = 64 * 1024 * 1024
"""Of a message; a larger one is not read to its end."""
PASSING = (502, 503, 504)
"""Status codes after which it is worth asking again."""

Message = TypeVar("Message")


@dataclass(frozen=True)
class Patience:
    """How long to wait for a server.

    Attributes:
        connect: s for a connection.
        answer: s for a whole answer, from the question on, however slowly it comes.
        tries: how often to ask.
        pause: s before the second try; each further pause is twice as long.
    """

    connect: float = 5.0
    answer: float = 60.0
    tries: int = 4
    pause: float = 0.5


PATIENT = Patience()


class ServerError(UnavailableError):
    """The server of a perception does not answer, or not as it should; results so far are not lost by it."""


class RemotePerception:
    """Sends each observation to a server, without the truth, and returns what that makes of it."""

    def __init__(self, url: str, patience: Patience = PATIENT) -> None:
        """Connect, and see that somebody is there; raises UnavailableError."""
        self.url = url.rstrip("/")
        self._patience = patience
        self._httpx = import_library("httpx", EXTRA)
        headers = {"Authorization": f"Bearer {os.environ[TOKEN]}"} if os.environ.get(TOKEN) else {}
        timeout = self._httpx.Timeout(patience.answer, connect=patience.connect)
        # no proxy of the environment: frames are large, and the server is near
        self._client = self._httpx.Client(timeout=timeout, headers=headers, trust_env=False)
        self.health = self._ask("GET", "/health", b"", Health)
        if self.health.protocol != PROTOCOL:
            raise ServerError(
                f"the server at {self.url} speaks version {self.health.protocol} of the messages (uniteam "
                f"{self.health.version}), and this is version {PROTOCOL}; install the same uniteam on both machines"
            )
        self.reset(Instruction("", "", ""), 0)

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin an episode; the server begins it with the first frame."""
        self._instruction, self._seed = instruction, seed
        self._session = uuid4().hex

    def perceive(self, observation: Observation) -> Segmentation:
        """Return what the server sees; raises ServerError where it gives no answer, or none that makes sense."""
        frame = frame_of(self._session, self._instruction, self._seed, observation)
        seen = self._ask("POST", "/perceive", msgspec.msgpack.encode(frame), Seen)
        try:
            segmentation = segmentation_of(seen)
        except InvalidInputError as error:
            raise ServerError(f"the server at {self.url} sent a segmentation that is none: {error}") from error
        if segmentation.instances.shape != observation.depth.shape:
            raise ServerError(
                f"the server at {self.url} sent a segmentation of {segmentation.instances.shape} for a frame of "
                f"{observation.depth.shape}; mend its perception"
            )
        return segmentation

    def _ask(self, method: str, path: str, body: bytes, kind: type[Message]) -> Message:
        """Return the server's answer; asks again where that may help."""
        for attempt in range(self._patience.tries):
            if attempt:
                sleep(self._patience.pause * 2 ** (attempt - 1))
            try:
                status, content = self._exchange(method, path, body)
            except (self._httpx.TransportError, TimeoutError) as error:
                why = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
                continue
            if status not in PASSING:
                return self._read(status, content, kind)
            why = f"status {status}"
        raise ServerError(
            f"the server at {self.url} did not answer in {self._patience.tries} tries ({why}); see that it runs, with "
            "'uniteam serve-perception', and that this machine can reach it"
        )

    def _exchange(self, method: str, path: str, body: bytes) -> tuple[int, bytes]:
        """Return the status and the content of one answer, which may neither be too long nor take too long."""
        until = monotonic() + self._patience.answer
        with self._client.stream(method, self.url + path, content=body) as response:
            content = bytearray()
            for part in response.iter_raw():
                content += part
                if len(content) > MOST_BYTES:
                    raise ServerError(f"the server at {self.url} sent more than {MOST_BYTES} bytes; is it another one?")
                if monotonic() > until:
                    raise TimeoutError(f"its answer took more than {self._patience.answer:g} s")
            return response.status_code, bytes(content)

    def _read(self, status: int, content: bytes, kind: type[Message]) -> Message:
        if status != 200:
            raise ServerError(f"the server at {self.url} refused with status {status}: {_sentence(content)}")
        try:
            return msgspec.msgpack.decode(content, type=kind)
        except (msgspec.MsgspecError, ValueError, RecursionError) as error:
            raise ServerError(
                f"the server at {self.url} sent no {kind.__name__} ({error}); is it another one?"
            ) from error


def _sentence(content: bytes) -> str:
    try:
        return msgspec.msgpack.decode(content, type=Problem).sentence[:500]
    except (msgspec.MsgspecError, ValueError, RecursionError):
        return "it does not say why"


def remote_of(argument: str) -> Callable[[], RemotePerception]:
    """Return what makes perceptions by a server's address; raises InvalidInputError where that is none."""
    scheme, _, rest = argument.partition("://")
    if scheme not in ("http", "https") or not rest.strip("/") or any(c.isspace() for c in argument):
        raise InvalidInputError(
            f"perception 'remote' needs the address of a server, such as remote:http://127.0.0.1:8712, got '{argument}'"
        )
    return partial(RemotePerception, argument)


REMOTE = Family("what 'uniteam serve-perception' serves on another machine", "URL", "http://127.0.0.1:8712", remote_of)
