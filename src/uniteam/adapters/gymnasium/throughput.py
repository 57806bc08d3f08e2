"""How many steps a second an environment makes on one core."""

import math
from dataclasses import dataclass
from time import perf_counter, process_time
from typing import Any

import gymnasium
import numpy as np

from uniteam.adapters.gymnasium.controls import STOP, Columns
from uniteam.adapters.gymnasium.task_env import TaskEnv
from uniteam.interface import DiscreteAction
from uniteam.stretch import NAVIGATION_POSTURE

_WARM_UP = 30
"""Steps before the clock runs: what is compiled is read from the cache in the first."""


@dataclass(frozen=True)
class Throughput:
    """What a random policy that does not stop got out of an environment, in one process.

    Attributes:
        name: of the environment.
        step_count: steps taken while the clock ran.
        steps_per_second: by the wall clock, resets left out.
        steps_per_cpu_second: by the processor's time, resets left out; other programs on the machine hardly change it.
        reset_milliseconds: of the processor's time, a reset in the home that is open; nan where none was needed.
        opening_seconds: of the processor's time, to open the first home and reset.
    """

    name: str
    step_count: int
    steps_per_second: float
    steps_per_cpu_second: float
    reset_milliseconds: float
    opening_seconds: float


class _Clock:
    """Adds up the time of a kind of call: by the wall clock, and the processor's."""

    def __init__(self) -> None:
        self.wall = self.processor = 0.0
        self.calls = 0

    def __enter__(self) -> None:
        self._began = perf_counter(), process_time()

    def __exit__(self, *_: object) -> None:
        self.wall += perf_counter() - self._began[0]
        self.processor += process_time() - self._began[1]
        self.calls += 1


def measure_throughput(name: str, steps: int, split: str = "minival") -> Throughput:
    """Step an environment with random actions that are no stop.

    Args:
        name: of a registered environment.
        steps: how many to take while the clock runs.
        split: whose homes.
    """
    # One home is enough, and its opening would hide what a step costs.
    env = gymnasium.make(name, split=split, episodes_per_home=1_000_000)
    opening, running, resets = _Clock(), _Clock(), _Clock()
    with opening:
        env.reset(seed=0)
    env.action_space.seed(0)
    _run(env, _WARM_UP, _Clock(), _Clock())
    _run(env, steps, running, resets)
    env.close()
    reset = 1000.0 * resets.processor / resets.calls if resets.calls else math.nan
    return Throughput(name, steps, steps / running.wall, steps / running.processor, reset, opening.processor)


def _run(env: gymnasium.Env[Any, Any], steps: int, running: _Clock, resets: _Clock) -> None:
    taken = 0
    while taken < steps:
        actions = [_without_stop(env) for _ in range(min(50, steps - taken))]
        is_over = False
        with running:
            for action in actions:
                _, _, is_ended, is_cut, _ = env.step(action)
                taken += 1
                if is_ended or is_cut:
                    is_over = True
                    break
        if is_over:
            with resets:
                env.reset()


def _without_stop(env: gymnasium.Env[Any, Any]) -> Any:
    """Return a random action that is no stop."""
    task_env = env.unwrapped
    assert isinstance(task_env, TaskEnv)
    action, controls = env.action_space.sample(), task_env.controls
    if isinstance(controls, Columns):
        return np.where(np.array(controls.names) == STOP, np.float32(-1.0), action)
    while controls.read(action, NAVIGATION_POSTURE, False) is DiscreteAction.STOP:
        action = env.action_space.sample()
    return action
