"""The measures, phase by phase, in a home: each is judged where it holds and where it does not."""

import math
from dataclasses import replace

import numpy as np
import pytest

from uniteam.geometry import BasePose
from uniteam.interface import DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF, gripper_to_base
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home
from uniteam.world.oracle.base_stands import manipulation_base
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.step_events import NOTHING
from uniteam.world.task.episode import Certificate, Episode
from uniteam.world.task.footprint import distance_to_footprint
from uniteam.world.task.judge import Judge
from uniteam.world.task.measures import Measures
from uniteam.world.task.splits import load_split

FOUND = Measures(find_object_phase_success=True)
CARRIED = Measures(
    find_object_phase_success=True, pick_object_phase_success=True, find_recep_phase_success=True
)  # fmt: skip


class Stage:
    """An episode's simulator and certificate, and a judge whose measures can be set."""

    def __init__(self) -> None:
        split = load_split("minival")
        self.episode: Episode = split.episodes[0]
        self.home: Home = split.homes[self.episode.home]
        self.simulator = Simulator(self.home, HEAD_CAMERA_HALF)
        assert self.episode.certificate is not None
        self.certificate: Certificate = self.episode.certificate

    def judge(self, measures: Measures) -> Judge:
        judge = Judge(self.home, self.episode)
        judge.measures = measures
        return judge

    def facing(self, stand: tuple[float, float], target: tuple[float, float]) -> BasePose:
        return BasePose(*stand, math.atan2(target[1] - stand[1], target[0] - stand[0]))

    def put_down(self, x: float, y: float, z: float) -> None:
        """Let the certified object fall from a point."""
        self.simulator.reset(self.certificate.grasp)
        pose = self.simulator.object_pose(self.certificate.object).copy()
        pose[:3, 3] = (x, y, z)
        self.simulator.physics.set_pose(self.certificate.object, pose)


@pytest.fixture(scope="module")
def stage() -> Stage:
    return Stage()


def _look(stage: Stage, judge: Judge, base: BasePose) -> Measures:
    stage.simulator.reset(base)
    judge.update(stage.simulator, NOTHING, stage.simulator.render(), stopped=False)
    return judge.measures


def _object_views(stage: Stage) -> tuple[tuple[float, float], list[tuple[float, float]]]:
    """Return where a candidate object lies and its view points at 0.9 to 1.3 m."""
    name = stage.certificate.object
    candidate = next(c for c in stage.episode.objects if c.name == name)
    x, y, _ = stage.home.by_name[name].position
    views = [p for p in candidate.view_points if 0.9 < math.hypot(p[0] - x, p[1] - y) < 1.3]
    return (x, y), views


def test_an_object_is_found_from_a_view_point_that_faces_it(stage: Stage) -> None:
    at, views = _object_views(stage)
    found = [
        _look(stage, stage.judge(Measures()), stage.facing(p, at)).find_object_phase_success for p in views[:8]
    ]  # fmt: skip
    assert sum(found) >= 0.7 * len(found) > 0


def test_an_object_is_not_found_with_the_back_to_it(stage: Stage) -> None:
    at, views = _object_views(stage)
    facing = stage.facing(views[0], at)
    away = replace(facing, heading=facing.heading + math.pi)
    assert not _look(stage, stage.judge(Measures()), away).find_object_phase_success


def test_an_object_is_not_found_away_from_its_view_points(stage: Stage) -> None:
    at, _ = _object_views(stage)
    judge = Judge(stage.home, replace(stage.episode, objects=(replace(stage.episode.objects[0], view_points=()),)))
    candidate = stage.episode.objects[0]
    assert not _look(stage, judge, stage.facing(candidate.view_points[0], at)).find_object_phase_success


def test_a_grasp_counts_only_for_a_candidate_that_was_found(stage: Stage) -> None:
    stage.simulator.reset(BasePose(stage.episode.start.x, stage.episode.start.y, 0.0))
    frame = stage.simulator.render()
    other = next(i.name for i in stage.home.instances if i.movable and i.category != "" and i.name not in
                 {c.name for c in stage.episode.objects})  # fmt: skip
    for measures, grasped, expected in (
        (FOUND, stage.certificate.object, True),
        (FOUND, other, False),
        (Measures(), stage.certificate.object, False),
    ):
        judge = stage.judge(measures)
        judge.update(stage.simulator, replace(NOTHING, grasped=grasped), frame, stopped=False)
        assert judge.measures.pick_object_phase_success is expected


