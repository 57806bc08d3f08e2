"""The stable interface: every name is there, and asking for none of them costs next to nothing."""

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
