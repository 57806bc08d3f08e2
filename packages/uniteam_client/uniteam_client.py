"""Have an agent evaluated by `uniteam serve`, from any Python from 3.8 on and any machine that reaches it.

    import uniteam_client

    class Spinner:
        def reset(self, instruction, seed):
            print("asked to:", instruction)

        def act(self, observation):
            return "turn_left" if observation.step < 12 else "stop"

    uniteam_client.play(Spinner(), "127.0.0.1:8085")

This file, numpy, msgpack and grpcio are all that is needed: install it, or copy it. Nothing in a message can be run.

The frames are right-handed, lengths in m, angles in rad. `start` is the robot's base when the episode begins: x
forward, y left, z up, origin on the floor. `base` moves with the robot. `camera` is OpenCV's: x right, y down, z
forward.
"""

from __future__ import annotations

import logging
import os
import queue
import time
import traceback
from dataclasses import astuple, dataclass
from typing import Any, Callable, Union

import grpc
import msgpack
import numpy as np

PROTOCOL = 1
METHOD = "/uniteam.Environment/Play"
TOKEN = "UNITEAM_TOKEN"

DISCRETE_ACTIONS = (
    "stop",
    "move_forward",
    "turn_left",
    "turn_right",
    "navigation_mode",
    "manipulation_mode",
    "extend_arm",
    "snap_object",
    "desnap_object",
    "empty_action",
)
"""The challenge's discrete actions: 0.25 m ahead, 30 degrees to the left or right, postures, the gripper."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Instruction:
    """Move `object_category` from `start_receptacle` to `goal_receptacle`; the receptacles are classes of furniture."""

    object_category: str
    start_receptacle: str
    goal_receptacle: str

    def __str__(self) -> str:
        words = [word.replace("_", " ") for word in astuple(self)]
        return "Move {} from {} to {}".format(*words)


@dataclass(frozen=True)
class Camera:
    """Intrinsics in pixels; the centre of the upper left pixel is (0, 0)."""

    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float


@dataclass(frozen=True)
class BasePose:
    """A pose on the floor: x and y (m), and heading (rad, left-positive)."""

    x: float
    y: float
    heading: float


@dataclass(frozen=True)
class Joints:
    """Positions or displacements of Stretch's joints: lift and arm extension in m, the others in rad."""

    lift: float = 0.0
    arm: float = 0.0
    wrist_yaw: float = 0.0
    wrist_pitch: float = 0.0
    wrist_roll: float = 0.0
    head_pan: float = 0.0
    head_tilt: float = 0.0


@dataclass(frozen=True)
class Segmentation:
    """The simulator's own segmentation: (H, W) int16 indices into `names`, -1 where nothing has a name."""

    instances: np.ndarray
    names: tuple[str, ...]


@dataclass(frozen=True)
class Observation:
    """What the robot knows at one step.

    Attributes:
        rgb: (H, W, 3) uint8, read-only.
        depth: (H, W) float32, m along the optical axis, read-only; 0 where nothing returned (beyond 10 m).
        camera: intrinsics of both images.
        camera_to_start: (4, 4) float64.
        base_to_start: exact localisation, relative to where the episode began.
        joints: where the joints are.
        is_holding: whether the gripper feels something between its fingers.
        step: how many steps have been taken.
        truth: None unless the server was started with --perception truth.
    """

    rgb: np.ndarray
    depth: np.ndarray
    camera: Camera
    camera_to_start: np.ndarray
    base_to_start: BasePose
    joints: Joints
    is_holding: bool
    step: int
    truth: Segmentation | None


@dataclass(frozen=True)
class BaseDisplacement:
    """Move the base: x forward and y left (m, base frame), then turn by heading (rad, left-positive).

    Less than 0.1 m or 5 degrees is not done, more than 1 m or 180 degrees is cut.
    """

    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0


@dataclass(frozen=True)
class JointDisplacement:
    """Move the joints by `delta`, after a displacement of the base; they stop at their limits."""

    delta: Joints
    base: BaseDisplacement = BaseDisplacement()


Action = Union[str, BaseDisplacement, JointDisplacement]
"""One of `DISCRETE_ACTIONS`, or a displacement."""


