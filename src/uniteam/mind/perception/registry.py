"""The kinds of perception by name."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.errors import UnknownNameError
from uniteam.interface import Perception
from uniteam.mind.perception.truth import truth_perception


@dataclass(frozen=True)
class PerceptionKind:
    """One kind of perception.

    Attributes:
        make: builds it afresh for an agent.
        needs_truth: whether observations must carry the simulator's own segmentation.
    """

    make: Callable[[], Perception]
    needs_truth: bool


PERCEPTIONS: dict[str, PerceptionKind] = {
    "truth": PerceptionKind(lambda: truth_perception, needs_truth=True),
}


def perception_kind(name: str) -> PerceptionKind:
    """Return a kind of perception; raises UnknownNameError with the nearest valid name."""
    try:
        return PERCEPTIONS[name]
    except KeyError:
        raise UnknownNameError("perception", name, PERCEPTIONS) from None
