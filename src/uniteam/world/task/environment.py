"""Playing one episode: actions in, observations out, and the measures kept apart from what the agent sees."""

import weakref
from collections.abc import Callable

from uniteam.errors import InvalidInputError
from uniteam.geometry import PinholeCamera, invert_transform
from uniteam.interface import Action, Detection, DiscreteAction, Observation, Segmentation
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.episode import Episode
from uniteam.world.task.judge import Judge
from uniteam.world.task.measures import Measures
from uniteam.world.task.simulator_pool import SimulatorPool

MAXIMUM_STEPS = 1250

_pool = SimulatorPool(capacity=2)


class Environment:
    """One episode in one home.

    Episodes of a home that are played one after the other share its compiled simulator; two environments that are
    alive at the same time never do.
    """

    def __init__(
        self, home: Home, episode: Episode, camera: PinholeCamera = HEAD_CAMERA_HALF, give_truth: bool = False
    ) -> None:
        """Prepare the home.

        Args:
            home: where the episode takes place.
            episode: what is asked.
            camera: the head camera's intrinsics.
            give_truth: whether observations carry the simulator's own segmentation.
        """
        if episode.home != home.name:
            raise InvalidInputError(f"episode '{episode.id}' is played in home '{episode.home}', not in '{home.name}'")
        self.home = home
        self.episode = episode
        self.camera = camera
        self.simulator: Simulator = _pool.take(home, camera)
        weakref.finalize(self, _pool.give_back, home, camera, self.simulator)
        self._truth_of = _truth_maker(home) if give_truth else _no_truth
        self._judge = Judge(home, episode)

    def reset(self) -> Observation:
        """Put the robot at the start and every object back, forget the measures, and look."""
        self.simulator.reset(self.episode.start)
        self._judge = Judge(self.home, self.episode)
        self._to_start = invert_transform(self.simulator.base.matrix())
        self._start_inverse = self.simulator.base.inverse()
        return self._observation(self.simulator.render())

    def step(self, action: Action) -> Observation:
        """Do one action and look.

        Raises:
            InvalidInputError: the episode is over.
        """
        if self.is_over:
            raise InvalidInputError(f"episode '{self.episode.id}' is over after {self.measures.num_steps} steps")
        events = self.simulator.apply(action, self.episode.instruction.object_category)
        frame = self.simulator.render()
        self._judge.update(self.simulator, events, frame, stopped=action is DiscreteAction.STOP)
        return self._observation(frame)

    @property
    def measures(self) -> Measures:
        """What the episode came to so far."""
        return self._judge.measures

    @property
    def is_over(self) -> bool:
        """Whether the agent has stopped or its steps are used up."""
        return self.measures.does_want_terminate or self.measures.num_steps >= MAXIMUM_STEPS

    def _observation(self, frame: Frame) -> Observation:
        return Observation(
            rgb=frame.rgb,
            depth=frame.depth,
            camera=self.camera,
            camera_to_start=self._to_start @ self.simulator.camera_to_world(),
            base_to_start=self._start_inverse.compose(self.simulator.base),
            joints=self.simulator.joints,
            is_holding=self.simulator.held is not None,
            step=self.measures.num_steps,
            truth=self._truth_of(frame),
        )


def _truth_maker(home: Home) -> Callable[[Frame], Segmentation | None]:
    """Return the function from a frame to its segmentation: every instance by its category's name, score 1."""
    detections = tuple(Detection(((instance.category, 1.0),)) for instance in home.instances)
    return lambda frame: Segmentation(frame.instances, detections)


def _no_truth(frame: Frame) -> None:
    return None
