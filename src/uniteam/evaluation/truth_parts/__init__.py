"""Agents of which one part is replaced by the simulator's truth: upper bounds of what that part could be worth."""
