"""Test the files for Rerun with Rerun's own checker and reader, in an environment of its own.

python tools/check_rerun.py FOLDER

makes the environment where it is missing (Rerun: 500 MB), and runs the tests of the files in it.
"""

import os
import subprocess
import sys
import venv
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXTRAS = "rerun,lerobot"
TESTS = ("tests/visualization/rerun_file", "tests/cli/test_export.py")


def main() -> int:
    """Return the exit status of the tests."""
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print((__doc__ or "").strip())
        return 2
    folder = Path(sys.argv[1]).resolve()
    python = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
    if not python.exists():
        venv.create(folder, with_pip=True)
    wanted = [f"{ROOT}[{EXTRAS}]", "pytest>=8", "pytest-xdist>=3.5"]
    subprocess.run([python, "-m", "pip", "install", "--quiet", *wanted], check=True)
    return subprocess.run([python, "-m", "pytest", "-n", "0", "-rs", *TESTS], cwd=ROOT).returncode


if __name__ == "__main__":
    sys.exit(main())
