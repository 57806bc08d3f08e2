"""What a package from outside brings works from the shell, in worker processes, as what is built in does."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from worlds import house_guest
from worlds.filled import filled

ENTRY_POINTS = """
[uniteam.agents]
spinner = house_guest:Spinner
[uniteam.perceptions]
blindfold = house_guest:Blindfold
[uniteam.improvements]
careful = house_guest:careful
[uniteam.homes]
cabins = house_guest:cabins
"""

METADATA = "Metadata-Version: 2.1\nName: house-guest\nVersion: 1.5\n"

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which the package is installed, as pip does it."""
    folder = tmp_path_factory.mktemp("site")
    shutil.copy(house_guest.__file__, folder / "house_guest.py")
    (folder / "house_guest-1.5.dist-info").mkdir()
    (folder / "house_guest-1.5.dist-info" / "METADATA").write_text(METADATA)
    (folder / "house_guest-1.5.dist-info" / "entry_points.txt").write_text(ENTRY_POINTS)
    return folder


@pytest.fixture
def workshop(tmp_path: Path) -> Path:
    """A folder with the module in it, not installed."""
    shutil.copy(house_guest.__file__, tmp_path / "my_agent.py")
    return tmp_path


def uniteam(
    folder: Path, *arguments: str, site: Path | None = None, **variables: str
) -> subprocess.CompletedProcess[str]:
    """Run the command in a folder, with what is installed in `site`."""
    paths = [str(site)] if site is not None else []
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([*paths, os.environ.get("PYTHONPATH", "")])} | variables
    command = [sys.executable, "-c", "from uniteam.cli.main import main; main()", *arguments]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)


def evaluate(
    folder: Path, *arguments: str, site: Path | None = None, **variables: str
) -> subprocess.CompletedProcess[str]:
    command = ("evaluate", "--episodes", "2", "--workers", "2", "--out", "out", *arguments)
    return uniteam(folder, *command, site=site, **variables)


def results(folder: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (folder / "out" / "results.jsonl").read_text().splitlines()]


def test_everything_that_an_installed_package_brings_is_listed_with_where_it_is_from(
    installed: Path, tmp_path: Path
) -> None:
    told = uniteam(tmp_path, "agents", site=installed, COLUMNS="200")
    assert told.returncode == 0
    for word in ("spinner", "blindfold", "careful", "cabins"):
        line = next(line for line in told.stdout.splitlines() if line.startswith(word))
        assert "house-guest 1.5" in line
    assert "does something with care that others do not" in told.stdout
    assert "edge_margin" in told.stdout


def test_the_help_teaches_the_names(installed: Path, tmp_path: Path) -> None:
    told = uniteam(tmp_path, "evaluate", "--help", site=installed).stdout
    for word in ("baseline", "oracle", "spinner", "truth", "blindfold", "edge_margin:", "careful: does something"):
        assert word in told


def test_an_installed_agent_perception_and_improvement_play_in_worker_processes(
    installed: Path, tmp_path: Path
) -> None:
    done = evaluate(
        tmp_path, "--agents", "spinner", "uniteam", "--perception", "blindfold", "--with", "careful", site=installed
    )
    assert done.stderr == ""
    assert done.returncode == 0
    assert "spinner" in done.stdout
    assert "uniteam with careful" in done.stdout.replace("\n", " ") or "careful" in done.stdout
    played = results(tmp_path)
    assert {row["agent"] for row in played} == {"spinner", "uniteam with careful"}
    assert [row["measures"]["num_steps"] for row in played if row["agent"] == "spinner"] == [6, 6]
    others = filled(row for row in played if row["agent"] != "spinner")
    assert not any(row["measures"]["pick_object_phase_success"] for row in others)
    assert not any(row["traceback"] for row in played)


def test_an_installed_source_of_homes_makes_homes(installed: Path, tmp_path: Path) -> None:
    done = uniteam(tmp_path, "home", "7", "--source", "cabins", "--out", "seven", site=installed)
    assert done.stderr == ""
    assert "cabin_7" in done.stdout
    assert (tmp_path / "seven" / "plan.png").stat().st_size > 1000


def test_episodes_in_homes_of_an_installed_source_are_certified_and_played_in_worker_processes(
    installed: Path, tmp_path: Path
) -> None:
    command = ("episodes", "--homes", "7:9", "--per-home", "1", "--source", "cabins", "--out", "cabins.jsonl.gz")
    made = uniteam(tmp_path, *command, site=installed)
    assert (made.returncode, made.stderr) == (0, "")
    assert "2 episodes in 2 homes" in made.stdout
    done = evaluate(tmp_path, "--split", "cabins.jsonl.gz", "--agents", "oracle", "spinner", site=installed)
    assert (done.returncode, done.stderr) == (0, "")
    played = results(tmp_path)
    assert {(row["agent"], row["home"]) for row in played} == {
        (agent, home) for agent in ("oracle", "spinner") for home in ("cabin_7", "cabin_8")
    }
    assert all(row["measures"]["place_success"] for row in filled(r for r in played if r["agent"] == "oracle"))


