"""Picking and placing, and where the arm can go."""
