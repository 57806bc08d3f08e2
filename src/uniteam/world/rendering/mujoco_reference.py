"""MuJoCo's renderer as a reference for the camera: how far the two agree, and how much faster ours is.

MuJoCo needs OpenGL and reads `MUJOCO_GL` when it is imported, so it renders in a process of its own, with EGL or else
with OSMesa. Where there is neither, `OpenGLMissingError` says so.
"""

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing
from dataclasses import dataclass
from multiprocessing import get_context
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import UniteamError
from uniteam.geometry import PinholeCamera
from uniteam.stretch import DEPTH_RANGE
from uniteam.world.homes.home import Home
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.rendering.scene import Scene

BACKENDS = ("egl", "osmesa")
_REPEATS = 5
_DEFAULT_SAMPLES = 4


class OpenGLMissingError(UniteamError):
    """There is no OpenGL that works without a display."""


@dataclass(frozen=True)
class Comparison:
    """What came of rendering the same views with both.

    Attributes:
        view_count: how many.
        depth_median_error: over all pixels that both see within range (m).
        instance_agreement: share of pixels with the same instance.
        milliseconds: of our camera, a view (RGB, depth and instances); the best of some repeats, mean over the views.
        mujoco_milliseconds: of `mujoco.Renderer` with its defaults, in three passes, likewise.
    """

    view_count: int
    depth_median_error: float
    instance_agreement: float
    milliseconds: float
    mujoco_milliseconds: float

    @property
    def camera_speedup(self) -> float:
        """How many times faster our camera is."""
        return self.mujoco_milliseconds / self.milliseconds


def compare_with_mujoco(home: Home, camera: PinholeCamera, poses: Sequence[NDArray[np.float64]]) -> Comparison:
    """Render a home from the poses (4, 4) of a camera with square pixels and a centred principal point, twice.

    Raises:
        OpenGLMissingError: MuJoCo's renderer does not work here.
    """
    failures = []
    for backend in (os.environ["MUJOCO_GL"],) if os.environ.get("MUJOCO_GL") else BACKENDS:
        with ProcessPoolExecutor(1, get_context("spawn"), _choose_backend, (backend,)) as executor:
            try:
                return executor.submit(_compare, home, camera, tuple(poses)).result()
            except (OpenGLMissingError, BrokenProcessPool) as error:
                failures.append(f"{backend}: {error or 'crashed'}")
    raise OpenGLMissingError(
        f"MuJoCo's renderer found no OpenGL ({'; '.join(failures)}); install libegl1 and libgl1-mesa-dri, or libosmesa6"
    )


def _choose_backend(backend: str) -> None:
    os.environ["MUJOCO_GL"] = backend


def _compare(home: Home, camera: PinholeCamera, poses: Sequence[NDArray[np.float64]]) -> Comparison:
    scene = Scene(home)
    ours = [render(scene, camera, pose) for pose in poses]
    with closing(_Renderer(scene, camera, samples=0)) as exact:
        theirs = [exact.render(pose) for pose in poses]
    with closing(_Renderer(scene, camera, samples=_DEFAULT_SAMPLES)) as usual:
        usual.keep_defaults()
        times = [(_best(lambda: render(scene, camera, p)), _best(lambda: usual.render(p))) for p in poses]  # noqa: B023
    errors = np.concatenate([_depth_errors(a, b) for a, b in zip(ours, theirs, strict=True)])
    equal = [np.mean(a.instances == b.instances) for a, b in zip(ours, theirs, strict=True)]
    own, other = np.mean(times, axis=0) * 1000.0
    return Comparison(len(poses), float(np.median(errors)), float(np.mean(equal)), float(own), float(other))


def _best(work: Any) -> float:
    """Return the shortest of some durations (s)."""

    def durations() -> Iterator[float]:
        for _ in range(_REPEATS):
            began = perf_counter()
            work()
            yield perf_counter() - began

    return min(durations())


def _depth_errors(ours: Frame, theirs: Frame) -> NDArray[np.float32]:
    both = (ours.depth > 0.0) & (theirs.depth > 0.0)
    return np.abs(ours.depth - theirs.depth)[both]


class _Renderer:
    """`mujoco.Renderer` in three passes, as a camera of ours."""

    def __init__(self, scene: Scene, camera: PinholeCamera, samples: int) -> None:
        # MuJoCo reads its OpenGL backend when it is imported: not before this process has chosen one.
        import mujoco

        from uniteam.world.rendering.mujoco_reference_model import mujoco_model

        self._mujoco = mujoco
        self._model, self._labels = mujoco_model(scene.buffers(), camera, samples)
        self._data = mujoco.MjData(self._model)
        try:
            self._renderer = mujoco.Renderer(self._model, camera.height, camera.width)
        except Exception as error:
            raise OpenGLMissingError(str(error)) from error
        self._renderer.scene.flags[mujoco.mjtRndFlag.mjRND_CULL_FACE] = False

    def keep_defaults(self) -> None:
        """Draw as MuJoCo does without being told."""
        self._renderer.scene.flags[self._mujoco.mjtRndFlag.mjRND_CULL_FACE] = True

    def render(self, camera_to_world: NDArray[np.float64]) -> Frame:
        """Return what the camera sees."""
        from uniteam.world.rendering.mujoco_reference_model import CAMERA_NAME, set_camera_pose

        set_camera_pose(self._model, camera_to_world)
        self._mujoco.mj_forward(self._model, self._data)
        self._renderer.update_scene(self._data, camera=CAMERA_NAME)
        rgb = self._renderer.render()
        self._renderer.enable_depth_rendering()
        depth = self._renderer.render()
        self._renderer.disable_depth_rendering()
        self._renderer.enable_segmentation_rendering()
        geoms = self._renderer.render()[..., 0]
        self._renderer.disable_segmentation_rendering()
        instances = np.where(geoms >= 0, self._labels[geoms], np.int16(-1)).astype(np.int16)
        return Frame(rgb, np.where(depth <= DEPTH_RANGE, depth, 0.0).astype(np.float32), instances)

    def close(self) -> None:
        """Free what OpenGL holds."""
        self._renderer.close()
