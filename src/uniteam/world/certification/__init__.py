"""Making episodes that can be solved: tasks, view points, and a way that was tried in the simulator."""
