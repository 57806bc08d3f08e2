"""A perception for other machines: one HTTP server, a perception for each episode that somebody plays."""

import hmac
import logging
from collections import OrderedDict
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Lock

import msgspec

from uniteam.errors import InvalidInputError, UniteamError
from uniteam.interface import Instruction, Perception, Segmentation
from uniteam.mind.perception.detectors.remote import MOST_BYTES
from uniteam.mind.perception.detectors.remote_messages import (
    PROTOCOL,
    Frame,
    Health,
    Problem,
    observation_of,
    seen_of,
)
from uniteam.mind.perception.registry import make_perception, needs_truth

MOST_SESSIONS = 64
"""Episodes that are played at once; the one that has been quiet longest is forgotten beyond that."""
QUIET_SECONDS = 60.0
"""s; a connection over which nothing comes for so long is closed."""

_log = logging.getLogger(__name__)


class Sessions:
    """A perception for each episode that is being played; one frame at a time is looked at."""

    def __init__(self, perception: str) -> None:
        """Make the first perception, so that what it needs is loaded; raises UniteamError where it cannot be made."""
        if needs_truth(perception):
            raise InvalidInputError(
                f"perception '{perception}' needs the simulator's truth, which is not sent to servers; serve another"
            )
        self._perception = perception
        self._spare: Perception | None = make_perception(perception)
        self._open: OrderedDict[str, Perception] = OrderedDict()
        self._lock = Lock()

    def perceive(self, frame: Frame) -> Segmentation:
        """Return what a session's perception sees; an unknown session is begun anew."""
        observation = observation_of(frame)
        with self._lock:
            if frame.session not in self._open:
                self._begin(frame)
            self._open.move_to_end(frame.session)
            return self._open[frame.session].perceive(observation)

    def _begin(self, frame: Frame) -> None:
        new, self._spare = self._spare or make_perception(self._perception), None
        new.reset(Instruction(*frame.instruction), frame.seed)
        self._open[frame.session] = new
        if len(self._open) > MOST_SESSIONS:
            self._open.popitem(last=False)


class PerceptionServer(ThreadingHTTPServer):
    """Answers `GET /health` and `POST /perceive`, in the messages of `remote_messages`."""

    daemon_threads = True

    def __init__(self, address: tuple[str, int], perception: str, version: str, token: str = "") -> None:
        """Make the perception and bind the address.

        Args:
            address: host and port; port 0 takes a free one.
            perception: what to serve, by name or reference.
            version: of the package, for those who ask.
            token: what callers must show; nothing where it is empty.

        Raises:
            UniteamError: the perception cannot be made, or needs the truth.
            OSError: the address cannot be had.
        """
        self.health = Health(PROTOCOL, perception, version)
        self.token = token
        self.sessions = Sessions(perception)
        super().__init__(address, _Handler)

    def handle_error(self, request: object, client_address: object) -> None:
        """Keep a line where a caller has gone away; UNITEAM_LOG=debug shows it."""
        _log.debug("the connection of %s broke off", client_address, exc_info=True)

    @property
    def url(self) -> str:
        """Where it can be reached."""
        return f"http://{self.server_address[0]!s}:{self.server_address[1]}"


class _Handler(BaseHTTPRequestHandler):
    server: PerceptionServer
    protocol_version = "HTTP/1.1"
    timeout = QUIET_SECONDS

    def do_GET(self) -> None:
        """Say what is served."""
        if self._is_welcome():
            self._answer(200, self.server.health) if self.path == "/health" else self._refuse(404, "ask for /health")

    def do_POST(self) -> None:
        """Look at a frame."""
        if not self._is_welcome():
            return
        length = self.headers.get("Content-Length", "")
        if self.path != "/perceive":
            self._refuse(404, "send frames to /perceive")
        elif not length.isdecimal():
            self._refuse(411, "say how long the frame is, with Content-Length")
        elif int(length) > MOST_BYTES:
            self._refuse(413, f"a frame has at most {MOST_BYTES} bytes")
        else:
            self._perceive(self.rfile.read(int(length)))

    def _perceive(self, body: bytes) -> None:
        try:
            frame = msgspec.msgpack.decode(body, type=Frame)
            self._answer(200, seen_of(self.server.sessions.perceive(frame)))
        except (msgspec.MsgspecError, ValueError, RecursionError, InvalidInputError) as error:
            self._refuse(400, f"this is no frame: {error}")
        except UniteamError as error:
            self._refuse(500, str(error))
        except Exception as error:  # whatever a perception raises is told to whoever asked
            _log.exception("the perception failed")
            self._refuse(500, f"the perception failed with {type(error).__name__}: {error}")

    def _is_welcome(self) -> bool:
        shown = self.headers.get("Authorization", "")
        if not self.server.token or hmac.compare_digest(shown.encode(), f"Bearer {self.server.token}".encode()):
            return True
        self._refuse(401, "set UNITEAM_TOKEN to what it is on the server")
        return False

    def _refuse(self, status: int, sentence: str) -> None:
        self.close_connection = True  # what was sent may not have been read
        self._answer(status, Problem(sentence))

    def _answer(self, status: int, message: msgspec.Struct) -> None:
        content = msgspec.msgpack.encode(message)
        self.send_response(status)
        self.send_header("Content-Type", "application/msgpack")
        self.send_header("Content-Length", str(len(content)))
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *arguments: object) -> None:
        """Keep a line for who looks: UNITEAM_LOG=debug shows it."""
        _log.debug(format, *arguments)
