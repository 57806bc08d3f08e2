"""The causes for which episodes fail, and which of the UniTeam report's sentences each is."""

from collections.abc import Mapping
from enum import Enum


class Cause(Enum):
    """Why an episode is no overall success; the value is its name in tables and files."""

    CRASHED = "agent crashed"
    WORLD = "the world's fault"
    COLLIDED = "arm or load collided"
    AGAINST_WALL = "through or against a wall"
    NOT_COUNTED = "done from where it does not count"
    STOPPED_EARLY = "stopped before it had lain long enough"
    WRONG_RECEPTACLE = "wrong receptacle"
    ONTO_ANOTHER = "onto another thing"
    TOO_HIGH = "receptacle too high"
    TOO_SMALL = "receptacle too small"
    CLUTTERED = "receptacle cluttered"
    TOO_LARGE = "receptacle too large"
    FELL_OFF = "fell off the edge"
    BESIDE = "dropped beside"
    WRONG_OBJECT = "wrong object"
    OUT_OF_REACH = "grasp out of reach"
    OUT_OF_VIEW = "grasp out of view"
    NOT_RECOGNISED = "seen but not recognised"
    NARROW_PASSAGE = "narrow passage"
    STUCK = "stuck or oscillating"
    GAVE_UP = "gave up with steps left"
    NEVER_SEEN = "object never seen"
    RECEPTACLE_NEVER_FOUND = "receptacle never found"
    NOT_REACHED = "found but not reached"
    TIME_RAN_OUT = "time ran out"
    NOT_RECORDED = "not to be told without a recording"


_RECOGNITION = "wrong recognition is behind most"
_PASSAGES = "stuck in or giving up on narrow passages"
_TIMEOUT = "timeout while searching"

REPORT: Mapping[Cause, str] = {
    Cause.AGAINST_WALL: "placing through a wall",
    Cause.WRONG_RECEPTACLE: _RECOGNITION,
    Cause.TOO_LARGE: "a receptacle too large",
    Cause.WRONG_OBJECT: _RECOGNITION,
    Cause.NOT_RECOGNISED: "overlooking the object",
    Cause.NARROW_PASSAGE: _PASSAGES,
    Cause.STUCK: _PASSAGES,
    Cause.NEVER_SEEN: _TIMEOUT,
    Cause.RECEPTACLE_NEVER_FOUND: _TIMEOUT,
}
"""What the UniTeam report (arXiv 2312.08611) names among its failures, for the causes that it names."""
