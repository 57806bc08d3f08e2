"""Faults of the baseline and of the improvements: what each is for, and that its switch puts it in.

`stepwise_place` measures again at every step. Where nothing moves and localisation is exact, the first and the last
look find the same places, so there is no mutant that does not look in between.
"""

from mutants.mutant import Mutant

_MIND = "src/uniteam/mind"
_REPORT = f"{_MIND}/agents/report.py"
_PLACE_TESTS = "tests/mind/manipulation/test_place.py"
_PICK_TESTS = "tests/mind/manipulation/test_pick.py"
_GOAL_TESTS = "tests/mind/navigation/test_goals.py"
_RING_TESTS = "tests/mind/navigation/test_ring_planner.py"
_AGENT_TESTS = "tests/mind/agents/test_agents.py"
_PERCEPTION_TESTS = "tests/mind/perception/test_perception.py"
_BLOCK_TESTS = "tests/mind/mapping/test_block_projection.py"
_COLLISIONS = f"{_MIND}/navigation/planning/collision_mapping.py"
_RING = f"{_MIND}/navigation/planning/ring_planner.py"
_MOTION = f"{_MIND}/manipulation/place/motion.py"
_PLACE = f"{_MIND}/manipulation/place"

_BASELINE = (
    Mutant(
        "slab half as wide",
        f"{_PLACE}/placing_points.py",
        "SLAB = (0.2, 0.2, 0.015)",
        "SLAB = (0.1, 0.1, 0.02)",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "drop from the grasp centre and not from the lift",
        f"{_PLACE}/drop_height.py",
        "BASELINE_HEIGHT = LIFT_ABOVE_SURFACE + ArmReach.of_wrist(HANGING_WRIST).low",
        "BASELINE_HEIGHT = LIFT_ABOVE_SURFACE",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "the baseline turns to the nearest whole step",
        _MOTION,
        "range(int(abs(bearing) // ACTION_LIMITS.turn_step))",
        "range(round(abs(bearing) / ACTION_LIMITS.turn_step))",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "the arm extends by what is left after the drive",
        _MOTION,
        "distance = max(0.0, _from_camera(first, point)[0] - self.wrist) + near",
        "distance = max(0.0, _from_camera(first, point)[0] % 0.25 + 0.25 - self.wrist) + near",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "the mask is not eroded",
        f"{_PLACE}/receptacle_mask.py",
        "RIM_SHARE = 10 / 480",
        "RIM_SHARE = 0",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "the dilation does not shrink for good",
        _RING,
        "            self._shrunk += 1\n",
        "            self._shrunk = 0\n",
        (_RING_TESTS,),
    ),
    Mutant("no cell is too steep", _RING, "STEEPEST = 1.5", "STEEPEST = 1e9", (_RING_TESTS,)),
    Mutant(
        "each pixel has its own label",
        f"{_MIND}/mapping/block_projection.py",
        "    for dv in range(block):\n        for du in range(block):",
        "    for dv in range(1):\n        for du in range(1):",
        (_BLOCK_TESTS,),
    ),
)

_IMPROVEMENTS = (
    Mutant(
        "collision_mapping writes 0.2 m ahead",
        _COLLISIONS,
        "    return np.array([motion.short_term_goal])",
        "    return _patch(motion.base, cell_size, np.array([4]), np.array([0]))",
        (_GOAL_TESTS,),
    ),
    Mutant(
        "stepwise_place drives a metre at once",
        f"{_PLACE}/stepwise_place.py",
        "    step: float = 0.25\n",
        "    step: float = 1.0\n",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "checked_arm_path checks nothing",
        f"{_PLACE}/checked_arm_path.py",
        "if is_path_free(path, _turned(near, angle), context.load, self.sweep):",
        "if True:",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "edge_margin does not count the distance",
        f"{_PLACE}/edge_margin.py",
        "worth = np.minimum(distance, margin) + BEYOND_MARGIN * distance",
        "worth = np.full(len(distance), margin)",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "edge_margin ignores the load",
        f"{_PLACE}/edge_margin.py",
        "margin = max(self.margin, load.along_base)",
        "margin = self.margin",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "surface_fallback takes the floor",
        f"{_PLACE}/surface_fallback.py",
        "lowest: float = 0.2",
        "lowest: float = -1.0",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "surface_fallback takes any point",
        f"{_PLACE}/surface_fallback.py",
        "flat = points_with_headroom(around[around[:, 2] > self.lowest])",
        "flat = around[around[:, 2] > self.lowest]",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "drop_height keeps no clearance",
        f"{_PLACE}/drop_height.py",
        "clearance: float = 0.15",
        "clearance: float = 0.0",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "reach_out_pick does not look what is in the way",
        f"{_MIND}/manipulation/pick/reach_out_pick.py",
        "[path for path in self._paths(view) if is_path_free(path, everything, EMPTY_GRIPPER, self.sweep)]",
        "[*self._paths(view)]",
        (_PICK_TESTS,),
    ),
    Mutant(
        "early_goal_memory forgets",
        _REPORT,
        "search__recall=remember_probabilities",
        "search__recall=BASELINE.search.recall",
        (_GOAL_TESTS, _AGENT_TESTS),
    ),
    Mutant(
        "collision_mapping is not put in",
        _REPORT,
        "planner__collisions=COLLISION_MAPPING",
        "planner__collisions=BASELINE.planner.collisions",
        (_GOAL_TESTS,),
    ),
    Mutant(
        "surround_start_receptacle is not put in",
        _REPORT,
        "search__start_receptacle=SurroundStartReceptacle()",
        "search__start_receptacle=BASELINE.search.start_receptacle",
        (_GOAL_TESTS,),
    ),
    Mutant(
        "receptacle_probability is not put in",
        _REPORT,
        "search__goal_receptacle=MostProbableReceptacle()",
        "search__goal_receptacle=BASELINE.search.goal_receptacle",
        (_GOAL_TESTS,),
    ),
    Mutant(
        "centre_approach is not put in",
        _REPORT,
        "search__approach=CentreApproach()",
        "search__approach=BASELINE.search.approach",
        (_GOAL_TESTS,),
    ),
    Mutant(
        "goal_or_frontier is not put in",
        _REPORT,
        "is_stuck=StuckDetector()",
        "is_stuck=BASELINE.is_stuck",
        (_GOAL_TESTS, _AGENT_TESTS),
    ),
    Mutant(
        "stepwise_place is not put in",
        _REPORT,
        "place__close_in=CloseInStepwise()",
        "place__close_in=BASELINE.place.close_in",
        (_PLACE_TESTS,),
    ),
    Mutant(
        "class_thresholds are not read from the file",
        f"{_MIND}/perception/threshold_file.py",
        'parse_json(path.read_text(encoding="utf-8"))',
        'parse_json(THRESHOLD_FILE.read_text(encoding="utf-8"))',
        (_PERCEPTION_TESTS,),
    ),
    Mutant(
        "verify_pick trusts the snap",
        _REPORT,
        "pick__is_grasped=feel_the_gripper",
        "pick__is_grasped=BASELINE.pick.is_grasped",
        (_PICK_TESTS, _AGENT_TESTS),
    ),
)

MUTANTS = (*_BASELINE, *_IMPROVEMENTS)
