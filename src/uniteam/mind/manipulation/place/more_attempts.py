"""Trying other places before anything is let go without a good one (`more_attempts`)."""

ATTEMPTS = 12
"""At how many places to try."""
LAST_CALL = 1_100
"""From this step on the next place is the last one: the challenge gives 1,250 steps, and the fall is waited for."""
LEAST_WORTH = 0.1
"""m; a point on level ground 5 cm from the edge is worth so much, one on a front seen from above is not. Nearer to the
edge, the play of the fall may be more than what is left of the surface."""
