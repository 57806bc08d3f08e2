"""The colours of what is shown, the same in the segmentation, on the map and in the words: RGB, 0 to 255."""

import colorsys
from zlib import crc32

from uniteam.interface import Instruction, MapLabel

Color = tuple[int, int, int]

BACKGROUND: Color = (22, 24, 28)
FRAME: Color = (58, 62, 70)
TEXT: Color = (232, 234, 237)
FAINT_TEXT: Color = (150, 156, 166)
SUCCESS: Color = (92, 201, 122)
FAILURE: Color = (238, 92, 84)

OBJECT: Color = (255, 64, 160)
START_RECEPTACLE: Color = (255, 176, 40)
GOAL_RECEPTACLE: Color = (64, 200, 110)
GOAL_POINT: Color = (214, 30, 30)
PATH: Color = (40, 120, 255)
ROBOT: Color = (20, 60, 170)

MAP_COLORS: dict[MapLabel, Color] = {
    MapLabel.UNKNOWN: (40, 43, 49),
    MapLabel.FREE: (226, 228, 232),
    MapLabel.VISITED: (186, 208, 240),
    MapLabel.OBSTACLE: (104, 108, 118),
    MapLabel.COLLISION: (140, 60, 40),
    MapLabel.FRONTIER: (150, 222, 226),
    MapLabel.START_RECEPTACLE: START_RECEPTACLE,
    MapLabel.GOAL_RECEPTACLE: GOAL_RECEPTACLE,
    MapLabel.OBJECT: OBJECT,
}


def name_color(name: str, instruction: Instruction) -> Color:
    """Return the colour of a category: that of its part in the instruction, or a muted one of its own."""
    parts = {
        instruction.goal_receptacle: GOAL_RECEPTACLE,
        instruction.start_receptacle: START_RECEPTACLE,
        instruction.object_category: OBJECT,
    }
    if name in parts:
        return parts[name]
    hue = crc32(name.encode()) % 360 / 360.0
    red, green, blue = colorsys.hsv_to_rgb(hue, 0.28, 0.66)
    return (round(red * 255), round(green * 255), round(blue * 255))
