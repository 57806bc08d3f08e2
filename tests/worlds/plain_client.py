"""A client of the bridge as stretch_ai's is, written from what is known of that: it trusts, and waits without end.

It unpickles whatever comes, takes the fields that stretch_ai's client takes without a default, resends an action until
its number comes back, and waits by the same conditions. It shares no line with the package's own side.
"""

import pickle
import threading
import time
from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import zmq

_STATE = ["base_pose", "ee_pose", "joint_positions", "joint_velocities", "joint_efforts", "control_mode", "at_goal"]
_FLAGS = ["is_homed", "is_runstopped", "step"]
_OBSERVATION = ["rgb", "depth", "camera_K", "rgb_height", "rgb_width", "step", "gps", "compass"]
_LIDAR = ["lidar_points", "lidar_timestamp"]
LIFT, ARM, GRIPPER, ROLL, PITCH, YAW, PAN, TILT = range(3, 11)


class PlainClient:
    """Drives a robot behind four ports."""

    def __init__(self, first_port: int) -> None:
        self._context = zmq.Context()
        self._send = self._context.socket(zmq.PUB)
        self._send.setsockopt(zmq.SNDHWM, 1)
        self._send.connect(f"tcp://127.0.0.1:{first_port + 1}")
        self._done = threading.Event()
        self._newest: dict[str, dict[str, Any]] = {}
        self._threads = []
        for offset, name in ((0, "observation"), (2, "state"), (3, "servo")):
            thread = threading.Thread(target=self._listen, args=(name, first_port + offset))
            thread.start()
            self._threads.append(thread)
        self._iteration = -1
        self.wait(lambda: len(self._newest) == 3, 10.0, "all three kinds of message")
        if not self.state["is_homed"] or self.state["is_runstopped"]:
            raise RuntimeError("the robot is not homed, or is run-stopped")

    @property
    def state(self) -> dict[str, Any]:
        state = self._newest["state"]
        assert all(key in state for key in (*_STATE, *_FLAGS))
        return state

    @property
    def joints(self) -> Any:
        return self.state["joint_positions"]

    def observation(self) -> dict[str, Any]:
        """Return the newest observation, its images unpacked."""
        seen = {key: self._newest["observation"][key] for key in (*_OBSERVATION, *_LIDAR)}
        seen["rgb"] = cv2.imdecode(np.frombuffer(seen["rgb"], np.uint8), cv2.IMREAD_COLOR)
        millimetres = np.asarray(cv2.imdecode(np.frombuffer(seen["depth"], np.uint8), cv2.IMREAD_UNCHANGED))
        seen["depth"] = millimetres / 1000.0
        assert seen["rgb"].shape[:2] == (seen["rgb_width"], seen["rgb_height"])
        return seen

    def servo(self) -> dict[str, Any]:
        servo = self._newest["servo"]
        assert "ee_cam/color_image" not in servo
        image = cv2.imdecode(np.frombuffer(servo["head_cam/color_image"], np.uint8), cv2.IMREAD_COLOR)
        assert image is not None and image.shape == servo["head_cam/color_image/shape"]
        return servo

    def send_action(self, action: dict[str, Any], reliable: bool = True) -> int:
        """Send an action, again and again until its number comes back."""
        acknowledged = max(self.state["step"], self._newest["observation"]["step"])
        self._iteration = max(self._iteration + 1, acknowledged + 1)
        message = {**action, "step": self._iteration}
        self._send.send_pyobj(message)
        began = time.monotonic()
        while reliable and self.state["step"] < self._iteration:
            assert time.monotonic() - began < 20.0, f"{action} was not acknowledged"
            time.sleep(0.01)
            self._send.send_pyobj(message)
        return self._iteration

    def switch_mode(self, mode: str) -> None:
        self.send_action({"control_mode": mode})
        self.wait(lambda: self.state["control_mode"] == mode, 20.0, mode)

    def take_posture(self, posture: str) -> None:
        self.send_action({"posture": posture})
        self.wait(lambda: self.state["control_mode"] == posture, 20.0, posture)

    def move_base_to(self, xyt: Any) -> None:
        self.send_action({"xyt": np.asarray(xyt, float), "nav_relative": False, "nav_blocking": True})
        polls = [0]

        def is_there() -> bool:
            before = self.state["base_pose"]
            time.sleep(0.05)
            after = self.state["base_pose"]
            still = np.abs(after - before).max() < 0.0005
            polls[0] = polls[0] + 1 if still and self.state["at_goal"] else 0
            return polls[0] > 2

        self.wait(is_there, 20.0, "the goal")

    def arm_to(self, joint: list[float], **more: Any) -> None:
        """Move the arm: base x, lift, arm, and of the wrist yaw, pitch, roll."""
        assert self.state["control_mode"] == "manipulation"
        self.send_action({"joint": joint, "manip_blocking": True, **more})

        def is_there() -> bool:
            now = self.joints[[0, LIFT, ARM, YAW, PITCH, ROLL]]
            return bool(np.abs(now - joint).max() < 0.02 and np.linalg.norm(self.state["joint_velocities"]) < 0.01)

        self.wait(is_there, 20.0, "the arm")

    def head_to(self, pan: float, tilt: float) -> None:
        self.send_action({"head_to": [pan, tilt], "manip_blocking": True})
        self.wait(lambda: bool(np.abs(self.joints[[PAN, TILT]] - (pan, tilt)).max() < 0.01), 5.0, "the head")

    def gripper_to(self, angle: float) -> None:
        self.send_action({"gripper": angle, "gripper_blocking": True})

    def wait(self, condition: Callable[[], bool], seconds: float, what: str) -> None:
        began = time.monotonic()
        while not condition():
            if time.monotonic() - began > seconds:
                raise RuntimeError(f"waited for {what} in vain")
            time.sleep(0.01)

    def close(self) -> None:
        self._done.set()
        for thread in self._threads:
            thread.join()
        self._context.destroy(linger=0)

    def _listen(self, name: str, port: int) -> None:
        socket = self._context.socket(zmq.SUB)
        socket.setsockopt(zmq.SUBSCRIBE, b"")
        socket.setsockopt(zmq.CONFLATE, 1)
        socket.connect(f"tcp://127.0.0.1:{port}")
        while not self._done.is_set():
            if socket.poll(50):
                self._newest[name] = pickle.loads(socket.recv())
        socket.close()
