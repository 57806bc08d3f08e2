"""What training begins with: ImageNet's weights, or those of networks that were trained before."""

from pathlib import Path

import numpy as np
import torch
from torch import nn

from uniteam.errors import InvalidInputError
from uniteam.mind.perception.learned.networks import WEIGHTS

IMAGENET, SHIPPED = "imagenet", "shipped"
_HALF = "_half"


def start_folder(start: str) -> Path | None:
    """Return the folder of the networks to begin with; None for ImageNet's weights alone.

    Args:
        start: "imagenet", "shipped" (the networks of this package), or a folder of networks.

    Raises:
        InvalidInputError: it is neither, and no folder.
    """
    if start == IMAGENET:
        return None
    folder = WEIGHTS if start == SHIPPED else Path(start)
    if not folder.is_dir():
        raise InvalidInputError(
            f"training can begin with '{IMAGENET}', '{SHIPPED}' or a folder of networks, and '{start}' is none of them"
        )
    return folder


def begin_with(model: nn.Module, path: Path) -> None:
    """Give a network the weights of an exported one of the same shape; what the file lacks stays as it is.

    Args:
        model: the network.
        path: an ONNX file that `halve` or `torch.onnx.export` has written of such a network.

    Raises:
        InvalidInputError: the file is missing, or of a network of another shape.
    """
    import onnx
    from onnx import numpy_helper

    if not path.is_file():
        raise InvalidInputError(f"there is no network '{path}' to begin with; leave --start out, or give its folder")
    weights = {w.name.removesuffix(_HALF): numpy_helper.to_array(w) for w in onnx.load(str(path)).graph.initializer}
    own = model.state_dict()
    unlike = [name for name, value in weights.items() if name not in own or own[name].shape != value.shape]
    if unlike or not weights:
        raise InvalidInputError(f"'{path}' is of a network of another shape (its '{(unlike or ['weights'])[0]}')")
    own.update({name: torch.from_numpy(np.array(value, dtype=np.float32)) for name, value in weights.items()})
    model.load_state_dict(own)
