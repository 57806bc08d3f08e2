"""Agents of other programs, other Pythons and other machines: they connect over gRPC and play a split."""
