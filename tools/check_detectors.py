"""Test the adapters of detectors with the libraries that they adapt, in an environment of its own.

python tools/check_detectors.py FOLDER

makes the environment where it is missing (PyTorch and transformers: several GB on a machine with CUDA), and runs the
tests of the detectors in it. Networks have a few random weights each; no weights are fetched.
"""

import sys

from own_environment import ROOT, commands_with, folder_asked_for, run_tests

EXTRAS = "remote,owlv2,grounded-sam"
TESTS = ("tests/mind/perception/detectors",)


def main() -> int:
    """Return the exit status of the tests."""
    folder = folder_asked_for(sys.argv[1:], __doc__)
    if folder is None:
        return 2
    return run_tests(commands_with(folder, f"{ROOT}[{EXTRAS}]"), TESTS, {"HF_HUB_OFFLINE": "1"})


if __name__ == "__main__":
    sys.exit(main())
