"""A body that plays a recording: it sees again, to the bit, what was seen, whatever agent is asked.

Nothing is simulated. The camera draws the home from the recorded poses, and what it draws is compared with the
checksums of what the agent saw.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError, UniteamError
from uniteam.evaluation.recording.checksums import checksums_of
from uniteam.evaluation.recording.recording import Recording
from uniteam.interface import Action, Observation
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.home_view import HomeView
from uniteam.world.simulation.robot_state import RobotState
from uniteam.world.task.check_action import checked_action
from uniteam.world.task.visible_truth import truth_maker


class OtherActionError(UniteamError):
    """A recording was asked for what comes of an action that was not taken."""


class OtherFrameError(UniteamError):
    """The camera draws other pixels than those that were recorded."""


class RecordedBody:
    """Gives the observations of a recording, one after the other, as long as its own actions are asked for."""

    def __init__(self, recording: Recording, give_truth: bool = False) -> None:
        """Build the home.

        Args:
            recording: what to play.
            give_truth: whether observations carry the simulator's own segmentation, though the recorded ones did not.

        Raises:
            DamagedFileError: the recording's home cannot be built.
        """
        self._recording = recording
        self._objects = _ObjectsAt(recording)
        self._view = HomeView(recording.home, self._objects)
        self._truth_of = truth_maker(recording.home)
        self._give_truth = give_truth
        self._step = 0
        self._has_begun = False

    @property
    def is_over(self) -> bool:
        """Whether every recorded step has been played."""
        return self._step >= len(self._recording.steps)

    def reset(self) -> Observation:
        """Go back to the first step, and look.

        Raises:
            OtherFrameError: the camera does not draw what was recorded.
            InvalidInputError: the recording has no step.
        """
        self._step, self._has_begun = 0, True
        return self._look()

    def step(self, action: Action) -> Observation:
        """Go on to the next step, and look; after the last one, what was there then.

        Raises:
            InvalidActionError: it is no action.
            OtherActionError: it is not the one that was taken at this step.
            OtherFrameError: the camera does not draw what was recorded.
            InvalidInputError: the recording has not begun, or is over.
        """
        wanted = checked_action(action)
        if not self._has_begun or self.is_over:
            raise InvalidInputError("the recording has not begun, or is over; call reset() to play it from the start")
        taken = self._recording.steps[self._step].decision.action
        if wanted != taken:
            raise OtherActionError(
                f"step {self._step} was recorded with {taken}, and {wanted} is asked for; a recording cannot tell what "
                "would have come of that, only a simulation can"
            )
        self._step += 1
        return self._look()

    def frame(self, moment: int) -> Frame:
        """Return what the head camera saw at a moment, drawn again (truth)."""
        self._objects.moment = moment
        return self._view.head(self._state(moment), self._recording.header.camera, {})

    def from_above(self, moment: int, size: tuple[int, int]) -> NDArray[np.uint8]:
        """Return the (H, W, 3) picture of the robot from above at a moment, of size (W, H) (truth)."""
        self._objects.moment = moment
        return self._view.from_above(self._state(moment), size, {})

    def _look(self) -> Observation:
        recorded, moment = self._recording, self._step
        if not recorded.steps:
            raise InvalidInputError(f"in '{recorded.path}' no step was taken, so that there is nothing to play")
        frame, checksums = self.frame(moment), recorded.checksums(moment)
        had_truth = checksums[-1] != 0
        observation = Observation(
            rgb=_locked(frame.rgb),
            depth=_locked(frame.depth),
            camera=recorded.header.camera,
            camera_to_start=_locked(recorded.camera_to_start(moment)),
            base_to_start=recorded.base_to_start(moment),
            joints=recorded.joints(moment),
            is_holding=recorded.is_holding(moment),
            step=moment,
            truth=self._truth_of(frame) if had_truth or self._give_truth else None,
        )
        kept = 3 if had_truth else 2
        if checksums_of(observation)[:kept] != checksums[:kept]:
            raise OtherFrameError(
                f"at step {moment} the camera draws other pixels than were recorded, with uniteam "
                f"{recorded.header.uniteam}; play the recording with the version and on the kind of processor that its "
                "configuration names"
            )
        return observation

    def _state(self, moment: int) -> RobotState:
        return RobotState(self._recording.base_to_world(moment), self._recording.true_joints(moment))


class _ObjectsAt:
    """Where the objects were at a moment, as a `HomeView` asks for it."""

    def __init__(self, recording: Recording) -> None:
        self._track = recording.objects
        self.moment = 0

    @property
    def names(self) -> Sequence[str]:
        return self._track.names

    @property
    def version(self) -> int:
        return self._track.changes_until(self.moment)

    def poses(self) -> NDArray[np.float64]:
        return self._track.all_at(self.moment)


def _locked(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array
