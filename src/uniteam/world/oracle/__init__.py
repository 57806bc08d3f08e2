"""The agent that is told the truth, and plays episodes as they were certified."""
