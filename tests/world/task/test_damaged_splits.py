"""Damaged splits and senseless actions, many of them: each is refused in one sentence, or can be played."""

import copy
import gzip
import json
import math
from dataclasses import astuple
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from worlds.filled import filled
from worlds.nonsense import outcome

from uniteam.geometry import PinholeCamera
from uniteam.interface import BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import SPLIT_DIRECTORY, load_split

pytestmark = pytest.mark.slow

CAMERA = PinholeCamera.from_horizontal_fov(24, 32, math.radians(42.0))
CHECKS = [HealthCheck.function_scoped_fixture, HealthCheck.too_slow, HealthCheck.data_too_large]
ANYTHING = st.one_of(
    st.none(), st.booleans(), st.text(max_size=5), st.integers(-(10**30), 10**30), st.floats(-1e3, 1e3),
    st.sampled_from([float("nan"), float("inf"), -1, 10**9, [], {}, [[]], ["a"], [1, 2, 3], "", "table_1"]),
)  # fmt: skip


def _first_home() -> list[dict[str, Any]]:
    """Return the lines of the first home of minival, with its episode, after that with the split's version."""
    lines = [json.loads(line) for line in gzip.decompress((SPLIT_DIRECTORY / "minival.jsonl.gz").read_bytes()).split()]
    first, second, *_ = (i for i, line in enumerate(lines) if "home" in line)
    assert first < second
    return lines[:second]


LINES = _first_home()


@st.composite
def changed(draw: st.DrawFn) -> list[Any]:
    """Return the lines with one to three things replaced, left out, doubled or scaled."""
    lines = copy.deepcopy(LINES)
    for _ in range(draw(st.integers(1, 3))):
        owner: Any = lines
        if not lines:
            break
        key: Any = draw(st.integers(0, len(lines) - 1))
        while isinstance(owner[key], dict | list) and owner[key] and draw(st.integers(0, 6)) > 0:
            owner = owner[key]
            key = draw(st.sampled_from(sorted(owner) if isinstance(owner, dict) else range(len(owner))))
        action = draw(st.sampled_from(["replace", "leave out", "double", "scale", "nest"]))
        if action == "leave out":
            del owner[key]
        elif action == "double" and isinstance(owner, list):
            owner.append(copy.deepcopy(owner[key]))
        elif action == "scale" and isinstance(owner[key], int | float):
            owner[key] = owner[key] * draw(st.sampled_from([-1, 0, 10, 10**7, float("nan")]))
        elif action == "nest":
            owner[key] = [owner[key]]
        else:
            owner[key] = copy.deepcopy(draw(ANYTHING))
    return lines


@settings(max_examples=600, deadline=None, derandomize=True, suppress_health_check=CHECKS)
@given(lines=changed())
def test_a_changed_split_is_refused_or_can_be_played(lines: list[Any], tmp_path: Path) -> None:
    path = tmp_path / "changed.jsonl"
    path.write_text("\n".join(json.dumps(line) for line in lines))
    environment = outcome(lambda: begun(path))
    if environment is not None:
        observation = environment.step(DiscreteAction.TURN_LEFT)
        assert all(math.isfinite(value) for value in filled(astuple(observation.base_to_start)))


def begun(path: Path) -> Environment:
    """Return the first episode of a split, begun."""
    split = load_split(path)
    episode = split.episodes[0]
    environment = Environment(split.homes[episode.home], episode, CAMERA)
    environment.reset()
    return environment


@pytest.fixture(scope="module")
def environment() -> Environment:
    split = load_split("minival")
    environment = Environment(split.homes[split.episodes[0].home], split.episodes[0], CAMERA)
    environment.reset()
    return environment


NUMBERS = st.one_of(ANYTHING, st.floats(), st.sampled_from([10**400, 1e308, 1j, b"1"]))
DISPLACEMENTS = st.builds(BaseDisplacement, NUMBERS, NUMBERS, NUMBERS)
POSTURES = st.builds(Joints, NUMBERS, NUMBERS, head_pan=NUMBERS)
ACTIONS = st.one_of(
    ANYTHING, DISPLACEMENTS, st.builds(JointDisplacement, POSTURES | ANYTHING, DISPLACEMENTS | ANYTHING),
    st.builds(BaseDisplacement, st.floats(-1e308, 1e308), st.floats(-1e308, 1e308), st.floats(-1e308, 1e308)),
)  # fmt: skip


@settings(max_examples=300, deadline=None, derandomize=True, suppress_health_check=CHECKS)
@given(action=ACTIONS)
def test_any_action_is_refused_before_anything_moves_or_leaves_finite_poses(
    action: Any, environment: Environment
) -> None:
    simulator = environment.simulator
    before = simulator.base, simulator.joints, environment.measures
    if outcome(lambda: environment.step(action)) is None:
        assert (simulator.base, simulator.joints, environment.measures) == before
    assert all(math.isfinite(value) for value in filled((*astuple(simulator.base), *astuple(simulator.joints))))
