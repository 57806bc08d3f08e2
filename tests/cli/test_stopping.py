"""A command that is told to end does so at once, keeps what it has, and goes on where it was."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import av
import pytest

from uniteam.evaluation.results.result import result_from_line

EVALUATE = ("evaluate", "--agents", "random", "--split", "val", "--workers", "2", "--out", "out")


def start(folder: Path, *arguments: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "uniteam.cli.main", *arguments]
    pipe = subprocess.PIPE
    heard = signal.signal(signal.SIGHUP, signal.SIG_DFL)  # a test run that `nohup` began would hand its deafness on
    try:
        return subprocess.Popen(command, cwd=folder, stdout=pipe, stderr=pipe, text=True, start_new_session=True)
    finally:
        signal.signal(signal.SIGHUP, heard)


def wait_until_larger(path: Path, size: int) -> None:
    for _ in range(6000):  # five minutes: the first command on a machine compiles the kernels
        if path.exists() and path.stat().st_size > size:
            return
        time.sleep(0.05)
    raise AssertionError(f"{path} has not grown beyond {size} bytes")


def children(process: int) -> list[int]:
    done = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process)], capture_output=True, text=True)
    return [int(word) for word in done.stdout.split()]


def are_alive(processes: list[int]) -> bool:
    done = subprocess.run(["ps", "-o", "stat=", "-p", ",".join(map(str, processes))], capture_output=True, text=True)
    return any(not state.startswith("Z") for state in done.stdout.split())


@pytest.mark.parametrize(
    ("number", "to_group"),
    [(signal.SIGTERM, False), (signal.SIGTERM, True), (signal.SIGHUP, True), (signal.SIGINT, True)],
)
def test_a_run_that_is_told_to_end_keeps_its_results_and_goes_on(
    number: signal.Signals, to_group: bool, tmp_path: Path
) -> None:
    run = start(tmp_path, *EVALUATE)
    wait_until_larger(tmp_path / "out" / "results.jsonl", 3000)
    workers = children(run.pid)
    began = time.monotonic()
    (os.killpg if to_group else os.kill)(run.pid, number)
    told, errors = run.communicate(timeout=30)
    assert time.monotonic() - began < 2.0
    assert run.returncode == 128 + number
    assert errors == ""
    assert "The same command goes on." in told
    time.sleep(0.5)  # multiprocessing's own helper ends after its parent
    assert not are_alive(workers)
    lines = (tmp_path / "out" / "results.jsonl").read_text().splitlines()
    kept = {result_from_line(line)[1].episode for line in lines}
    assert f"{len(lines)} of 400 results are kept" in told
    assert len(kept) == len(lines) > 0


def test_a_killed_run_is_taken_up_without_a_loss(tmp_path: Path) -> None:
    run = start(tmp_path, *EVALUATE)
    results = tmp_path / "out" / "results.jsonl"
    wait_until_larger(results, 3000)
    workers = children(run.pid)
    run.kill()
    run.communicate()
    before = results.read_bytes()
    count = before.count(b"\n")
    again = subprocess.run(
        [sys.executable, "-m", "uniteam.cli.main", *EVALUATE, "--episodes", str(count)],
        cwd=tmp_path, capture_output=True, text=True,
    )  # fmt: skip
    assert again.returncode == 0
    assert again.stderr == ""
    assert results.read_bytes().startswith(before[: before.rfind(b"\n") + 1])
    assert not are_alive(workers)


def test_a_film_that_is_told_to_end_plays_up_to_there(tmp_path: Path) -> None:
    run = start(tmp_path, "run", "--agent", "random", "--video", "film.mp4")  # it never stops by itself
    wait_until_larger(tmp_path / "film.mp4", 60_000)
    run.terminate()
    told, errors = run.communicate(timeout=30)
    assert run.returncode == 143
    assert errors == ""
    assert "Film: film.mp4, up to here" in told
    with av.open(str(tmp_path / "film.mp4")) as film:
        assert sum(1 for _ in film.decode(video=0)) > 5