@dataclass(frozen=True)
class Decision:
    """An action, the state of whoever decided ("FIND_OBJECT"), and a sentence of why; for results and recordings."""

    action: Action
    state: str = "REMOTE"
    reason: str = "the agent did not say why"


@dataclass(frozen=True)
class Episode:
    """What an episode came to: its id, its measures under the challenge's names, and why it is no overall success."""

    id: str
    measures: dict[str, Any]
    failure: str


class ServerError(Exception):
    """The server is not there, refuses, or says what this file does not understand."""


def play(
    agent: Any,
    address: str = "127.0.0.1:8085",
    token: str | None = None,
    wait: float = 60.0,
    on_episode: Callable[[Episode], None] = lambda episode: None,
) -> list[Episode]:
    """Play episodes until the server has no more, and return what they came to.

    Where the agent raises, the episode counts as failed, the traceback is logged here and kept there, and the next
    episode begins. Where it was too slow or the connection broke, it is connected again.

    Args:
        agent: has `reset(instruction, seed)`, after which it remembers nothing, and `act(observation)`, which returns
            an action or a `Decision`.
        address: HOST:PORT of the server.
        token: what the server asks for; the environment variable UNITEAM_TOKEN where none is given.
        wait: how long the server may be away (s), at first and in between.
        on_episode: is told of each episode as it ends.

    Raises:
        ServerError: the server stays away, or refuses; it says why.
    """
    shown = os.environ.get(TOKEN, "") if token is None else token
    options = [
        ("grpc.max_receive_message_length", -1),
        ("grpc.enable_http_proxy", 0),  # observations are large, and the server is near
        ("grpc.max_reconnect_backoff_ms", 2000),
    ]
    played: list[Episode] = []
    visit = _Visit(agent, [("authorization", "Bearer " + shown)] if shown else [], played, on_episode)
    channel = grpc.insecure_channel(address, options=options)
    try:
        while not visit.is_done:
            _wait_for(channel, address, wait)
            _play_on(visit, channel, address)
    finally:
        channel.close()
    return played


def _wait_for(channel: Any, address: str, wait: float) -> None:
    try:
        grpc.channel_ready_future(channel).result(timeout=wait)
    except grpc.FutureTimeoutError:
        raise ServerError(f"nobody answers at {address} in {wait:g} s; see that 'uniteam serve' runs there") from None


def _play_on(visit: _Visit, channel: Any, address: str) -> None:
    """Play until the line breaks; raises ServerError where it is of no use to connect again."""
    visit.was_welcome = False
    try:
        visit.play(channel.stream_stream(METHOD))
    except grpc.RpcError as error:
        code = error.code()
        sentence = f"{address}: {error.details()}"
        is_passing = code in (grpc.StatusCode.DEADLINE_EXCEEDED, grpc.StatusCode.UNAVAILABLE, grpc.StatusCode.CANCELLED)
        if not (is_passing and visit.was_welcome):
            raise ServerError(sentence) from error
        _log.warning("%s; connecting again", sentence)
        time.sleep(0.2)


