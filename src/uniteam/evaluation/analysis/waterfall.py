"""From all episodes to overall success: how many are lost in each phase, and to which causes."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from uniteam.evaluation.analysis.explanation import Explanations
from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.diagnosis import PHASES


@dataclass(frozen=True)
class Stage:
    """One phase.

    Attributes:
        phase: one of `PHASES`.
        lost: how many episodes missed this phase first.
        left: how many remain.
        causes: how many of those lost each cause has, the most frequent first.
    """

    phase: str
    lost: int
    left: int
    causes: Mapping[Cause, int]


@dataclass(frozen=True)
class Waterfall:
    """One agent's.

    Attributes:
        label: of the agent.
        episodes: how many it played.
        stages: in the order of the phases.
        unrecorded: how many failures there are whose recording could not be looked at.
    """

    label: str
    episodes: int
    stages: Sequence[Stage]
    unrecorded: int

    @property
    def successes(self) -> int:
        """How many episodes are an overall success."""
        return self.stages[-1].left

    def total(self, cause: Cause) -> int:
        """Return how many episodes a cause has in all phases."""
        return sum(stage.causes.get(cause, 0) for stage in self.stages)


def waterfall_of(explanations: Explanations) -> Waterfall:
    """Return the waterfall of an agent's episodes."""
    found = [each.diagnosis for each in explanations.episodes if each.diagnosis is not None]
    left, stages = len(explanations.episodes), []
    for phase in PHASES:
        causes = Counter(diagnosis.cause for diagnosis in found if diagnosis.phase == phase)
        left -= causes.total()
        stages.append(Stage(phase, causes.total(), left, dict(causes.most_common())))
    unrecorded = sum(not diagnosis.is_recorded for diagnosis in found)
    return Waterfall(explanations.label, len(explanations.episodes), stages, unrecorded)


def causes_in(waterfalls: Sequence[Waterfall], phase: str) -> list[Cause]:
    """Return the causes that any of some agents has in a phase, the most frequent of all first."""
    counts: Counter[Cause] = Counter()
    for waterfall in waterfalls:
        counts.update(next(stage.causes for stage in waterfall.stages if stage.phase == phase))
    return [cause for cause, _ in counts.most_common()]
