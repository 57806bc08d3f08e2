"""The figures of the report show what they say, in the colours of their legends."""

import colorsys
from pathlib import Path

import cv2
import numpy as np
import pytest

from uniteam.cli.main import main
from uniteam.mind.agents.map_overlay import draw_overlay
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.visualization.canvas import Image
from uniteam.visualization.figures import colors, floor_as_table, goal_map, search_panel
from uniteam.visualization.figures.belief_map import Layer, chosen_point, draw_belief, start_cells
from uniteam.visualization.figures.drawing import FIGURES
from uniteam.visualization.figures.moment import Moment
from uniteam.visualization.figures.page import Entry
from uniteam.visualization.map_window import MapWindow

SIZE = (800, 600)

PROTANOPIA = np.array(
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
)
DEUTERANOPIA = np.array(
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
)
"""What such a reader sees of a linear RGB colour: Machado, Oliveira and Fernandes (2009), doi:10.1109/TVCG.2009.113."""


@pytest.fixture(scope="module")
def search() -> Moment:
    """A step of the search at which both the panel and the goal map have something to show."""
    return search_panel.SCENE.play()


@pytest.fixture(scope="module")
def floor() -> Moment:
    """A step at which floor is taken for a table."""
    return floor_as_table.SCENE.play()


def share_of(picture: Image, moment: Moment, cells: np.ndarray, color: tuple[int, int, int]) -> float:
    """Return at how many of some cells a picture of the map has a colour."""
    board, base = moment.agent.board, moment.observation.base_to_start
    size = picture.shape[1], picture.shape[0]
    window = MapWindow(draw_overlay(board.bird_map, base, plan=board.plan), base, size)
    pixels = [window.pixel(*point) for point in board.bird_map.points_of(cells)]
    return float(np.mean([np.array_equal(picture[v, u], color) for u, v in pixels]))


def words_of(legend: tuple[Entry, ...], words: str) -> tuple[int, int, int]:
    return next(entry.color for entry in legend if entry.words == words)


def test_receptacles_have_the_colours_that_the_legend_says(search: Moment) -> None:
    bird_map = search.agent.board.bird_map
    unexplored, explored = start_cells(bird_map)
    goal = bird_map.class_cells(ClassRole.GOAL_RECEPTACLE)
    picture = draw_belief(search, (), SIZE)
    for cells, words in (
        (unexplored, "start receptacle, not looked at yet"),
        (explored, "start receptacle, looked at"),
        (goal, "goal receptacle"),
    ):
        for legend in (search_panel.LEGEND, goal_map.LEGEND):
            assert share_of(picture, search, cells, words_of(legend, words)) > 0.9


def test_the_colours_are_those_that_the_report_names() -> None:
    hue, saturation, value = zip(
        *(
            colorsys.rgb_to_hsv(*(part / 255 for part in color))
            for color in (
                colors.UNEXPLORED_START,
                colors.EXPLORED_START,
                colors.GOAL_RECEPTACLE,
                colors.GOAL_POINT,
                colors.CHOSEN_POINT,
            )
        ),
        strict=True,
    )
    assert all(0.52 < hue[k] < 0.68 for k in (0, 3, 4))  # blue
    assert all(0.03 < hue[k] < 0.12 for k in (1, 2))  # orange
    assert value[1] < 0.8 < value[2] and saturation[1] > 0.9 > saturation[2]  # dark and light orange
    assert value[4] < 0.5 < value[0] < 0.8 < value[3]  # dark blue, blue and light blue


@pytest.mark.parametrize("sees", [PROTANOPIA, DEUTERANOPIA])
def test_colour_blind_readers_tell_the_colours_apart(sees: np.ndarray) -> None:
    names = ["UNEXPLORED_START", "EXPLORED_START", "GOAL_RECEPTACLE", "GOAL_POINT", "CHOSEN_POINT"]
    names += ["FRONTIER", "OBSTACLE", "FREE", "UNKNOWN", "OBJECT"]
    given = np.array([getattr(colors, name) for name in names]) / 255.0
    linear = np.where(given <= 0.04045, given / 12.92, ((given + 0.055) / 1.055) ** 2.4)
    seen = np.clip(linear @ sees.T, 0.0, 1.0)
    encoded = np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** (1 / 2.4) - 0.055)
    lab = cv2.cvtColor(encoded[None].astype(np.float32), cv2.COLOR_RGB2LAB)[0]
    apart = np.linalg.norm(lab[:, None] - lab, axis=-1) + 100.0 * np.eye(len(names))
    closest = np.unravel_index(apart.argmin(), apart.shape)
    assert apart.min() > 17.0, [names[k] for k in closest]


