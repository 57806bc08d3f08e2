"""Recordings: an episode in one file, from which it can be explained, and its agent asked again, without a simulation.

The format is described in `docs/recordings.md`.
"""
