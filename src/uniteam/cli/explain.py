"""`uniteam explain`: why each episode failed, and how many for each cause."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import tyro

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.contestants import Contestant, contestants_named
from uniteam.evaluation.analysis.explanation import Explanations, explain_run, explained_to_data, failure_count
from uniteam.evaluation.analysis.waterfall import Waterfall, waterfall_of
from uniteam.evaluation.analysis.waterfall_table import failure_lines, waterfall_table
from uniteam.files import try_output, write_json
from uniteam.visualization.picture_file import write_png
from uniteam.visualization.waterfall_chart import draw_waterfalls

MARKED = "(report): the UniTeam report names this failure too; docs/failures.md has its sentence."


def explain(
    runs: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar="RUN[:AGENT]")] = (),
    figure: Annotated[Path | None, tyro.conf.arg(metavar="FILE.png")] = None,
    json: Annotated[Path | None, tyro.conf.arg(metavar="FILE.json")] = None,
) -> None:
    """Say why each failed episode failed: one cause, with its step, its place and what shows it.

    Above stands the waterfall: from all episodes to overall success, in which phase and to which cause each is lost.
    Causes are decided from recordings ('uniteam evaluate --record failures'); of an episode without one, the line of
    its result can say little, and the list says that it is so. docs/failures.md says how each cause is decided.

    Args:
        runs: Folders of runs, for all agents in them, or FOLDER:AGENT for one; several stand side by side.
        figure: A .png file to draw the waterfalls into.
        json: A .json file to write counts and causes into.
    """
    for path, ending in ((figure, ".png"), (json, ".json")):
        if path is not None:
            try_output(path, (ending,))
    contestants = contestants_named(runs)
    if not contestants:
        raise InvalidInputError("name the folder of a run, such as 'uniteam explain runs/val-truth-half-challenge'")
    console = make_console()
    with counting(console, "explaining", sum(map(failure_count, contestants))) as count:
        explanations = [explain_run(contestant, count) for contestant in contestants]
    waterfalls = [waterfall_of(each) for each in explanations]
    told = _told(contestants, waterfalls)
    for each in explanations:
        console.print(f"\n[bold]{shown(each.label)}[/]")
        for line in failure_lines(each, shown):
            console.print(line, soft_wrap=True)
    console.print()
    console.print(waterfall_table(waterfalls, shown(f"{told} {MARKED}"), shown))
    if figure is not None:
        write_png(figure, draw_waterfalls("From all episodes to overall success", waterfalls, told))
        console.print(f"Figure: {shown(figure)}", soft_wrap=True)
    if json is not None:
        write_json(json, [_to_data(*pair) for pair in zip(explanations, waterfalls, strict=True)])
        console.print(f"Causes: {shown(json)}", soft_wrap=True)


def _told(contestants: Sequence[Contestant], waterfalls: Sequence[Waterfall]) -> str:
    """Return what the figures are from, and what is to be kept in mind."""
    runs = {contestant.run.directory: contestant.run.configuration for contestant in contestants}
    sentences = [_told_run(directory, told) for directory, told in runs.items()]
    first = contestants[0]
    if any(set(contestant.results) != set(first.results) for contestant in contestants):
        sentences.append("The agents have played different episodes.")
    without = sum(waterfall.unrecorded for waterfall in waterfalls)
    if without:
        sentences.append(f"{without} of the failures have no recording that can be read.")
    return " ".join(sentences)


def _told_run(directory: Path, told: Mapping[str, Any]) -> str:
    return (
        f"{directory}: split {told.get('split')} (version {told.get('split_version')}), perception "
        f"{told.get('perception')}, camera {told.get('camera')}, grasp {told.get('grasp')}."
    )


def _to_data(explanations: Explanations, waterfall: Waterfall) -> dict[str, Any]:
    return {
        "agent": explanations.label,
        "episodes": waterfall.episodes,
        "overall_success": waterfall.successes,
        "failed": {
            stage.phase: {cause.value: count for cause, count in stage.causes.items()} for stage in waterfall.stages
        },
        "failures": [explained_to_data(each) for each in explanations.episodes if each.diagnosis is not None],
    }
