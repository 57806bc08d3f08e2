"""What all rewards of the skills have in common, as HomeRobot trains them (habitat-lab's OVMM branch)."""

SLACK = -0.005
"""Of every step."""
SUCCESS = 10.0
"""Of the step that solves the episode."""
