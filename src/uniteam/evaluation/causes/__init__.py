"""Why an episode failed: one cause, decided from its recording by a sequence of named rules, with its evidence.

The causes and how each is decided are described in `docs/failures.md`.
"""
