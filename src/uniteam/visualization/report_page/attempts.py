"""Every attempt at an episode as a row of the page."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from uniteam.evaluation.analysis.contestants import Contestant
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.visualization.captions import MILESTONES
from uniteam.visualization.report_page.causes import causes_of
from uniteam.world.task.episode import Episode

LinkOf = Callable[[Contestant, str], str | None]
"""Returns where the page of an agent's episode lies, as a link from the report; None where there is none."""


def attempts_data(
    contestants: Sequence[Contestant], episodes: Mapping[str, Episode], link_of: LinkOf
) -> list[dict[str, Any]]:
    """Return the attempts in the order of the episodes' names, those of one episode together.

    Args:
        contestants: the agents.
        episodes: those of the split by their ids, for their style; what is missing has none.
        link_of: where replays lie.

    Raises:
        DamagedFileError: a run has causes that cannot be read.
    """
    causes = {c.run.directory: causes_of(c.run) for c in contestants}
    rows = [
        _row(number, result, episodes.get(name), causes[c.run.directory].get((c.agent, name)), link_of(c, name))
        for number, c in enumerate(contestants)
        for name, result in c.results.items()
    ]
    return sorted(rows, key=lambda row: (row["episode"], row["agent"]))


def _row(
    agent: int, result: EpisodeResult, episode: Episode | None, cause: Mapping[str, Any] | None, link: str | None
) -> dict[str, Any]:
    return {
        "agent": agent,
        "episode": result.episode,
        "home": result.home,
        "asked": result.instruction,
        "unseen": result.unseen,
        "style": "" if episode is None or episode.tags is None else episode.tags.style.replace("_", " "),
        "reached": [bool(getattr(result.measures, name)) for name in MILESTONES],
        "success": result.measures.overall_success,
        "steps": result.measures.num_steps,
        "failure": result.failure,
        "crashed": result.crashed,
        "cause": cause,
        "replay": link,
    }
