"""How many workers: by what this process may use, not by what the machine has."""

import os
from pathlib import Path

import pytest

from uniteam.evaluation.backends.capacity import allowed_cores, free_memory, most_workers

GB = 1024**3


def machine(root: Path, group: str, files: dict[str, str], available: int = 64 * GB) -> Path:
    """Write what a Linux system tells of memory and of this process's control group under a folder."""
    (root / "proc/self").mkdir(parents=True)
    (root / "proc/meminfo").write_text(f"MemTotal: 99 kB\nMemAvailable: {available // 1024} kB\n")
    (root / "proc/self/cgroup").write_text(group)
    for name, content in files.items():
        path = root / "sys/fs/cgroup" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content + "\n")
    return root


@pytest.fixture
def bound(monkeypatch: pytest.MonkeyPatch) -> None:
    """This process is bound to eight cores."""
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: set(range(8)), raising=False)


@pytest.mark.usefixtures("bound")
def test_cores_are_those_that_this_process_is_bound_to(tmp_path: Path) -> None:
    assert allowed_cores(machine(tmp_path, "0::/\n", {"cpu.max": "max 100000"})) == 8


@pytest.mark.usefixtures("bound")
def test_the_quota_of_the_group_or_of_one_around_it_limits_the_cores(tmp_path: Path) -> None:
    second = {"job/cpu.max": "300000 100000", "job/step/cpu.max": "max 100000"}
    assert allowed_cores(machine(tmp_path / "v2", "0::/job/step\n", second)) == 3
    first = {"cpu/job/cpu.cfs_quota_us": "150000", "cpu/job/cpu.cfs_period_us": "100000"}
    assert allowed_cores(machine(tmp_path / "v1", "3:cpu,cpuacct:/job\n0::/\n", first)) == 2
    tiny = {"cpu.max": "1000 100000"}
    assert allowed_cores(machine(tmp_path / "tiny", "0::/\n", tiny)) == 1


def test_memory_is_what_the_system_has_left(tmp_path: Path) -> None:
    assert free_memory(machine(tmp_path, "0::/\n", {"memory.max": "max"}, available=5 * GB)) == 5 * GB


def test_the_groups_limit_counts_less_what_is_used_and_cannot_be_freed(tmp_path: Path) -> None:
    second = {"memory.max": str(4 * GB), "memory.current": str(3 * GB), "memory.stat": f"inactive_file {GB}\nanon 1"}
    assert free_memory(machine(tmp_path / "v2", "0::/\n", second)) == 2 * GB
    first = {"memory/memory.limit_in_bytes": str(4 * GB), "memory/memory.usage_in_bytes": str(3 * GB)}
    assert free_memory(machine(tmp_path / "v1", "4:memory:/docker/ab12\n", first)) == GB


def test_a_limit_that_is_none_is_none(tmp_path: Path) -> None:
    none = {"memory/memory.limit_in_bytes": "9223372036854771712", "memory/memory.usage_in_bytes": "1"}
    assert free_memory(machine(tmp_path, "4:memory:/\n", none)) == 64 * GB


@pytest.mark.usefixtures("bound")
def test_there_is_always_one_worker_and_never_more_than_four_a_core(tmp_path: Path) -> None:
    used_up = {"memory.max": str(GB), "memory.current": str(2 * GB)}
    assert most_workers(machine(tmp_path, "0::/\n", used_up)) == 1
    assert most_workers(machine(tmp_path / "other", "0::/\n", {})) == 32
    assert most_workers(machine(tmp_path / "small", "0::/\n", {}, available=3 * GB)) == 3


def test_this_machine_has_cores_and_memory() -> None:
    assert allowed_cores() >= 1
    assert free_memory() > 1e8
