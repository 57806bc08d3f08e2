"""Check a body."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from uniteam.errors import InvalidActionError
from uniteam.interface import Action, BaseDisplacement, Body, DiscreteAction, JointDisplacement, Joints, Observation
from uniteam.testing.difference import first_difference
from uniteam.testing.failure import CheckFailedError, called, one_line
from uniteam.testing.handed_out import own_copy
from uniteam.testing.observations import observation_problem

SCRIPT: tuple[Action, ...] = (
    DiscreteAction.TURN_LEFT,
    DiscreteAction.MOVE_FORWARD,
    BaseDisplacement(x=0.2, heading=0.5),
    DiscreteAction.TURN_RIGHT,
    JointDisplacement(Joints(0.0, 0.0, head_tilt=-0.2)),
    DiscreteAction.MANIPULATION_MODE,
    DiscreteAction.EXTEND_ARM,
    JointDisplacement(Joints(0.1, -0.2), BaseDisplacement(y=0.15)),
    DiscreteAction.SNAP_OBJECT,
    DiscreteAction.DESNAP_OBJECT,
    DiscreteAction.NAVIGATION_MODE,
    BaseDisplacement(heading=-1.0),
    DiscreteAction.EMPTY_ACTION,
)
"""A little of everything that a body does."""

NO_ACTIONS: tuple[Any, ...] = (
    None,
    "move_forward",
    BaseDisplacement(x=float("nan")),
    BaseDisplacement(heading=float("inf")),
    JointDisplacement(Joints(float("nan"), 0.0)),
    JointDisplacement(Joints(0.0, 0.0), None),  # type: ignore[arg-type]
)
"""What no body does."""

Step = Callable[[Body, Action], Observation]


def check_body(make: Callable[[], Body]) -> None:
    """Check that a body keeps what `uniteam.Body` promises: a simulator, a recording, the interface of a robot.

    - Its observations are sound: read-only arrays, a rigid camera pose, finite numbers, steps that count up from 0; the
      base is at the origin after `reset`.
    - The same actions give the same observations, to the bit: of two bodies made alike, while both are alive, and of
      one that is reset in the midst of what it does.
    - What is no action is refused with `InvalidActionError` before anything moves: the next step comes out the same.
    - No observation changes after it was returned.

    In a test of your own:

        def test_my_simulator() -> None:
            check_body(lambda: MySimulator("kitchen"))

    A real robot is never twice in the same place, so that it cannot pass; what stands for it in your tests can.

    Args:
        make: returns a new body; two of them are alive at once.

    Raises:
        CheckFailedError: what differed, and at which step.
    """
    one, other = called("making the body", make), called("making a second body", make)
    first = _compared(
        _played(one, _plainly), _played(other, _plainly), "two bodies made alike answer the same actions differently"
    )
    _compared(first, _played(one, _plainly), "reset() does not bring the body back to where it began")
    _compared(first, _played(other, _after_nonsense), "a step that was refused has changed something")


def _compared(one: Iterable[Observation], other: Iterable[Observation], blame: str) -> list[Observation]:
    """Return the first's observations; raises CheckFailedError where the second's differ."""
    seen = []
    for step, (observation, another) in enumerate(zip(one, other, strict=True)):
        differing = first_difference(observation, another, "observation")
        if differing:
            raise CheckFailedError(f"{blame} ({differing} after {_after(step)})")
        seen.append(observation)
    return seen


def _played(body: Body, step: Step) -> Iterator[Observation]:
    """Reset a body, take it through the script, and yield copies of what it returns."""
    returned: list[tuple[Observation, Observation]] = []
    moves = [lambda: body.reset(), *(lambda action=action: step(body, action) for action in SCRIPT)]
    for number, move in enumerate(moves):
        observation = called(_after(number), move)
        problem = observation_problem(observation, number)
        if problem:
            raise CheckFailedError(f"{_after(number)} returned {problem}")
        returned.append((observation, own_copy(observation)))
        yield returned[-1][1]
    for number, (observation, copy) in enumerate(returned):
        changed = first_difference(observation, copy, "observation")
        if changed:
            raise CheckFailedError(
                f"{changed}, which {_after(number)} returned, was changed afterwards; "
                "return a copy of what is used again"
            )


def _after(number: int) -> str:
    """Return what to call the moves of `_played`: the reset, then the steps of the script."""
    return "reset()" if number == 0 else f"step {number}, {one_line(SCRIPT[number - 1])},"


def _plainly(body: Body, action: Action) -> Observation:
    return body.step(action)


def _after_nonsense(body: Body, action: Action) -> Observation:
    """Do an action after some that are none."""
    for nonsense in NO_ACTIONS:
        _check_refused(body, nonsense)
    return body.step(action)


def _check_refused(body: Body, nonsense: Any) -> None:
    what = f"step({one_line(repr(nonsense))}) must raise InvalidActionError"
    try:
        body.step(nonsense)
    except InvalidActionError:
        return
    except Exception as error:
        raise CheckFailedError(f"{what}, but raised {type(error).__name__}: {one_line(error)}") from error
    raise CheckFailedError(f"{what}, but was done")
