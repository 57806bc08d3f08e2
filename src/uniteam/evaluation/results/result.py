"""What one episode came to, as a value and as a line of JSON."""

import json
from dataclasses import asdict, dataclass, fields
from typing import Any

from uniteam.errors import DamagedFileError
from uniteam.strict_json import parse_json
from uniteam.world.task.episode import MAXIMUM_STEPS
from uniteam.world.task.measures import Measures

LARGEST_NUMBER = 1e9
"""Of seconds or megabytes; a larger one was never measured."""


@dataclass(frozen=True)
class EpisodeResult:
    """One attempt at one episode.

    Attributes:
        episode: the episode's id in its split.
        home: name of the home.
        instruction: what was asked, as a sentence.
        unseen: whether the object's class occurs in no training home.
        measures: the challenge's measures at the end; all failed where the agent crashed.
        state: the agent's state at the end.
        failure: one sentence of why it is no overall success; empty where it is one.
        seconds: wall time of the whole episode (s).
        peak_memory: largest resident memory of the process so far (MB).
        traceback: of the agent's crash; empty where there was none.
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
        """Whether the agent raised an exception or used up its time."""
        return bool(self.traceback)


def measures_to_data(measures: Measures) -> dict[str, Any]:
    """Return the measures, with the two that follow from the others, under the challenge's names."""
    return {
        **asdict(measures),
        "overall_success": measures.overall_success,
        "partial_success": measures.partial_success,
    }


def result_to_line(agent: str, result: EpisodeResult) -> str:
    """Return an agent's result as one line of JSON, with its line feed.

    The agent's own words may hold what is no text (half of a surrogate pair): it is replaced.
    """
    data = {f.name: getattr(result, f.name) for f in fields(result)}
    words = {name: str(data[name]).encode(errors="replace").decode() for name in ("state", "failure", "traceback")}
    return json.dumps({"agent": agent, **data, **words, "measures": measures_to_data(result.measures)}) + "\n"


def result_from_line(line: str | bytes) -> tuple[str, EpisodeResult]:
    """Return the agent and the result that `result_to_line` wrote.

    Raises:
        DamagedFileError: the line is not a result: not JSON, a field is missing, unknown, of another type or beyond
            its bounds, or the measures contradict each other.
    """
    try:
        data = parse_json(line)
        _check_fields(data, ("agent", *(f.name for f in fields(EpisodeResult))))
        return _text(data, "agent"), EpisodeResult(
            episode=_text(data, "episode"),
            home=_text(data, "home"),
            instruction=_text(data, "instruction"),
            unseen=_boolean(data, "unseen"),
            measures=_measures(data["measures"]),
            state=_string(data, "state"),
            failure=_string(data, "failure"),
            seconds=_number(data, "seconds"),
            peak_memory=_number(data, "peak_memory"),
            traceback=_string(data, "traceback"),
        )
    except (ValueError, RecursionError) as error:
        raise DamagedFileError(f"not an episode's result ({error})") from error


def _check_fields(data: Any, names: tuple[str, ...]) -> None:
    if not isinstance(data, dict):
        raise ValueError("it is not a JSON object")
    for name in names:
        if name not in data:
            raise ValueError(f"'{name}' is missing")
    for name in data:
        if name not in names:
            raise ValueError(f"'{name}' is unknown")


def _measures(data: Any) -> Measures:
    _check_fields(data, tuple(measures_to_data(Measures())))
    measures = Measures(
        find_object_phase_success=_boolean(data, "find_object_phase_success"),
        pick_object_phase_success=_boolean(data, "pick_object_phase_success"),
        find_recep_phase_success=_boolean(data, "find_recep_phase_success"),
        place_success=_boolean(data, "place_success"),
        robot_scene_colls=_count(data, "robot_scene_colls"),
        num_steps=_count(data, "num_steps"),
        does_want_terminate=_boolean(data, "does_want_terminate"),
        obj_scene_colls=_count(data, "obj_scene_colls"),
        robot_obj_colls=_count(data, "robot_obj_colls"),
    )
    derived = _boolean(data, "overall_success"), _number(data, "partial_success")
    if derived != (measures.overall_success, measures.partial_success):
        raise ValueError("its measures contradict each other")
    return measures


def _boolean(data: dict[str, Any], name: str) -> bool:
    value = data[name]
    if not isinstance(value, bool):
        raise ValueError(f"'{name}' must be true or false")
    return value


def _count(data: dict[str, Any], name: str) -> int:
    value = data[name]
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= MAXIMUM_STEPS:
        raise ValueError(f"'{name}' must be a whole number from 0 to {MAXIMUM_STEPS}")
    return value


def _number(data: dict[str, Any], name: str) -> float:
    value = data[name]
    if not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value <= LARGEST_NUMBER:
        raise ValueError(f"'{name}' must be a number from 0 to {LARGEST_NUMBER:g}")
    return float(value)


def _string(data: dict[str, Any], name: str) -> str:
    value = data[name]
    if not isinstance(value, str):
        raise ValueError(f"'{name}' must be text")
    value.encode()  # half of a surrogate pair raises ValueError
    return value


def _text(data: dict[str, Any], name: str) -> str:
    value = _string(data, name)
    if not value:
        raise ValueError(f"'{name}' must not be empty")
    return value
