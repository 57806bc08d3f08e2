"""What a skill is, and what it is shown."""
