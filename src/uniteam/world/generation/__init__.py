"""Making furnished homes from seeds."""
