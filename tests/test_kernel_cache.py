"""Compiled kernels find a folder that can be written, and the kernels of other sources find another."""

import ast
import os
import shutil
import stat
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import uniteam
from uniteam.errors import InvalidInputError
from uniteam.kernel_cache import SOURCES, VARIABLE, cache_folder, check_environment, ensure_cache

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
    folder = Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home")).parent
    assert folder.parent == tmp_path / "tmp"
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    assert Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home")).parent == folder


def test_kernels_are_kept_in_a_home_that_can_be_written(installation: Path, tmp_path: Path) -> None:
    folder = Path(chosen_folder(installation, tmp_path / "tmp", str(tmp_path)))
    assert folder.is_relative_to(tmp_path)
    assert not folder.is_relative_to(tmp_path / "tmp")


def test_a_folder_that_others_can_write_is_not_trusted(installation: Path, tmp_path: Path) -> None:
    first = Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home")).parent
    first.chmod(0o777)
    second = Path(chosen_folder(installation, tmp_path / "tmp", "/dev/null/home")).parent
    assert second != first
    assert stat.S_IMODE(second.stat().st_mode) == 0o700


def test_the_users_own_choice_of_a_place_is_kept_by_worker_processes_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    ensure_cache()
    chosen, lasts = cache_folder()
    assert (chosen.parent, lasts) == (tmp_path, True)
    ensure_cache()
    assert cache_folder()[0] == chosen


KERNEL = """
from typing import NamedTuple
from numba import njit

class {name}(NamedTuple):
    x: float

@njit(cache=True)
def doubled(one):
    return {factor} * one.x
"""
CALL = "import uniteam; from uniteam.stretch import {name}, doubled; print(doubled({name}(1.0)))"


def test_a_cache_of_other_sources_is_left_alone(installation: Path, tmp_path: Path) -> None:
    """numba itself cannot read a cache with a type that is gone: "module has no attribute 'Old'"."""
    installation.joinpath("uniteam").chmod(0o755)
    source = installation / "uniteam" / "stretch.py"
    variables = {**os.environ, "PYTHONPATH": str(installation), VARIABLE: str(tmp_path / "cache")}
    printed = []
    for name, factor in (("Old", 2.0), ("New", 3.0), ("Old", 2.0)):
        source.write_text(KERNEL.format(name=name, factor=factor))
        os.utime(source, ns=(0, 0))
        command = [sys.executable, "-B", "-c", CALL.format(name=name)]
        printed.append(
            subprocess.run(command, env=variables, capture_output=True, text=True, check=True).stdout.strip()
        )
    assert printed == ["2.0", "3.0", "2.0"]
    assert len(list((tmp_path / "cache").iterdir())) == 2


PACKAGE = Path(uniteam.__file__).parent


def files_from_which_kernels_take_something(path: Path) -> set[str]:
    """Return the files of the package whose names a module's kernels use, or are annotated with."""
    module = import_module(".".join(("uniteam", *path.relative_to(PACKAGE).with_suffix("").parts)))
    functions = [value.py_func for value in vars(module).values() if hasattr(value, "py_func")]
    used = {name for function in functions for name in function.__code__.co_names}
    used |= {getattr(type_, "__name__", "") for function in functions for type_ in function.__annotations__.values()}
    imports = [node for node in ast.parse(path.read_text()).body if isinstance(node, ast.ImportFrom)]
    modules = [str(node.module) for node in imports if used & {alias.name for alias in node.names}]
    return {name.removeprefix("uniteam.").replace(".", "/") + ".py" for name in modules if name.startswith("uniteam.")}


def test_every_file_with_kernels_and_every_file_from_which_they_take_something_counts() -> None:
    with_kernels = [path for path in sorted(PACKAGE.rglob("*.py")) if "from numba import njit" in path.read_text()]
    needed = {path.relative_to(PACKAGE).as_posix() for path in with_kernels}
    needed = needed.union(*(files_from_which_kernels_take_something(path) for path in with_kernels))
    assert needed == set(SOURCES)


@pytest.mark.parametrize("threads", ["0", "-1", "many", "", "1.5"])
def test_a_number_of_threads_that_numba_cannot_take_is_refused(threads: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_NUM_THREADS", threads)
    with pytest.raises(InvalidInputError, match=r"NUMBA_NUM_THREADS is .* whole number of at least 1"):
        check_environment()
