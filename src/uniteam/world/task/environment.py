"""Playing episodes in one home: actions in, observations out, and the measures kept apart from what the agent sees."""

from typing import Any, NoReturn

from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import PinholeCamera, invert_transform
from uniteam.interface import Action, DiscreteAction, Observation
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.step_events import NOTHING, StepEvents
from uniteam.world.task.check_action import checked_action
from uniteam.world.task.check_episode import episode_problems
from uniteam.world.task.episode import MAXIMUM_STEPS, Episode
from uniteam.world.task.grasp_rules import EpisodeGraspRule, challenge
from uniteam.world.task.judge import Judge
from uniteam.world.task.measures import Measures
from uniteam.world.task.visible_truth import truth_maker


class Environment:
    """A home that is compiled once, and one episode after the other in it.

    It cannot be pickled: send the home and the episode, and make an environment of them in the other process.

    Attributes:
        home: where the episodes take place.
        episode: what is asked at present.
        camera: the head camera's intrinsics.
        simulator: the truth, for the oracle and for whoever watches.
        events: what came of the last step.
    """

    def __init__(
        self,
        home: Home,
        episode: Episode,
        camera: PinholeCamera = HEAD_CAMERA_HALF,
        give_truth: bool = False,
        grasp: EpisodeGraspRule = challenge,
    ) -> None:
        """Compile the home, for its first episode.

        Args:
            home: where the episodes take place.
            episode: what is asked.
            camera: the head camera's intrinsics.
            give_truth: whether observations carry the simulator's own segmentation.
            grasp: which object the gripper takes when it snaps.

        Raises:
            InvalidInputError: the episode cannot be played in this home.
        """
        _check(episode, home)
        self.home = home
        self.camera = camera
        self.simulator = Simulator(home, camera)
        self._truth_of = truth_maker(home) if give_truth else _no_truth
        self._grasp = grasp
        self._take(episode)

    def __reduce__(self) -> NoReturn:
        raise TypeError(
            "an Environment cannot be pickled or copied: send its home and episode, and make one of them there"
        )

    def reset(self, episode: Episode | None = None) -> Observation:
        """Put the robot at the start and every object back, forget the measures, and look.

        Args:
            episode: of the same home, to be played from now on; the present one where none is given.

        Raises:
            InvalidInputError: the episode cannot be played in this home.
        """
        if episode is not None and episode != self.episode:
            _check(episode, self.home)
        self._take(self.episode if episode is None else episode)
        self._has_begun = True
        return self._observation(self.simulator.render())

    def step(self, action: Action) -> Observation:
        """Do one action and look.

        Raises:
            InvalidActionError: it is no action, or a number of it is none or not finite; nothing has moved.
            InvalidInputError: the episode has not begun, or is over.
        """
        wanted = checked_action(action)
        if not self._has_begun:
            raise InvalidInputError(f"episode '{self.episode.id}' has not begun; call reset() before the first step")
        if self.is_over:
            raise InvalidInputError(
                f"episode '{self.episode.id}' is over after {self.measures.num_steps} steps; call reset() to play again"
            )
        self.events: StepEvents = self.simulator.apply(wanted, self._grasp_rule)
        frame = self.simulator.render()
        self._judge.update(self.simulator, self.events, frame, stopped=wanted is DiscreteAction.STOP)
        return self._observation(frame)

    @property
    def measures(self) -> Measures:
        """What the episode came to so far."""
        return self._judge.measures

    @property
    def is_over(self) -> bool:
        """Whether the agent has stopped or its steps are used up."""
        return self.measures.does_want_terminate or self.measures.num_steps >= MAXIMUM_STEPS

    def _take(self, episode: Episode) -> None:
        """Bring everything to the beginning of an episode."""
        if not self.simulator.floor.is_free(episode.start.x, episode.start.y):
            raise InvalidInputError(
                f"episode '{episode.id}' cannot be played: at its start ({episode.start.x:.2f}, {episode.start.y:.2f}) "
                "the base would stand in something; choose a start on the free floor"
            )
        self.episode = episode
        self.events = NOTHING
        self._has_begun = False
        self.simulator.reset(episode.start)
        self._judge = Judge(self.home, episode)
        self._grasp_rule = self._grasp(episode)
        self._to_start = invert_transform(self.simulator.base.matrix())
        self._start_inverse = self.simulator.base.inverse()

    def _observation(self, frame: Frame) -> Observation:
        """Return what the agent may see, in arrays that it cannot write into and the simulator does not read again."""
        return Observation(
            rgb=_locked(frame.rgb.copy()),
            depth=_locked(frame.depth.copy()),
            camera=self.camera,
            camera_to_start=_locked(self._to_start @ self.simulator.camera_to_world()),
            base_to_start=self._start_inverse.compose(self.simulator.base),
            joints=self.simulator.joints,
            is_holding=self.simulator.held is not None,
            step=self.measures.num_steps,
            truth=self._truth_of(frame),
        )


def _check(episode: Episode, home: Home) -> None:
    problem = next(episode_problems(episode, home), None)
    if problem is not None:
        raise InvalidInputError(f"episode '{episode.id}' cannot be played: {problem}")


def _no_truth(frame: Frame) -> None:
    return None


def _locked(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array
