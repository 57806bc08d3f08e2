"""The task and its skills."""
