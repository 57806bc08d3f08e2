"""Play the episodes in which an agent failed once more, with the code as it is, and record those that fail again.

    python tools/play_failures.py results/val-truth-half-challenge:uniteam-plus --out runs/failed-again
    uniteam explain runs/failed-again

The episodes are played in a random order, that of a seed: the first failures are a random choice of all. Split,
perception, camera and grasp are those of the run. Give the command again to go on with one that was stopped.
"""

import random
from pathlib import Path
from typing import Annotated

import tyro

from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.analysis.contestants import Contestant, contestants_named
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.worker import Attempt


class Again(Evaluation):
    """The attempts of a run at some of its episodes alone, in their order."""

    def __init__(self, run: Run, directory: Path, episodes: list[str]) -> None:
        """Open the split; `episodes` are ids."""
        super().__init__(run, directory)
        self._again = episodes

    @property
    def attempts(self) -> list[Attempt]:
        """Every attempt, episode by episode."""
        index = {episode.id: number for number, episode in enumerate(self.split.episodes)}
        return [Attempt(agent, index[episode]) for episode in self._again for agent in self.run.agents]


def main(run: Annotated[str, tyro.conf.Positional], out: Path, seed: int = 0) -> None:
    """Play the failures of one agent again.

    Args:
        run: RUN:AGENT, of which the failures are taken.
        out: folder of the new run.
        seed: of the order.
    """
    (failed,) = contestants_named([run])
    episodes = shuffled_failures(failed, seed)
    told = failed.run.configuration
    agents = label_agents((failed.agent,), told["perception"], (), ())
    with Again(Run(told["split"], agents, told["perception"], told["camera"], told["grasp"]), out, episodes) as again:
        again.play(
            worker_count=1,
            on_result=lambda _, result: print(result.episode, result.measures.overall_success, flush=True),
            on_lost=lambda _, episode, lost: print(episode.id, lost.reason, flush=True),
            group_of=lambda episode: episode.id,
            record="failures",
        )
        again.write_summary()


def shuffled_failures(contestant: Contestant, seed: int) -> list[str]:
    """Return the ids of an agent's episodes that are no overall success, in the random order of a seed."""
    failed = sorted(name for name, result in contestant.results.items() if not result.measures.overall_success)
    random.Random(seed).shuffle(failed)
    return failed


if __name__ == "__main__":
    tyro.cli(main)
