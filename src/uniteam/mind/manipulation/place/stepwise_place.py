"""Closing in step by step: look, come a little closer, look again; then line the arm up (`stepwise_place`).

The robot keeps what it saw on the way in (`LocalCloud`): close to a receptacle, the camera looks over its near edge.
"""

from dataclasses import dataclass

import numpy as np

from uniteam.mind.manipulation.place.local_cloud import LocalCloud
from uniteam.mind.manipulation.place.place import PlaceContext, Stand, enter_manipulation_mode
from uniteam.mind.manipulation.place.placing_points import NOWHERE
from uniteam.mind.skills.skill import Skill
from uniteam.mind.skills.view import Points, View

GOOD_SHARE = 0.7
"""Of the best worth: among points so good the nearest is headed for, since one much farther would cost more steps and
views than the rest of the worth is."""


@dataclass(frozen=True)
class CloseInStepwise:
    """Comes closer in small steps and measures again after each.

    Attributes:
        step: of the drive (m).
        most_steps: how many turns and drives to make before the arm must do.
        comfort: distance (m) from the base to a placing point, as a share of the arm's reach, that is near enough.
    """

    step: float = 0.25
    most_steps: int = 12
    comfort: float = 0.92

    def __call__(self, view: View, context: PlaceContext) -> Skill[Stand | None]:
        """Answer with the stand near enough to a placing point; None where no receptacle is seen."""
        nearby = LocalCloud()
        nearby.add(view, context.receptacle(view))
        if len(nearby.goal_points(view.observation.base_to_start)) == 0:
            return None
        view = yield from self._come_closer(view, context, nearby)
        view = yield from enter_manipulation_mode(view, "I am near enough and point the arm at the receptacle.")
        nearby.add(view, context.receptacle(view))
        pose = view.observation.base_to_start
        points = nearby.goal_points(pose)
        everything_else = nearby.others(pose)
        chosen = NOWHERE
        if len(points):
            chosen = context.choose_points(points, everything_else, context.load, context.generator)
        in_line = context.motion.in_line(chosen, context.release.reach)
        return Stand(view, in_line, nearby.surroundings(pose), context.motion.line_up)

    def _come_closer(self, view: View, context: PlaceContext, nearby: LocalCloud) -> Skill[View]:
        enough = self.comfort * context.release.reach.far
        for _ in range(self.most_steps):
            pose = view.observation.base_to_start
            target = self._nearest_good_point(nearby.goal_points(pose), nearby.others(pose), context)
            move = None if target is None else context.motion.next_move(target, enough, self.step)
            if move is None:
                break
            before = view.observation.base_to_start
            view = yield move
            if view.observation.base_to_start == before:
                break
            nearby.add(view, context.receptacle(view))
        return view

    def _nearest_good_point(self, points: Points, others: Points, context: PlaceContext) -> np.ndarray | None:
        if len(points) == 0:
            return None
        chosen = context.choose_points(points, others, context.load, context.generator)
        if len(chosen.points) == 0:
            return None
        distance = np.hypot(chosen.points[:, 0], chosen.points[:, 1])
        good = chosen.worth >= GOOD_SHARE * chosen.worth.max()
        return chosen.points[int(np.argmin(np.where(good, distance, np.inf)))]
