"""The lines of a split's file: their fields, their types and their bounds."""

import math
from dataclasses import asdict
from typing import Annotated

import msgspec

from uniteam.stretch import MANIPULATION_POSTURE
from uniteam.world.homes.schema import Coordinate, Name

MOST_BYTES = 64 * 1024 * 1024
"""A split's file is no larger than this once it is unpacked."""
MOST_VIEW_POINTS = 5_000_000
"""In a split."""

Cell = Annotated[int, msgspec.Meta(ge=-10_000, le=10_000)]
Heading = Annotated[float, msgspec.Meta(ge=-2.0 * math.pi, le=2.0 * math.pi)]
JointPosition = Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
Runs = Annotated[list[Cell], msgspec.Meta(max_length=30_000)]
Names = Annotated[list[Name], msgspec.Meta(min_length=1, max_length=2_000)]


class PoseData(msgspec.Struct, forbid_unknown_fields=True):
    """A `BasePose`."""

    x: Coordinate
    y: Coordinate
    heading: Heading


class InstructionData(msgspec.Struct, forbid_unknown_fields=True):
    """An `Instruction`."""

    object_category: Name
    start_receptacle: Name
    goal_receptacle: Name


class JointsData(msgspec.Struct, forbid_unknown_fields=True):
    """`Joints`."""

    lift: JointPosition
    arm: JointPosition
    wrist_yaw: JointPosition = 0.0
    wrist_pitch: JointPosition = 0.0
    wrist_roll: JointPosition = 0.0
    head_pan: JointPosition = 0.0
    head_tilt: JointPosition = 0.0


class CertificateData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Certificate`."""

    object: Name
    grasp: PoseData
    receptacle: Name
    release: PoseData
    release_joints: JointsData
    grasp_joints: JointsData = msgspec.field(default_factory=lambda: JointsData(**asdict(MANIPULATION_POSTURE)))
    release_rise: Annotated[float, msgspec.Meta(ge=0.0, le=1.1)] = 0.0


Count = Annotated[int, msgspec.Meta(ge=0, le=1_000_000)]
Length = Annotated[float, msgspec.Meta(ge=0.0, le=100_000.0)]


class TagsData(msgspec.Struct, forbid_unknown_fields=True):
    """`Tags`."""

    style: Name
    area: Length
    rooms: Count
    shortest_path: Length
    least_clearance: Length
    object_height: Length
    object_pixels: Count
    goals: Count
    same_class: Count


class EpisodeData(msgspec.Struct, forbid_unknown_fields=True):
    """An `Episode`; its candidates' view points stand in a line of their own."""

    id: Name
    home: Name
    start: PoseData
    instruction: InstructionData
    objects: Names
    start_receptacles: Names
    goal_receptacles: Names
    unseen: bool
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**53)]
    certificate: CertificateData | None = None
    tags: TagsData | None = None


class ViewPointsData(msgspec.Struct, forbid_unknown_fields=True):
    """The view points of a home's instances, as the runs of `lattice`."""

    home: Name
    instances: dict[Name, Runs]


class SplitData(msgspec.Struct, forbid_unknown_fields=True):
    """What a `Split` is besides its episodes and homes."""

    version: Annotated[int, msgspec.Meta(ge=1, le=1_000_000)]


class LineData(msgspec.Struct, forbid_unknown_fields=True):
    """A line: one of the four."""

    home: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    view_points: ViewPointsData | msgspec.UnsetType = msgspec.UNSET
    episode: EpisodeData | msgspec.UnsetType = msgspec.UNSET
    split: SplitData | msgspec.UnsetType = msgspec.UNSET
