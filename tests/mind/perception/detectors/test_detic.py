"""Detic in another process: a real process, in which a stand-in answers at the library's border."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from worlds.box_world import Box, observe
from worlds.detic_stand_in import write

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import Instruction, Observation, Perception
from uniteam.mind.perception.detectors.detic import DeticError
from uniteam.mind.perception.registry import make_perception
from uniteam.testing import check_perception

PLAIN = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"),), BasePose(0.0, 0.0, 0.0))
CUP = Instruction("cup", "chest_of_drawers", "bed")


@pytest.fixture
def settings(tmp_path: Path) -> dict[str, object]:
    """Where the stand-in is; each test has a process of its own."""
    folder = write(tmp_path / "Detic")
    files = {"config": "config.yaml", "weights": "weights.pth"}
    return {"python": sys.executable, "detic": str(folder), **files, "starting_seconds": 60.0, "frame_seconds": 20.0}


def made(settings: dict[str, object], tmp_path: Path) -> Perception:
    file = tmp_path / "detic.json"
    file.write_text(json.dumps(settings))
    perception = make_perception(f"detic:{file}")
    perception.reset(CUP, 0)
    return perception


def half_red() -> Observation:
    rgb = PLAIN.rgb.copy()
    rgb[:, :100, 0] = 255
    return replace(PLAIN, rgb=rgb)


def test_it_passes_the_check(settings: dict[str, object], tmp_path: Path) -> None:
    made(settings, tmp_path)
    check_perception(f"detic:{tmp_path / 'detic.json'}", steps=4)


def test_masks_names_and_scores_come_back_and_frames_arrive_as_bgr(settings: dict[str, object], tmp_path: Path) -> None:
    perception = made(settings, tmp_path)
    seen = perception.perceive(half_red())
    assert [(d.name, d.score) for d in seen.detections] == [("cup", 0.8), ("chest_of_drawers", 0.4)]
    assert (seen.instances[:, :100] == 0).all() and (seen.instances[:, 100:] == 1).all()
    assert perception.perceive(PLAIN).detections == ()
    perception.reset(Instruction("bowl", "bed", "bed"), 0)
    assert [d.name for d in perception.perceive(half_red()).detections] == ["bowl", "bed"]


@pytest.mark.parametrize(
    ("mode", "sentence"),
    [
        ("dies", "Detic failed at a frame .*the GPU is gone"),
        ("sleeps", r"it took more than 1 s and was ended"),
        ("stumbles", "RuntimeError: out of memory"),
    ],
)
def test_what_happens_to_the_process_is_told_in_a_sentence(
    settings: dict[str, object], tmp_path: Path, mode: str, sentence: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("STAND_IN", mode)
    perception = made({**settings, "frame_seconds": 1.0}, tmp_path)
    with pytest.raises(DeticError, match=sentence):
        perception.perceive(half_red())


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"python": "/nowhere/python"}, "'/nowhere/python' cannot be run .*environment of their own"),
        ({"weights": "missing.pth"}, "Detic cannot be loaded; install.*FileNotFoundError"),
        ({"detic": "/nowhere"}, "Detic cannot be loaded; install.*FileNotFoundError"),
    ],
)
def test_what_is_missing_is_told_with_what_to_install(
    settings: dict[str, object], tmp_path: Path, change: dict[str, str], sentence: str
) -> None:
    with pytest.raises(DeticError, match=sentence):
        made({**settings, **change}, tmp_path)


def test_an_environment_without_detectron2_is_told(settings: dict[str, object], tmp_path: Path) -> None:
    (tmp_path / "Detic" / "detectron2" / "config.py").unlink()
    (tmp_path / "Detic" / "detectron2" / "engine.py").unlink()
    with pytest.raises(DeticError, match=r"Detic cannot be loaded; install.*ModuleNotFoundError.*detectron2"):
        made(settings, tmp_path)


@pytest.mark.parametrize("text", ["{", "[]", '{"python": "p"}', '{"python": "p", "detic": "d", "wieghts": "w"}'])
def test_a_damaged_file_is_refused_in_a_sentence(tmp_path: Path, text: str) -> None:
    file = tmp_path / "detic.json"
    file.write_text(text)
    with pytest.raises(DamagedFileError, match='must hold "python" and "detic"'):
        make_perception(f"detic:{file}")


def test_a_missing_file_is_refused() -> None:
    with pytest.raises(InvalidInputError, match="needs a JSON file that says where Detic is"):
        make_perception("detic:nowhere.json")


def test_masks_of_any_size_are_packed_and_unpacked(settings: dict[str, object], tmp_path: Path) -> None:
    rgb = np.zeros((320, 240, 3), np.uint8)
    rgb[7, 13, 0] = 255
    perception = made(settings, tmp_path)
    seen = perception.perceive(replace(PLAIN, rgb=rgb))
    assert np.argwhere(seen.instances == 0).tolist() == [[7, 13]]
