"""The page of one run, or of two of the same episode beside each other."""

from collections.abc import Callable, Sequence
from typing import Any

from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.recording import Recording
from uniteam.visualization.html_file import PageParts, html_file
from uniteam.visualization.replay_page.first_parting import first_parting
from uniteam.visualization.replay_page.run_data import run_data

_PARTS = PageParts(
    package="uniteam.visualization.replay_page",
    body="page.html",
    styles=("styles/page.css", "styles/run.css", "styles/controls.css", "styles/narrow.css"),
    scripts=tuple(
        f"scripts/{name}.js" for name in ("arrays", "film", "map", "words", "run", "timeline", "player", "page")
    ),
)


def replay_page(recordings: Sequence[Recording], advance: Callable[[], None] = lambda: None) -> str:
    """Return the page, HTML that needs no other file and no network.

    Args:
        recordings: one, or two of the same episode.
        advance: called for each moment of each recording, once it has been drawn.

    Raises:
        InvalidInputError: they are not of the same episode, or no step was taken in one.
        DamagedFileError: a part of a recording cannot be read, or its home cannot be built.
    """
    if len(recordings) not in (1, 2):
        raise InvalidInputError(f"a page shows one recording or two, got {len(recordings)}")
    first = recordings[0]
    asked = first.episode.instruction
    data: dict[str, Any] = {
        "instruction": {
            "object": asked.object_category.replace("_", " "),
            "start": asked.start_receptacle.replace("_", " "),
            "goal": asked.goal_receptacle.replace("_", " "),
        },
        "parting": None if len(recordings) == 1 else vars(first_parting(*recordings)),
    }
    data["runs"] = [run_data(recording, advance) for recording in recordings]
    agents = " and ".join(recording.header.agent for recording in recordings)
    return html_file(_PARTS, f"{agents}: {asked}", data)
