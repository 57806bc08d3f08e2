"""The networks that the package ships, on ONNX Runtime: what segments and what names."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import DamagedFileError

WEIGHTS = Path(__file__).with_name("weights")
"""`segmenter.onnx`, `namer.onnx` and `card.json`, which says what they were trained on and what they can name."""


@dataclass(frozen=True)
class Card:
    """What the networks are.

    Attributes:
        names: that the namer was trained with, by the role that they have: "object", "receptacle", "decor".
        receptacles: names of the segmenter's last channels.
        scale: by which the namer's cosines are multiplied.
        calibration: by role, (scores, chances): what a raw score is worth, between the points a straight line.
    """

    names: dict[str, list[str]]
    receptacles: list[str]
    scale: float
    calibration: dict[str, tuple[list[float], list[float]]]


class Network:
    """A network of one file, run on one thread, so that the same input gives the same bits."""

    def __init__(self, path: Path) -> None:
        """Load it.

        Raises:
            DamagedFileError: the file cannot be read as a network.
        """
        import onnxruntime  # a run that sees the truth does without

        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        options.log_severity_level = 3
        try:
            self._session: Any = onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
        except Exception as error:
            raise DamagedFileError(f"the network '{path}' cannot be read: {error}; reinstall uniteam") from error
        self._inputs = [each.name for each in self._session.get_inputs()]

    def __call__(self, *inputs: NDArray[np.float32]) -> list[NDArray[np.float32]]:
        """Return the network's outputs."""
        found: list[NDArray[np.float32]] = self._session.run(None, dict(zip(self._inputs, inputs, strict=True)))
        return found


def as_input(images: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Return (N, H, W, 3) uint8 images as the networks take them: (N, 3, H, W) from -1 to 1."""
    moved = np.ascontiguousarray(images.transpose(0, 3, 1, 2), dtype=np.float32)
    return np.asarray((moved - np.float32(127.0)) / np.float32(128.0))


def read_card(folder: Path = WEIGHTS) -> Card:
    """Return what the networks of a folder are; raises DamagedFileError where that cannot be read."""
    path = folder / "card.json"
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        calibration = {role: (list(map(float, x)), list(map(float, y))) for role, (x, y) in data["calibration"].items()}
        return Card(data["names"], data["receptacles"], float(data["scale"]), calibration)
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise DamagedFileError(
            f"'{path}', which describes the networks, cannot be read: {error!r}; reinstall uniteam"
        ) from error
