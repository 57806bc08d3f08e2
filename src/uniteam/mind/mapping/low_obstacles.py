"""What lies low in the way: a scale, a folded towel, a cable box (`low_obstacles`).

HomeRobot maps what is 10 cm high and more, for its depth camera does not measure the floor much better. What is lower
stops the base of a Stretch all the same, and the robot that does not map it tries the same way again and again.
"""

LOWEST_OBSTACLE = 0.028
"""m; a Stretch drives over what is lower, a rug or a threshold."""
