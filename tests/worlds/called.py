"""The command line, called in the tests' own process."""

import pytest

from uniteam.cli.main import main


def call(*arguments: str) -> int:
    """Run `uniteam` with arguments and return its exit code."""
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    code = ended.value.code
    return code if isinstance(code, int) else int(code is not None)


def complaint(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Run `uniteam` with what it refuses, and return the one sentence that it answers with."""
    assert call(*arguments) == 2
    lines = capsys.readouterr().err.strip().splitlines()
    assert len(lines) == 1
    return lines[0]
