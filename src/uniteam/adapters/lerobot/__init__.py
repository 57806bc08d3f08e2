"""Recordings as a dataset of LeRobot, and what its plug-ins share with them."""
