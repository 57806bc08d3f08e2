"""Film an episode while it is played."""

from pathlib import Path
from types import TracebackType

from uniteam.evaluation.episode_loop import Step
from uniteam.geometry import BasePose
from uniteam.visualization.panel import HEIGHT, THIRD_PERSON_SIZE, WIDTH, PanelContent, draw_panel
from uniteam.visualization.video import FRAMES_PER_SECOND, VideoWriter
from uniteam.world.task.environment import Environment

HOLD_SECONDS = 2


class Film:
    """An observer that draws a panel of each step into an MP4 file."""

    def __init__(self, path: Path, environment: Environment, title: str) -> None:
        """Open the file; raises InvalidInputError or UnwritableError as `VideoWriter` does."""
        self._video = VideoWriter(path, WIDTH, HEIGHT)
        self._environment = environment
        self._title = title
        self._trail: list[BasePose] = []

    def __call__(self, step: Step) -> None:
        """Add a frame; the last one stands still for a while."""
        self._trail.append(step.observation.base_to_start)
        content = PanelContent(
            title=self._title,
            instruction=self._environment.episode.instruction,
            step=step,
            trail=self._trail,
            third_person=self._environment.simulator.render_third_person(*THIRD_PERSON_SIZE),
        )
        self._video.add(
            draw_panel(content), repeat=HOLD_SECONDS * FRAMES_PER_SECOND if self._environment.is_over else 1
        )

    def __enter__(self) -> "Film":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Finish the file, so that it plays to its end where the episode was broken off."""
        self._video.close()
