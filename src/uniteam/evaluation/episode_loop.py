"""Play one episode: the loop that joins an environment of the world with an agent of the mind."""

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from traceback import format_exception
from typing import Protocol

from uniteam.evaluation.memory import peak_memory
from uniteam.evaluation.results.failure_cause import explain_failure
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.interface import Action, Agent, Decision, Explaining, Explanation, Observation
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.episode import Episode
from uniteam.world.task.measures import Measures

CRASHED_STATE = "CRASHED"


class PlayableEnvironment(Protocol):
    """What the loop needs of an environment (`uniteam.world.task.environment.Environment` has it)."""

    episode: Episode

    @property
    def events(self) -> StepEvents:
        """What the last step came to."""

    @property
    def measures(self) -> Measures:
        """The measures so far."""

    @property
    def is_over(self) -> bool:
        """Whether the agent stopped or the steps are used up."""

    def reset(self) -> Observation:
        """Begin the episode."""

    def step(self, action: Action) -> Observation:
        """Take one step."""


@dataclass(frozen=True)
class Step:
    """One step of the loop: what the agent saw, what it decided upon that, and what came of it.

    Attributes:
        observation: what the agent saw.
        decision: what it decided.
        explanation: what is behind the decision; empty for an agent that does not explain.
        events: what the action came to.
        measures: once that was done.
        outcome: what the agent sees next; where it has stopped, nobody is shown it.
    """

    observation: Observation
    decision: Decision
    explanation: Explanation
    events: StepEvents
    measures: Measures
    outcome: Observation


Observer = Callable[[Step], None]
"""Called once a step, after the decision's action was taken."""


def play_episode(environment: PlayableEnvironment, agent: Agent, observer: Observer | None = None) -> EpisodeResult:
    """Play the environment's episode to its end; both are reset first, and exceptions of either pass through."""
    began = perf_counter()
    episode = environment.episode
    state, reason = "START", "no step was taken"
    agent.reset(episode.instruction, episode.seed)
    observation = environment.reset()
    while not environment.is_over:
        decision = agent.act(observation)
        explanation = _explanation(agent) if observer is not None else Explanation()
        seen, observation = observation, environment.step(decision.action)
        state, reason = decision.state, decision.reason
        if observer is not None:
            observer(Step(seen, decision, explanation, environment.events, environment.measures, observation))
    return EpisodeResult(
        episode=episode.id,
        home=episode.home,
        instruction=str(episode.instruction),
        unseen=episode.unseen,
        measures=environment.measures,
        state=state,
        failure=explain_failure(environment.measures, state, reason),
        seconds=perf_counter() - began,
        peak_memory=peak_memory(),
    )


def _explanation(agent: Agent) -> Explanation:
    return agent.explain() if isinstance(agent, Explaining) else Explanation()


def crashed_result(episode: Episode, failure: str, traceback: str, steps: int = 0) -> EpisodeResult:
    """Return the result of an episode that crashed: failed in every phase, with the traceback kept."""
    return EpisodeResult(
        episode=episode.id,
        home=episode.home,
        instruction=str(episode.instruction),
        unseen=episode.unseen,
        measures=Measures(num_steps=steps),
        state=CRASHED_STATE,
        failure=failure,
        seconds=0.0,
        peak_memory=peak_memory(),
        traceback=traceback,
    )


def result_of_exception(episode: Episode, error: BaseException, steps: int) -> EpisodeResult:
    """Return the result of an episode that ended in an exception after `steps` steps."""
    failure = f"crashed after {steps} steps with {type(error).__name__}: {error}"
    return crashed_result(episode, failure, "".join(format_exception(error)), steps)
