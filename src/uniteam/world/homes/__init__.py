"""What a home is, what must hold for one, and homes as files."""
