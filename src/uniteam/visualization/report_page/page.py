"""The page of some runs."""

from collections.abc import Sequence

from uniteam.evaluation.analysis.contestants import Contestant
from uniteam.visualization.captions import MILESTONES
from uniteam.visualization.html_file import PageParts, html_file
from uniteam.visualization.report_page.agents import agents_data, shared_data, tagged_episodes, tags_data, told
from uniteam.visualization.report_page.attempts import LinkOf, attempts_data

_PARTS = PageParts(
    package="uniteam.visualization.report_page",
    body="page.html",
    styles=("styles/report.css",),
    scripts=("scripts/figures.js", "scripts/attempts.js", "scripts/report.js"),
)


def report_page(contestants: Sequence[Contestant], link_of: LinkOf) -> str:
    """Return the report, HTML that needs no other file and no network, but for the replays that it links to.

    Args:
        contestants: the agents of the runs, at least one.
        link_of: where replays lie.

    Raises:
        DamagedFileError: a run has causes that cannot be read.
    """
    runs = list({contestant.run.directory: contestant.run for contestant in contestants}.values())
    episodes = tagged_episodes(contestants)
    data = {
        **told(runs),
        "runs": [str(run.directory) for run in runs],
        "phases": list(MILESTONES.values()),
        "agents": agents_data(contestants),
        "shared": shared_data(contestants),
        "tags": tags_data(contestants, episodes),
        "attempts": attempts_data(contestants, {episode.id: episode for episode in episodes}, link_of),
    }
    return html_file(_PARTS, f"Report: {', '.join(c.label for c in contestants)}", data)