def test_a_receptacle_is_found_only_after_the_pick(stage: Stage) -> None:
    name = stage.certificate.receptacle
    candidate = next(c for c in stage.episode.goal_receptacles if c.name == name)
    at = stage.home.by_name[name].position[:2]
    points = sorted(candidate.view_points, key=lambda p: abs(math.hypot(p[0] - at[0], p[1] - at[1]) - 1.2))
    base = stage.facing(points[0], at)
    picked = Measures(find_object_phase_success=True, pick_object_phase_success=True)
    assert _look(stage, stage.judge(picked), base).find_recep_phase_success
    assert not _look(stage, stage.judge(FOUND), base).find_recep_phase_success


def _released(stage: Stage, measures: Measures, steps: int = 60) -> list[bool]:
    """Return place_success after the release of the certified object and after each of the steps that follow."""
    judge = stage.judge(measures)
    frame = stage.simulator.render()
    placed = []
    events = replace(NOTHING, released=stage.certificate.object)
    for _ in range(steps):
        judge.update(stage.simulator, events, frame, stopped=False)
        placed.append(judge.measures.place_success)
        events = stage.simulator.apply(DiscreteAction.EMPTY_ACTION, "")
    return placed


def _over_the_goal(stage: Stage) -> tuple[float, float, float]:
    certificate = stage.certificate
    to_world = manipulation_base(certificate.release).matrix() @ gripper_to_base(certificate.release_joints)
    x, y, z = to_world[:3, 3]
    height = load_catalogue()[stage.home.by_name[certificate.object].model].size[2]
    return float(x), float(y), float(z) - height


def test_a_released_object_is_placed_once_it_rests_on_the_goal(stage: Stage) -> None:
    stage.put_down(*_over_the_goal(stage))
    placed = _released(stage, CARRIED)
    assert not placed[0]
    assert placed[-1]


def test_nothing_is_placed_before_the_receptacle_was_found(stage: Stage) -> None:
    stage.put_down(*_over_the_goal(stage))
    picked = Measures(find_object_phase_success=True, pick_object_phase_success=True)
    assert not any(_released(stage, picked))


def test_an_object_on_the_floor_is_not_placed(stage: Stage) -> None:
    start = stage.episode.start
    stage.put_down(start.x, start.y, 0.2)
    assert not any(_released(stage, CARRIED))


def test_an_object_that_rolls_off_later_is_not_placed(stage: Stage) -> None:
    stage.put_down(*_over_the_goal(stage))
    judge, frame = stage.judge(CARRIED), stage.simulator.render()
    judge.update(stage.simulator, replace(NOTHING, released=stage.certificate.object), frame, stopped=False)
    for _ in range(60):
        judge.update(stage.simulator, stage.simulator.apply(DiscreteAction.EMPTY_ACTION, ""), frame, stopped=False)
    assert judge.measures.place_success
    pose = stage.simulator.object_pose(stage.certificate.object).copy()
    pose[:3, 3] = (stage.episode.start.x, stage.episode.start.y, 0.3)
    stage.simulator.physics.set_pose(stage.certificate.object, pose)
    judge.update(stage.simulator, stage.simulator.apply(DiscreteAction.EMPTY_ACTION, ""), frame, stopped=False)
    assert not judge.measures.place_success


def test_collisions_and_steps_are_counted_and_cost_the_overall_success(stage: Stage) -> None:
    judge = stage.judge(replace(CARRIED, place_success=True))
    assert judge.measures.overall_success
    stage.simulator.reset(stage.episode.start)
    frame = stage.simulator.render()
    for hit in ("wall", None, "table_1"):
        judge.update(stage.simulator, replace(NOTHING, hit=hit), frame, stopped=False)
    assert judge.measures.robot_scene_colls == 2
    assert judge.measures.num_steps == 3
    assert not judge.measures.overall_success


def test_the_distance_to_furniture_is_that_to_its_turned_rectangle(stage: Stage) -> None:
    fixed = next(i for i in stage.home.instances if i.name == stage.certificate.receptacle)
    turned = replace(fixed, position=(1.0, 2.0, 0.0), quaternion=(math.cos(0.4), 0.0, 0.0, math.sin(0.4)))
    to_world = turned.model_to_world()
    width, depth, _ = load_catalogue()[fixed.model].size
    beside = (to_world @ [width / 2 + 0.7, 0.1, 0.0, 1.0])[:2]
    corner = (to_world @ [width / 2 + 0.3, depth / 2 + 0.4, 0.0, 1.0])[:2]
    inside = (to_world @ [0.0, depth / 2 - 0.01, 0.0, 1.0])[:2]
    assert distance_to_footprint(stage.home, turned, np.array([beside, corner, inside])) == pytest.approx(
        [0.7, 0.5, 0.0]
    )
