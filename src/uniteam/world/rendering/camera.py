"""A pinhole camera in a scene: colour, depth and instance in one pass, on one thread, without any graphics library."""

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import PinholeCamera, invert_transform
from uniteam.world.rendering.kernels.frame import Frame, Geometry
from uniteam.world.rendering.kernels.measuring import measure
from uniteam.world.rendering.kernels.rasteriser import rasterise
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace
from uniteam.world.rendering.kernels.shading import shade
from uniteam.world.rendering.scene import Scene


def render(scene: Scene, camera: PinholeCamera, camera_to_world: NDArray[np.floating]) -> Frame:
    """Return what the camera sees; the same scene, camera and pose give the same bits.

    Args:
        scene: what there is.
        camera: intrinsics; pixel centres are at whole numbers.
        camera_to_world: (4, 4) rigid; x right, y down, z forward.

    Raises:
        InvalidInputError: the pose is not a (4, 4) transform.
    """
    buffers, workspace = _rasterised(scene, camera, camera_to_world)
    shape = (camera.height, camera.width)
    frame = Frame(np.empty((*shape, 3), np.uint8), np.empty(shape, np.float32), np.empty(shape, np.int16))
    shade(buffers, _rays(camera, camera_to_world), workspace, frame.rgb, frame.depth, frame.instances)
    return frame


def render_geometry(scene: Scene, camera: PinholeCamera, camera_to_world: NDArray[np.floating]) -> Geometry:
    """Return what the camera sees but for its colours, in less time; takes and raises what `render` does."""
    buffers, workspace = _rasterised(scene, camera, camera_to_world)
    shape = (camera.height, camera.width)
    geometry = Geometry(np.empty(shape, np.float32), np.empty(shape, np.int16))
    measure(buffers, workspace, geometry.depth, geometry.instances)
    return geometry


def _rasterised(
    scene: Scene, camera: PinholeCamera, camera_to_world: NDArray[np.floating]
) -> tuple[SceneBuffers, Workspace]:
    if camera_to_world.shape != (4, 4):
        raise InvalidInputError(f"a camera's pose must be a (4, 4) transform, got {camera_to_world.shape}")
    shape = (camera.height, camera.width)
    projection = _projection(camera, camera_to_world)
    buffers, workspace = scene.buffers_in_view(projection, *shape), scene.workspace(*shape)
    rasterise(buffers, projection, workspace)
    return buffers, workspace


def _intrinsics(camera: PinholeCamera) -> NDArray[np.float64]:
    return np.array([[camera.fx, 0.0, camera.cx], [0.0, camera.fy, camera.cy], [0.0, 0.0, 1.0]])


def _projection(camera: PinholeCamera, camera_to_world: NDArray[np.floating]) -> NDArray[np.float32]:
    """Return the (3, 4) transform from the world to pixel coordinates times depth."""
    return (_intrinsics(camera) @ invert_transform(camera_to_world)[:3]).astype(np.float32)


def _rays(camera: PinholeCamera, camera_to_world: NDArray[np.floating]) -> NDArray[np.float32]:
    """Return the camera's position, the ray of pixel (0, 0) and its change a column and a row, (4, 3) in the world."""
    rotation = np.asarray(camera_to_world)[:3, :3]
    first = rotation @ np.array([-camera.cx / camera.fx, -camera.cy / camera.fy, 1.0])
    rows = [np.asarray(camera_to_world)[:3, 3], first, rotation[:, 0] / camera.fx, rotation[:, 1] / camera.fy]
    return np.array(rows, dtype=np.float32)
