"""Homes from the files of other scene data sets."""
