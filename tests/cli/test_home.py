"""`uniteam home` and `uniteam assets`: pictures, tables, and one sentence where there are none."""

from pathlib import Path

import cv2
import mujoco
import numpy as np
import pytest
from worlds.called import call
from worlds.own_home import made_home

from uniteam.world.homes.serialization import write_home


def test_a_homes_own_file_is_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_home(made_home(tmp_path), tmp_path / "loft.json")
    out = tmp_path / "pictures"
    assert call("home", str(tmp_path / "loft.json"), "--out", str(out)) == 0
    assert {path.name for path in out.iterdir()} == {"plan.png", "above.png", "loft_1.png"}
    assert all(np.std(np.asarray(cv2.imread(str(path)))) > 10.0 for path in out.iterdir())
    told = capsys.readouterr().out
    assert "home loft: 1 rooms, 27 m2" in told
    assert str(out) in told.replace("\n", "")


def test_a_home_is_written_for_other_programs_and_its_ways_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_home(made_home(tmp_path), tmp_path / "loft.json")
    mjcf, glb = tmp_path / "mjcf", tmp_path / "loft.glb"
    asked = ("home", str(tmp_path / "loft.json"), "--out", str(tmp_path / "pictures"), "--mjcf", str(mjcf))
    assert call(*asked, "--glb", str(glb)) == 0
    assert mujoco.MjModel.from_xml_path(str(mjcf / "home.xml")).ngeom > 5
    assert glb.read_bytes()[:4] == b"glTF"
    told = capsys.readouterr().out
    assert "way between rooms" in told and "receptacles" in told


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("home", "7", "--source", "my:own", "--style", "lived_in"), "are made of train or test, not by 'my:own'"),
        (("home", "7", "--glb", "home.gltf"), ".glb"),
        (("home", "nowhere.json"), "'nowhere.json' is neither a seed (a whole number) nor the file of a home"),
        (("home", "--", "-1"), "a home's seed must not be negative, got -1"),
        (("home", "9" * 5000), "is neither a seed (a whole number) nor the file of a home"),
        (("home", "1" + "0" * 20), "a home's seed must be at most 9007199254740992"),
        (("home", "7", "--source", "tset"), "unknown source of homes 'tset': did you mean 'test'?"),
        (("home", "damaged.json"), "the home damaged.json cannot be read"),
        (("home", "1", "--out", "damaged.json"), "'damaged.json' cannot be written (File exists)"),
        (("assets", "--category", "chiar"), "unknown category 'chiar': did you mean 'chair'?"),
        (("assets", "--library", "nowhere"), "nowhere/catalogue.json cannot be read (there is no such file)"),
        (("assets", "--category", "cup", "--sheet", "damaged.json"), "'damaged.json' cannot be written"),
        (("episodes", "--homes", "9", "--out", "mine.json"), "'mine.json' must end in .jsonl.gz"),
        (("episodes", "--homes", "9", "--out", "damaged.json/mine.jsonl.gz"), "cannot be written"),
        (("episodes", "--homes", "9:1", "--out", "mine.jsonl.gz"), "--homes must be seeds such as 9000:9010"),
        (("episodes", "--homes", "0:" + "9" * 30, "--out", "mine.jsonl.gz"), "--homes must be seeds such as"),
        (("episodes", "--homes", "9", "--per-home", "0", "--out", "mine.jsonl.gz"), "--per-home must be from 1 to"),
        (("episodes", "--homes", "9", "--source", "tset", "--out", "mine.jsonl.gz"), "unknown source of homes 'tset'"),
    ],
)
def test_bad_input_is_answered_in_one_sentence(
    arguments: tuple[str, ...],
    sentence: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("damaged.json").write_text("{")
    assert call(*arguments) == 2
    lines = capsys.readouterr().err.strip().splitlines()
    assert len(lines) == 1
    assert sentence in lines[0]
    assert [path.name for path in tmp_path.iterdir()] == ["damaged.json"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no device that is always full")
def test_a_picture_that_was_not_written_is_not_told_as_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "above.png").symlink_to("/dev/full")
    assert call("home", "1", "--out", str(tmp_path)) == 2
    told = capsys.readouterr()
    assert "above.png' cannot be written (No space left on device)" in told.err
    assert "pictures in" not in told.out
