"""Picking an object up, and the improvements of it."""
