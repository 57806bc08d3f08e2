"""What a server of episodes and an agent say to each other, as MessagePack in one gRPC stream.

The agent says `Hello` and is told `Welcome`. It says `Next`, and an episode begins, in which the server asks and the
agent answers, once for each question: `Reset` with `Ready`, `Observe` with `Decide`, either of them with `Failed` where
the agent raised. `Over` ends the episode, and the agent says `Next` again, until it is told `Done`. A message is
checked as it is read; nothing in it can be run.
"""

from typing import TypeVar

import msgspec

from uniteam.errors import InvalidActionError
from uniteam.interface import (
    Action,
    BaseDisplacement,
    Decision,
    DiscreteAction,
    Instruction,
    JointDisplacement,
    Joints,
    Observation,
)
from uniteam.mind.perception.detectors.remote_messages import Frame, Seen, frame_of, seen_of

PROTOCOL = 1
"""Of these messages; two sides of different ones do not understand each other."""
SERVICE, METHOD = "uniteam.Environment", "Play"
"""The gRPC service and its one method: a stream of answers in, a stream of questions out."""
MOST_BYTES = 64 * 1024
"""Of an answer; a longer one is no answer."""


class Message(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag=str.lower):
    """A message says of which kind it is, and holds the fields of its kind and no others."""


class Hello(Message, frozen=True):
    """The agent's first word: which messages it understands."""

    protocol: int


class Next(Message, frozen=True):
    """The agent wants another episode; one that leaves instead has lost none."""


class Ready(Message, frozen=True):
    """The agent has begun the episode."""


class Discrete(Message, frozen=True):
    """One of the discrete actions, by its value in `DiscreteAction`."""

    name: str


class Base(Message, frozen=True):
    """A displacement of the base: x and y (m, base frame) and heading (rad)."""

    x: float
    y: float
    heading: float


class Arm(Message, frozen=True):
    """Displacements of the seven joints in the order of `Joints`, and of the base as `Base` has it."""

    delta: tuple[float, float, float, float, float, float, float]
    base: tuple[float, float, float]


class Decide(Message, frozen=True):
    """What the agent wants done, and why."""

    action: Discrete | Base | Arm
    state: str
    reason: str


class Failed(Message, frozen=True):
    """The agent raised: what, in a sentence, and where."""

    sentence: str
    traceback: str = ""


class Welcome(Message, frozen=True):
    """What the server says of itself, and how many episodes are left to be played."""

    protocol: int
    version: str
    split: str
    remaining: int


class Reset(Message, frozen=True):
    """An episode begins: object, start receptacle, goal receptacle, and what fixes every random choice."""

    instruction: tuple[str, str, str]
    seed: int


class Observe(Message, frozen=True):
    """What the robot sees and feels; the truth only in a run whose perception is `truth`."""

    frame: Frame
    truth: Seen | None = None


class Over(Message, frozen=True):
    """An episode has ended: its id, its measures under the challenge's names, and why it is no overall success."""

    episode: str
    measures: dict[str, bool | int | float]
    failure: str


class Done(Message, frozen=True):
    """Nothing is left to be played."""


Answer = Hello | Next | Ready | Decide | Failed
Given = TypeVar("Given", bound=Message)

_encoder, _decoder = msgspec.msgpack.Encoder(), msgspec.msgpack.Decoder(Answer)


def encode(message: Message) -> bytes:
    """Return a message as it is sent."""
    return _encoder.encode(message)


def decode_answer(content: bytes) -> Answer:
    """Return an agent's message; raises ValueError where it is none."""
    try:
        return _decoder.decode(content)
    except RecursionError as error:
        raise ValueError("it is nested too deeply") from error


def reset_of(instruction: Instruction, seed: int) -> Reset:
    """Return the question with which an episode begins."""
    return Reset((instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle), seed)


def observe_of(instruction: Instruction, seed: int, observation: Observation) -> Observe:
    """Return the question what to do upon an observation."""
    truth = None if observation.truth is None else seen_of(observation.truth)
    return Observe(frame_of("", instruction, seed, observation), truth)


def decision_of(decided: Decide) -> Decision:
    """Return a decision; raises InvalidActionError where it names no action."""
    return Decision(_action(decided.action), decided.state, decided.reason)


def _action(action: Discrete | Base | Arm) -> Action:
    if isinstance(action, Base):
        return BaseDisplacement(action.x, action.y, action.heading)
    if isinstance(action, Arm):
        return JointDisplacement(Joints(*action.delta), BaseDisplacement(*action.base))
    try:
        return DiscreteAction(action.name)
    except ValueError as error:
        names = ", ".join(one.value for one in DiscreteAction)
        raise InvalidActionError(
            f"there is no action '{action.name[:50]}'; the discrete actions are {names}"
        ) from error
