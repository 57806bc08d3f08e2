"""What makes an episode easy or hard, measured when it is made: by these its results can be broken down."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Tags:
    """Facts of an episode.

    Attributes:
        style: in which its home was made; "own" where it is from no generator of ours.
        area: of the home's floor (m2).
        rooms: of the home.
        shortest_path: how far the base drives from the start to where it grasped, and from there to where it released,
            when the episode was certified (m).
        least_clearance: from the base's centre to the nearest obstacle on that way (m).
        object_height: of the origin of the object that was grasped above the floor (m).
        object_pixels: of that object in its best view from a view point, in the half-size camera.
        goals: receptacles of the goal class that count.
        same_class: objects of its class in the home that do not count.
    """

    style: str
    area: float
    rooms: int
    shortest_path: float
    least_clearance: float
    object_height: float
    object_pixels: int
    goals: int
    same_class: int
