"""Pictures of a home: a labelled plan, a view from above without the ceiling, and a view inside each room."""

import math
from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera, transform_points
from uniteam.world.homes.fixed_mesh import section, stage_mesh
from uniteam.world.homes.home import Home, Instance, Opening, Room, Wall
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.scene import Scene

Image = NDArray[np.uint8]
Colour = tuple[int, int, int]

PIXELS_PER_METRE = 100
"""Of a plan; fewer where the plan would be longer than `LONGEST_PLAN`."""
LONGEST_PLAN = 6_000
"""Pixels."""
EYE_HEIGHT = 1.6
"""m."""

_MARGIN = 0.6
_FROM_WALLS = 0.22
_SHARPEST = 0.3
_CUT_HEIGHT = 1.2
_INK: Colour = (45, 45, 50)
_ROOM_COLOURS: dict[str, Colour] = {
    "living_room": (250, 232, 200), "kitchen": (252, 214, 190), "dining_room": (245, 224, 228),
    "bedroom": (214, 226, 246), "bathroom": (206, 240, 240), "office": (222, 238, 210), "hall": (238, 236, 232),
    "laundry": (226, 216, 240),
}  # fmt: skip
_ROLE_COLOURS: dict[str, Colour] = {
    "receptacle": (255, 255, 255), "decor": (225, 228, 220), "door": (190, 150, 110), "object": (210, 60, 50),
}  # fmt: skip
_INSIDE = PinholeCamera.from_horizontal_fov(800, 600, math.radians(84.0))


def draw_plan(home: Home) -> Image:
    """Return the plan from above, (H, W, 3) RGB: rooms by kind, furniture with names, objects as dots, a scale."""
    return _Plan(home).draw()


def view_from_above(home: Home, width: int = 1200) -> Image:
    """Return the home without its ceiling, seen from high above, (H, W, 3) RGB."""
    low, high = _bounds(home)
    height = round(width * (high[1] - low[1]) / (high[0] - low[0]))
    distance = 30.0
    focal = width / (high[0] - low[0]) * (distance - home.stage.ceiling_height)
    camera = PinholeCamera(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = (*((low + high) / 2), distance)
    scene = Scene(home)
    scene.show("ceiling", False)
    return render(scene, camera, pose).rgb


def views_inside(home: Home) -> Iterator[tuple[str, Image]]:
    """Yield (room name, (H, W, 3) RGB): each room from the corner that shows most of it, at eye height."""
    scene = Scene(home)
    small = PinholeCamera.from_horizontal_fov(80, 60, math.radians(84.0))
    for room in home.stage.rooms:
        poses = list(_corner_poses(room))
        openness = [float(np.minimum(render(scene, small, pose).depth, 6.0).mean()) for pose in poses]
        yield room.name, render(scene, _INSIDE, poses[int(np.argmax(openness))]).rgb


def _corner_poses(room: Room) -> Iterator[NDArray[np.float64]]:
    """Yield camera_to_world (4, 4) in each corner that opens inwards, looking past the middle and a little down."""
    corners, middle = np.array(room.outline), np.array(room.middle)
    for before, corner, after in zip(np.roll(corners, 1, axis=0), corners, np.roll(corners, -1, axis=0), strict=True):
        into, on = (corner - before) / math.dist(before, corner), (after - corner) / math.dist(corner, after)
        turn = into[0] * on[1] - into[1] * on[0]
        if turn > _SHARPEST:
            eye = corner + _FROM_WALLS * (on - into) / turn
            yield _looking((*eye, EYE_HEIGHT), (*(middle + (middle - eye) * 0.5), 0.55))


def _looking(eye: tuple[float, ...], target: tuple[float, ...]) -> NDArray[np.float64]:
    forward = np.subtract(target, eye)
    forward = forward / np.linalg.norm(forward)
    right = np.array([forward[1], -forward[0], 0.0])
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(forward, right), forward], axis=1)
    pose[:3, 3] = eye
    return pose


def _bounds(home: Home) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    corners = np.array([(room.low, room.high) for room in home.stage.rooms])
    return corners[:, 0].min(axis=0) - _MARGIN, corners[:, 1].max(axis=0) + _MARGIN


