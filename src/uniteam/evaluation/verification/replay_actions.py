"""Play recorded actions in the simulator, and compare what they come to with what was claimed."""

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.recording.actions_kept import kept_actions
from uniteam.evaluation.results.differences import differences
from uniteam.evaluation.results.result import measures_to_data
from uniteam.evaluation.verification.submission import Claim, Submission
from uniteam.evaluation.worker import camera_named
from uniteam.interface import Action
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode
from uniteam.world.task.grasp_rules import grasp_rule_named


def check_claims(submission: Submission, claims: Sequence[Claim]) -> Iterator[tuple[Claim, list[str]]]:
    """Yield each claim with a phrase for each measure that its actions do not come to; an empty list where all agree.

    A recording that cannot be read, and actions that are no whole episode, are such a phrase too.

    Args:
        submission: that the claims are of.
        claims: to be checked; a home is built anew where it is another one than that of the claim before.
    """
    environment_of = _opener(submission)
    for claim in claims:
        yield claim, _differences(submission, claim, environment_of)


def _opener(submission: Submission) -> Callable[[Episode], Environment]:
    """Return what resets an environment for an episode; the home of the last one is kept."""
    told, split = submission.run.configuration, submission.split
    camera, grasp = camera_named(told["camera"]), grasp_rule_named(told["grasp"])

    @lru_cache(maxsize=1)
    def build(home: str) -> Environment:
        first = next(episode for episode in split.episodes if episode.home == home)
        return Environment(split.homes[home], first, camera, grasp=grasp)

    def open_at(episode: Episode) -> Environment:
        environment = build(episode.home)
        environment.reset(episode)
        return environment

    return open_at


def _differences(submission: Submission, claim: Claim, environment_of: Callable[[Episode], Environment]) -> list[str]:
    try:
        actions = kept_actions(submission.run.directory, claim.agent, claim.episode.id)
        environment = environment_of(claim.episode)
        _play(environment, actions)
    except (DamagedFileError, InvalidInputError) as error:
        return [str(error)]
    found = differences(measures_to_data(claim.result.measures), measures_to_data(environment.measures))
    return found or ([] if environment.is_over else [f"the {len(actions)} actions end before the episode does"])


def _play(environment: Environment, actions: Sequence[Action]) -> None:
    for number, action in enumerate(actions):
        if environment.is_over:
            raise InvalidInputError(f"the episode is over after {number} of its {len(actions)} actions")
        environment.step(action)
