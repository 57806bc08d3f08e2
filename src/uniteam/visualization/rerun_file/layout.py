"""How Rerun's viewer arranges what is in the file, until its user does otherwise."""

from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.visualization.rerun_file import paths

LEAST_SPAN = 4.0
"""How large a part of the floor (m) the view of the map shows at least."""


def layout(rerun: ModuleType, way: NDArray[np.float64]) -> Any:
    """Return the blueprint: the home and the map on the left, pictures, measures and words on the right.

    Args:
        rerun: the library.
        way: (M, 2) points of the floor (m, start frame) that the robot went through; the map is seen from above them.
    """
    rrb = rerun.blueprint
    camera = rrb.Spatial2DView(origin=paths.CAMERA, contents=[paths.COLOUR], name="head camera")
    seen = rrb.Spatial2DView(origin=paths.CAMERA, name="perception")
    depth = rrb.Spatial2DView(origin=paths.DEPTH, name="depth")
    measures = rrb.TimeSeriesView(origin="measures", name="measures")
    states = rrb.StateTimelineView(origin=paths.STATE, name="state")
    words = rrb.TextLogView(origin="agent", contents=[paths.DECISIONS, paths.TROUBLE], name="decisions")
    asked = rrb.TextDocumentView(origin=paths.EPISODE, name="episode")
    scene = rrb.Spatial3DView(origin=paths.WORLD, name="map and home", eye_controls=_eye(rrb, way))
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(scene, states, row_shares=[5, 1]),
            rrb.Vertical(rrb.Horizontal(camera, seen, depth), rrb.Horizontal(measures, asked), words),
            column_shares=[1, 1],
        ),
        collapse_panels=True,
    )


def _eye(rrb: ModuleType, way: NDArray[np.float64]) -> Any:
    """Return an eye above the way and a little behind it."""
    low, high = way.min(axis=0), way.max(axis=0)
    (x, y), span = (low + high) / 2.0, max(LEAST_SPAN, float((high - low).max()))
    return rrb.EyeControls3D(position=(x - 0.7 * span, y, 1.4 * span), look_target=(x, y, 0.0), eye_up=(0.0, 0.0, 1.0))
