"""Why an episode failed, of its recording, or of its line in the results where there is none."""

from dataclasses import dataclass

from uniteam.evaluation.causes.cause import REPORT, Cause
from uniteam.evaluation.causes.decide import decide
from uniteam.evaluation.causes.reading.read_story import read_story
from uniteam.evaluation.recording.recording import Recording
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.geometry import Point2
from uniteam.world.task.measures import Measures

PHASES = ("find object", "pick object", "find receptacle", "place", "no collision")
"""What an episode must come through, in this order."""


@dataclass(frozen=True)
class Diagnosis:
    """Why an episode is no overall success.

    Attributes:
        cause: the one cause.
        phase: of `PHASES`, the first that was missed.
        step: at which the cause shows.
        place: where on the floor (m, world), or None.
        words: what shows it, one sentence.
        is_recorded: whether it was decided from a recording.
    """

    cause: Cause
    phase: str
    step: int
    place: Point2 | None
    words: str
    is_recorded: bool

    @property
    def report(self) -> str:
        """Which of the UniTeam report's sentences the cause is; empty where it is none."""
        return REPORT.get(self.cause, "")

    @property
    def evidence(self) -> str:
        """Step, place and words in one line."""
        at = "" if self.place is None else f" at ({self.place[0]:.1f}, {self.place[1]:.1f})"
        return f"step {self.step}{at}: {self.words}"


def diagnose(recording: Recording) -> Diagnosis | None:
    """Return why a recorded episode failed; None for an overall success.

    Raises:
        DamagedFileError: the recording's home or films cannot be read.
    """
    measures = recording.result.measures
    if measures.overall_success:
        return None
    found = decide(read_story(recording))
    return Diagnosis(found.cause, missed_phase(measures), found.step, found.place, found.words, True)


def diagnose_result(result: EpisodeResult) -> Diagnosis | None:
    """Return what can be said of a failure without a recording; None for an overall success."""
    measures = result.measures
    if measures.overall_success:
        return None
    return Diagnosis(_cause_of(result), missed_phase(measures), measures.num_steps, None, result.failure, False)


def missed_phase(measures: Measures) -> str:
    """Return the first of `PHASES` that was missed in an episode that is no overall success."""
    passed = (
        measures.find_object_phase_success,
        measures.pick_object_phase_success,
        measures.find_recep_phase_success,
        measures.place_success,
    )
    return PHASES[passed.index(False) if False in passed else len(passed)]


def _cause_of(result: EpisodeResult) -> Cause:
    """Return the cause where measures alone leave no other: crashes, and touches after which all else was done."""
    if result.crashed:
        return Cause.CRASHED
    return Cause.COLLIDED if result.measures.place_success else Cause.NOT_RECORDED
