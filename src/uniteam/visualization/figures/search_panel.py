"""The report's Figure 1: a step of the search for the object, as the robot sees it, from outside, and on its map."""

import numpy as np

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.mind.navigation.goal import GoalKind
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.visualization.canvas import Area, Image, write, write_wrapped
from uniteam.visualization.captions import describe_action
from uniteam.visualization.figures import colors
from uniteam.visualization.figures.belief_map import Layer, draw_belief, start_cells
from uniteam.visualization.figures.moment import Moment, Scene
from uniteam.visualization.figures.page import (
    PLAIN,
    ROW,
    STRONG,
    Entry,
    draw_legend,
    place_titled,
    white_page,
)

WIDTH, HEIGHT = 1600, 836

LEGEND = (
    Entry(colors.UNEXPLORED_START, "start receptacle, not looked at yet"),
    Entry(colors.EXPLORED_START, "start receptacle, looked at"),
    Entry(colors.GOAL_RECEPTACLE, "goal receptacle"),
    Entry(colors.GOAL_POINT, "goal points"),
    Entry(colors.CHOSEN_POINT, "goal point that is headed for", is_point=True),
    Entry(colors.PATH, "path"),
    Entry(colors.OBSTACLE, "obstacle"),
    Entry(colors.ROBOT, "robot", is_point=True),
)

_HEAD = Area(24, 96, 360, 480)
_THIRD_PERSON = Area(408, 96, 568, 480)
_MAP = Area(1000, 96, 576, 480)
_WORDS = Area(24, 612, 600, 212)
_ROWS = 5
"""Of the legend's first column."""

ENOUGH = 60
"""Cells of each kind that there should be in the picture."""
FAR = 2.0
"""m; so long a path is seen on the map."""


def has_all_kinds(moment: Moment) -> bool:
    """Return whether receptacles of each kind are on the map, and the robot drives to look at one of them."""
    board = moment.agent.board
    if board.goal is None or board.plan is None or board.goal.kind is not GoalKind.START_RECEPTACLE:
        return False
    kinds = (*start_cells(board.bird_map), board.bird_map.class_cells(ClassRole.GOAL_RECEPTACLE), board.goal.cells)
    return all(np.count_nonzero(cells) >= ENOUGH for cells in kinds) and board.plan.distance > FAR


SCENE = Scene("val", 44, AgentSpec("uniteam-plus", "truth"), has_all_kinds)


def draw_search_panel(moment: Moment) -> Image:
    """Return the (836, 1600, 3) RGB figure."""
    page = white_page(WIDTH, HEIGHT)
    write(page, str(moment.instruction), 24, 40, STRONG)
    place_titled(page, moment.observation.rgb, _HEAD, "Head camera")
    view = moment.environment.simulator.render_third_person(_THIRD_PERSON.width, _THIRD_PERSON.height)
    place_titled(page, view, _THIRD_PERSON, "Third person")
    goal = moment.agent.board.goal
    layers = () if goal is None else (Layer(goal.cells, colors.GOAL_POINT),)
    place_titled(page, draw_belief(moment, layers, (_MAP.width, _MAP.height)), _MAP, "Map")
    _write_words(page, moment)
    draw_legend(page, LEGEND[:_ROWS], _WORDS.left + 640, _WORDS.top)
    draw_legend(page, LEGEND[_ROWS:], _WORDS.left + 1160, _WORDS.top)
    return page


def _write_words(page: Image, moment: Moment) -> None:
    """Write the phase, the next action, why, and the collisions so far."""
    measures = moment.environment.measures
    told = {
        "Step": str(moment.observation.step),
        "Phase": moment.decision.state.replace("_", " ").lower(),
        "Next action": describe_action(moment.decision.action),
        "Collisions": f"{measures.robot_scene_colls} of arm or gripper, {moment.blocked} of the base",
    }
    for number, (name, words) in enumerate(told.items()):
        baseline = _WORDS.top + 20 + number * ROW
        write(page, name, _WORDS.left, baseline, STRONG)
        write(page, words, _WORDS.left + 170, baseline, PLAIN)
    rest = Area(_WORDS.left, _WORDS.top + len(told) * ROW + 4, _WORDS.width, 76)
    write_wrapped(page, f"“{moment.decision.reason}”", rest, PLAIN)
