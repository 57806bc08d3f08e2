"""What one episode came to, as a value and as a line of JSON."""

import json
from dataclasses import asdict, dataclass, fields
from typing import Any

from uniteam.errors import DamagedFileError
from uniteam.world.task.measures import Measures


@dataclass(frozen=True)
class EpisodeResult:
    """One attempt at one episode.

    Attributes:
        episode: the episode's id in its split.
        home: name of the home.
        instruction: what was asked, as a sentence.
        unseen: whether the object's class occurs in no training home.
        measures: the challenge's measures at the end; all failed where the episode crashed.
        state: the agent's state at the end.
        failure: one sentence of why it is no overall success; empty where it is one.
        seconds: wall time of the whole episode (s).
        peak_memory: largest resident memory of the process so far (MB).
        traceback: of the crash; empty where there was none.
    """

    episode: str
    home: str
    instruction: str
    unseen: bool
    measures: Measures
    state: str
    failure: str
    seconds: float
    peak_memory: float
    traceback: str = ""

    @property
    def crashed(self) -> bool:
        """Whether the episode ended in an exception or the death of its process."""
        return bool(self.traceback)


def measures_to_data(measures: Measures) -> dict[str, Any]:
    """Return the measures, with the two that follow from the others, under the challenge's names."""
    return {
        **asdict(measures),
        "overall_success": measures.overall_success,
        "partial_success": measures.partial_success,
    }


def result_to_line(agent: str, result: EpisodeResult) -> str:
    """Return an agent's result as one line of JSON, with its line feed."""
    data = {f.name: getattr(result, f.name) for f in fields(result)}
    return json.dumps({"agent": agent, **data, "measures": measures_to_data(result.measures)}) + "\n"


def result_from_line(line: str) -> tuple[str, EpisodeResult]:
    """Return the agent and the result that `result_to_line` wrote.

    Raises:
        DamagedFileError: the line is not a result.
    """
    try:
        data: dict[str, Any] = json.loads(line)
        agent = data.pop("agent")
        measures = Measures(**{f.name: data["measures"][f.name] for f in fields(Measures)})
        return agent, EpisodeResult(**{**data, "measures": measures})
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise DamagedFileError(f"not an episode's result ({type(error).__name__}: {error})") from error
