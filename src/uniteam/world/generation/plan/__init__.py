"""Drawing a home's rooms, walls and openings."""
