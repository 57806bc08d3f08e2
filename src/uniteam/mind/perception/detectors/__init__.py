"""Detectors behind the one door of perception, one adapter a file; what they need is imported when they are made."""
