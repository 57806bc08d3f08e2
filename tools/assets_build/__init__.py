"""Builds the pack of models from its sources; run once by the maintainers, never by users."""
