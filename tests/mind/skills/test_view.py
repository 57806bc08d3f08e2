"""What a skill sees, against pixel by pixel."""

import math
from dataclasses import replace

import numpy as np
from worlds.box_world import Box, observe

from uniteam.geometry import BasePose, invert_transform, transform_points
from uniteam.interface import Instruction
from uniteam.mind.perception.truth import visible_truth
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.view import View

BOXES = (Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table"), Box((1.2, -0.3, 0.7), (1.28, -0.22, 0.8), "cup"))


def test_the_cloud_holds_each_pixel_in_the_frame_of_the_base() -> None:
    base = BasePose(-0.6, 0.2, math.radians(-12.0))
    observation = observe(BOXES, base)
    view = View(observation, visible_truth(observation), Instruction("cup", "table", "bed"))
    to_base = invert_transform(base.matrix()) @ observation.camera_to_start
    expected = transform_points(to_base, observation.camera.unproject(observation.depth).astype(np.float64))
    assert view.cloud.dtype == np.float32
    assert np.abs(view.cloud - expected).max() < 1e-5
    cup = view.cloud[view.mask(ClassRole.OBJECT)]
    assert len(cup) > 20 and np.all((cup[:, 2] > 0.69) & (cup[:, 2] < 0.81))
    names = np.array([*(d.name for d in view.segmentation.detections), ""])[view.segmentation.instances]
    assert np.array_equal(view.mask(ClassRole.OBJECT), names == "cup")
    assert not replace(view, instruction=Instruction("pen", "bed", "bed")).mask(ClassRole.OBJECT).any()
