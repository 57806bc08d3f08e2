"""What a camera of the simulator sees at one instant."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Geometry:
    """Depth and instance of every pixel.

    Attributes:
        depth: (H, W) float32, metres along the optical axis; 0 where nothing is within `uniteam.stretch.DEPTH_RANGE`.
        instances: (H, W) int16; index into the home's instances, -1 for the stage, the robot and the void.
    """

    depth: NDArray[np.float32]
    instances: NDArray[np.int16]


@dataclass(frozen=True)
class Frame:
    """Colour, depth and instance of every pixel.

    Attributes:
        rgb: (H, W, 3) uint8.
        depth: (H, W) float32, metres along the optical axis; 0 where nothing is within `uniteam.stretch.DEPTH_RANGE`.
        instances: (H, W) int16; index into the home's instances, -1 for the stage, the robot and the void.
    """

    rgb: NDArray[np.uint8]
    depth: NDArray[np.float32]
    instances: NDArray[np.int16]

    @property
    def geometry(self) -> Geometry:
        """All but the colours."""
        return Geometry(self.depth, self.instances)
