"""The colours of the figures: those that the report names, in shades that colour-blind readers tell apart.

Most shades are those of Okabe and Ito, "Color Universal Design" (2008). Of two
of the same hue one is much lighter.
"""

from uniteam.visualization.colors import Color

PAPER: Color = (255, 255, 255)
INK: Color = (25, 27, 31)
FAINT_INK: Color = (95, 100, 110)

UNEXPLORED_START: Color = (0, 114, 178)
"""Blue: start receptacles that have not been looked at."""
EXPLORED_START: Color = (196, 78, 0)
"""Dark orange: start receptacles that have been looked at."""
GOAL_RECEPTACLE: Color = (255, 187, 102)
"""Light orange."""
GOAL_POINT: Color = (100, 200, 248)
"""Light blue: wherever the robot may go next."""
CHOSEN_POINT: Color = (8, 24, 110)
"""Dark blue: where it goes."""

FRONTIER: Color = (0, 178, 128)
OBJECT: Color = (240, 228, 66)
UNKNOWN: Color = (192, 196, 204)
FREE: Color = (248, 248, 249)
OBSTACLE: Color = (88, 92, 100)
COLLISION: Color = (120, 0, 0)
PATH: Color = CHOSEN_POINT
ROBOT: Color = (25, 27, 31)
