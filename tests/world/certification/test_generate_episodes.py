"""Making episodes: view points, certified episodes, and the command that writes them."""

from collections import Counter
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.cli.main import main
from uniteam.geometry import BasePose
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import START_DISTANCE, EpisodeMaker
from uniteam.world.certification.rejection import Cause, Proposals, Rejected
from uniteam.world.certification.view_points import Viewpoints
from uniteam.world.homes.home import Home
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.episode import Episode
from uniteam.world.task.footprint import distance_to_footprint
from uniteam.world.task.splits import SPLIT_DIRECTORY, SPLIT_NAMES, SUFFIX, load_split


@pytest.fixture(scope="module")
def home() -> Home:
    split = load_split("minival")
    return split.homes[split.episodes[0].home]


@pytest.fixture(scope="module")
def simulator(home: Home) -> Simulator:
    return Simulator(home, HEAD_CAMERA_HALF)


@pytest.fixture(scope="module")
def made(home: Home) -> tuple[Episode, ...]:
    return tuple(EpisodeMaker(home, Tally(), "tidy").episodes(2))


def test_view_points_are_reachable_near_and_see_the_instance(home: Home, simulator: Simulator) -> None:
    views = Viewpoints(home, simulator.floor, simulator.physics.model)
    rng = np.random.default_rng(0)
    seen = []
    things = [i.name for i in home.instances if i.movable and load_catalogue()[i.model].size[2] > 0.06]
    for name in filled(rng.choice(things, 8, replace=False)):
        x, y, _ = home.by_name[name].position
        points = [p for p in views.of(name) if np.hypot(p[0] - x, p[1] - y) > 0.7]
        for i in filled(rng.permutation(len(points))[:4]):
            px, py = points[i]
            assert simulator.floor.is_free(px, py)
            assert distance_to_footprint(home, home.by_name[name], np.array([px, py])) <= 1.0
            simulator.reset(BasePose(px, py, float(np.arctan2(y - py, x - px))))
            index = home.instances.index(home.by_name[name])
            seen.append(bool(np.any(simulator.render().instances == index)))
    assert np.mean(seen) > 0.8


def test_furniture_is_seen_from_within_a_metre_of_its_rectangle(home: Home, simulator: Simulator) -> None:
    views = Viewpoints(home, simulator.floor, simulator.physics.model)
    bed = home.of_category("bed")[0]
    distances = distance_to_footprint(home, bed, np.array(views.of(bed.name)))
    assert len(distances) > 20
    assert 0.9 < distances.max() <= 1.0


def test_what_is_behind_a_wall_is_not_seen(home: Home, simulator: Simulator) -> None:
    views = Viewpoints(home, simulator.floor, simulator.physics.model)
    blocked = 0
    for instance in home.instances:
        if instance.category in RECEPTACLE_CATEGORIES:
            room = next(r for r in home.stage.rooms if r.name == instance.room)
            points, seen = views.standable(instance), set(views.of(instance.name))
            outside = (points < np.array(room.low) - 0.3) | (points > np.array(room.high) + 0.3)
            hidden = [tuple(p) not in seen for p in points[outside.any(axis=1)].tolist()]
            blocked += sum(hidden)
    assert blocked > 50


def test_certified_episodes_start_far_from_the_object_and_ask_for_different_things(
    home: Home, made: tuple[Episode, ...], simulator: Simulator
) -> None:
    assert len(made) == 2
    assert len({episode.instruction for episode in made}) == 2
    assert len({episode.id for episode in made}) == 2
    for episode in filled(made):
        assert simulator.floor.is_free(episode.start.x, episode.start.y)
        assert simulator.floor.largest_component[simulator.floor.to_cell(episode.start.x, episode.start.y)]
        for candidate in filled(episode.objects):
            assert episode.start.distance_to(*home.by_name[candidate.name].position[:2]) >= START_DISTANCE
            assert candidate.view_points
        assert all(candidate.view_points for candidate in filled(episode.goal_receptacles))
        assert episode.certificate is not None


def test_an_episode_says_what_makes_it_hard(home: Home, made: tuple[Episode, ...], simulator: Simulator) -> None:
    for episode in filled(made):
        tags, certificate = episode.tags, episode.certificate
        assert tags is not None and certificate is not None
        assert (tags.style, tags.rooms, tags.goals) == ("tidy", len(home.stage.rooms), len(episode.goal_receptacles))
        assert tags.area == pytest.approx(sum(room.area for room in home.stage.rooms), abs=0.1)
        straight = episode.start.distance_to(certificate.grasp.x, certificate.grasp.y)
        straight += certificate.grasp.distance_to(certificate.release.x, certificate.release.y)
        assert straight - 0.01 <= tags.shortest_path <= 4 * straight
        assert 0.299 <= tags.least_clearance <= simulator.floor.clearance(episode.start.x, episode.start.y)
        assert tags.object_height == pytest.approx(home.by_name[certificate.object].position[2], abs=1e-3)
        assert tags.object_pixels > 0
        same = len(home.of_category(episode.instruction.object_category))
        assert tags.same_class == same - len(episode.objects)


def test_what_is_rejected_is_counted_by_cause(home: Home) -> None:
    maker = EpisodeMaker(home, Tally(), "tidy")
    certifier = maker._certifier
    task = next(iter(maker._tasks))
    certifier._views._standable[:] = False
    outcome = certifier.certify(task, "x", BasePose(1.0, 1.0, 0.0), 0)
    assert outcome == Rejected(Cause.OBJECT_UNSEEN)


def test_the_shares_of_rejected_proposals_are_told() -> None:
    proposals = Proposals(certified=6)
    other = Proposals(certified=0, rejected=Counter({Cause.RELEASE_FAILS: 3, Cause.NO_START: 1}))
    proposals.add(other)
    first, *causes = proposals.lines()
    assert first == "4 of 10 proposals rejected (40.0 %)"
    assert causes[0].startswith("30.0 % ") and causes[1].startswith("10.0 % no start")
    assert Proposals().lines() == ["no episode was proposed"]


def test_the_same_home_gives_the_same_episodes(home: Home, made: tuple[Episode, ...]) -> None:
    assert tuple(EpisodeMaker(home, Tally(), "tidy").episodes(1)) == made[:1]


def test_the_command_writes_a_split_that_can_be_played(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "mine.jsonl.gz"
    with pytest.raises(SystemExit) as ended:
        main(["episodes", "--homes", "9000", "--per-home", "1", "--out", str(out)])
    assert ended.value.code == 0
    split = load_split(out)
    assert (split.name, len(split.episodes), len(split.homes)) == ("mine", 1, 1)
    assert "uniteam evaluate --split" in capsys.readouterr().out


@pytest.mark.parametrize("homes", ["ten", "5:5", "-3:2"])
def test_seeds_that_are_none_are_refused_in_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], homes: str
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["episodes", f"--homes={homes}", "--out", str(tmp_path / "mine.jsonl.gz")])
    assert ended.value.code == 2
    assert "9000:9010" in capsys.readouterr().err


def test_built_in_splits_share_no_home() -> None:
    present = [name for name in SPLIT_NAMES if (SPLIT_DIRECTORY / f"{name}{SUFFIX}").exists()]
    homes = [set(load_split(name).homes) for name in present]
    assert all(one.isdisjoint(other) for one, other in filled(combinations(homes, 2)))
