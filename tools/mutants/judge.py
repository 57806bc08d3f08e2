"""Faults of the judge, of the rules of the task, and of what they rest on in the simulator."""

from mutants.mutant import Mutant, a_third_up_and_down

_JUDGE, _JUDGE_TESTS = "src/uniteam/world/task/judge.py", "tests/world/task/test_judge.py"
_PHYSICS, _PHYSICS_TESTS = "src/uniteam/world/physics/physics.py", "tests/world/physics/test_physics.py"
_SIMULATOR, _SIMULATOR_TESTS = "src/uniteam/world/simulation/simulator.py", "tests/world/simulation/test_simulator.py"
_ARM, _ARM_TESTS = "src/uniteam/world/simulation/arm_collision.py", "tests/world/simulation/test_arm_collision.py"
_GRIPPER = "src/uniteam/world/simulation/gripper.py"
_RULES, _RULES_TESTS = "src/uniteam/world/task/grasp_rules.py", "tests/world/task/test_grasp_rules.py"
_ENVIRONMENT, _ENVIRONMENT_TESTS = "src/uniteam/world/task/environment.py", "tests/world/task/test_environment.py"
_TRUTH = "src/uniteam/world/task/visible_truth.py"
_INTERFACE, _STRETCH = "src/uniteam/interface.py", "src/uniteam/stretch.py"

_NUMBERS = (
    *a_third_up_and_down("view coverage", _JUDGE, "0.001", "VIEW_COVERAGE = 0.001", _JUDGE_TESTS),
    *a_third_up_and_down("view point tolerance", _JUDGE, "0.1", "VIEW_POINT_TOLERANCE = 0.1", _JUDGE_TESTS),
    *a_third_up_and_down("lowest contact", _JUDGE, "0.05", "LOWEST_CONTACT = 0.05", _JUDGE_TESTS),
    *a_third_up_and_down("deepest contact", _JUDGE, "0.01", "DEEPEST_CONTACT = 0.01", _JUDGE_TESTS),
    *a_third_up_and_down("steps at rest", _JUDGE, "50", "REST_STEPS = 50", _JUDGE_TESTS),
    *a_third_up_and_down("speed at rest", _PHYSICS, "0.005", "REST_LINEAR_SPEED = 0.005", _PHYSICS_TESTS),
    *a_third_up_and_down("turning at rest", _PHYSICS, "0.05", "REST_ANGULAR_SPEED = 0.05", _PHYSICS_TESTS),
    *a_third_up_and_down("touch depth", _ARM, "0.005", "TOUCH_DEPTH = 0.005", _ARM_TESTS),
    *a_third_up_and_down("grasp range", _STRETCH, "0.8", "GRASP_RANGE = 0.8", _RULES_TESTS),
    *a_third_up_and_down("grasp range, in play", _STRETCH, "0.8", "GRASP_RANGE = 0.8", _SIMULATOR_TESTS),
    *a_third_up_and_down("centre of the picture", _GRIPPER, "0.25", "CENTRE_SHARE = 0.25", _SIMULATOR_TESTS),
    *a_third_up_and_down("lift of EXTEND_ARM", _SIMULATOR, "0.8", "EXTENDED_LIFT = 0.8", _SIMULATOR_TESTS),
    *a_third_up_and_down("seconds a step", _SIMULATOR, "0.032", "STEP_SECONDS = 0.032", _SIMULATOR_TESTS),
    *a_third_up_and_down("forward step", _INTERFACE, "0.25", "forward_step: float = 0.25", _SIMULATOR_TESTS),
    *a_third_up_and_down("turn step", _INTERFACE, "30.0", "turn_step: float = math.radians(30.0)", _SIMULATOR_TESTS),
    *a_third_up_and_down("least move", _INTERFACE, "0.1", "least_move: float = 0.1", _SIMULATOR_TESTS),
    *a_third_up_and_down("most move", _INTERFACE, "1.0", "most_move: float = 1.0", _SIMULATOR_TESTS),
    *a_third_up_and_down("least turn", _INTERFACE, "5.0", "least_turn: float = math.radians(5.0)", _SIMULATOR_TESTS),
    *a_third_up_and_down(
        "steps of an episode", "src/uniteam/world/task/episode.py", "1250", "MAXIMUM_STEPS = 1250", _ENVIRONMENT_TESTS
    ),
    *a_third_up_and_down(
        "view distance", "src/uniteam/world/task/footprint.py", "1.0", "VIEW_DISTANCE = 1.0",
        "tests/world/certification/test_view_distance.py",
    ),
)  # fmt: skip


def _of(file: str, tests: str, *changes: tuple[str, str, str]) -> tuple[Mutant, ...]:
    """Return the mutants of one file: each a name, the old text and the new."""
    return tuple(Mutant(name, file, old, new, (tests,)) for name, old, new in changes)


_RULES_BROKEN = (
    *_of(
        _JUDGE,
        _JUDGE_TESTS,
        ("no rest asked for", "simulator.physics.is_still(name) and ", ""),
        ("a full gripper places", " or simulator.held is not None:", ":"),
        ("placed is not latched", "before.place_success or ", ""),
        ("found is not latched", "before.find_object_phase_success or ", ""),
        ("picked is not latched", "before.pick_object_phase_success or ", ""),
        ("receptacle found is not latched", "before.find_recep_phase_success or ", ""),
        ("picked unseen", "(found and simulator.held", "(simulator.held"),
        ("anything held is picked", "simulator.held in self._object_names", "simulator.held is not None"),
        ("placed before found", "(found_receptacle and self._steps_at_rest", "(self._steps_at_rest"),
        ("anything released is placed", "if events.released in self._object_names:", "if events.released:"),
        (
            "rest is not in a row",
            "_lies_on_goal(simulator) else 0",
            "_lies_on_goal(simulator) else self._steps_at_rest",
        ),
        ("any touch costs the success", "(touches.robot_scene is not None)", "(touches.first is not None)"),
    ),
    *_of(
        _ARM,
        _ARM_TESTS,
        ("small objects are scene", "        kinds[:, self._is_small[things]] = _ROBOT_OBJ\n", ""),
        ("the held object is robot", "        kinds[len(self._model.arm) :] = _OBJ_SCENE\n", ""),
    ),
    *_of(
        _GRIPPER,
        _SIMULATOR_TESTS,
        ("grasp range in space", "(np.hypot(middle[0] - x, middle[1] - y))", "(np.linalg.norm(middle - [x, y, 0.6]))"),
    ),
    *_of(
        _RULES,
        _RULES_TESTS,
        ("the challenge takes any of the class", "if thing.name in candidates", "if thing.category == category"),
        ("the challenge grasps blindly", "if not any(thing.is_in_view and", "if not any("),
        ("the honest gripper takes what is beside", "if thing.is_in_centre", "if thing.is_in_view"),
    ),
    *_of(
        _SIMULATOR,
        _SIMULATOR_TESTS,
        (
            "MANIPULATION_MODE does not turn",
            "turn = self._displace(BaseDisplacement(heading=QUARTER_TURN))",
            "turn = NOTHING",
        ),
        ("NAVIGATION_MODE does not fold", "simulator._pose(NAVIGATION_POSTURE)", "simulator._pose(simulator.joints)"),
    ),
    *_of(
        _TRUTH,
        _ENVIRONMENT_TESTS,
        ("truth of all that the home holds", "for k in seen)", "for k in range(len(detections)))"),
        ("persistent ids", "index_of[instance] = count", "index_of[instance] = instance"),
    ),
)

MUTANTS = (*_NUMBERS, *_RULES_BROKEN)
