"""The report's goal map: the frontier, and the points around start receptacles from which they are to be looked at."""

import cv2
import numpy as np

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.grid import Mask, disc
from uniteam.mind.navigation.goal import GoalKind
from uniteam.mind.navigation.goals.exploration import ChooseGoal
from uniteam.visualization.canvas import Area, Image, write
from uniteam.visualization.figures import colors
from uniteam.visualization.figures.belief_map import Layer, draw_belief, start_cells
from uniteam.visualization.figures.moment import Moment, Scene
from uniteam.visualization.figures.page import STRONG, Entry, draw_legend, white_page

WIDTH, HEIGHT = 1600, 900

LEGEND = (
    Entry(colors.FRONTIER, "frontier"),
    Entry(colors.GOAL_POINT, "points around start receptacles"),
    Entry(colors.CHOSEN_POINT, "point that is headed for", is_point=True),
    Entry(colors.UNEXPLORED_START, "start receptacle, not looked at yet"),
    Entry(colors.EXPLORED_START, "start receptacle, looked at"),
    Entry(colors.GOAL_RECEPTACLE, "goal receptacle"),
    Entry(colors.OBSTACLE, "obstacle"),
    Entry(colors.FREE, "floor that was seen"),
    Entry(colors.UNKNOWN, "not seen yet"),
    Entry(colors.PATH, "path"),
    Entry(colors.ROBOT, "robot, and where it has been", is_point=True),
)

_MAP = Area(24, 72, 1060, 804)
_LEGEND_LEFT = 1116

ENOUGH = 80
"""Cells of each kind that there should be in the picture."""
FAR = 2.0
"""m; so long a path is seen on the map."""


def goal_layers(moment: Moment) -> tuple[Layer, Layer]:
    """Return the frontier, and the points around start receptacles: (H, W) cells of the map."""
    search = moment.agent.board.search
    return (
        Layer(_cells(search.frontier, moment), colors.FRONTIER),
        Layer(_cells(search.start_receptacle, moment), colors.GOAL_POINT),
    )


def has_both_goals(moment: Moment) -> bool:
    """Return whether there are both kinds of goals, and the robot drives to look at a receptacle."""
    board = moment.agent.board
    if board.goal is None or board.plan is None or board.goal.kind is not GoalKind.START_RECEPTACLE:
        return False
    kinds = (*start_cells(board.bird_map), *(layer.cells for layer in goal_layers(moment)))
    return all(np.count_nonzero(cells) >= ENOUGH for cells in kinds) and board.plan.distance > FAR


SCENE = Scene("val", 44, AgentSpec("uniteam-plus", "truth"), has_both_goals)


def draw_goal_map(moment: Moment) -> Image:
    """Return the (900, 1600, 3) RGB figure."""
    page = white_page(WIDTH, HEIGHT)
    write(page, f"{moment.instruction}: where to look next", _MAP.left, 44, STRONG)
    frontier, around = goal_layers(moment)
    layers = (_thick(frontier), around)
    picture = draw_belief(moment, layers, (_MAP.width, _MAP.height))
    page[_MAP.top : _MAP.top + _MAP.height, _MAP.left : _MAP.left + _MAP.width] = picture
    draw_legend(page, LEGEND, _LEGEND_LEFT, _MAP.top)
    return page


def _thick(line: Layer) -> Layer:
    """Return a line of cells as one that is seen on a page."""
    return Layer(cv2.dilate(line.cells.view(np.uint8), disc(1)).view(np.bool_), line.color)


def _cells(choose: ChooseGoal, moment: Moment) -> Mask:
    bird_map = moment.agent.board.bird_map
    goal = choose(bird_map, moment.observation.base_to_start)
    return np.zeros(bird_map.shape, dtype=np.bool_) if goal is None else goal.cells
