"""`uniteam fake-robot`: a simulated Stretch behind the ports of a real one."""

from collections.abc import Callable
from typing import Annotated, Literal

import tyro
from rich.console import Console

from uniteam.cli.keys import Keys, listening
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.worker import camera_named
from uniteam.visualization.captions import new_milestones
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import no_truth
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.fake.zmq_server import RealTime, ZmqServer
from uniteam.world.real.zmq_wire import OBSERVATION_PORT
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.measures import Measures
from uniteam.world.task.splits import load_split
from uniteam.world.task.visible_truth import truth_maker

LOOPBACK = ("127.0.0.1", "localhost")
RUN_STOP_KEY = "r"


def fake_robot(
    split: str = "minival",
    episode: int = 0,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest", "arm"] = "challenge",
    truth: bool = False,
    latency: Annotated[float, tyro.conf.arg(metavar="SECONDS")] = 0.0,
    drift: Annotated[float, tyro.conf.arg(metavar="SHARE")] = 0.0,
    depth_noise: Annotated[float, tyro.conf.arg(metavar="METRES")] = 0.0,
    holes: Annotated[float, tyro.conf.arg(metavar="SHARE")] = 0.0,
    agility: float = 1.0,
    image_hz: float = 15.0,
    seed: int = 0,
    host: str = "127.0.0.1",
    port: Annotated[int, tyro.conf.arg(metavar="N")] = OBSERVATION_PORT,
) -> None:
    """Put a simulated Stretch into an episode's home, behind the four ports of stretch_ai's bridge, until Ctrl-C.

    `uniteam robot 127.0.0.1` drives it in another terminal, and so can a client of stretch_ai. It says what the episode
    comes to. The key r presses its run-stop, and releases it again. Whoever reaches the ports can drive it, as with a
    real Stretch; serve it to your own machine only.

    Args:
        split: A built-in split (minival, val, test-standard, test-challenge, train) or a file of episodes.
        episode: Which episode of the split, counted from 0.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, whatever small object the camera
            points at (honest), or what its fingers close around (arm), which needs --with arm_grasp.
        truth: Whether its pictures carry the simulator's own segmentation, which no real robot has.
        latency: By how much every message is late, in either direction.
        drift: The odometry's error, as a share of what is driven and turned.
        depth_noise: The depth's standard deviation at 1 m; it grows with the square of the distance.
        holes: The share of the depth image in which nothing returns.
        agility: How many times as fast its motors are as a Stretch's.
        image_hz: Pictures a second.
        seed: Of drift, noise and holes.
        host: The address to listen at.
        port: The first of the four ports in a row.
    """
    if not 1 <= port <= 65_532:
        raise InvalidInputError(f"--port must be from 1 to 65532, for it is the first of four, got {port}")
    dials = Dials(latency, drift, depth_noise, holes, agility, image_hz, seed)
    console, episodes = make_console(), load_split(split)
    if not 0 <= episode < len(episodes.episodes):
        raise InvalidInputError(f"split '{split}' has episodes 0 to {len(episodes.episodes) - 1}, not {episode}")
    chosen = episodes.episodes[episode]
    with console.status("starting (the first time on a machine, compiling)"):
        home, head = episodes.homes[chosen.home], camera_named(camera)
        robot = FakeStretch(Simulator(home, head), chosen, dials, grasp_rule_named(grasp))
        bridge = FakeBridge(robot)
        server = ZmqServer(bridge, head, truth_maker(home) if truth else no_truth, (host, port))
    if host not in LOOPBACK:
        console.print(f"[yellow]Anybody who reaches {shown(host)} can drive this robot, and see what it sees.[/]")
    console.print(f"[bold]{shown(chosen.instruction)}[/] ({shown(episodes.name)}, episode {episode})")
    where = f"host {shown(host)}, ports {port} to {port + 3}; r is its run-stop, Ctrl-C ends it"
    console.print(f"A fake Stretch at {where}", soft_wrap=True)
    with listening() as keys:
        server.serve(_Watching(robot, keys, console), RealTime())


class _Watching:
    """Is asked before each moment whether the robot lives on; tells what is new, and hears the run-stop's key."""

    def __init__(self, robot: FakeStretch, keys: Keys, console: Console) -> None:
        self._robot, self._keys, self._console = robot, keys, console
        self._told = Measures()

    def __call__(self) -> bool:
        if self._keys.pressed().strip() == RUN_STOP_KEY:
            self._toggle()
        measures = self._robot.measures
        for words in new_milestones(self._told, measures):
            self._console.print(f"[dim]{self._robot.time:7.1f} s[/]  [green]Measure reached: {words}.[/]")
        if measures.robot_scene_colls > self._told.robot_scene_colls == 0:
            self._console.print(f"[dim]{self._robot.time:7.1f} s[/]  [red]The arm has touched something.[/]")
        self._told = measures
        return True

    def _toggle(self) -> None:
        is_pressed = not self._robot.is_run_stopped
        act: Callable[[], None] = self._robot.press_run_stop if is_pressed else self._robot.release_run_stop
        act()
        self._console.print(f"The run-stop is {'engaged' if is_pressed else 'released'}.")
