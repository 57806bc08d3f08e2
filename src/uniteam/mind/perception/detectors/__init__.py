"""Detectors behind the one door of perception: the networks that the package ships, and one adapter a file.

What an adapter needs is imported when it is made.
"""
