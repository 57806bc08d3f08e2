"""The agents: their configurations, the improvements, the state machine, and all of them by name."""
