"""An episode as the rules of its failure look at it: facts alone, of which some are the simulator's truth."""

from dataclasses import dataclass

from uniteam.geometry import Point2, Point3
from uniteam.interface import Instruction
from uniteam.world.task.measures import Measures


@dataclass(frozen=True)
class Target:
    """An instance that would have counted: a candidate object until it was taken, or a goal receptacle.

    Attributes:
        name: of the instance.
        seen_at: the first moment at which it covered as much of the picture as finding it takes; None for never.
        seen_for: at how many moments it did.
        most_pixels: of it in any picture.
        recognised_at: the first of the moments looked into at which the agent believed it to be what was asked for.
        taken_for: what it was believed to be there, the name that was given most often; empty where it was nothing.
        nearest: how near the base came to its rectangle on the floor (m), with no wall between; infinite where there
            always was one. A receptacle's, while something was carried.
        nearest_at: at which moment.
        place: its middle on the floor (m, world).
    """

    name: str
    seen_at: int | None
    seen_for: int
    most_pixels: int
    recognised_at: int | None
    taken_for: str
    nearest: float
    nearest_at: int
    place: Point2


@dataclass(frozen=True)
class Grasp:
    """One attempt to grasp.

    Attributes:
        step: of the attempt.
        nearest: the candidate object nearest to the gripper, of those in the picture where there are any.
        distance: from the gripper to it, in the horizontal plane (m).
        is_in_view: whether a pixel of it was in the picture.
        believed: what the agent took for the object when it last did before, an instance or "floor or wall"; None for
            nothing.
        is_of_class: whether that is of the class that was asked for.
        took: the instance that it took, or None.
        place: where the base stood (m, world).
    """

    step: int
    nearest: str
    distance: float
    is_in_view: bool
    believed: str | None
    is_of_class: bool
    took: str | None
    place: Point2


@dataclass(frozen=True)
class Release:
    """The last time that a candidate object was let go of.

    Attributes:
        step: at which.
        name: the object.
        place: where it hung (m, world).
        bottom: how high its lowest point was (m).
        side: its longer side, from above (m).
        arm: how far the arm was extended (m).
        highest: how high its lowest point would have been with the lift at its limit and the wrist level (m).
        touched: what arm, gripper or object touched in the last steps before, or None.
        goal: the goal receptacle that the agent saw last before; else the nearest to it that is behind no wall, or the
            nearest where all are.
        to_goal: distance in the plane to that one's rectangle (m); 0 above it.
        goal_lowest: height of its lowest surface (m).
        goal_highest: height of its highest surface (m).
        goal_side: the longer side of its rectangle (m).
        above: another movable thing right below the object, that lies on furniture; None where there is none.
        is_wall_between: whether a wall is between base and object, or between object and receptacle.
        believed: what the agent took for the goal receptacle when it last did before; None for nothing.
        rests_on: what the object lies on at the end, names or "floor" and "wall"; None where it does not lie still.
        rests_at: where it is at the end (m, world).
        is_over_goal: whether it is above a goal receptacle's rectangle in the end, and not below its lowest surface.
        stay_steps: for how many steps to the end it did not move by more than 2 cm.
        rest_steps: for how many steps to the end it lay still on a goal receptacle.
        has_fallen_through: whether it came to be below that receptacle's lowest surface by going through it.
    """

    step: int
    name: str
    place: Point2
    bottom: float
    side: float
    arm: float
    highest: float
    touched: str | None
    goal: str
    to_goal: float
    goal_lowest: float
    goal_highest: float
    goal_side: float
    above: str | None
    is_wall_between: bool
    believed: str | None
    rests_on: tuple[str, ...] | None
    rests_at: Point3
    is_over_goal: bool
    stay_steps: int
    rest_steps: int
    has_fallen_through: bool

    @property
    def is_on_goal(self) -> bool:
        """Whether it lies on a goal receptacle in the end, or is above one and has not come to rest."""
        return self.rest_steps > 0 or (self.is_over_goal and self.rests_on is None)


@dataclass(frozen=True)
class Standstill:
    """The longest time for which the base did not get away from where it was, to within a metre.

    Attributes:
        first, last: steps.
        place: where (m, world).
        blocked: in how many of these steps something was in the base's way.
    """

    first: int
    last: int
    place: Point2
    blocked: int

    @property
    def steps(self) -> int:
        """How many they are."""
        return self.last - self.first + 1


@dataclass(frozen=True)
class Touch:
    """A step in which arm or gripper touched what is no small object: what, in which state, and where the base was."""

    step: int
    what: str
    state: str
    place: Point2


@dataclass(frozen=True)
class Phase:
    """Steps in a row in one state of the agent."""

    state: str
    first: int
    last: int


@dataclass(frozen=True)
class Story:
    """What happened.

    Attributes:
        instruction: what was asked.
        measures: what it came to.
        traceback: of the agent's crash; empty for none.
        phases: of all steps, in their order.
        last_words: the agent's reason for its last action.
        end: where the base was in the end (m, world).
        objects: the candidate objects.
        receptacles: the goal receptacles.
        grasps: the attempts to grasp.
        taken_at: the step at which a candidate object was grasped first; None for never.
        held: what the gripper holds in the end, or None.
        release: the last one of a candidate object, or None.
        standstill: the longest.
        touches: of arm or gripper with the scene.
        way: width (m) of the widest way, at the end, from the base to a view point of what it was still to reach; None
            where that was not looked into, as in an episode of which the object was placed.
        has_said: whether the agent said at any step what it believed to see.
        moved_alone: a candidate object that was moved far before the robot had touched anything, or None.
    """

    instruction: Instruction
    measures: Measures
    traceback: str
    phases: tuple[Phase, ...]
    last_words: str
    end: Point2
    objects: tuple[Target, ...]
    receptacles: tuple[Target, ...]
    grasps: tuple[Grasp, ...] = ()
    taken_at: int | None = None
    held: str | None = None
    release: Release | None = None
    standstill: Standstill | None = None
    touches: tuple[Touch, ...] = ()
    way: float | None = None
    has_said: bool = True
    moved_alone: str | None = None

    @property
    def last_step(self) -> int:
        """Number of the last step; 0 where there was none."""
        return self.phases[-1].last if self.phases else 0

    @property
    def state(self) -> str:
        """The agent's state in the end."""
        return self.phases[-1].state if self.phases else "START"

    @property
    def is_placed(self) -> bool:
        """Whether what was let go of last is no longer in the gripper: then it failed by where it lies."""
        return self.release is not None and self.held is None

    @property
    def has_taken(self) -> bool:
        """Whether a candidate object was ever in the gripper."""
        return self.taken_at is not None

    @property
    def sought(self) -> tuple[Target, ...]:
        """What it was still to reach: a candidate object, or a goal receptacle once one was taken."""
        return self.receptacles if self.has_taken else self.objects

    @property
    def sought_words(self) -> str:
        """What it was still to reach, in a word."""
        asked = self.instruction.goal_receptacle if self.has_taken else self.instruction.object_category
        return asked.replace("_", " ")
