"""How Rerun's viewer arranges what is in the file, until its user does otherwise."""

from types import ModuleType
from typing import Any

from uniteam.visualization.rerun_file import paths


def layout(rerun: ModuleType) -> Any:
    """Return the blueprint: the home and the map on the left, pictures, measures and words on the right."""
    rrb = rerun.blueprint
    camera = rrb.Spatial2DView(origin=paths.CAMERA, contents=[paths.COLOUR], name="head camera")
    seen = rrb.Spatial2DView(origin=paths.CAMERA, name="perception")
    depth = rrb.Spatial2DView(origin=paths.DEPTH, name="depth")
    measures = rrb.TimeSeriesView(origin="measures", name="measures")
    states = rrb.StateTimelineView(origin=paths.STATE, name="state")
    words = rrb.TextLogView(origin="agent", contents=[paths.DECISIONS, paths.TROUBLE], name="decisions")
    asked = rrb.TextDocumentView(origin=paths.EPISODE, name="episode")
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(rrb.Spatial3DView(origin=paths.WORLD, name="map and home"), states, row_shares=[5, 1]),
            rrb.Vertical(rrb.Horizontal(camera, seen, depth), rrb.Horizontal(measures, asked), words),
            column_shares=[1, 1],
        ),
        collapse_panels=True,
    )
