"""Which episodes a run and its shards play."""

from collections import Counter
from dataclasses import replace

import pytest

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_choice import Shard, choose_episodes, deal, shard_named
from uniteam.world.task.splits import load_split

VAL = load_split("val")


@pytest.mark.parametrize(("count", "shards"), [(None, 4), (None, 7), (100, 3), (11, 11), (5, 1)])
def test_shards_are_disjoint_complete_and_as_large_as_each_other(count: int | None, shards: int) -> None:
    chosen = choose_episodes(VAL.episodes, count)
    parts = [deal(VAL.episodes, chosen, Shard(number, shards)) for number in range(1, shards + 1)]
    assert sorted(index for part in parts for index in part) == sorted(chosen)
    sizes = [len(part) for part in parts]
    assert max(sizes) - min(sizes) <= 1 and min(sizes) > 0


def test_a_home_is_shared_by_two_shards_only_where_a_cut_falls_into_it() -> None:
    chosen = choose_episodes(VAL.episodes, None)
    parts = [deal(VAL.episodes, chosen, Shard(number, 7)) for number in range(1, 8)]
    shards_of = Counter(home for part in parts for home in {VAL.episodes[index].home for index in part})
    assert sum(shards_of.values()) - len(shards_of) <= 6


def test_a_shard_too_takes_its_episodes_from_the_homes_in_turn() -> None:
    chosen = choose_episodes(VAL.episodes, None)
    part = deal(VAL.episodes, chosen, Shard(2, 4))
    homes = [VAL.episodes[index].home for index in part]
    assert len(set(homes[: len(set(homes))])) == len(set(homes)) > 5


def test_more_shards_than_episodes_are_refused() -> None:
    with pytest.raises(InvalidInputError, match="3 episodes cannot be dealt to 4 shards"):
        deal(VAL.episodes, choose_episodes(VAL.episodes, 3), Shard(1, 4))


def test_a_shard_is_named_by_its_number_and_their_count() -> None:
    assert shard_named("2/4") == Shard(2, 4)


@pytest.mark.parametrize("name", ["0/4", "5/4", "2", "2/", "a/b", "-1/4", "1/4/2", "", "1.0/4", "²/4", "1/0"])
def test_what_names_no_shard_is_refused(name: str) -> None:
    with pytest.raises(InvalidInputError, match="such as 2/4"):
        shard_named(name)


def test_the_configuration_says_what_merging_must_know_and_is_otherwise_the_whole_runs() -> None:
    run = Run("val", {"random": AgentSpec("random", "truth")}, "truth", "half", episode_count=20)
    whole = resolve(run, VAL)
    part = resolve(replace(run, shard=Shard(3, 3)), VAL)
    assert {name: value for name, value in part.items() if name != "shard"} == whole
    own = deal(VAL.episodes, choose_episodes(VAL.episodes, 20), Shard(3, 3))
    told = {"number": 3, "count": 3, "asked": 20, "episodes": [VAL.episodes[index].id for index in own]}
    assert part["shard"] == told
