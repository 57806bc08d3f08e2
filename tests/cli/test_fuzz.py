"""Nonsense in results, configurations and command lines: one sentence, never a traceback, never a figure."""

import json
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from copy import deepcopy
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from worlds.filled import filled
from worlds.nonsense import ended_after, outcome

from uniteam.cli.main import COMMANDS, main
from uniteam.evaluation.results.result import EpisodeResult, result_to_line
from uniteam.evaluation.results.store import ResultStore
from uniteam.world.task.measures import Measures

pytestmark = pytest.mark.slow

CONFIGURATION = {
    "version": "1",
    "code": "abc",
    "software": {"numba": "1.0", "cpu": "znver3"},
    "episode_seconds": 3600.0,
    "agents": {"uniteam": {"threshold": 0.45, "states": ["PICK", {"PLACE": None}]}},
}
EPISODES = tuple(f"val_{k}" for k in range(5))
RESULTS = [
    EpisodeResult(
        episode, "home_7", "Move cup from table to sink", False,
        Measures(True, k > 1, k > 2, k > 3, 0, 100 + k, True), "DONE", "stopped", 9.5, 700.0,
    )
    for k, episode in enumerate(EPISODES)
]  # fmt: skip


@pytest.fixture(autouse=True)
def empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever a command writes, it writes there."""
    monkeypatch.chdir(tmp_path)


often = settings(max_examples=250, deadline=None, suppress_health_check=list(HealthCheck))

scalars = st.one_of(
    st.none(), st.booleans(), st.integers(), st.integers(10**400, 10**401), st.floats(), st.text(max_size=20)
)
values = st.recursive(
    scalars, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3)
)


def leaves(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the way to everything in a tree of plain data."""
    yield path
    if isinstance(data, dict | list):
        for key, inner in data.items() if isinstance(data, dict) else enumerate(data):
            yield from leaves(inner, (*path, key))


@st.composite
def changed(draw: st.DrawFn, data: Any) -> Any:
    """Return plain data with one thing in it replaced, removed or added."""
    data = deepcopy(data)
    *way, last = draw(st.sampled_from([path for path in leaves(data) if path]))
    around = data
    for key in way:
        around = around[key]
    kind = draw(st.sampled_from(["replace", "remove", "add"]))
    if kind == "remove":
        del around[last]
    elif kind == "add" and isinstance(around, dict):
        around[draw(st.text(max_size=8))] = draw(values)
    else:
        around[last] = draw(values)
    return data


@st.composite
def damaged(draw: st.DrawFn, content: bytes) -> bytes:
    """Return a file's content with some bytes cut out, overwritten or put in."""
    start = draw(st.integers(0, len(content)))
    end = draw(st.integers(start, min(len(content), start + draw(st.sampled_from([0, 1, 10, 1000])))))
    return content[:start] + draw(st.binary(max_size=8)) + content[end:]


