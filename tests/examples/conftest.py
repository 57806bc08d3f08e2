"""The examples can be imported, as in their own folder, and leave nothing there."""

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from uniteam.cli.main import main

EXAMPLES = Path(__file__).parents[2] / "examples"

Call = Callable[..., int]


@pytest.fixture(autouse=True)
def in_examples(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(EXAMPLES)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)


@pytest.fixture
def call() -> Call:
    """Run `uniteam` in this process and return its exit code."""

    def run(*arguments: str) -> int:
        with pytest.raises(SystemExit) as ended:
            main(arguments)
        assert isinstance(ended.value.code, int)
        return ended.value.code

    return run


@pytest.fixture
def tidy_loft(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The split that `python bring_a_task.py` writes."""
    monkeypatch.chdir(tmp_path)
    source = EXAMPLES / "bring_a_task.py"
    exec(compile(source.read_text(), source, "exec"), {"__name__": "__main__"})
    return tmp_path / "tidy_loft.jsonl.gz"
