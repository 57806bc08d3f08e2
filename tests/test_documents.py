"""What README and docs say is so: links lead somewhere, commands can be given, code runs, tables are the code's."""

import functools
import importlib.util
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import tyro
from worlds.filled import filled
from worlds.recorded import Brief, record

import uniteam
import uniteam.testing
from uniteam.cli.main import COMMANDS, function_of
from uniteam.evaluation.agent_spec import AGENTS, AgentSpec
from uniteam.evaluation.results.result import EpisodeResult, result_to_line
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.improvements import IMPROVEMENTS
from uniteam.mind.agents.other_ways import OTHER_WAYS
from uniteam.mind.agents.report import REPORT
from uniteam.mind.perception.registry import PERCEPTIONS
from uniteam.registry import Registry
from uniteam.world.generation.registry import HOMES
from uniteam.world.task.measures import Measures
from uniteam.world.task.splits import SPLIT_NAMES, load_split

ROOT = Path(__file__).parents[1]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")])
TEXT = {page: page.read_text() for page in PAGES}
SNIPPET = re.compile(r'--8<-- "(.+?)"')


def named(page: Path) -> str:
    return str(page.relative_to(ROOT))


def links() -> Iterator[tuple[Path, str]]:
    for page, text in TEXT.items():
        prose = re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)
        for target in re.findall(r"\]\(([^)\s]+)\)", prose):
            if not re.match(r"[a-z]+:", target):
                yield page, target