class _Plan:
    """Draws one home on one canvas; points are in m of the world, y up."""

    def __init__(self, home: Home) -> None:
        self._home = home
        self._low, self._high = _bounds(home)
        self._scale = min(PIXELS_PER_METRE, LONGEST_PLAN / float((self._high - self._low).max()))
        width, height = np.ceil((self._high - self._low) * self._scale).astype(int)
        self._canvas = np.full((height, width, 3), 255, np.uint8)

    def draw(self) -> Image:
        for room in self._home.stage.rooms:
            self._fill(np.array(room.outline), _ROOM_COLOURS.get(room.kind, (235, 235, 235)), None)
        for wall in self._home.stage.walls:
            self._draw_wall(wall)
        mesh = stage_mesh(self._home.stage)
        for start, end in [] if mesh is None else section(mesh, _CUT_HEIGHT):
            cv2.line(self._canvas, self._pixel(start), self._pixel(end), _INK, 3, cv2.LINE_AA)
        pieces = sorted(self._home.instances, key=lambda i: (i.movable, i.position[2] + self._size(i)[2]))
        for piece in pieces:
            if not piece.movable:
                self._draw_piece(piece)
        for piece in pieces:
            if piece.movable:
                cv2.circle(self._canvas, self._pixel(piece.position[:2]), 5, _ROLE_COLOURS["object"], -1, cv2.LINE_AA)
        for room in self._home.stage.rooms:
            self._write(room.name.replace("_", " "), _label_corner(room), 0.55, 2)
        self._draw_scale()
        return self._canvas

    def _size(self, piece: Instance) -> tuple[float, float, float]:
        return self._home.model_of(piece).size

    def _pixel(self, point: NDArray[np.float64] | tuple[float, float]) -> tuple[int, int]:
        x, y = (np.array([point[0], self._high[1] - point[1] + self._low[1]]) - self._low) * self._scale
        return round(float(x)), round(float(y))

    def _fill(self, outline: NDArray[np.float64], colour: Colour, edge: Colour | None) -> None:
        pixels = np.array([self._pixel(point) for point in outline], np.int32)
        cv2.fillPoly(self._canvas, [pixels], colour, cv2.LINE_AA)
        if edge is not None:
            cv2.polylines(self._canvas, [pixels], True, edge, 1, cv2.LINE_AA)

    def _draw_wall(self, wall: Wall) -> None:
        length = math.dist(wall.start, wall.end)
        self._fill(_strip(wall, 0.0, length, wall.thickness), _INK, None)
        for opening in wall.openings:
            self._draw_opening(wall, opening)

    def _draw_opening(self, wall: Wall, opening: Opening) -> None:
        colour = (150, 205, 245) if opening.kind == "window" else (255, 255, 255)
        self._fill(_strip(wall, opening.start, opening.end, wall.thickness), colour, _INK)

    def _draw_piece(self, piece: Instance) -> None:
        model = self._home.model_of(piece)
        hx, hy = model.size[0] / 2, model.size[1] / 2
        corners = np.array([(-hx, -hy, 0), (hx, -hy, 0), (hx, hy, 0), (-hx, hy, 0)])
        outline = transform_points(piece.model_to_world(), corners)[:, :2]
        if model.shapes and piece.position[2] < 1.0:
            self._fill(outline, _ROLE_COLOURS[model.role], _INK)
            cv2.line(self._canvas, self._pixel(outline[0]), self._pixel(outline[1]), (200, 90, 30), 2, cv2.LINE_AA)
            if model.role != "door":
                self._label(piece.category.replace("_", " "), outline.mean(axis=0))
        else:
            pixels = np.array([self._pixel(point) for point in outline], np.int32)
            cv2.polylines(self._canvas, [pixels], True, (150, 140, 160), 1, cv2.LINE_AA)

    def _label(self, text: str, centre: NDArray[np.float64]) -> None:
        (width, height), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, 0.36, 1)
        self._write(text, tuple(centre - np.array([width, height]) / (2 * self._scale)), 0.36, 1)

    def _write(self, text: str, at: tuple[float, float], size: float, weight: int) -> None:
        cv2.putText(self._canvas, text, self._pixel(at), cv2.FONT_HERSHEY_SIMPLEX, size, _INK, weight, cv2.LINE_AA)

    def _draw_scale(self) -> None:
        x, y = self._low[0] + 0.15, self._low[1] + 0.15
        cv2.line(self._canvas, self._pixel((x, y)), self._pixel((x + 2.0, y)), _INK, 3)
        self._write("2 m", (x + 2.1, y - 0.04), 0.45, 1)


def _label_corner(room: Room) -> tuple[float, float]:
    """Return where a room's name begins: below its highest corner, the leftmost of them."""
    x, y = max(room.outline, key=lambda corner: (corner[1], -corner[0]))
    return x + 0.12, y - 0.28


def _strip(wall: Wall, start: float, end: float, thickness: float) -> NDArray[np.float64]:
    """Return the (4, 2) corners of the stretch [start, end] of a wall, seen from above."""
    origin = np.array(wall.start)
    along = (np.array(wall.end) - origin) / math.dist(wall.start, wall.end)
    across = np.array([-along[1], along[0]]) * thickness / 2
    near, far = origin + along * start, origin + along * end
    return np.array([near - across, far - across, far + across, near + across])
