"""Check a perception."""

from uniteam.interface import DiscreteAction, Segmentation
from uniteam.mind.perception.registry import PERCEPTIONS, PerceptionFactory, build_perception
from uniteam.testing.answers import segmentation_problem
from uniteam.testing.episodes import shared_environment
from uniteam.testing.failure import called, name_of
from uniteam.testing.side_by_side import Subject, Trial, check_alike
from uniteam.testing.truth import READS_THE_TRUTH, as_it_is, without_and_with_another, without_truth

_WALK = (DiscreteAction.TURN_LEFT, DiscreteAction.TURN_LEFT, DiscreteAction.MOVE_FORWARD)
"""What the robot does while it looks, over and over."""


def check_perception(perception: str | PerceptionFactory, steps: int = 20) -> None:
    """Check that a perception keeps what `uniteam.Perception` promises, on the frames of two short walks.

    - Two copies made alike see the same, to the bit, while both are alive.
    - Nothing of one episode is left in the next: a copy that has seen another episode sees as a new one does.
    - Each frame's `Segmentation` has the frame's size; its detections are named, best candidate first, and what they
      embed is float32.
    - No array of an observation is written into, and no segmentation changes after it was returned.
    - The truth is not read; unless the perception's class has `needs_truth = True`.

    In a test of your own:

        def test_my_detector() -> None:
            check_perception("my_package.my_eyes:MyDetector")

    Args:
        perception: a name, a reference "module:attribute", or what makes a perception (often its class).
        steps: how many frames of each walk are looked at.

    Raises:
        CheckFailedError: what differed, and at which step.
        UnknownNameError: there is no perception of this name.
    """
    factory = PERCEPTIONS.get(perception) if isinstance(perception, str) else perception
    is_shown_the_truth = bool(getattr(factory, "needs_truth", False))
    name = f"perception '{name_of(perception)}'"

    def subject() -> Subject[Segmentation]:
        new = called(f"{name}: making it", lambda: build_perception(name_of(perception), factory))
        return Subject(name, "perceive", new.reset, new.perceive, segmentation_problem)

    show = as_it_is if is_shown_the_truth else without_truth
    seen = Trial(shared_environment(), subject, show, lambda _, step: _WALK[step % len(_WALK)], steps).check()
    if not is_shown_the_truth:
        check_alike(subject(), subject(), without_and_with_another(seen), READS_THE_TRUTH)
