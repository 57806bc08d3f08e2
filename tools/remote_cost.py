"""What a step costs more when the agent is elsewhere: the same turns, in process and through `uniteam serve`.

    python tools/remote_cost.py --steps 300

The clock is that of the processor, so that other processes on the machine disturb it less. The agent's side runs in a
thread of this process, so that the clock counts the work of both sides: packing, sending, receiving and unpacking.
What it does not count is a network; a frame has 7 bytes a pixel.
"""

import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from threading import Thread
from time import process_time
from typing import Any

import cv2
import tyro

from uniteam.adapters.remote.agent_server import Place
from uniteam.adapters.remote.served_episodes import RemoteSpec, ServedEpisodes
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.episode_loop import play_episode
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.worker import camera_named
from uniteam.interface import Decision, DiscreteAction
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split

CLIENT = Path(__file__).parents[1] / "packages" / "uniteam_client"
WARM = 10
"""Steps that are not counted: the first ones open files and fill caches."""


class Turner:
    """Turns on the spot, then stops; looks at the processor's clock at each step."""

    def __init__(self, steps: int, turn: Any, stop: Any) -> None:
        self._clock: list[float] = []
        self._steps, self._turn, self._stop = steps, turn, stop

    @property
    def milliseconds(self) -> float:
        """What a step took."""
        return 1000.0 * (self._clock[-1] - self._clock[WARM]) / (len(self._clock) - 1 - WARM)

    def reset(self, instruction: object, seed: int) -> None:
        """There is nothing to forget."""

    def act(self, observation: Any) -> Any:
        """Turn, or stop."""
        self._clock.append(process_time())
        return self._turn if observation.step < WARM + self._steps else self._stop


def main(steps: int = 300) -> None:
    """Print milliseconds of the processor a step.

    Args:
        steps: how many turns are counted.
    """
    cv2.setNumThreads(1)
    minival = load_split("minival")
    episode = replace(minival.episodes[8], id="measured")
    split = Split("measured", (episode,), {episode.home: minival.homes[episode.home]})
    for camera in ("half", "full"):
        for perception in ("own", "truth"):
            here, there = play_here(split, camera, perception, steps), serve(split, camera, perception, steps)
            print(
                f"camera {camera}, perception {perception}: {here:.2f} ms a step in process, "
                f"{there:.2f} ms through the server, {there - here:+.2f} ms",
                flush=True,
            )


def play_here(split: Split, camera: str, perception: str, steps: int) -> float:
    """Return the milliseconds a step of an agent that the environment calls."""
    (episode,) = split.episodes
    environment = Environment(split.homes[episode.home], episode, camera_named(camera), perception == "truth")
    turn, stop = (Decision(action, "", "") for action in (DiscreteAction.TURN_LEFT, DiscreteAction.STOP))
    agent = Turner(steps, turn, stop)
    play_episode(environment, agent)
    return agent.milliseconds


def serve(split: Split, camera: str, perception: str, steps: int) -> float:
    """Return the milliseconds a step of an agent at the other end of a gRPC stream on loopback."""
    sys.path.insert(0, str(CLIENT))
    import uniteam_client

    agent = Turner(steps, "turn_left", "stop")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "measured.jsonl.gz"
        write_split(split, path)
        run = Run(str(path), {"turner": RemoteSpec("turner", perception)}, perception, camera)
        served = ServedEpisodes(Place(), 60.0, lambda sentence: None)
        with Evaluation(run, Path(folder) / "out") as evaluation:
            client = Thread(target=uniteam_client.play, args=(agent, served.address), daemon=True)
            client.start()
            engine = served.engine(evaluation.split)
            evaluation.play(1, lambda *result: None, lambda *lost: None, engine=engine)
            client.join()
    return agent.milliseconds


if __name__ == "__main__":
    tyro.cli(main)
