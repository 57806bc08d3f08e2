"""A recording as a file for the viewer of Rerun (https://rerun.io)."""