def test_points_to_go_to_are_light_blue_and_the_chosen_one_dark_blue(search: Moment) -> None:
    board = search.agent.board
    assert board.goal is not None and board.plan is not None
    picture = draw_belief(search, (Layer(board.goal.cells, colors.GOAL_POINT),), SIZE)
    window = MapWindow(
        draw_overlay(board.bird_map, search.observation.base_to_start, plan=board.plan),
        search.observation.base_to_start,
        SIZE,
    )
    x, y = chosen_point(board.plan.goal_points, board.plan.path)
    u, v = window.pixel(x, y)
    assert tuple(picture[v, u]) == words_of(search_panel.LEGEND, "goal point that is headed for")
    apart = board.goal.cells.copy()
    row, column = board.bird_map.to_cell(x, y)
    apart[row - 8 : row + 9, column - 8 : column + 9] = False
    assert apart.any() and share_of(picture, search, apart, words_of(search_panel.LEGEND, "goal points")) > 0.9


def test_the_panel_has_camera_third_person_map_and_legend(search: Moment) -> None:
    page = search_panel.draw_search_panel(search)
    assert page.shape == (search_panel.HEIGHT, search_panel.WIDTH, 3)
    head = cv2.resize(search.observation.rgb, (360, 480), interpolation=cv2.INTER_LINEAR)
    assert np.array_equal(page[96 : 96 + 480, 24 : 24 + 360], head)
    assert len(np.unique(page[100:570, 410:970].reshape(-1, 3), axis=0)) > 1000  # a picture of a room
    below = page[600:]
    for entry in search_panel.LEGEND:
        assert np.count_nonzero((below == entry.color).all(axis=-1)) > 300
    assert (page[:, -20:] == 255).all() and (page[-8:] == 255).all()  # nothing is cut


def test_the_goal_map_has_the_frontier_and_the_points_around_receptacles(search: Moment) -> None:
    assert goal_map.has_both_goals(search)
    frontier, around = goal_map.goal_layers(search)
    page = goal_map.draw_goal_map(search)
    picture = page[72 : 72 + 804, 24 : 24 + 1060]
    assert share_of(picture, search, frontier.cells, words_of(goal_map.LEGEND, "frontier")) > 0.8
    assert share_of(picture, search, around.cells, words_of(goal_map.LEGEND, "points around start receptacles")) > 0.5
    assert not search.agent.board.bird_map.explored[frontier.cells].any()


def test_floor_is_taken_for_a_table_without_the_filter_and_not_with_it(floor: Moment) -> None:
    patch = floor_as_table.dropped(floor)[0]
    assert floor.observation.truth is not None
    true_names = [d.name for d in floor.observation.truth.detections]
    of_patch = floor.observation.truth.instances[patch.mask]
    assert not {true_names[k] for k in np.unique(of_patch[of_patch >= 0])} & {"table"}
    before, after = floor_as_table.before_and_after(floor)
    rgb = floor.observation.rgb
    without, filtered = floor_as_table.tinted(rgb, before), floor_as_table.tinted(rgb, after)
    inside = cv2.erode(patch.mask.astype(np.uint8), np.ones((9, 9))).astype(bool)
    assert np.median(without[inside][:, 2].astype(int) - without[inside][:, 0]) > 60  # blue: a start receptacle
    assert np.array_equal(filtered[inside][:, 0], filtered[inside][:, 2])  # grey
    assert any("table" in thing.words for thing in after)  # the real one stays


def test_a_figure_is_written_into_a_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(("figures", "--only", "floor-as-table", "--out", str(tmp_path / "new")))
    assert ended.value.code == 0
    (file,) = (tmp_path / "new").iterdir()
    assert file.name == "floor-as-table.jpg" and file.stat().st_size < 150_000
    picture = cv2.imread(str(file))
    assert picture is not None and picture.shape == (floor_as_table.HEIGHT, floor_as_table.WIDTH, 3)
    assert "floor-as-table.jpg" in capsys.readouterr().out.replace("\n", "")


def test_there_is_a_figure_for_each_name_of_the_command() -> None:
    assert list(FIGURES) == ["search-panel", "floor-as-table", "goal-map"]
