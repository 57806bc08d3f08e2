"""A task in the homes of a split, as a Gymnasium environment."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.gymnasium.controls import Controls
from uniteam.adapters.gymnasium.draw import Draw
from uniteam.adapters.gymnasium.labels import labels_of
from uniteam.adapters.gymnasium.sensors import Scene
from uniteam.adapters.gymnasium.task import Referee, Task
from uniteam.adapters.gymnasium.tasks.grasp import GAZE, PICK
from uniteam.adapters.gymnasium.tasks.navigate import NAVIGATE_TO_OBJECT, NAVIGATE_TO_RECEPTACLE
from uniteam.adapters.gymnasium.tasks.place import PLACE
from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import PinholeCamera
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF, HEAD_CAMERA_SMALL
from uniteam.world.task.episode import Split

SKILLS: Mapping[str, Task] = {
    task.name: task for task in (NAVIGATE_TO_OBJECT, GAZE, PICK, NAVIGATE_TO_RECEPTACLE, PLACE)
}
CAMERAS: Mapping[str, PinholeCamera] = {
    "small": HEAD_CAMERA_SMALL,
    "half": HEAD_CAMERA_HALF,
    "full": HEAD_CAMERA_FULL,
}

Observation = dict[str, Any]


class TaskEnv(gymnasium.Env[Observation, Any]):
    """A robot in a home, and what is to be learned there.

    `info` holds the instruction in words, the ids of the episode and its home, `is_success`, and the task's measures.

    Attributes:
        task: what is to be learned.
        controls: what an action means.
        render_mode: "rgb_array" shows what the head camera sees, "third_person" the robot from above.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array", "third_person"], "render_fps": 10}  # noqa: RUF012

    def __init__(
        self,
        task: str | Task,
        split: str | Path | Split = "train",
        camera: str = "small",
        actions: str | None = None,
        episodes_per_home: int = 16,
        render_mode: str | None = None,
    ) -> None:
        """Take the task and the split; the first home is opened by `reset`.

        Args:
            task: a skill's name, or a task.
            split: a split's name, its file, or itself.
            camera: "small" (120 wide, 160 high), "half" (240, 320) or "full" (480, 640).
            actions: one of the task's controls by name; the task's usual ones where none is given.
            episodes_per_home: how many episodes are drawn of a home before another is opened.
            render_mode: "rgb_array", "third_person" or None.

        Raises:
            UnknownNameError: there is no such skill, split, camera or way to act.
            InvalidInputError: no such render mode, or no episodes for a home.
        """
        self.task = task if isinstance(task, Task) else _named("skill", task, SKILLS)
        self.render_mode = _render_mode(render_mode, self.metadata["render_modes"])
        self._camera = _named("camera", camera, CAMERAS)
        self.controls: Controls = _named("way to act", actions or next(iter(self.task.controls)), self.task.controls)
        self._draw = Draw(split, self._camera, episodes_per_home)
        self.action_space = self.controls.space
        self.observation_space = gymnasium.spaces.Dict({s.name: s.space(self._camera) for s in self.task.sensors})
        self._scene: Scene | None = None
        self._steps = 0

    @property
    def _max_episode_steps(self) -> int:
        """After how many steps an episode is truncated, where some libraries look for it."""
        return self.task.most_steps

    @property
    def episode_ids(self) -> tuple[str, ...]:
        """The episodes of the split, which `reset(options={"episode_id": id})` plays."""
        return tuple(episode.id for episode in self._draw.split.episodes)

    @property
    def task_description(self) -> str:
        """The instruction of the present episode; empty before the first."""
        return "" if self._scene is None else str(self._scene.episode.instruction)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin an episode; the same seed begins the same ones.

        Args:
            seed: of all chance from now on.
            options: `{"episode_id": id}` plays one episode of the split; where its skill begins is still drawn.

        Raises:
            UnknownNameError: the split has no such episode.
        """
        super().reset(seed=seed)
        if seed is not None:
            self._draw.restart()
        wanted = (options or {}).get("episode_id")
        episode = self._draw.any(self.np_random) if wanted is None else self._draw.named(wanted)
        place = self._draw.open(episode)
        self._referee: Referee = self.task.begin(place, episode, self.np_random)
        labels = labels_of(place.home, episode.instruction)
        self._scene = Scene(place.simulator, episode, place.simulator.base, labels)
        self._steps, self._is_over = 0, False
        return self._observation(), self._info(False)

    def step(self, action: Any) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Do an action.

        Raises:
            InvalidActionError: it is none; nothing has moved.
            InvalidInputError: no episode has begun, or it is over.
        """
        simulator = self._begun().simulator
        wanted = self.controls.read(action, simulator.joints, simulator.held is not None)
        events = simulator.apply(wanted, self._referee.grasp_rule)
        verdict = self._referee.judge(wanted, events)
        self._steps += 1
        is_cut = not verdict.is_over and self._steps >= self.task.most_steps
        self._is_over = verdict.is_over or is_cut
        return self._observation(), float(verdict.reward), verdict.is_over, is_cut, self._info(verdict.is_success)

    def render(self) -> NDArray[np.uint8] | None:
        """Return the (H, W, 3) picture of the render mode; None without one."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() shows nothing without a render mode; give make() one")
            return None
        if self._scene is None:
            raise InvalidInputError("no episode has begun; call reset() before render()")
        simulator = self._scene.simulator
        return simulator.render().rgb.copy() if self.render_mode == "rgb_array" else simulator.render_third_person()

    def _begun(self) -> Scene:
        if self._scene is None:
            raise InvalidInputError("no episode has begun; call reset() before the first step")
        if self._is_over:
            raise InvalidInputError(f"the episode is over after {self._steps} steps; call reset() to begin another")
        return self._scene

    def _observation(self) -> Observation:
        scene = self._scene
        assert scene is not None, "reset has made it"
        return {sensor.name: sensor.read(scene) for sensor in self.task.sensors}

    def _info(self, is_success: bool) -> dict[str, Any]:
        scene = self._scene
        assert scene is not None, "reset has made it"
        return {
            "instruction": str(scene.episode.instruction),
            "episode_id": scene.episode.id,
            "home": scene.episode.home,
            "is_success": bool(is_success),
            **self._referee.measures(),
        }


def _named(kind: str, name: str, known: Mapping[str, Any]) -> Any:
    if name not in known:
        raise UnknownNameError(kind, str(name), known)
    return known[name]


def _render_mode(mode: str | None, known: list[str]) -> str | None:
    if mode is not None and mode not in known:
        raise InvalidInputError(f"there is no render mode '{mode}'; there are {', '.join(known)}")
    return mode
