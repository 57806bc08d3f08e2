"""A recording as a `Story`: what was in view, grasped, let go of, and where the base stood."""
