"""A room with a table, two low boards, a cup and a ball, and an episode in it, for what the judge decides."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from worlds.glb import box, write_glb
from worlds.small_home import BALL, CUP, SINK, TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box, Model
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.step_events import NOTHING, StepEvents
from uniteam.world.simulation.touches import Touches
from uniteam.world.task.episode import Candidate, Episode
from uniteam.world.task.judge import Judge
from uniteam.world.task.measures import Measures


def _board(height: float) -> Model:
    size = (0.5, 0.5, height)
    return replace(TABLE, id=f"board_{height}", size=size, shapes=(Box((0.0, 0.0, height / 2), size),))


LOW_BOARD, HIGH_BOARD = _board(0.042), _board(0.058)
THINGS = (
    instance("cup", CUP, 0.5, 0.5),
    instance("other_cup", CUP, 0.5, 3.5),
    instance("table", TABLE, 2.0, 1.0),
    instance("ball", BALL, 1.0, 3.5),
    instance("sink", SINK, 7.5, 2.0),
    instance("low_board", LOW_BOARD, 6.0, 1.0),
    instance("high_board", HIGH_BOARD, 6.0, 3.0),
)


def judged_home(folder: Path, without: str = "") -> Home:
    """Return the room, with meshes of its models written into a folder, and without one of its things if asked to."""
    models = {model.id: _with_mesh(model, folder) for model in (TABLE, CUP, BALL, SINK, LOW_BOARD, HIGH_BOARD)}
    things = (thing for thing in THINGS if thing.name != without)
    return small_home(*things, library=Catalogue(models, frozenset()))


def _with_mesh(model: Model, folder: Path) -> Model:
    width, depth, height = model.size
    path = folder / f"{model.id}.glb"
    write_glb(path, box((-width / 2, -depth / 2, 0.0), (width / 2, depth / 2, height)))
    return replace(model, path=path)


CUP_INDEX, OTHER_INDEX, TABLE_INDEX = range(3)
CUP_VIEW, TABLE_VIEW = (1.0, 1.0), (2.0, 2.0)
EPISODE = Episode(
    id="judged",
    home="small",
    start=BasePose(3.0, 3.0, 0.0),
    instruction=Instruction("cup", "sink", "table"),
    objects=(Candidate("cup", (CUP_VIEW,)),),
    start_receptacles=("sink",),
    goal_receptacles=(Candidate("table", (TABLE_VIEW,)),),
    unseen=False,
    seed=0,
)
FOUND = Measures(find_object_phase_success=True)
PICKED = Measures(find_object_phase_success=True, pick_object_phase_success=True)
CARRIED = Measures(find_object_phase_success=True, pick_object_phase_success=True, find_recep_phase_success=True)
ON_THE_TABLE = (2.0, 1.0, TABLE_HEIGHT)


@dataclass
class Judged:
    """A judge, and a simulator whose objects are put where a test wants them."""

    simulator: Simulator
    judge: Judge

    @staticmethod
    def begin(simulator: Simulator, measures: Measures = CARRIED) -> "Judged":
        """Begin with every object in its place and measures that have been reached."""
        simulator.reset(EPISODE.start)
        judged = Judged(simulator, Judge(simulator.home, EPISODE))
        judged.judge.measures = measures
        return judged

    def stand(self, x: float, y: float) -> None:
        """Put the base somewhere, and every object back."""
        self.simulator.reset(BasePose(x, y, 0.0))

    def put(self, name: str, x: float, y: float, z: float) -> None:
        """Put an object somewhere, at standstill."""
        pose = np.eye(4)
        pose[:3, 3] = (x, y, z)
        self.simulator.physics.set_pose(name, pose)

    def see(self, pixels: int, index: int) -> Measures:
        """Let a step pass in which the camera sees an instance in so many pixels."""
        return self.step(NOTHING, frame_of(pixels, index))

    def release(self, name: str = "cup") -> Measures:
        """Let a step pass in which the gripper has let go of an object."""
        return self.step(StepEvents(released=name))

    def touch(self, touches: Touches) -> Measures:
        """Let a step pass in which something was met."""
        return self.step(StepEvents(touches=touches))

    def wait(self, steps: int) -> Measures:
        """Let steps and their time pass."""
        for _ in range(steps):
            self.simulator.physics.advance(0.032)
            self.step(NOTHING)
        return self.judge.measures

    def step(self, events: StepEvents, frame: Frame | None = None) -> Measures:
        """Have the judge look."""
        self.judge.update(self.simulator, events, frame_of(0, 0) if frame is None else frame, stopped=False)
        return self.judge.measures


def frame_of(pixels: int, index: int) -> Frame:
    """Return a half-size frame that shows an instance in so many pixels and nothing else."""
    shape = (HEAD_CAMERA_HALF.height, HEAD_CAMERA_HALF.width)
    instances = np.full(shape, -1, np.int16)
    instances.ravel()[:pixels] = index
    return Frame(np.zeros((*shape, 3), np.uint8), np.ones(shape, np.float32), instances)
