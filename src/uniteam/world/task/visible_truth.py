"""The simulator's own segmentation as an agent may have it: what the frame shows, and nothing else."""

from collections.abc import Callable

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.interface import Detection, Segmentation
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.frame import Frame


def truth_maker(home: Home) -> Callable[[Frame], Segmentation]:
    """Return the function from a frame to its segmentation: every instance in it by its category's name, score 1.

    Indices are of that frame: the instances in the order in which its pixels show them, row by row. So they say
    nothing of what is not seen, nor whether what is seen has been seen before.
    """
    detections = tuple(Detection(((instance.category, 1.0),)) for instance in home.instances)

    def truth_of(frame: Frame) -> Segmentation:
        instances, seen = number_by_appearance(frame.instances, len(detections))
        instances.flags.writeable = False
        return Segmentation(instances, tuple(detections[k] for k in seen))

    return truth_of


@njit(cache=True, nogil=True)
def number_by_appearance(
    instances: NDArray[np.int16], instance_count: int
) -> tuple[NDArray[np.int16], NDArray[np.int16]]:
    """Return the (H, W) image with its indices replaced by those of the order of appearance, and that order (D,).

    Args:
        instances: (H, W) below `instance_count`; -1 where there is none, which stays.
        instance_count: how many there could be.
    """
    index_of = np.full(instance_count, -1, np.int16)
    order = np.empty(instance_count, np.int16)
    numbered = np.full(instances.shape, -1, np.int16)
    count = 0
    for row in range(instances.shape[0]):
        for column in range(instances.shape[1]):
            instance = instances[row, column]
            if instance >= 0:
                if index_of[instance] < 0:
                    index_of[instance] = count
                    order[count] = instance
                    count += 1
                numbered[row, column] = index_of[instance]
    return numbered, order[:count].copy()
