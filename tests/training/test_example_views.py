"""Pictures of the views of which perception made most and least."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from uniteam.mind.perception.learned.asking import Asking
from uniteam.mind.perception.learned.eyes import Eyes
from uniteam.mind.perception.learned.networks import read_card
from uniteam.mind.perception.words.meaning import load_words, plain_words
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.training.calibration import FIRST_HOME
from uniteam.training.example_views import FEWEST_THINGS, SCALE, ExampleViews, Look
from uniteam.training.records import things_of
from uniteam.training.sightings import Watcher
from uniteam.training.views import training_home, views_of


@pytest.fixture(scope="module")
def asking() -> Asking:
    return Asking(read_card(), load_words())


@pytest.fixture(scope="module")
def looks(asking: Asking) -> list[Look]:
    """What was made of some views of a home in which no network was trained."""
    home, found = training_home(FIRST_HOME + 1), list[Look]()
    views = views_of(home, 36, np.random.default_rng(4), 0.0, 0.0)
    Watcher(Eyes(), asking, HEAD_CAMERA_HALF, found.append).watch(views, things_of(home))
    return found


def share_told(look: Look, asking: Asking) -> float:
    """Return which share of the things there have a region that is called what they are."""
    names = {(index, asking.best_name(glimpse)) for glimpse, index in zip(look.glimpses, look.matched, strict=True)}
    return sum((i, plain_words(look.things[i].category)) in names for i in look.there) / len(look.there)


def test_the_views_with_the_largest_and_the_smallest_share_of_right_names_are_kept(
    looks: list[Look], asking: Asking, tmp_path: Path
) -> None:
    shares = sorted(share_told(look, asking) for look in looks if len(look.there) >= FEWEST_THINGS)
    assert len(shares) >= 4 and shares[0] < shares[-1]
    examples = ExampleViews(asking, keep=2)
    for look in looks:
        examples(look)
    assert [e.share for e in examples.best] == shares[:-3:-1]
    assert [e.share for e in examples.worst] == shares[:2]
    written = examples.write(tmp_path / "pictures")
    assert [path.name for path in written] == ["best-1.png", "best-2.png", "worst-1.png", "worst-2.png"]
    height, width = HEAD_CAMERA_HALF.height * SCALE, 2 * HEAD_CAMERA_HALF.width * SCALE
    pictures = [np.asarray(cv2.imread(str(path))) for path in written]
    assert {picture.shape for picture in pictures} == {(height, width, 3)}
    left, right = pictures[0][:, : width // 2], pictures[0][:, width // 2 :]
    assert (left != right).any(axis=2).mean() > 0.3, "one half is what was seen, the other what it was taken for"


def test_views_of_few_things_are_passed_over(looks: list[Look], asking: Asking) -> None:
    examples = ExampleViews(asking)
    for look in looks:
        examples(
            Look(look.rgb, look.instances, look.things, look.glimpses, look.matched, look.there[: FEWEST_THINGS - 1])
        )
    assert examples.best == examples.worst == []
