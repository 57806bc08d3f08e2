"""A body can be joined to a fake robot in two ways, and finds the same."""

import math
import threading

import pytest
from worlds.fake_robot import bridge

from uniteam.interface import DiscreteAction
from uniteam.world.fake.bridge_messages import no_truth
from uniteam.world.fake.joined import Join, in_lockstep, over_sockets
from uniteam.world.simulation.simulator import Simulator


@pytest.mark.parametrize("join", [in_lockstep, over_sockets])
def test_what_it_is_asked_is_done_either_way(world: Simulator, join: Join) -> None:
    pytest.importorskip("zmq", reason="the extra 'robot' is not installed")
    side = bridge(world)
    with join(side, no_truth) as robot:
        robot.reset()
        robot.step(DiscreteAction.TURN_LEFT)
        base = robot.step(DiscreteAction.MOVE_FORWARD).base_to_start
    assert (base.x, base.y) == pytest.approx((0.25 * math.cos(math.pi / 6), 0.125), abs=0.01)
    assert base.heading == pytest.approx(math.pi / 6, abs=0.015)
    assert side.refusals == []


def test_nothing_is_served_any_more_once_the_agent_has_failed(world: Simulator) -> None:
    pytest.importorskip("zmq", reason="the extra 'robot' is not installed")
    side, before = bridge(world), threading.active_count()
    with pytest.raises(ZeroDivisionError), over_sockets(side, no_truth):
        raise ZeroDivisionError
    assert threading.active_count() == before
