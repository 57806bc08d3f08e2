"""A robot that acts in a home: motions, collisions, the gripper, and time."""
