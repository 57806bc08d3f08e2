"""Test the files for Rerun with Rerun's own checker and reader, in an environment of its own.

python tools/check_rerun.py FOLDER

makes the environment where it is missing (Rerun: 500 MB), and runs the tests of the files in it.
"""

import sys

from own_environment import ROOT, commands_with, folder_asked_for, run_tests

EXTRAS = "rerun,lerobot"
TESTS = ("tests/visualization/rerun_file", "tests/cli/test_export.py")


def main() -> int:
    """Return the exit status of the tests."""
    folder = folder_asked_for(sys.argv[1:], __doc__)
    if folder is None:
        return 2
    return run_tests(commands_with(folder, f"{ROOT}[{EXTRAS}]"), TESTS)


if __name__ == "__main__":
    sys.exit(main())
