"""Test the adapters of detectors with the libraries that they adapt, in an environment of its own.

python tools/check_detectors.py FOLDER

makes the environment where it is missing (PyTorch and transformers: several GB on a machine with CUDA), and runs the
tests of the detectors in it. Networks have a few random weights each; no weights are fetched.
"""

import os
import subprocess
import sys
import venv
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXTRAS = "remote,owlv2,grounded-sam"
TESTS = "tests/mind/perception/detectors"


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
    offline = {**os.environ, "HF_HUB_OFFLINE": "1"}
    return subprocess.run([python, "-m", "pytest", "-n", "0", "-rs", TESTS], cwd=ROOT, env=offline).returncode


if __name__ == "__main__":
    sys.exit(main())
