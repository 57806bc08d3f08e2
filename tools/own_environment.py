"""An environment of its own for tests of heavy extras; the scripts `check_*.py` say which."""

import os
import subprocess
import venv
from collections.abc import Mapping, Sequence
from pathlib import Path

ROOT = Path(__file__).parents[1]
TEST_TOOLS = ("pytest>=8", "pytest-xdist>=3.5")


def folder_asked_for(arguments: Sequence[str], help_text: str | None) -> Path | None:
    """Return the one folder that a script's arguments name; None, once the help is printed, where they name none."""
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print((help_text or "").strip())
        return None
    return Path(arguments[0]).resolve()


def commands_with(folder: Path, *packages: str) -> Path:
    """Install packages and pytest into the environment of a folder, made where it is missing; return its commands."""
    commands = folder / ("Scripts" if os.name == "nt" else "bin")
    if not (commands / "python").exists():
        venv.create(folder, with_pip=True)
    subprocess.run([commands / "python", "-m", "pip", "install", "--quiet", *packages, *TEST_TOOLS], check=True)
    return commands


def run_tests(commands: Path, tests: Sequence[str], variables: Mapping[str, str] | None = None) -> int:
    """Return the exit status of tests of the repository, with environment variables besides."""
    command = [commands / "python", "-m", "pytest", "-n", "0", "-rs", *tests]
    return subprocess.run(command, cwd=ROOT, env={**os.environ, **(variables or {})}).returncode
