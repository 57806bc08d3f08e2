"""`uniteam doctor`: whether this installation is whole."""

import os
import platform
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from tempfile import TemporaryDirectory

from rich.progress import Progress, SpinnerColumn, TextColumn
from rich.table import Table

import uniteam
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import UniteamError
from uniteam.kernel_cache import VARIABLE, cache_folder

OLDEST_PYTHON = (3, 11)
PACKAGES = ("numpy", "numba", "msgspec", "mujoco", "opencv-python-headless", "av", "tyro", "rich")
SMALLEST_MEMORY = 3.0
"""GB: two workers and what else there is."""


@dataclass(frozen=True)
class Finding:
    """What a check found, and what to do where it is not well; `advice` is empty where it is."""

    text: str
    advice: str = ""


def doctor() -> None:
    """Check Python, the packages, the machine, the models, the splits, the camera and films, and say what is missing.

    The first time on a machine, the camera's kernels are compiled, which takes a minute.
    """
    console = make_console()
    table = Table(show_header=False, box=None, padding=(0, 2, 0, 0))
    advice = []
    with Progress(SpinnerColumn(), TextColumn("{task.description}"), console=console, transient=True) as progress:
        bar = progress.add_task("")
        for name, check in CHECKS.items():
            progress.update(bar, description=f"checking: {name}")
            finding = _find(check)
            mark = "[red]fault[/]" if finding.advice else "[green]ok[/]"
            table.add_row(mark, f"[bold]{name}[/]", shown(finding.text))
            advice += [f"{name}: {finding.advice}"] if finding.advice else []
    console.print(table)
    for sentence in advice:
        console.print(f"\n[red]{shown(sentence)}[/]", soft_wrap=True)
    if advice:
        raise UniteamError(f"{len(advice)} of {len(CHECKS)} checks found a fault; what to do is said above")
    console.print("\nEverything is in place. Begin with [bold]uniteam evaluate[/].")


def _find(check: Callable[[], Finding]) -> Finding:
    try:
        return check()
    except UniteamError as error:
        return Finding("broken", str(error))
    except Exception as error:  # a doctor reports what it finds
        return Finding("broken", f"{type(error).__name__}: {error}; reinstall uniteam")


def _python() -> Finding:
    text = f"{platform.python_version()} on {platform.system()} {platform.machine()}"
    oldest = ".".join(map(str, OLDEST_PYTHON))
    return Finding(text, "" if sys.version_info >= OLDEST_PYTHON else f"install Python {oldest} or newer")


def _packages() -> Finding:
    found, missing = [f"uniteam {uniteam.__version__}"], []
    for package in PACKAGES:
        try:
            found.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            missing.append(package)
    return Finding(", ".join(found), f"pip install {' '.join(missing)}" if missing else "")


def _machine() -> Finding:
    from uniteam.evaluation.backends.capacity import allowed_cores, free_memory

    memory = free_memory() / 1e9
    advice = "" if memory >= SMALLEST_MEMORY else "with little memory free, evaluate with --workers 1"
    return Finding(
        f"{allowed_cores()} of {os.cpu_count()} cores may be used, {memory:.1f} GB of memory are free", advice
    )


def _kernels() -> Finding:
    """Say where what numba compiles is kept; where nothing else can be written, that is a folder that does not last."""
    folder, lasts = cache_folder()
    cure = "" if lasts else f"; set {VARIABLE} to a folder that lasts, or everything is compiled anew after a restart"
    return Finding(f"compiled kernels are kept in {folder}{cure}")


def _pack() -> Finding:
    from uniteam.world.assets.catalogue import load_catalogue
    from uniteam.world.assets.verify import verify_pack

    problems = verify_pack()
    models = load_catalogue().models.values()
    furniture = sum(model.role == "receptacle" for model in models)
    objects = sum(model.role == "object" for model in models)
    advice = f"{'; '.join(problems[:5])} ({len(problems)} files in all); reinstall uniteam" if problems else ""
    return Finding(f"{len(models)} models: {furniture} receptacles, {objects} graspable objects", advice)


def _splits() -> Finding:
    from uniteam.world.task.splits import SPLIT_NAMES, load_split

    counts = [f"{name} {len(load_split(name).episodes)}" for name in SPLIT_NAMES]
    return Finding("episodes: " + ", ".join(counts))


def _camera() -> Finding:
    """Render the first view of the first episode; the checksum tells whether two machines see the same."""
    from uniteam.world.task.environment import Environment
    from uniteam.world.task.splits import load_split

    split = load_split("minival")
    episode = split.episodes[0]
    seen = Environment(split.homes[episode.home], episode).reset()
    digest = sha256(seen.rgb.tobytes() + seen.depth.tobytes()).hexdigest()[:16]
    return Finding(f"one frame rendered, checksum {digest}")


def _films() -> Finding:
    """Write a film and read it back."""
    import av
    import numpy as np

    from uniteam.visualization.video import VideoWriter

    with TemporaryDirectory() as folder:
        path = Path(folder) / "film.mp4"
        video = VideoWriter(path, 64, 64)
        video.add(np.zeros((64, 64, 3), np.uint8), repeat=3)
        video.close()
        with av.open(str(path)) as film:
            codec = film.streams.video[0].codec_context.name
    return Finding(f"written as MP4 ({codec}), which browsers play")


def _opengl() -> Finding:
    """Nothing but the comparison with MuJoCo's renderer needs OpenGL, so its absence is no fault."""
    from uniteam.world.rendering.mujoco_reference import BACKENDS

    for backend in BACKENDS:
        if _renders(backend):
            return Finding(f"present ({backend}): 'uniteam bench' compares the camera with MuJoCo's")
    return Finding("absent, and not needed: where it is, 'uniteam bench' compares the camera with MuJoCo's")


def _renders(backend: str) -> bool:
    """Return whether MuJoCo renders with an OpenGL backend, which it reads when it is imported: in a new process."""
    code = "import mujoco; mujoco.Renderer(mujoco.MjModel.from_xml_string('<mujoco/>'), 8, 8).close()"
    environment = {**os.environ, "MUJOCO_GL": backend}
    return subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True).returncode == 0


CHECKS: dict[str, Callable[[], Finding]] = {
    "Python": _python,
    "packages": _packages,
    "machine": _machine,
    "kernels": _kernels,
    "models": _pack,
    "splits": _splits,
    "camera": _camera,
    "films": _films,
    "OpenGL": _opengl,
}
