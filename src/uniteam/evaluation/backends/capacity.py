"""How many worker processes this machine, or what of it we are allowed, can bear."""

import os
from collections.abc import Iterator
from pathlib import Path

WORKER_MEMORY = 1.0e9
"""Bytes: a worker with a large home and the full-size camera stays below it."""

WORKERS_PER_CORE = 4
"""More would only wait for each other, even where their agents wait for something else most of the time."""

_UNLIMITED = 1 << 60
"""Version 1 of cgroups writes "no limit" as a number beyond any memory."""

_MEMORY_FILES = (("memory.max", "memory.current"), ("memory.limit_in_bytes", "memory.usage_in_bytes"))
"""Limit and usage as versions 2 and 1 of cgroups name them."""

_ROOT = Path("/")


def allowed_cores(root: Path = _ROOT) -> int:
    """Return how many cores this process may use: those it is bound to, and no more than its control group's quota.

    Args:
        root: where /proc and /sys are found.
    """
    bound = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    quota = min(_cpu_quotas(root), default=float(bound))
    return max(1, min(bound, int(quota + 0.5)))


def free_memory(root: Path = _ROOT) -> float:
    """Return how many bytes can still be used: those the system has left, and no more than our control group may."""
    return max(0.0, min([_available(root), *_memory_left(root)]))


def most_workers(root: Path = _ROOT) -> int:
    """Return how many workers fit into the free memory and do not get in each other's way; at least one."""
    return max(1, min(int(free_memory(root) / WORKER_MEMORY), WORKERS_PER_CORE * allowed_cores(root)))


def _available(root: Path) -> float:
    for line in _read(root / "proc/meminfo").splitlines():
        if line.startswith("MemAvailable:"):
            return float(line.split()[1]) * 1024.0
    if hasattr(os, "sysconf") and "SC_PHYS_PAGES" in os.sysconf_names:  # macOS: half of all, for want of a better guess
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2.0
    return float(_UNLIMITED)


def _cpu_quotas(root: Path) -> Iterator[float]:
    """Yield the cores that each control group around this process grants, where it grants fewer than all."""
    for folder in _groups(root, "cpu"):
        limit, period = _cpu_quota(folder)
        if _is_count(limit) and _is_count(period):
            yield int(limit) / int(period)


def _cpu_quota(folder: Path) -> tuple[str, str]:
    """Return what version 2 of cgroups writes as "LIMIT PERIOD" into one file, and version 1 into two."""
    words = _read(folder / "cpu.max").split()
    return (
        (words[0], words[1])
        if len(words) == 2
        else (
            _read(folder / "cpu.cfs_quota_us"),
            _read(folder / "cpu.cfs_period_us"),
        )
    )


def _memory_left(root: Path) -> Iterator[float]:
    """Yield the bytes that each control group around this process has left; its file cache counts as free."""
    for folder in _groups(root, "memory"):
        for limit_name, usage_name in _MEMORY_FILES:
            limit, usage = _read(folder / limit_name), _read(folder / usage_name)
            if _is_count(limit) and _is_count(usage) and int(limit) < _UNLIMITED:
                yield float(int(limit) - int(usage) + _file_cache(folder))


def _file_cache(folder: Path) -> int:
    lines = [line.split() for line in _read(folder / "memory.stat").splitlines()]
    return sum(int(words[1]) for words in lines if len(words) == 2 and words[0] == "inactive_file")


def _groups(root: Path, controller: str) -> Iterator[Path]:
    """Yield the folders of this process's control group and of those around it, of version 1 or 2."""
    for line in _read(root / "proc/self/cgroup").splitlines():
        _, controllers, path = line.split(":", 2)
        if controllers and controller not in controllers.split(","):
            continue
        top = root / "sys/fs/cgroup" / (controller if controllers else "")
        folder = top / path.strip("/")
        yield from (f for f in (folder, *folder.parents) if f.is_dir() and f.is_relative_to(top))


def _is_count(text: str) -> bool:
    return text.strip().isdigit() and int(text) > 0


def _read(path: Path) -> str:
    try:
        return path.read_text().strip()
    except OSError:
        return ""
