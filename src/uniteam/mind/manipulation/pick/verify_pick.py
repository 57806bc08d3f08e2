"""Verifying a pick: believe what the gripper feels (`verify_pick`).

A pick that is known to have failed leads back to the search, which then tries other places (`failed_attempts`).
"""

from uniteam.mind.skills.view import View


def feel_the_gripper(view: View) -> bool:
    """Return whether the gripper feels something after the snap."""
    return view.observation.is_holding