def headings(text: str) -> set[str]:
    """Return the anchors of a page: of its headings, and of what its reference shows."""
    words = re.findall(r"^#+ (.+)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL), flags=re.MULTILINE)
    plain = {re.sub(r"[^\w\- ]", "", heading).strip().lower().replace(" ", "-") for heading in words}
    return plain | set(re.findall(r"^::: (\S+)$", text, flags=re.MULTILINE))


@pytest.mark.parametrize(
    ("page", "target"), [pytest.param(*link, id=f"{named(link[0])}-{link[1]}") for link in links()]
)
def test_every_relative_link_leads_somewhere(page: Path, target: str) -> None:
    path, _, anchor = target.partition("#")
    aim = (page.parent / path).resolve() if path else page
    assert aim.exists()
    assert not anchor or anchor in headings(aim.read_text())


def shown_files(page: Path) -> Iterator[str]:
    """Yield a page's text, and that of the examples it shows."""
    yield TEXT[page]
    yield from ((ROOT / path).read_text() for path in SNIPPET.findall(TEXT[page]))


def command_lines() -> Iterator[tuple[str, str]]:
    for page in PAGES:
        for text in shown_files(page):
            lines = re.findall(r"^(?: {4})?((?:[A-Z_]+=\S+ )*uniteam .+)$", text, flags=re.MULTILINE)
            chained = re.findall(r"^ {4}.*&& (uniteam .+)$", text, flags=re.MULTILINE)
            for line in (*lines, *chained, *re.findall(r"`((?:[A-Z_]+=\S+ )?uniteam [^`\n]+)`", text)):
                yield named(page), line


def parse(command: str, arguments: list[str]) -> None:
    """Have a command's arguments read, and nothing done; exits where they cannot be."""

    @functools.wraps(function_of(command))
    def do_nothing(*positional: object, **named: object) -> None:
        pass

    tyro.cli(do_nothing, args=arguments)


REGISTRY_OF: dict[str, Registry[Any]] = {"agents": AGENTS, "agent": AGENTS, "perception": PERCEPTIONS, "source": HOMES}
REGISTRY_OF |= {"beside": PERCEPTIONS, "with": IMPROVEMENTS, "without": IMPROVEMENTS}


@pytest.mark.parametrize("line", sorted({line for _, line in command_lines()}))
def test_every_command_line_can_be_given_and_names_what_there_is(line: str) -> None:
    words = [word for word in shlex.split(line) if not re.fullmatch(r"[A-Z_]+=\S+", word)]
    assert words[1] in COMMANDS
    if words[2:] == ["--help"]:
        return
    parse(words[1], words[2:])
    option = ""
    for word in filled(words[1:]):
        option = word[2:] if word.startswith("--") else option
        is_name = not word.startswith("--") and ":" not in word and word not in ("NAME", "FILE", "DIR")
        if is_name and option in REGISTRY_OF:
            assert word in REGISTRY_OF[option].names()
        if is_name and option == "split":
            assert word in SPLIT_NAMES or word.endswith(".jsonl.gz")


def test_there_are_command_lines_to_look_at() -> None:
    assert {line.split()[1] for _, line in command_lines() if "=" not in line.split()[0]} == set(COMMANDS)


def python_blocks() -> Iterator[tuple[str, str]]:
    for page, text in TEXT.items():
        for block in re.findall(r"^```python\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE):
            yield named(page), block


@pytest.mark.slow
@pytest.mark.parametrize(("page", "block"), list(python_blocks()))
def test_every_block_of_python_runs(page: str, block: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "runs" / "val-learned-half-challenge").mkdir(parents=True)
    result = EpisodeResult("a", "b", "Move cup", False, Measures(), "DONE", "it fell", 1.0, 1.0)
    (tmp_path / "runs" / "val-learned-half-challenge" / "results.jsonl").write_text(result_to_line("baseline", result))
    monkeypatch.chdir(tmp_path)
    if "read_recording" in block:
        spec = AgentSpec("uniteam-plus", "truth")
        record(tmp_path / "episode.zip", Brief(spec.make(None), 3), spec)
    exec(compile(block, page, "exec"), {"__name__": "shown"})


def test_every_file_that_is_shown_is_an_example() -> None:
    shown = {path for text in TEXT.values() for path in SNIPPET.findall(text)}
    assert shown >= {str(path.relative_to(ROOT)) for path in (ROOT / "examples").glob("*.py")}


def test_the_tables_of_improvements_are_those_of_the_code() -> None:
    text = TEXT[ROOT / "docs" / "improvements.md"]
    for name, improvements in (("report", REPORT), ("beyond", BEYOND), ("other", OTHER_WAYS)):
        table = text.partition(f"<!-- table: {name} -->")[2].partition("<!-- end -->")[0]
        rows = re.findall(r"^\| `(\w+)` \| (.+) \|$", table, flags=re.MULTILINE)
        assert rows == [(i.name, i.summary) for i in improvements], "run python tools/improvement_tables.py"


def test_the_tool_writes_the_tables_that_are_there() -> None:
    specification = importlib.util.spec_from_file_location("tables", ROOT / "tools" / "improvement_tables.py")
    assert specification is not None and specification.loader is not None
    tables = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(tables)
    assert tables.with_tables(TEXT[tables.PAGE]) == TEXT[tables.PAGE]


@pytest.mark.slow
@pytest.mark.parametrize("name", SPLIT_NAMES)
def test_the_table_of_splits_counts_their_episodes_and_homes(name: str) -> None:
    split = load_split(name)
    row = f"| `{name}` | {len(split.episodes):,} | {len(split.homes)} |"
    assert row in TEXT[ROOT / "docs" / "task.md"]


def test_every_public_name_has_its_entry_in_the_reference() -> None:
    shown = set(re.findall(r"^::: (\S+)$", TEXT[ROOT / "docs" / "reference.md"], flags=re.MULTILINE))
    wanted = {f"{module}.{name}" for name, module in uniteam._MODULE_OF.items()}
    wanted |= {f"{getattr(uniteam.testing, name).__module__}.{name}" for name in uniteam.testing.__all__}
    assert shown >= wanted


@pytest.mark.slow
def test_the_pages_can_be_built(tmp_path: Path) -> None:
    pytest.importorskip("mkdocs", reason="the extra 'docs' is not installed")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(tmp_path)]
    built = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert built.returncode == 0, built.stderr
    pages = [page.read_text() for page in tmp_path.rglob("*.html")]
    assert not any(re.search(r'<(?:link|script|img)[^>]+(?:href|src)="https?:', page) for page in filled(pages))
