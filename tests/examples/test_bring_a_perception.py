"""The example of a perception of one's own works as its first lines say."""

from pathlib import Path

import pytest
from examples.conftest import Call

from uniteam.testing import check_perception
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


def test_an_agent_plays_with_the_detector_that_wavers(
    call: Call, tidy_loft: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    seen_with = ("--perception", "bring_a_perception:Wavering", "--out", str(tmp_path / "out"), "--workers", "1")
    assert call("evaluate", "--agents", "uniteam-plus", "--split", str(tidy_loft), "--episodes", "1", *seen_with) == 0
    told = capsys.readouterr().out
    assert "perception bring_a_perception:Wavering" in " ".join(told.split())
    assert "uniteam-plus, loft-0-mug: " in told
    assert "crashed" not in told


def test_the_detector_that_wavers_keeps_what_a_perception_promises() -> None:
    check_perception("bring_a_perception:Wavering")


def test_the_detector_that_wavers_misses_what_is_far_and_is_never_sure_of_it(tidy_loft: Path) -> None:
    from bring_a_perception import Wavering

    split = load_split(tidy_loft)
    environment = Environment(split.homes["loft-0"], split.episodes[0], give_truth=True)
    observation = environment.reset()
    eye = Wavering()
    eye.reset(environment.episode.instruction, seed=1)
    frames = [eye.perceive(observation) for _ in range(20)]
    scores = [detection.score for frame in frames for detection in frame.detections if detection.name == "table"]
    assert 0 < len(scores) < len(frames)
    assert all(0.0 < score < 1.0 for score in scores)
