"""`uniteam bench`: where a step's time goes."""

import json
import math
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import tyro
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

import uniteam
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.bench import BenchReport, compare_cameras, measure
from uniteam.files import try_output, write_whole
from uniteam.world.rendering.mujoco_reference import OpenGLMissingError
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split

if TYPE_CHECKING:
    from uniteam.adapters.gymnasium.throughput import Throughput

SPLIT = "minival"
ENVIRONMENT_STEPS = 1000
"""With each environment: some seconds."""


def bench(
    agent: str = "uniteam",
    perception: str = "truth",
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE.json")] = None,
    episodes: int = 10,
    env: bool = False,
) -> None:
    """Measure the steps a second of one process, and the milliseconds a step spends where.

    Plays episodes of minival with the half-size camera, after everything is compiled. Close other programs first: the
    figures are of this machine as it is.

    Args:
        agent: Which agent: a name, or your own as MODULE:ATTRIBUTE.
        perception: What the agent sees with, as `uniteam run` takes it.
        out: A JSON file to write the figures to.
        episodes: How many episodes to play.
        env: Measure the Gymnasium environments instead, with random actions and the small camera.
    """
    console = make_console()
    if out is not None:
        try_output(out)
    report = _bench_environments(console) if env else _bench_agent(console, AgentSpec(agent, perception), episodes)
    if out is not None:
        figures = {**report, "version": uniteam.__version__}
        write_whole(out, (json.dumps(figures, indent=2) + "\n").encode())
        console.print(f"Written to {shown(out)}.", soft_wrap=True)


def _bench_agent(console: Console, spec: AgentSpec, episodes: int) -> dict[str, Any]:
    """Play the episodes, print where the time goes, and return it as JSON data."""
    split = load_split(SPLIT)
    if not 1 <= episodes <= len(split.episodes):
        raise InvalidInputError(f"{SPLIT} has {len(split.episodes)} episodes; --episodes {episodes} is out of range")
    with Progress(console=console, transient=True) as progress:
        bar = progress.add_task("playing", total=episodes)
        report = measure(split, spec, episodes, lambda: progress.advance(bar))
    console.print(_table(report, spec))
    return {"agent": spec.name, "perception": spec.perception, **asdict(report), **_compare(split, console)}


def _bench_environments(console: Console) -> dict[str, Any]:
    """Step each environment, print how fast that went, and return it as JSON data."""
    from uniteam.adapters.gymnasium import ENVIRONMENTS
    from uniteam.adapters.gymnasium.throughput import measure_throughput

    found = []
    with Progress(console=console, transient=True) as progress:
        bar = progress.add_task("stepping", total=len(ENVIRONMENTS))
        for name in ENVIRONMENTS:
            found.append(measure_throughput(name, ENVIRONMENT_STEPS))
            progress.advance(bar)
    console.print(_table_of_environments(found))
    return {"environments": [asdict(throughput) for throughput in found]}


def _table_of_environments(found: "list[Throughput]") -> Table:
    caption = (
        f"{ENVIRONMENT_STEPS} random steps each in the first home of {SPLIT} that seed 0 draws, 160 x 120 pixels, one "
        f"process, uniteam {uniteam.__version__}; times are the processor's but where it says otherwise"
    )
    table = Table(caption=caption, caption_justify="left")
    for head in ("environment", "steps/s", "by the wall clock", "reset", "first reset"):
        table.add_column(head, justify="left" if head == "environment" else "right", no_wrap=head == "environment")
    for t in found:
        reset = "" if math.isnan(t.reset_milliseconds) else f"{t.reset_milliseconds:.0f} ms"
        speeds = (f"[bold]{t.steps_per_cpu_second:.0f}[/]", f"{t.steps_per_second:.0f}")
        table.add_row(t.name, *speeds, reset, f"{t.opening_seconds:.1f} s")
    return table


def _compare(split: Split, console: Console) -> dict[str, Any]:
    """Print how much faster the camera is than MuJoCo's renderer, or why that is not known; return it as JSON data."""
    try:
        with console.status("comparing the camera with MuJoCo's renderer"):
            comparison = compare_cameras(split)
    except OpenGLMissingError as error:
        console.print(f"The camera was not compared with MuJoCo's renderer: {shown(error)}.")
        return {"camera_speedup": None, "camera_comparison_missing": str(error)}
    console.print(
        f"Camera against mujoco.Renderer, {comparison.view_count} views, RGB, depth and instances: "
        f"{comparison.milliseconds:.1f} ms against {comparison.mujoco_milliseconds:.1f} ms, "
        f"[bold]{comparison.camera_speedup:.1f} times faster[/]; depth agrees to "
        f"{comparison.depth_median_error * 1000:.3f} mm (median), instances to "
        f"{comparison.instance_agreement * 100:.2f} %.",
    )
    return {"camera_speedup": comparison.camera_speedup, "camera_comparison": asdict(comparison)}


def _table(report: BenchReport, spec: AgentSpec) -> Table:
    caption = (
        f"{report.episode_count} episodes of {SPLIT}, {report.step_count} steps of {spec.name}, perception "
        f"{spec.perception}, uniteam {uniteam.__version__}"
    )
    table = Table(caption=caption, caption_justify="left", show_header=False)
    table.add_column(justify="left")
    table.add_column(justify="right")
    table.add_row("[bold]steps a second[/] (median over episodes)", f"[bold]{report.steps_per_second:.1f}[/]")
    for section, milliseconds in report.milliseconds.items():
        table.add_row(f"{section}, a step", f"{milliseconds:.2f} ms")
    table.add_row("opening a home (median)", f"{report.opening_seconds:.2f} s")
    table.add_row("warming up", f"{report.warm_up_seconds:.1f} s")
    table.add_row("peak memory", f"{report.peak_memory_mb:.0f} MB")
    return table
