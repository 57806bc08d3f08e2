"""What others have published of this task: in another simulator, in other homes, and so unlike all figures of ours."""

from dataclasses import dataclass

UNLIKE = (
    "Published figures, UNLIKE those above: HomeRobot's simulator and homes are others, and so are the episodes; "
    "none of these differences is one between agents alone."
)


@dataclass(frozen=True)
class PublishedRow:
    """A system's figures in percent, as they were printed; None where they were not.

    Attributes:
        system: its name.
        setting: split and perception.
        find_object, pick, find_receptacle, overall, partial: the challenge's measures.
        steps: mean number of steps.
        source: where they were printed.
    """

    system: str
    setting: str
    find_object: float | None
    pick: float | None
    find_receptacle: float | None
    overall: float
    partial: float | None
    steps: float | None
    source: str


_HOMEROBOT, _HELIOS, _MOMANIP = "arXiv 2306.11565", "arXiv 2509.22498", "arXiv 2503.13446"
_CHALLENGE, _REPORT = "arXiv 2407.06939", "arXiv 2312.08611"
_TRUTH, _DETIC = "val, ground truth", "val, Detic"
_TEST, _FINAL = "test-standard, detector", "challenge final, detector"

PUBLISHED = (
    PublishedRow("HomeRobot heuristic", _TRUTH, 54.1, 48.5, 31.5, 5.1, 34.8, None, _HOMEROBOT),
    PublishedRow("HomeRobot heuristic, RL gaze and place", _TRUTH, 56.5, 51.5, 42.3, 13.2, 40.9, None, _HOMEROBOT),
    PublishedRow("HomeRobot RL", _TRUTH, 66.6, 61.1, 50.9, 14.8, 48.3, None, _HOMEROBOT),
    PublishedRow("MoManipVLA", _TRUTH, 66.1, 62.6, 53.1, 15.8, 49.4, None, _MOMANIP),
    PublishedRow("HELIOS", _TRUTH, 66.3, 58.3, 53.4, 21.0, None, None, _HELIOS),
    PublishedRow("HomeRobot heuristic", _DETIC, 28.7, 15.2, 5.3, 0.4, 12.4, None, _HOMEROBOT),
    PublishedRow("HELIOS", _DETIC, 42.3, 30.5, 18.6, 3.2, None, None, _HELIOS),
    PublishedRow("KuzHum", _TEST, None, None, None, 2.8, 19.1, 1152.99, _REPORT),
    PublishedRow("UniTeam", _TEST, None, None, None, 2.0, 18.6, 1140.54, _REPORT),
    PublishedRow("PieSquare", _TEST, None, None, None, 2.0, 11.1, 1082.56, _REPORT),
    PublishedRow("HomeRobot heuristic", _TEST, None, None, None, 0.0, 10.5, 1063.74, _REPORT),
    PublishedRow("UniTeam", _FINAL, None, None, None, 10.8, 32.8, None, _CHALLENGE),
    PublishedRow("HomeRobot heuristic", _FINAL, None, None, None, 0.8, 17.7, None, _CHALLENGE),
)
"""In the order of the settings; agents in one setting are comparable with each other."""
