"""Printed faces that boxes, books and bottles share."""

import numpy as np

from assets_build.primitives import Drawing, Finish

UNIT = np.array([[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [0, 1]]], float)


def front(half: float, low: float, high: float, reach: float) -> np.ndarray:
    q = np.array([[-half, -reach, low], [half, -reach, low], [half, -reach, high], [-half, -reach, high]])
    return np.array([q[[0, 1, 2]], q[[0, 2, 3]]])


def sheet(d: Drawing, x: tuple[float, float], y: tuple[float, float], z: float, finish: Finish) -> None:
    """Draw a level picture."""
    q = np.array([[x[0], y[0], z], [x[1], y[0], z], [x[1], y[1], z], [x[0], y[1], z]])
    uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    d.add(np.array([q[[0, 1, 2]], q[[0, 2, 3]]]), finish, np.array([uv[[0, 1, 2]], uv[[0, 2, 3]]]))


def printed_box(d: Drawing, w: float, dep: float, h: float, face: Finish, side: Finish) -> None:
    """Draw a printed box, the print on its two large faces."""
    d.box((-w / 2, -dep / 2, 0), (w / 2, dep / 2, h), side)
    for turn in (0, 180):
        part = Drawing()
        part.add(front(w / 2, 0.0, h, dep / 2 + 0.0005), face, UNIT)
        d.place(part, turn=(0, 0, turn))
