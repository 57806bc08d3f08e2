"""Say in one sentence why an episode is no overall success."""

from uniteam.world.task.measures import Measures


def explain_failure(measures: Measures, state: str, reason: str) -> str:
    """Return what was missed first and how the episode ended; empty for an overall success.

    Args:
        measures: at the end of the episode.
        state: the agent's state at the end.
        reason: the agent's own sentence for its last action.
    """
    missed = _first_missed(measures)
    if not missed:
        return ""
    ended = "stopped" if measures.does_want_terminate else "ran out of steps"
    return f"{missed}; {ended} after {measures.num_steps} steps in {state} ({reason.rstrip('.')})"


def _first_missed(measures: Measures) -> str:
    if not measures.find_object_phase_success:
        return "never stood before a candidate object with it in view"
    if not measures.pick_object_phase_success:
        return "found the object but never grasped a candidate"
    if not measures.find_recep_phase_success:
        return "took the object but never stood before a goal receptacle with it in view"
    if not measures.place_success:
        return "reached a goal receptacle but the object did not come to rest on it"
    if not measures.overall_success:
        return f"placed the object but touched the scene in {measures.robot_scene_colls} steps"
    return ""