def test_an_agent_of_the_present_folder_has_its_row_its_film_and_is_taken_up_again(workshop: Path) -> None:
    command = ("--agents", "random", "my_agent:Spinner")
    first = evaluate(workshop, *command)
    assert first.stderr == ""
    assert "my_agent:Spinner" in first.stdout.replace("\n", "")
    again = evaluate(workshop, *command)
    assert "4 of 4 episodes were played before" in again.stdout
    film = uniteam(workshop, "run", "--agent", "my_agent:Spinner", "--video", "film.mp4")
    assert film.returncode == 0
    assert "SPIN: I am looking for" in film.stdout
    assert (workshop / "film.mp4").stat().st_size > 1000


def test_an_agent_that_has_changed_is_another_agent(workshop: Path) -> None:
    assert evaluate(workshop, "--agents", "my_agent:Spinner").returncode == 0
    source = workshop / "my_agent.py"
    source.write_text(source.read_text().replace("step < 5", "step < 7"))
    changed = evaluate(workshop, "--agents", "my_agent:Spinner")
    assert changed.returncode == 2
    assert "holds results of another configuration" in changed.stderr


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--agents", "no_such_module:Agent"), "No module named 'no_such_module'"),
        (("--agents", "my_agent:Spinet"), "names nothing"),
        (("--agents", "my_agent:np"), "agent"),
        (("--perception", "my_agent:careful"), "perception 'my_agent:careful' must be"),
        (("--with", "my_agent:Spinner"), "my_agent:Spinner"),
        (("--agents", "broken:Agent"), "ZeroDivisionError"),
    ],
)
def test_what_cannot_be_used_is_told_in_one_sentence(arguments: tuple[str, ...], sentence: str, workshop: Path) -> None:
    (workshop / "broken.py").write_text("1 / 0\n")
    done = evaluate(workshop, *arguments)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert sentence in done.stderr


@pytest.mark.parametrize(
    ("name", "failure"),
    [
        ("Crasher", "crashed after 2 steps with ValueError: a wheel came off"),
        ("Quitter", "crashed after 2 steps with SystemExit"),
        ("Mute", "crashed after 0 steps with InvalidInputError: an agent's act must return a Decision, got NoneType"),
        ("Jumper", "crashed after 0 steps with InvalidActionError"),
    ],
)
def test_what_an_agent_does_wrong_is_its_failure(name: str, failure: str, workshop: Path) -> None:
    done = evaluate(workshop, "--agents", f"my_agent:{name}")
    assert done.returncode == 0
    assert "Crashed and counted as failures: 2." in done.stdout
    assert all(row["failure"].startswith(failure) and row["traceback"] for row in filled(results(workshop)))


def test_an_agent_that_hangs_runs_out_of_time_and_the_run_goes_on(workshop: Path) -> None:
    done = evaluate(workshop, "--agents", "my_agent:Sleeper", "random", "--episode-seconds", "6")
    assert done.returncode == 0
    played = results(workshop)
    assert len(played) == 4
    hung = [row for row in played if row["agent"] == "my_agent:Sleeper"]
    assert [row["failure"] for row in hung] == ["ran out of time: the agent took more than 6 s"] * 2


def test_an_episode_whose_worker_was_killed_is_lost_and_played_again(workshop: Path) -> None:
    first = evaluate(workshop, "--agents", "my_agent:Victim", "random")
    assert first.returncode == 2
    assert "2 of the episodes were lost by no fault of the agents (its process was killed" in first.stderr
    assert len(first.stderr.splitlines()) == 1
    assert {row["agent"] for row in results(workshop)} == {"random"}
    assert len((workshop / "out" / "lost.jsonl").read_text().splitlines()) == 2
    again = evaluate(workshop, "--agents", "my_agent:Victim", "random", SPARE_ME="1")
    assert again.returncode == 0
    assert sorted(row["agent"] for row in results(workshop)) == ["my_agent:Victim"] * 2 + ["random"] * 2


def test_an_exception_of_the_simulator_is_no_failure_of_the_agent(workshop: Path) -> None:
    done = evaluate(workshop, "--agents", "my_agent:Saboteur")
    assert done.returncode == 2
    assert "the simulator failed with AttributeError" in done.stderr
    assert results(workshop) == []
    lost = [json.loads(line) for line in (workshop / "out" / "lost.jsonl").read_text().splitlines()]
    assert all("Traceback" in entry["traceback"] for entry in filled(lost))
