"""`uniteam replay-check`: an agent asked again upon what a recording saw."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import tyro

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import UniteamError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.recording.body import RecordedBody
from uniteam.evaluation.recording.recording import read_recording
from uniteam.evaluation.recording.replay import first_difference


class DecidesOtherwiseError(UniteamError):
    """An agent does not decide as was recorded."""


def replay_check(
    file: Annotated[Path, tyro.conf.Positional],
    /,
    agent: str | None = None,
    perception: str | None = None,
    with_: Annotated[tuple[str, ...], tyro.conf.arg(name="with")] = (),
    without: tuple[str, ...] = (),
) -> None:
    """Let an agent decide again upon what it saw in a recording, and name the first step at which it decides otherwise.

    Nothing is simulated: the camera draws again, to the bit, what the agent saw. Exits with 0 where every decision is
    the same: action, state and reason.

    Args:
        file: A recording that `uniteam evaluate --record` or `uniteam run --record` wrote.
        agent: Whom to ask: a name, or your own as MODULE:ATTRIBUTE; by default the agent that was recorded.
        perception: What it sees with; by default what was recorded.
        with_: Improvements to add, by name or as MODULE:ATTRIBUTE.
        without: Improvements to take away, by name.
    """
    console = make_console()
    with console.status("reading the recording and building its home"):
        recording = read_recording(file)
        own = recording.header.spec
        plain = own if agent is None else replace(own, name=agent, added=(), removed=())
        added, removed = (*plain.added, *with_), (*plain.removed, *without)
        labelled = label_agents((plain.name,), perception or own.perception, added, removed)
        ((label, spec),) = labelled.items()
        asked, body = spec.make(None), RecordedBody(recording, spec.needs_truth)
    count = len(recording.steps)
    with counting(console, f"asking {shown(label)}", count) as advance:
        difference = first_difference(recording, asked, body, advance)
    if difference is not None:
        raise DecidesOtherwiseError(
            f"{label} decides otherwise than {recording.header.agent} was recorded: {difference}"
        )
    console.print(f"{shown(label)} decides the same at each of the {count} steps.", soft_wrap=True)
