"""Groups of episodes, for a table with a row for each."""

from dataclasses import replace

import pytest

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.evaluation.analysis.breakdown import FACTS, grouped
from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.world.task.episode import Candidate, Episode
from uniteam.world.task.tags import Tags

TAGS = Tags("tidy", 90.0, 5, 10.0, 0.4, 0.7, 500, 1, 0)


def episode(number: int, unseen: bool = False, **facts: object) -> Episode:
    return Episode(
        f"e{number}", "h", BasePose(0, 0, 0), Instruction("cup", "table", "sink"), (Candidate("cup_1", ()),),
        ("table_1",), (Candidate("sink_1", ()),), unseen, 0, tags=replace(TAGS, **facts),  # type: ignore[arg-type]
    )  # fmt: skip


def sizes(episodes: list[Episode], fact: str) -> dict[str, int]:
    return {heading: len(own) for heading, own in grouped(episodes, fact).items()}


def test_words_and_small_numbers_make_a_group_of_each_value() -> None:
    episodes = [episode(k, style=("tidy", "lived_in")[k % 2], goals=1 + k % 3) for k in range(6)]
    assert sizes(episodes, "style") == {"style lived_in": 3, "style tidy": 3}
    assert sizes(episodes, "goals") == {"goals 1": 2, "goals 2": 2, "goals 3": 2}


def test_other_numbers_are_cut_into_thirds_in_their_order() -> None:
    episodes = [episode(k, object_height=0.1 * k) for k in range(9)]
    assert sizes(episodes, "object_height") == {
        "object height 0 to 0.2": 3, "object height 0.3 to 0.5": 3, "object height 0.6 to 0.8": 3
    }  # fmt: skip


def test_every_episode_is_in_one_group_of_every_fact() -> None:
    episodes = [episode(k, unseen=k == 3, object_pixels=[5, 5, 5, 9, 9, 12, 30, 31][k], area=k) for k in range(8)]
    for fact in FACTS:
        ids = [e.id for own in grouped(episodes, fact).values() for e in own]
        assert sorted(ids) == [f"e{k}" for k in range(8)]
    assert sizes(episodes, "unseen") == {"seen categories": 7, "unseen categories": 1}


def test_an_unknown_fact_and_an_episode_without_tags_are_refused() -> None:
    with pytest.raises(UnknownNameError, match="'style'"):
        grouped([episode(0)], "styel")
    with pytest.raises(InvalidInputError, match="'e1' has no tags"):
        grouped([episode(0), replace(episode(1), tags=None)], "rooms")
