"""Uniteam in the words of other libraries, each of them an extra: import the one that you use."""
