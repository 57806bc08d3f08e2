"""Faults of what goes beyond the report: in the main point of each improvement."""

from mutants.mutant import Mutant

_MIND = "src/uniteam/mind"
_GOALS = f"{_MIND}/navigation/goals"
_PLANNING = f"{_MIND}/navigation/planning"

MUTANTS = (
    Mutant(
        "a failed goal is not avoided",
        f"{_GOALS}/failed_goals.py",
        "return replace(goal, shunned=self._around(places, bird_map)) if places else goal",
        "return goal",
        ("tests/mind/navigation/test_failed_goals.py",),
    ),
    Mutant(
        "a second failure is remembered no longer than the first",
        f"{_GOALS}/failed_goals.py",
        "until = step + self.steps * 2**failure.count",
        "until = step + self.steps",
        ("tests/mind/navigation/test_failed_goals.py",),
    ),
    Mutant(
        "clearance costs nothing",
        f"{_PLANNING}/clearance_cost.py",
        "np.clip(1 + np.ceil(",
        "np.clip(1 + 0 * np.ceil(",
        ("tests/mind/navigation/test_clearance_cost.py",),
    ),
    Mutant(
        "the narrowest line is taken through a gap",
        f"{_PLANNING}/narrow_motion.py",
        "if worth > best:",
        "if worth > -best:",
        ("tests/mind/navigation/test_narrow_motion.py",),
    ),
    Mutant(
        "too small a turn is not made by two",
        f"{_PLANNING}/narrow_motion.py",
        "needed += math.copysign(1.5 * SMALLEST_TURN, needed)",
        "needed += math.copysign(SMALLEST_TURN, needed)",
        ("tests/mind/navigation/test_narrow_motion.py",),
    ),
    Mutant(
        "what is seen through stays",
        f"{_MIND}/mapping/clearing.py",
        "channels.obstacle[row, column] = False",
        "channels.obstacle[row, column] = True",
        ("tests/mind/mapping/test_clearing.py",),
    ),
    Mutant(
        "what was felt is taken back too",
        f"{_MIND}/mapping/clearing.py",
        "if not felt[row, column]:",
        "if True:",
        ("tests/mind/mapping/test_clearing.py",),
    ),
    Mutant(
        "a look resolves whatever the distance",
        f"{_MIND}/mapping/resolved_look.py",
        "coarsest: float = 0.004",
        "coarsest: float = 4.0",
        ("tests/mind/mapping/test_resolved_look.py",),
    ),
    Mutant(
        "other things on a surface leave any room",
        f"{_MIND}/manipulation/place/occupied_surface.py",
        "max(0.0, needed - self._room(sample, others, load))",
        "0.0",
        ("tests/mind/manipulation/test_occupied_surface.py",),
    ),
    Mutant(
        "the load is as wide as the base",
        f"{_MIND}/manipulation/load_footprint.py",
        "return min(max(BASE_RADIUS, reach), self.most)",
        "return BASE_RADIUS",
        ("tests/mind/manipulation/test_load_footprint.py",),
    ),
    Mutant(
        "whatever is seen lies where it should be",
        f"{_MIND}/manipulation/place/verify_place.py",
        "return bool(np.any(np.abs(receptacle[is_near, 2] - bottom) < self.below))",
        "return True",
        ("tests/mind/manipulation/test_verify_place.py",),
    ),
    Mutant(
        "the robot waits on though nothing moves",
        f"{_MIND}/manipulation/place/verify_place.py",
        "since >= self.still_steps",
        "since >= 1000",
        ("tests/mind/manipulation/test_verify_place.py",),
    ),
    Mutant(
        "in the last round it gives up",
        f"{_MIND}/agents/last_round.py",
        "return self.order[rounds % len(self.order)]",
        "return None",
        ("tests/mind/agents/test_last_round.py",),
    ),
)