class _Visit:
    """One agent and what it has played; `play` is one connection of it."""

    def __init__(
        self,
        agent: Any,
        metadata: list[tuple[str, str]],
        played: list[Episode],
        on_episode: Callable[[Episode], None],
    ) -> None:
        self.is_done = self.was_welcome = False
        self._agent, self._metadata, self._played, self._on_episode = agent, metadata, played, on_episode

    def play(self, connect: Callable[..., Any]) -> None:
        """Answer what is asked until the server is done; raises grpc.RpcError where the line breaks."""
        answers: queue.Queue[bytes | None] = queue.Queue()
        call = connect(iter(answers.get, None), metadata=self._metadata)
        answers.put(_pack("hello", protocol=PROTOCOL))
        try:
            for content in call:
                answer = self._answer(_unpack(content))
                if answer is not None:
                    answers.put(answer)
        finally:
            answers.put(None)
            call.cancel()
        if not self.is_done:
            raise ServerError("the server ended the conversation before it was done")

    def _answer(self, message: dict[str, Any]) -> bytes | None:
        kind = message.get("kind")
        if kind == "reset":
            return _attempt(lambda: self._reset(message))
        if kind == "observe":
            return _attempt(lambda: _pack_decision(self._agent.act(_observation(message))))
        if kind == "welcome":
            self._welcome(message)
            return _pack("next")
        if kind == "over":
            self._take_in(Episode(message["episode"], message["measures"], message["failure"]))
            return _pack("next")
        if kind != "done":
            raise ServerError(f"the server sent a message of the unknown kind {kind!r}")
        self.is_done = True
        return None

    def _take_in(self, episode: Episode) -> None:
        self._played.append(episode)
        self._on_episode(episode)

    def _welcome(self, message: dict[str, Any]) -> None:
        if message["protocol"] != PROTOCOL:
            raise ServerError(
                "the server (uniteam {}) speaks version {} of the messages and this file version {}; take the "
                "uniteam_client.py of that uniteam".format(message["version"], message["protocol"], PROTOCOL)
            )
        self.was_welcome = True

    def _reset(self, message: dict[str, Any]) -> bytes:
        self._agent.reset(Instruction(*message["instruction"]), message["seed"])
        return _pack("ready")


def _attempt(answer: Callable[[], bytes]) -> bytes:
    """Return the answer, or that the agent raised."""
    try:
        return answer()
    except Exception as error:
        _log.exception("the agent raised, and the episode counts as failed")
        sentence = f"{type(error).__name__}: {error}"
        return _pack("failed", sentence=_text(sentence), traceback=_text(traceback.format_exc()[-8000:]))


def _observation(message: dict[str, Any]) -> Observation:
    frame = message["frame"]
    shape = (frame["height"], frame["width"])
    return Observation(
        rgb=np.frombuffer(frame["rgb"], np.uint8).reshape((*shape, 3)),
        depth=np.frombuffer(frame["depth"], "<f4").reshape(shape),
        camera=Camera(shape[1], shape[0], *frame["intrinsics"]),
        camera_to_start=np.array(frame["camera_to_start"], np.float64).reshape(4, 4),
        base_to_start=BasePose(*frame["base_to_start"]),
        joints=Joints(*frame["joints"]),
        is_holding=frame["is_holding"],
        step=frame["step"],
        truth=_segmentation(message["truth"], shape),
    )


def _segmentation(seen: dict[str, Any] | None, shape: tuple[int, int]) -> Segmentation | None:
    if seen is None:
        return None
    names = tuple(thing["candidates"][0][0] for thing in seen["detections"])
    return Segmentation(np.frombuffer(seen["instances"], "<i2").reshape(shape), names)


def _pack_decision(decided: Action | Decision) -> bytes:
    decision = decided if isinstance(decided, Decision) else Decision(decided)
    return _pack("decide", action=_action(decision.action), state=_text(decision.state), reason=_text(decision.reason))


def _action(action: Action) -> dict[str, Any]:
    if isinstance(action, str):
        return {"kind": "discrete", "name": action}
    if isinstance(action, BaseDisplacement):
        x, y, heading = _numbers(action)
        return {"kind": "base", "x": x, "y": y, "heading": heading}
    if isinstance(action, JointDisplacement):
        return {"kind": "arm", "delta": _numbers(action.delta), "base": _numbers(action.base)}
    raise TypeError(
        "an agent's act must return one of {}, a BaseDisplacement, a JointDisplacement or a Decision, got {}".format(
            ", ".join(DISCRETE_ACTIONS), type(action).__name__
        )
    )


def _numbers(given: BaseDisplacement | Joints) -> list[float]:
    return [float(number) for number in astuple(given)]


def _text(text: str) -> str:
    """Return text that can be sent, whatever it holds."""
    return str(text).encode(errors="replace").decode()


def _pack(kind: str, **content: Any) -> bytes:
    packed: bytes = msgpack.packb({"kind": kind, **content})
    return packed


def _unpack(content: bytes) -> dict[str, Any]:
    message = msgpack.unpackb(content)
    if not isinstance(message, dict):
        raise ServerError("the server sent what is no message; is it another one?")
    return message
