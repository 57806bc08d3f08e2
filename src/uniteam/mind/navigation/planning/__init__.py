"""How to get there: obstacles, distances, and the next motion."""
