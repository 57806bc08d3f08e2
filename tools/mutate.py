"""Put small faults into a copy of the repository, one at a time, and see that the tests notice each.

    python tools/mutate.py [--only NAME]

`--only` takes a part of a mutant's name or of its file's. Ends with 1 where a fault survived. It takes minutes, and is
run by hand when a test or what it tests has changed.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from mutants import beyond, judge, mind
from mutants.mutant import Mutant

ROOT = Path(__file__).resolve().parent.parent
MUTANTS = (*judge.MUTANTS, *mind.MUTANTS, *beyond.MUTANTS)
LONGEST_TEST = 900.0
"""s; a mutant that hangs is noticed too."""


class StaleMutantError(Exception):
    """The text that a mutant changes is no longer there, or more than once."""


def main() -> int:
    """Try the mutants that are asked for and return how the process ends."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", metavar="NAME", help="part of a mutant's name or file")
    only = parser.parse_args().only
    chosen = [mutant for mutant in MUTANTS if only in mutant.name or only in mutant.file]
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder) / "tree"
        shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns(".git", ".venv", "runs", "__pycache__", "*.egg-info"))
        survivors = [mutant.name for mutant in chosen if not _report(mutant, tree)]
    print(f"{len(chosen) - len(survivors)} of {len(chosen)} mutants were killed")
    return 1 if survivors or not chosen else 0


def _report(mutant: Mutant, tree: Path) -> bool:
    """Say what became of a mutant, and return whether it was killed."""
    try:
        killed = _is_killed(mutant, tree)
        verdict = "killed" if killed else "SURVIVED"
    except StaleMutantError as error:
        killed, verdict = False, f"STALE: {error}"
    print(f"{verdict:9} {mutant.file}: {mutant.name}", flush=True)
    return killed


def _is_killed(mutant: Mutant, tree: Path) -> bool:
    """Put the fault in, run its tests, take it out again, and return whether a test failed."""
    path = tree / mutant.file
    before = path.read_text()
    if before.count(mutant.old) != 1:
        raise StaleMutantError(f"the file holds {mutant.old!r} {before.count(mutant.old)} times, not once")
    path.write_text(before.replace(mutant.old, mutant.new))
    try:
        return _test(mutant.tests, tree) == FAILED
    finally:
        path.write_text(before)


FAILED = 1
"""How pytest ends where a test failed; anything else but 0 means that the tests did not run."""


def _test(tests: tuple[str, ...], tree: Path) -> int:
    command = (sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider", *tests)
    environment = {**os.environ, "PYTHONPATH": str(tree / "src")}
    try:
        done = subprocess.run(
            command, cwd=tree, env=environment, capture_output=True, timeout=LONGEST_TEST, check=False
        )
    except subprocess.TimeoutExpired:
        return FAILED
    if done.returncode not in (0, FAILED):
        raise StaleMutantError(f"the tests did not run: {done.stdout.decode()[-300:]}")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
