"""The report's failure of perception: the floor taken for furniture, and the same frame with the floor filter."""

from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.grid import Mask
from uniteam.interface import Segmentation
from uniteam.mind.perception.filters import FloorFilter, heights
from uniteam.mind.perception.vocabulary import ClassRole, roles_of_name
from uniteam.stretch import HEAD_CAMERA_FULL
from uniteam.visualization.canvas import BOLD, Area, Image, TextStyle, write, write_tag, write_wrapped
from uniteam.visualization.colors import Color
from uniteam.visualization.figures import colors
from uniteam.visualization.figures.moment import Moment, Scene
from uniteam.visualization.figures.page import PLAIN, STRONG, place_titled, white_page

WIDTH, HEIGHT = 1600, 872
_SIDE, _TOP, _SIZE = 24, 96, (501, 668)
_AREAS = tuple(Area(_SIDE + k * (_SIZE[0] + 24), _TOP, *_SIZE) for k in range(3))

LARGE = 0.05
"""Of the picture: a patch of floor that is worth showing."""
TINT = 0.6
"""How much of a thing's pixel is its colour, the rest the camera's grey."""

NAME = TextStyle(22, colors.PAPER, BOLD)

ROLE_COLORS: dict[ClassRole, Color] = {
    ClassRole.OBJECT: colors.OBJECT,
    ClassRole.START_RECEPTACLE: colors.UNEXPLORED_START,
    ClassRole.GOAL_RECEPTACLE: colors.GOAL_RECEPTACLE,
}


@dataclass(frozen=True)
class Believed:
    """Something that is taken for a class of the instruction: (H, W) mask, role, name and score."""

    mask: Mask
    role: ClassRole
    words: str


def believed(moment: Moment, segmentation: Segmentation) -> list[Believed]:
    """Return what of a segmentation is taken for a class of the instruction."""
    found = []
    for index, detection in enumerate(segmentation.detections):
        for role in roles_of_name(detection.name, moment.instruction)[:1]:
            words = f"{detection.name.replace('_', ' ')} {detection.score:.2f}"
            found.append(Believed(segmentation.instances == index, role, words))
    return found


def before_and_after(moment: Moment) -> tuple[list[Believed], list[Believed]]:
    """Return what the agent, which has no floor filter, believes of its frame, and what it would with one."""
    seen = moment.agent.explain().segmentation
    assert seen is not None
    filtered = FloorFilter()(seen, moment.observation, moment.instruction)
    return believed(moment, seen), believed(moment, filtered)


def dropped(moment: Moment) -> list[Believed]:
    """Return the receptacles that only the filter drops, the largest first."""
    before, after = before_and_after(moment)
    kept = np.zeros(moment.observation.depth.shape, dtype=np.bool_)
    for thing in after:
        kept |= thing.mask
    lost = [b for b in before if b.role is not ClassRole.OBJECT and not (b.mask & kept).any()]
    return sorted(lost, key=lambda b: -np.count_nonzero(b.mask))


def has_floor_as_furniture(moment: Moment) -> bool:
    """Return whether a large patch of floor is taken for a receptacle."""
    patches = dropped(moment)
    return bool(patches) and bool(patches[0].mask.mean() > LARGE)


SCENE = Scene(
    "val",
    44,
    AgentSpec("uniteam-plus", "noisy:0.6", removed=("floor_filter",)),
    has_floor_as_furniture,
    HEAD_CAMERA_FULL,
)


def draw_floor_as_table(moment: Moment) -> Image:
    """Return the (872, 1600, 3) RGB figure."""
    page = white_page(WIDTH, HEIGHT)
    before, after = before_and_after(moment)
    patch = dropped(moment)[0]
    rgb = moment.observation.rgb
    write(page, str(moment.instruction), _SIDE, 40, STRONG)
    place_titled(page, rgb, _AREAS[0], "Head camera")
    place_titled(page, tinted(rgb, before), _AREAS[1], "Without the floor filter")
    place_titled(page, tinted(rgb, after), _AREAS[2], "With the floor filter")
    high = max(float(np.percentile(heights(moment.observation)[patch.mask], 95)), 0.0)
    told = (
        f"Step {moment.observation.step} of {SCENE.agent.name}, perception {SCENE.agent.perception}.",
        f"Floor is taken for a {patch.words.rpartition(' ')[0]} (score {patch.words.rpartition(' ')[2]}).",
        f"Dropped: it ends {high:.2f} m above the floor, below {FloorFilter().lowest_receptacle:.2f} m.",
    )
    for area, words in zip(_AREAS, told, strict=True):
        write_wrapped(page, words, Area(area.left, _TOP + _SIZE[1] + 14, area.width, 80), PLAIN)
    return page


def tinted(rgb: Image, things: list[Believed]) -> Image:
    """Return an (H, W, 3) image in grey, with what is believed in the colour of its role, outlined and named."""
    grey: Image = cv2.cvtColor(cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY), cv2.COLOR_GRAY2RGB).astype(np.uint8)
    for thing in things:
        color = np.array(ROLE_COLORS[thing.role])
        grey[thing.mask] = ((1.0 - TINT) * grey[thing.mask] + TINT * color).astype(np.uint8)
        outline, _ = cv2.findContours(thing.mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
        cv2.drawContours(grey, outline, -1, ROLE_COLORS[thing.role], 2, cv2.LINE_AA)
    for thing in things:
        rows, columns = np.nonzero(thing.mask)
        write_tag(grey, thing.words, max(int(columns.mean()) - 50, 0), int(rows.mean()) - 12, NAME)
    return grey
