"""Furnishing rooms: what stands, what hangs, what belongs together."""
