"""How often the arm grasps what the snap takes: both from where the oracle stood to take it, with perfect perception.

    python tools/measure_grasps.py --split val --episodes 20

Each episode of the split, taken from the homes in turn, begins at its certified stand; the picking of `uniteam-plus` is
done once with the snap, by the challenge's rule, and once with the improvement `arm_grasp`, by the rule `arm`.
"""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace

from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.mind.agents.registry import agent_config
from uniteam.mind.manipulation.pick.pick import PickConfig, pick
from uniteam.mind.skills.view import View
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.homes.home import Home
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.splits import load_split

AGENT = "uniteam-plus"
KINDS = {"challenge": (), "arm": ("arm_grasp",)}
"""The improvements that the agent has besides its own, by the rule of the grasp."""


@dataclass(frozen=True)
class Outcome:
    """What a pick came to.

    Attributes:
        held: whether an object that counts is in the gripper.
        collisions: steps in which the arm, the gripper or what it held touched anything but small objects, or what it
            held touched anything.
        steps: how many it took.
    """

    held: bool
    collisions: int
    steps: int


def main() -> None:
    """Read the arguments, do every pick in both ways, and print how many objects were taken."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--split", default="val")
    parser.add_argument("--episodes", type=int, default=20)
    arguments = parser.parse_args()
    split = load_split(arguments.split)
    outcomes: dict[str, list[Outcome]] = {kind: [] for kind in KINDS}
    for index in choose_episodes(split.episodes, arguments.episodes):
        episode = split.episodes[index]
        for kind in KINDS:
            outcomes[kind].append(picked(split.homes[episode.home], episode, kind))
        last = ", ".join(f"{kind} {'took' if outcomes[kind][-1].held else 'missed'} it" for kind in KINDS)
        print(f"{episode.instruction}: {last}", flush=True)
    for kind, own in outcomes.items():
        print(f"{kind}: {words(own)}")


def picked(home: Home, episode: Episode, kind: str) -> Outcome:
    """Return what the pick of an episode comes to from its certified stand."""
    config, certificate = agent_config(AGENT, KINDS[kind]), episode.certificate
    assert config is not None and certificate is not None
    begun = replace(episode, start=certificate.grasp)
    environment = Environment(home, begun, HEAD_CAMERA_HALF, give_truth=True, grasp=grasp_rule_named(kind))
    carry_out(environment, config.pick)
    measures = environment.measures
    held = environment.simulator.held in {candidate.name for candidate in episode.objects}
    return Outcome(held, measures.robot_scene_colls + measures.obj_scene_colls, measures.num_steps)


def carry_out(environment: Environment, config: PickConfig) -> None:
    """Have the robot do the pick in an environment; what is seen is what is there."""
    observation = environment.reset()
    skill = None
    while True:
        assert observation.truth is not None
        view = View(observation, observation.truth, environment.episode.instruction)
        try:
            if skill is None:
                skill = pick(view, config)
                move = next(skill)
            else:
                move = skill.send(view)
        except StopIteration:
            return
        observation = environment.step(move.action)


def words(outcomes: Sequence[Outcome]) -> str:
    """Return in words how many of some picks took the object, and what they touched."""
    taken, count = sum(each.held for each in outcomes), len(outcomes)
    interval = estimate_proportion(taken, count)
    touched = sum(each.collisions > 0 for each in outcomes)
    steps = sum(each.steps for each in outcomes) / count
    return (
        f"{taken} of {count} taken ({100 * interval.low:.0f}-{100 * interval.high:.0f} %), "
        f"{touched} with a collision of the arm or what it holds, {steps:.1f} steps on average"
    )


if __name__ == "__main__":
    main()
