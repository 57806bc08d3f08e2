"""Compiled kernels find a folder where neither the installation nor the home can be written."""

import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest

import uniteam
from uniteam.errors import InvalidInputError
from uniteam.kernel_cache import check_environment

DROP_RIGHTS = ("setpriv", "--bounding-set=-dac_override")
"""What lets root meet files that cannot be written."""


@pytest.fixture
def installation(tmp_path: Path) -> Path:
    """The package's first three modules in a folder that cannot be written."""
    package = tmp_path / "site" / "uniteam"
    package.mkdir(parents=True)
    for name in ("__init__.py", "kernel_cache.py", "errors.py"):
        shutil.copy(Path(uniteam.__file__).parent / name, package)
    package.chmod(0o555)
    return package.parent


def chosen_folder(installation: Path, temporary: Path, home: str) -> str:
    """Return NUMBA_CACHE_DIR as a new process finds it after importing the package."""
    temporary.mkdir(exist_ok=True)
    code = "import os, uniteam; print(os.environ.get('NUMBA_CACHE_DIR', ''))"
    variables = {k: v for k, v in os.environ.items() if k not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME")}
    variables |= {"PYTHONPATH": str(installation), "HOME": home, "TMPDIR": str(temporary)}
    command = [sys.executable, "-B", "-c", code]
    if os.getuid() == 0:
        if shutil.which(DROP_RIGHTS[0]) is None:
            pytest.skip("root can write everywhere")
        command = [*DROP_RIGHTS, *command]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, cwd=temporary, check=True)
    return done.stdout.strip()


def test_kernels_are_kept_in_a_temporary_folder_of_the_users_own(installation: Path, tmp_path: Path) -> None:
    folder = Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home"))
    assert folder.parent == tmp_path / "tmp"
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    assert chosen_folder(installation, tmp_path / "tmp", "/dev/null/home") == str(folder)


def test_a_home_that_can_be_written_is_left_to_numba(installation: Path, tmp_path: Path) -> None:
    assert chosen_folder(installation, tmp_path / "tmp", str(tmp_path)) == ""


def test_a_folder_that_others_can_write_is_not_trusted(installation: Path, tmp_path: Path) -> None:
    first = Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home"))
    first.chmod(0o777)
    second = Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home"))
    assert second != first
    assert stat.S_IMODE(second.stat().st_mode) == 0o700


@pytest.mark.parametrize("threads", ["0", "-1", "many", "", "1.5"])
def test_a_number_of_threads_that_numba_cannot_take_is_refused(threads: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_NUM_THREADS", threads)
    with pytest.raises(InvalidInputError, match=r"NUMBA_NUM_THREADS is .* whole number of at least 1"):
        check_environment()
