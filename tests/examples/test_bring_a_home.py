"""The example of a home of one's own works as its first lines say."""

from pathlib import Path

from examples.conftest import Call

from uniteam.testing import check_home
from uniteam.world.task.splits import load_split


def test_the_loft_is_drawn(call: Call, tmp_path: Path) -> None:
    assert call("home", "7", "--source", "bring_a_home:loft", "--out", str(tmp_path)) == 0
    assert {path.name for path in tmp_path.iterdir()} == {"plan.png", "above.png", "loft.png"}


def test_the_lofts_keep_what_a_source_of_homes_promises() -> None:
    check_home("bring_a_home:loft")


def test_episodes_are_made_in_the_loft(call: Call, tmp_path: Path) -> None:
    out = tmp_path / "loft.jsonl.gz"
    assert call("episodes", "--homes", "0", "--per-home", "1", "--source", "bring_a_home:loft", "--out", str(out)) == 0
    split = load_split(out)
    assert split.homes["loft-0"].library["tin_mug"].category == "cup"
    assert split.episodes[0].instruction.goal_receptacle == "couch"
