"""The gRPC server that agents connect to: one stream for each, and so many at once as there are seats."""

import hmac
import logging
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from threading import BoundedSemaphore, Thread
from types import TracebackType
from typing import Any

from uniteam.adapters.remote.desk import Notice
from uniteam.adapters.remote.line import HungUpError, Line, LineError, NoAnswerError, SilentError
from uniteam.adapters.remote.messages import METHOD, SERVICE
from uniteam.adapters.remote.session import OtherProtocolError, Stage, notice_of, play_session
from uniteam.errors import UnavailableError
from uniteam.mind.perception.detectors.weights import import_library

EXTRA = "serve"
SPARE = 4
"""Connections beyond the seats that can be told at once why they are refused."""
SEAT_SECONDS = 5.0
"""s that an agent waits for a seat: its own from before, which it left without a word, is free by then."""
MOST_RECEIVED = 4 * 1024 * 1024
"""Bytes of a message that gRPC does not take in; shorter ones are refused with a sentence of ours."""
LAST_WORDS = 5.0
"""s that the last messages of a run have to reach the agents."""

_STATUS: dict[type[LineError], str] = {
    SilentError: "DEADLINE_EXCEEDED",
    HungUpError: "CANCELLED",
    NoAnswerError: "INVALID_ARGUMENT",
    OtherProtocolError: "FAILED_PRECONDITION",
}
"""By which gRPC status an agent is told why it is hung up on."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Place:
    """Where a server listens, and who may come.

    Attributes:
        host: the address to listen at.
        port: the port; 0 for any that is free.
        seats: how many agents may play at once.
        token: what agents must show; nothing where it is empty.
    """

    host: str = "127.0.0.1"
    port: int = 0
    seats: int = 1
    token: str = ""


class AgentServer:
    """Listens from the beginning on, and plays once it is given a stage. Use it in a `with`.

    Attributes:
        address: HOST:PORT that agents connect to.
    """

    def __init__(self, place: Place) -> None:
        """Bind the address; raises UnavailableError where it, or grpcio, cannot be had."""
        self._grpc = import_library("grpc", EXTRA)
        self._place, self._free = place, BoundedSemaphore(place.seats)
        room = place.seats + SPARE
        options = (
            ("grpc.so_reuseport", 0),
            ("grpc.max_receive_message_length", MOST_RECEIVED),
            ("grpc.max_send_message_length", -1),
        )
        self._server = self._grpc.server(ThreadPoolExecutor(room), maximum_concurrent_rpcs=room, options=options)
        try:
            port = self._server.add_insecure_port(f"{place.host}:{place.port}")
        except RuntimeError as error:
            raise UnavailableError(
                f"{place.host}:{place.port} cannot be listened at; choose another --host or --port"
            ) from error
        self.address = f"{place.host}:{port}"

    def __enter__(self) -> "AgentServer":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._server.stop(LAST_WORDS if kind is None else 0.0).wait()

    def play(self, stage: Stage) -> None:
        """Let agents in."""
        handler = self._grpc.stream_stream_rpc_method_handler(_Door(self._grpc, stage, self._place.token, self._free))
        self._server.add_generic_rpc_handlers((self._grpc.method_handlers_generic_handler(SERVICE, {METHOD: handler}),))
        self._server.start()


class _Door:
    """What gRPC calls for each agent that connects: it yields what the agent is told."""

    def __init__(self, grpc: Any, stage: Stage, token: str, free: BoundedSemaphore) -> None:
        self._grpc, self._stage, self._token, self._free = grpc, stage, token, free

    def __call__(self, incoming: Iterator[bytes], context: Any) -> Iterator[bytes]:
        if not self._is_welcome(context):
            context.abort(self._grpc.StatusCode.UNAUTHENTICATED, "set UNITEAM_TOKEN to what it is on the server")
        if not self._free.acquire(timeout=SEAT_SECONDS):
            context.abort(
                self._grpc.StatusCode.RESOURCE_EXHAUSTED,
                "as many agents play already as this server lets in at once; wait for one to end, "
                "or start the server with more --seats",
            )
        line = Line(incoming)
        session = _Session(line, self._stage, _peer(context), self._free.release)
        if not context.add_callback(line.hang_up):  # it has hung up already
            line.hang_up()
        Thread(target=session.run, name="play with an agent", daemon=True).start()
        yield from line.outgoing()
        if line.fault is not None:
            context.abort(getattr(self._grpc.StatusCode, _STATUS[type(line.fault)]), str(line.fault)[:1000])

    def _is_welcome(self, context: Any) -> bool:
        shown = str(dict(context.invocation_metadata()).get("authorization", ""))
        return not self._token or hmac.compare_digest(shown.encode(), f"Bearer {self._token}".encode())


@dataclass(frozen=True)
class _Session:
    """One agent's visit, in a thread of its own."""

    line: Line
    stage: Stage
    peer: str
    leave: Callable[[], None]

    def run(self) -> None:
        """Play, and report what is wrong."""
        events = self.stage.desk.events
        events.put(Notice(f"{self.peer} has connected"))
        try:
            play_session(self.line, self.stage)
        except LineError as fault:
            self.line.fault = fault
            events.put(notice_of(fault, self.peer))
        except BaseException as error:  # no agent is at fault: the run ends with it
            _log.debug("a session failed", exc_info=True)
            events.put(error)
        finally:
            self.leave()
            self.line.close()


def _peer(context: Any) -> str:
    return f"the agent at {str(context.peer()).removeprefix('ipv4:').removeprefix('ipv6:')}"
