"""The stable interface: every name is there, and asking for none of them costs next to nothing."""

import resource
import subprocess
import sys

import pytest

import uniteam


@pytest.mark.parametrize("name", uniteam.__all__)
def test_every_public_name_resolves(name: str) -> None:
    assert getattr(uniteam, name) is not None


def test_an_unknown_name_is_no_attribute() -> None:
    with pytest.raises(AttributeError, match="no attribute 'environment_of'"):
        _ = uniteam.environment_of


def test_importing_the_package_loads_no_simulator_and_no_compiler() -> None:
    loaded = "import sys, uniteam; print([m for m in ('numba', 'mujoco', 'cv2', 'numpy') if m in sys.modules])"
    shown = subprocess.run([sys.executable, "-c", loaded], capture_output=True, text=True, check=True)
    assert shown.stdout.strip() == "[]"


def seconds_of_processor(code: str) -> float:
    """Return how much processor time a new process takes to run Python code: the least of three."""
    taken = []
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", code], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        taken.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(taken)


def test_importing_the_package_takes_less_than_150_milliseconds_with_the_start_of_python() -> None:
    assert seconds_of_processor("import uniteam") < 0.15
