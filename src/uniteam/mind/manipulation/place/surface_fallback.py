"""Placing where no receptacle is detected: on a flat surface in reach, not blindly out (`surface_fallback`)."""

from dataclasses import dataclass

import numpy as np

from uniteam.mind.manipulation.place.baseline_place import extend_blindly
from uniteam.mind.manipulation.place.headroom import points_with_headroom
from uniteam.mind.manipulation.place.local_cloud import LocalCloud
from uniteam.mind.manipulation.place.place import Aim, Fallback, PlaceContext, Stand, enter_manipulation_mode
from uniteam.mind.manipulation.place.placing_points import PlacingPoints
from uniteam.mind.skills.skill import Skill
from uniteam.mind.skills.view import View


@dataclass(frozen=True)
class OntoFlatSurface:
    """Aims at a flat surface of anything that stands high enough to be furniture.

    Attributes:
        lowest: height (m) above the floor from which a surface counts.
        otherwise: what to do where there is none in reach.
    """

    lowest: float = 0.2
    otherwise: Fallback = extend_blindly

    def __call__(self, view: View, stand: Stand | None, context: PlaceContext) -> Skill[Aim]:
        """Answer with an aim at a flat surface in reach; as otherwise where there is none.

        What was seen before from the same stand is kept in mind: it is from there that the last view is.
        """
        nearby = LocalCloud()
        view = yield from enter_manipulation_mode(view, "I see no receptacle, so I look for a flat surface beside me.")
        nearby.add(view, context.receptacle(view))
        around = nearby.surroundings(view.observation.base_to_start)
        known = around if stand is None else np.concatenate([around, stand.surroundings])
        flat = points_with_headroom(around[around[:, 2] > self.lowest])
        if len(flat) == 0:
            return (yield from self.otherwise(view, stand, context))
        chosen = context.choose_points(flat, np.zeros((0, 3), np.float32), context.load, context.generator)
        in_reach = np.array([self._is_in_reach(context, x, y) for x, y, _ in chosen.points], dtype=np.bool_)
        candidates = context.motion.in_line(
            PlacingPoints(chosen.points[in_reach], chosen.worth[in_reach]), context.release.reach
        )
        aim = context.find_path(Stand(view, candidates, known, context.motion.line_up), context)
        return (yield from self.otherwise(view, stand, context)) if aim is None else aim

    def _is_in_reach(self, context: PlaceContext, x: float, y: float) -> bool:
        reach = context.release.reach
        return (
            reach.reaches(float(x), float(y)) and context.motion.line_up(reach.turn_to(float(x), float(y))) is not None
        )
