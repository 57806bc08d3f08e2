"""Perception that errs as detectors do, as much as one dial says: a seeded model of noise over the truth."""
