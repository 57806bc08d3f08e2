"""The room of the judged scene, opened for the referees of the Gymnasium environments."""

from pathlib import Path

from worlds.judged_scene import EPISODE, judged_home

from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.geometry import BasePose
from uniteam.stretch import HEAD_CAMERA_SMALL
from uniteam.world.task.episode import Split


def judged_split(folder: Path) -> Split:
    """Return a split of the one episode; the meshes of its models are written into a folder."""
    return Split("judged", (EPISODE,), {EPISODE.home: judged_home(folder)})


def opened(folder: Path) -> OpenHome:
    """Return the room with the robot at the episode's start."""
    place = OpenHome(judged_home(folder), HEAD_CAMERA_SMALL)
    place.simulator.reset(EPISODE.start)
    return place


def stand(place: OpenHome, x: float, y: float, heading: float) -> None:
    """Put the base somewhere (world), whatever the gripper holds."""
    place.simulator.return_to(place.simulator.moment(), BasePose(x, y, heading))