def read(results: bytes, configuration: bytes) -> dict[str, dict[str, EpisodeResult]] | None:
    """Return the results that a directory of these files is taken to hold, or None where it is refused."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "results.jsonl").write_bytes(results)
        (Path(folder) / "config.json").write_bytes(configuration)
        return outcome(lambda: opened(Path(folder)))


def opened(folder: Path) -> dict[str, dict[str, EpisodeResult]]:
    store = ResultStore(folder, CONFIGURATION, EPISODES)
    store.close()
    return store.results


LINES = [result_to_line("uniteam", result) for result in RESULTS]
WHOLE = "".join(LINES).encode()
CONFIG = json.dumps(CONFIGURATION).encode()


def is_sound(result: EpisodeResult) -> bool:
    """Tell whether a result can have been measured."""
    is_timed = isinstance(result.seconds, float) and 0.0 <= result.seconds < 1e10
    return is_timed and 0 <= result.measures.num_steps <= 1250 and result.measures.partial_success * 4 in range(5)


@often
@given(number=st.integers(0, len(LINES) - 1), data=st.data())
def test_a_row_of_which_one_thing_is_changed_is_refused_or_sound(number: int, data: st.DataObject) -> None:
    row = data.draw(changed(json.loads(LINES[number])))
    lines = [*LINES[:number], json.dumps(row) + "\n", *LINES[number + 1 :]]
    results = read("".join(lines).encode(), CONFIG)
    if results is None:
        return
    assert set(results) == {"uniteam"}
    assert set(results["uniteam"]) == set(EPISODES)
    assert all(is_sound(result) for result in filled(results["uniteam"].values()))


@often
@given(content=damaged(WHOLE))
def test_results_of_which_bytes_are_changed_are_refused_or_are_results(content: bytes) -> None:
    results = read(content, CONFIG) or {}
    assert False not in [is_sound(result) for result in results.get("uniteam", {}).values()]  # there may be none


@often
@given(configuration=changed(CONFIGURATION))
def test_a_configuration_of_which_one_thing_is_changed_is_refused(configuration: Any) -> None:
    agents = configuration.get("agents") if isinstance(configuration, dict) else None
    only_agents_joined = isinstance(agents, dict) and {
        **configuration,
        "agents": {**agents, **CONFIGURATION["agents"]},  # type: ignore[dict-item]
    } == {**CONFIGURATION, "agents": {**agents, **CONFIGURATION["agents"]}}  # type: ignore[dict-item]
    assert read(b"", json.dumps(configuration).encode()) is None or only_agents_joined


@often
@given(content=damaged(CONFIG))
def test_a_configuration_of_which_bytes_are_changed_is_refused_or_says_the_same(content: bytes) -> None:
    results = read(WHOLE, content)
    assert results is None or results["uniteam"] == {result.episode: result for result in RESULTS}


NONSENSE = [
    "", " ", "-", "--", "---", "=", "\x1b[31m", "[/b]", "\udc80", "ü", "9" * 400, "-1", "0", "1e400", "nan", "0x10",
    "None", "True", "a\nb", "/", "..", "/dev/null", "/dev/full", "/proc/self/mem", "no_such.jsonl", "x" * 5000, ":",
    "uniteam:", ":x", "json:", "json:nothing", "no_such_module:Agent", "a.b.c", "../x:y", "--help ", "-h-h", "@file",
]  # fmt: skip
OPTIONS = [
    "--agents", "--agent", "--split", "--perception", "--episodes", "--episode", "--workers", "--camera", "--out",
    "--with", "--without", "--breakdown", "--style", "--episode-seconds", "--video", "--category", "--sheet",
    "--homes", "--per-home", "--pool", "--nothing", "-v", "--out=", "--video=", "--workers=", "--agents=",
    "--levels", "--measure", "--model", "--revision", "--host", "--port",
]  # fmt: skip
words = st.one_of(st.sampled_from(NONSENSE), st.sampled_from(OPTIONS), st.text(max_size=6))
HARMLESS = {
    "evaluate": ["--split", "no_such_split"],
    "run": ["--split", "no_such_split"],
    "dial": ["--split", "no_such_split"],
    "ablate": ["--split", "no_such_split"],
    "swap": ["--split", "no_such_split"],
    "compare": ["no_such_run"],
    "merge": ["no_such_run"],
    "leaderboard": ["no_such_run"],
    "explain": ["no_such_run"],
    "report": ["no_such_run"],
    "replay": ["no_such_recording"],
    "replay-check": ["no_such_recording"],
    "data": ["no_such_question"],
    "export": ["no_such_program"],
    "figures": ["--only", "no_such_figure"],
    "verify": ["no_such_run"],
    "scale": ["no_such_run"],
    "robot": ["--speed", "9"],
    "fake-robot": ["--split", "no_such_split"],
    "rehearse": ["--split", "no_such_split"],
    "serve": ["--port", "70000"],
    "serve-perception": ["--port", "70000"],
    "perception": ["--split", "no_such_split"],
    "train": ["--homes", "0"],
    "bench": ["--episodes", "0"],
    "home": ["no_seed"],
    "episodes": ["--homes", "none"],
    "assets": ["--category", "no_such_category"],
    "doctor": ["--no-such-option"],
    "agents": ["--no-such-option"],
}
"""What keeps each command from doing any work; given last, so that it is what counts."""


def answered(arguments: list[str]) -> tuple[object, str]:
    """Return the exit code of a command, and what it wrote to stderr."""
    output, errors = StringIO(), StringIO()
    with redirect_stdout(output), redirect_stderr(errors), pytest.raises(SystemExit) as ended, ended_after(60.0):
        main(arguments)
    assert "Traceback" not in output.getvalue() + errors.getvalue()
    assert "\x1b" not in errors.getvalue()
    return ended.value.code, errors.getvalue()


@settings(max_examples=300, deadline=20_000, suppress_health_check=list(HealthCheck))
@given(name=st.sampled_from(sorted(COMMANDS)), given_words=st.lists(words, max_size=5))
def test_a_command_line_of_nonsense_is_answered_without_a_traceback(name: str, given_words: list[str]) -> None:
    code, errors = answered([name, *given_words, *HARMLESS[name]])
    is_help = any(word in ("-h", "--help") for word in given_words)
    assert code == (0 if is_help else 2)
    assert is_help or errors.strip()


@settings(max_examples=100, deadline=20_000, suppress_health_check=list(HealthCheck))
@given(given_words=st.lists(words, min_size=1, max_size=3).filter(lambda given_words: given_words[0] not in COMMANDS))
def test_a_command_that_does_not_exist_is_answered_without_a_traceback(given_words: list[str]) -> None:
    code, errors = answered(given_words)
    is_asked = given_words[0] in ("-h", "--help", "help", "-V", "--version")
    assert code == (0 if is_asked else 2)
    assert is_asked or errors.strip()
