"""`uniteam verify`: whether results are what comes of the actions that were recorded with them."""

from pathlib import Path
from secrets import randbelow
from typing import Annotated

import tyro
from rich.console import Console

from uniteam.cli.evaluate import check_at_least_one
from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError, UniteamError
from uniteam.evaluation.verification.replay_actions import check_claims
from uniteam.evaluation.verification.submission import Claim, Submission, open_submission

_SEEDS = 1 << 31


class NotVerifiedError(UniteamError):
    """Results that their actions do not come to."""


def verify(
    folder: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="DIR")],
    /,
    episodes: Annotated[int, tyro.conf.arg(metavar="N")] = 20,
    seed: Annotated[int | None, tyro.conf.arg(metavar="SEED")] = None,
    split: Annotated[str | None, tyro.conf.arg(metavar="FILE")] = None,
) -> None:
    """Play some of a run's episodes again from their recorded actions, and compare every measure.

    No agent is asked: the simulator takes the actions, and the judge measures what comes of them. Every result is
    compared with its episode first, and each must have a recording ('uniteam evaluate --record actions'). Exits with 2
    where something differs, and says what.

    Args:
        folder: The folder of a run.
        episodes: How many episodes to play, drawn at random from those of all its agents.
        seed: Draws the same episodes again; by default, nobody knows before which are drawn.
        split: Where the run is of a file of episodes, or of a folder of the challenge's: the file, or ovmm:FOLDER.
    """
    check_at_least_one(episodes=episodes)
    if seed is not None and not 0 <= seed < _SEEDS:
        raise InvalidInputError(f"--seed must be from 0 to {_SEEDS - 1}, got {seed}")
    console = make_console()
    with console.status("reading the results and the split"):
        submission = open_submission(folder, split)
    drawn_by = randbelow(_SEEDS) if seed is None else seed
    drawn = submission.sample(episodes, drawn_by)
    differing = _check(submission, drawn, console)
    whole = f"of {len(submission.claims)} that did not crash, drawn with --seed {drawn_by}"
    if differing:
        raise NotVerifiedError(f"{differing} of {len(drawn)} episodes ({whole}) do not come to what '{folder}' says")
    console.print(f"{len(drawn)} episodes ({whole}) come to what {shown(folder)} says.", soft_wrap=True)


def _check(submission: Submission, drawn: list[Claim], console: Console) -> int:
    """Check claims under a bar, say which differ and how, and return how many do."""
    differing = 0
    with counting(console, "playing the recorded actions", len(drawn)) as advance:
        for claim, found in check_claims(submission, drawn):
            advance()
            if found:
                differing += 1
                words = f"{claim.agent}, {claim.episode.id}: {'; '.join(found)}"
                console.print(f"[red]differs:[/] {shown(words)}", soft_wrap=True)
    return differing
