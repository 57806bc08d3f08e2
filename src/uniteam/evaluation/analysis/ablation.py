"""What each improvement is worth: paired effects between agents that differ in it."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from uniteam.evaluation.analysis.ablation_plan import GROUPS, Effect
from uniteam.evaluation.analysis.comparison import Comparison, compare, corrected
from uniteam.evaluation.results.reading import Results


@dataclass(frozen=True)
class MeasuredEffect:
    """An effect with what was measured of it: the second agent of the comparison has the improvement."""

    effect: Effect
    comparison: Comparison


def measure_effects(
    effects: Sequence[Effect], results: Results, count: Callable[[], None]
) -> Mapping[str, list[MeasuredEffect]]:
    """Return the effects of which both agents have played an episode, by group, p corrected within each (Holm).

    Args:
        effects: to measure.
        results: by agent, then by episode.
        count: called after each.

    Raises:
        UnavailableError: SciPy is not installed.
    """
    measured: dict[str, list[MeasuredEffect]] = {}
    for group in GROUPS:
        found = []
        for effect in (effect for effect in effects if effect.group == group):
            without, with_ = (results.get(label, {}) for label in (effect.without, effect.with_))
            shared = sorted(set(without) & set(with_))
            if shared:
                pairs = [(without[episode], with_[episode]) for episode in shared]
                found.append((effect, compare(effect.without, effect.with_, pairs)))
            count()
        compared = corrected([comparison for _, comparison in found])
        if found:
            measured[group] = [MeasuredEffect(e, c) for (e, _), c in zip(found, compared, strict=True)]
    return measured
