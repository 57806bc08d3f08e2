"""`uniteam serve`: a split's episodes for agents that connect over gRPC, and the challenge's table."""

import os
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console

from uniteam.adapters.remote.agent_server import Place
from uniteam.adapters.remote.served_episodes import RemoteSpec, ServedEpisodes, label_of
from uniteam.cli.evaluate import (
    LONGEST_EPISODE,
    LostEpisodesError,
    check_at_least_one,
    default_directory,
    lost_sentence,
    tell_results,
)
from uniteam.cli.progress import play_under_bar
from uniteam.cli.serve_perception import LOOPBACK
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation
from uniteam.mind.perception.detectors.remote import TOKEN


def serve(
    agent: Annotated[str, tyro.conf.Positional, tyro.conf.arg(metavar="NAME")],
    split: str = "minival",
    perception: Literal["own", "truth"] = "own",
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    seats: Annotated[int, tyro.conf.arg(metavar="N")] = 1,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest"] = "challenge",
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    record: Annotated[str | None, tyro.conf.arg(metavar="all|failures|N")] = None,
    answer_seconds: Annotated[float, tyro.conf.arg(metavar="S")] = 60.0,
    episode_seconds: Annotated[float, tyro.conf.arg(metavar="S")] = 3600.0,
    host: str = "127.0.0.1",
    port: Annotated[int, tyro.conf.arg(metavar="N")] = 8085,
) -> None:
    """Serve a split's episodes to an agent that runs elsewhere, and print the challenge's table when all are played.

    On the agent's side, uniteam_client.py is all that is needed beside numpy, msgpack and grpcio:
    uniteam_client.play(my_agent, "HOST:8085"). An agent that fails, is too slow or hangs up loses the episode; it may
    connect again and go on with the next. Stop with Ctrl-C and give the same command again to go on.

    Observations go over the network as they are, and whoever reaches the port can play. Serve to other machines through
    an SSH tunnel, or set the environment variable UNITEAM_TOKEN to the same secret on both of them.

    Args:
        agent: What to call the agent in the results; say its version too, such as homerobot-1.0.
        split: A built-in split (minival, val, test-standard, test-challenge, train), a file of episodes, or
            ovmm:FOLDER for a folder of the challenge's own.
        perception: What the agent sees with: detectors of its own, or the simulator's truth, which it is sent with each
            observation, and which the results then say.
        episodes: How many episodes, taken from the homes in turn; all by default.
        seats: How many agents may play at once; the episodes are dealt out among them.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, or whatever small object the camera
            points at (honest).
        out: Directory of the results; runs/SPLIT-PERCEPTION-CAMERA-GRASP by default.
        record: Which episodes to record, each into a file of its own below the directory of the results: all, failures
            (those without overall success), or how many of the first ones.
        answer_seconds: How long the agent may take for one answer; beyond it the episode fails and it is hung up on.
        episode_seconds: How long the agent may take for all answers of an episode.
        host: The address to listen at; 0.0.0.0 for all of this machine's.
        port: The port to listen at; 0 for any that is free.
    """
    check_at_least_one(episodes=episodes, seats=seats)
    _check_times(answer_seconds, episode_seconds)
    if not 0 <= port <= 65_535:
        raise InvalidInputError(f"--port must be from 0 to 65535, got {port}")
    if not agent.strip():
        raise InvalidInputError("the agent needs a name, such as: uniteam serve my-agent")
    console, place = make_console(), Place(host, port, seats, os.environ.get(TOKEN, ""))
    specs = {label_of(agent): RemoteSpec(agent, perception)}
    run = Run(split, specs, perception, camera, grasp, episodes, episode_seconds)
    served = ServedEpisodes(place, answer_seconds, lambda sentence: _notice(console, sentence))
    with console.status("reading the split and the models"):
        opened = Evaluation(run, out or default_directory(run))
    with opened as evaluation:
        order = evaluation.recordings(record)
        if evaluation.remaining:
            _tell_address(served.address, place, console)
        engine = served.engine(evaluation.split)
        lost = play_under_bar(
            evaluation, seats, console, record=record, beginning="waiting for an agent", engine=engine
        )
        evaluation.write_summary()
        tell_results(evaluation, {}, order, console)
    if lost:
        raise LostEpisodesError(lost_sentence(lost, evaluation))


def _check_times(answer_seconds: float, episode_seconds: float) -> None:
    for name, seconds in (("answer", answer_seconds), ("episode", episode_seconds)):
        if not 0.0 < seconds <= LONGEST_EPISODE:
            raise InvalidInputError(f"--{name}-seconds must be above 0 and at most a week, got {seconds}")


def _tell_address(address: str, place: Place, console: Console) -> None:
    if place.host not in LOOPBACK and not place.token:
        console.print(f"[yellow]Anybody who reaches {shown(place.host)} can play; set {TOKEN} to a secret.[/]")
    console.print(f'Serving: uniteam_client.play(agent, "{shown(address)}")', soft_wrap=True)


def _notice(console: Console, sentence: str) -> None:
    console.print(f"[dim]{shown(sentence)}[/]", soft_wrap=True)
