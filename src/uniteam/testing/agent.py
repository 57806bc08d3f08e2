"""Check an agent."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from uniteam.evaluation.agent_spec import AGENTS
from uniteam.interface import Agent, Decision, Explaining, Explanation, Observation
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.registry import AgentContext, AgentFactory, build_agent
from uniteam.mind.perception.registry import needs_truth
from uniteam.testing.answers import decision_problem, explanation_problem
from uniteam.testing.depth_bands import DepthBands
from uniteam.testing.episodes import new_environment, shared_environment
from uniteam.testing.failure import called, name_of
from uniteam.testing.side_by_side import Subject, Trial, check_alike
from uniteam.testing.truth import READS_THE_TRUTH, as_it_is, without_and_with_another, without_truth

_STAND_IN = f"{DepthBands.__module__}:{DepthBands.__name__}"


def check_agent(agent: str | AgentConfig | AgentFactory, perception: str = "truth", steps: int = 30) -> None:
    """Check that an agent keeps what `uniteam.Agent` promises, in the first steps of two episodes.

    - Two copies made alike decide the same, to the bit, while both are alive.
    - Nothing of one episode is left in the next: a copy that has played another episode decides as a new one does.
    - Each decision is a `Decision` with a state, a reason and an action that a body does, within `ACTION_LIMITS`.
    - `explain`, where there is one, returns an `Explanation` of the frame's size, and to ask changes no decision.
    - No array of an observation is written into, and no decision changes after it was returned.
    - Nobody but the perception reads the truth; unless the agent's factory has `needs_truth = True`.

    In a test of your own:

        def test_my_agent() -> None:
            check_agent("my_package.my_agent:MyAgent")

        def test_my_improvement_alone() -> None:
            check_agent(improved(BASELINE, ["my_package.my_agent:my_improvement"]))

    Args:
        agent: a name, a reference "module:attribute", a configuration, or what makes an agent (often its class).
        perception: name or reference of the perception that it sees with, if it looks.
        steps: how many of each episode are played; the more, the more of what the agent can do is reached.

    Raises:
        CheckFailedError: what differed, and at which step.
        UnknownNameError: there is no agent or no perception of this name.
    """
    entry = AGENTS.get(agent) if isinstance(agent, str) else agent
    is_told_the_truth = bool(getattr(entry, "needs_truth", False))
    show = as_it_is if needs_truth(perception) else without_truth
    environment = new_environment() if is_told_the_truth else shared_environment()
    name = f"agent '{name_of(agent)}'"

    def made(eyes: str) -> Agent:
        context = AgentContext(eyes, environment if is_told_the_truth else None)
        return called(f"{name}: making it", lambda: build_agent(name_of(agent), entry, context))

    def subject(eyes: str) -> Subject[Decision]:
        new = made(eyes)
        return Subject(name, "act", new.reset, new.act, decision_problem)

    seen = Trial(environment, partial(subject, perception), show, lambda decision, _: decision.action, steps).check()
    if is_told_the_truth:
        return
    talking = made(perception)
    if isinstance(talking, Explaining):
        frames = ((show(observation), show(observation)) for observation in seen)
        asked = _asked(Subject(name, "explain", talking.reset, talking.act, decision_problem), talking.explain)
        check_alike(asked, subject(perception), frames, "asking it to explain() changes what it decides")
    eyes = _STAND_IN if needs_truth(perception) else perception
    check_alike(subject(eyes), subject(eyes), without_and_with_another(seen), READS_THE_TRUTH)


def _asked(subject: Subject[Decision], explain: Callable[[], Explanation]) -> Subject[Decision]:
    """Return an agent that is asked after each decision what is behind it."""
    explanations: list[Explanation] = []

    def answer(observation: Observation) -> Decision:
        decision = subject.answer(observation)
        explanations[:] = [explain()]
        return decision

    def problem(decision: Decision, observation: Observation) -> str:
        return explanation_problem(explanations[0], observation) or subject.problem(decision, observation)

    return replace(subject, answer=answer, problem=problem)
