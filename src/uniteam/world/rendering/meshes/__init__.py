"""The triangles of a home: walls, floors, models and the robot."""
