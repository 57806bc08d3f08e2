"""The named changes of the baseline, each of which can be switched on and off: the report's, those beyond, and others.

An improvement puts something in the place of what the baseline does there. Where a configuration does something else
there already, the improvement does not fit, and says so. All that are built in change different places, so any set of
them gives one configuration, whatever the order.
"""

from collections.abc import Iterable

from uniteam.errors import InvalidInputError, UniteamError
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.improvement import Improvement, ImprovementError
from uniteam.mind.agents.other_ways import OTHER_WAYS
from uniteam.mind.agents.report import REPORT
from uniteam.registry import Registry

BUILT_IN = (*REPORT, *BEYOND, *OTHER_WAYS)
"""All that are built in, in the order in which they are applied."""


def improved(config: AgentConfig, improvements: Iterable[str | Improvement]) -> AgentConfig:
    """Return a configuration with improvements, given as values, names or references, each applied once.

    The built-in ones are applied first, in their order; then the others in the order of their names.

    Raises:
        UnknownNameError: there is none of a name; the message offers the nearest.
        ImprovementError: one that does not fit, fails, or makes something else than a configuration.
    """
    given = (i if isinstance(i, Improvement) else IMPROVEMENTS.get(i) for i in improvements)
    chosen = {improvement.name: improvement for improvement in given}
    for improvement in sorted(chosen.values(), key=_place_in_order):
        config = _applied(improvement, config)
    return config


def _applied(improvement: Improvement, config: AgentConfig) -> AgentConfig:
    try:
        changed = improvement.apply(config)
    except UniteamError:
        raise
    except Exception as error:  # whatever an improvement of the user's raises
        raise ImprovementError(f"improvement '{improvement.name}' failed ({type(error).__name__}: {error})") from error
    if not isinstance(changed, AgentConfig):
        raise ImprovementError(
            f"improvement '{improvement.name}' must return an AgentConfig, but returned {type(changed).__name__}"
        )
    return changed


def _place_in_order(improvement: Improvement) -> tuple[int, str]:
    built_in = [other.name for other in BUILT_IN]
    return built_in.index(improvement.name) if improvement.name in built_in else len(built_in), improvement.name


def _checked(name: str, value: object) -> Improvement:
    if not isinstance(value, Improvement):
        raise InvalidInputError(
            f"improvement '{name}' must be an uniteam.mind.agents.improvement.Improvement(name, summary, apply), "
            f"got {type(value).__name__}"
        )
    return value


IMPROVEMENTS: Registry[Improvement] = Registry("improvement", "uniteam.improvements", _checked)
for _improvement in BUILT_IN:
    IMPROVEMENTS.register(_improvement.name, _improvement)
