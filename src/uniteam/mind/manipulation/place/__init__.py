"""Placing the object that is held, and the improvements of it."""
