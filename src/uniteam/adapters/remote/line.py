"""The line to one connected agent: what is asked, what is answered, and what goes wrong in between."""

from collections.abc import Iterator
from queue import Empty, Full, Queue, SimpleQueue
from threading import Thread
from typing import TypeVar

from uniteam.adapters.remote.messages import MOST_BYTES, Failed, Message, decode_answer, encode
from uniteam.errors import UniteamError

MOST_AHEAD = 8
"""Messages that may lie unread."""
MOST_WORDS = 10_000
"""Characters of what an agent may say of an error of its own."""

Wanted = TypeVar("Wanted", bound=Message)


class LineError(UniteamError):
    """The conversation cannot go on, so that the agent is hung up on; it may connect again."""


class SilentError(LineError):
    """No answer came in time."""


class HungUpError(LineError):
    """The agent is not there any more."""


class NoAnswerError(LineError):
    """What came is no answer to what was asked."""


class AgentRaisedError(UniteamError):
    """The agent says that it raised an exception; the conversation goes on."""


class Line:
    """Questions go out and answers come in, one for each.

    Attributes:
        fault: why the conversation cannot go on; None as long as it can.
    """

    def __init__(self, incoming: Iterator[bytes]) -> None:
        """Begin to listen."""
        self.fault: LineError | None = None
        self._outbox: SimpleQueue[bytes | None] = SimpleQueue()
        self._inbox: Queue[bytes | None] = Queue(MOST_AHEAD)
        self._is_flooded = False
        Thread(target=self._listen, args=(incoming,), name="listen to an agent", daemon=True).start()

    def outgoing(self) -> Iterator[bytes]:
        """Yield what is to be sent, until the line is closed."""
        return iter(self._outbox.get, None)

    def close(self) -> None:
        """Send what was said, and then nothing more."""
        self._outbox.put(None)

    def hang_up(self) -> None:
        """Take note that the agent is not there any more."""
        self._put(None)
        self.close()

    def tell(self, message: Message) -> None:
        """Say what is not answered."""
        self._outbox.put(encode(message))

    def ask(self, question: Message, wanted: type[Wanted], seconds: float) -> Wanted:
        """Return the answer to a question; raises what `hear` does, and NoAnswerError where one came before it."""
        self._check_calm(not self._inbox.empty() and self._inbox.queue[0] is not None)
        self.tell(question)
        return self.hear(wanted, seconds)

    def hear(self, wanted: type[Wanted], seconds: float) -> Wanted:
        """Return the next message.

        Raises:
            SilentError: none came in so many seconds.
            HungUpError: the agent is not there any more.
            NoAnswerError: it is too long, no message, or of another kind, or far more came than was asked for.
            AgentRaisedError: the agent says that it raised an exception.
        """
        self._check_calm(self._is_flooded)
        try:
            content = self._inbox.get(timeout=seconds)
        except Empty:
            raise self._broken(SilentError(f"the agent did not answer in {seconds:.3g} s")) from None
        if content is None:
            raise self._broken(HungUpError("the agent hung up before it had answered"))
        answer = self._read(content)
        if isinstance(answer, Failed):
            raise _raised(answer)
        if not isinstance(answer, wanted):
            kinds = type(answer).__name__.lower(), wanted.__name__.lower()
            raise self._broken(NoAnswerError("the agent sent the message '{}', expected was '{}'".format(*kinds)))
        return answer

    def _read(self, content: bytes) -> Message:
        if len(content) > MOST_BYTES:
            raise self._broken(
                NoAnswerError(f"the agent sent {len(content)} bytes, and an answer has at most {MOST_BYTES}")
            )
        try:
            return decode_answer(content)
        except ValueError as error:
            raise self._broken(NoAnswerError(f"the agent sent what is no message ({error})")) from error

    def _check_calm(self, is_ahead: bool) -> None:
        if is_ahead:
            raise self._broken(NoAnswerError("the agent answered before it was asked; let it answer once a question"))

    def _broken(self, fault: LineError) -> LineError:
        self.fault = fault
        return fault

    def _listen(self, incoming: Iterator[bytes]) -> None:
        """Take in what comes, until too much of it lies unread."""
        try:
            while self._put(next(incoming)):
                pass
        except Exception:  # gRPC raises an exception of no class of its own where a stream breaks off
            self._put(None)

    def _put(self, content: bytes | None) -> bool:
        try:
            self._inbox.put_nowait(content)
        except Full:
            self._is_flooded = True
            return False
        return True


def _raised(failed: Failed) -> AgentRaisedError:
    error = AgentRaisedError(f"the agent raised {failed.sentence[:MOST_WORDS]}")
    if failed.traceback:
        error.add_note(f"On the agent's side:\n{failed.traceback[-MOST_WORDS:]}")
    return error
