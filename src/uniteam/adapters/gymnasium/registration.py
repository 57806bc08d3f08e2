"""The names under which `gymnasium.make` knows the environments."""

from collections.abc import Mapping
from typing import Any

from uniteam.errors import UnavailableError

try:
    import gymnasium
except ImportError as error:
    raise UnavailableError(
        f"the environments need Gymnasium ({error}); install it with pip install 'uniteam[gym]'"
    ) from error

_ROOM = "uniteam.adapters.gymnasium"

ENVIRONMENTS: Mapping[str, Mapping[str, Any]] = {
    "uniteam/OVMM-v0": {"entry_point": f"{_ROOM}.ovmm_env:OvmmEnv"},
    **{
        f"uniteam/{skill}-v0": {"entry_point": f"{_ROOM}.task_env:TaskEnv", "kwargs": {"task": skill}}
        for skill in ("NavigateToObject", "Gaze", "Pick", "NavigateToReceptacle", "Place")
    },
}
"""What `gymnasium.register` is told of each id. An entry point in words can be sent to the workers of a vector."""


def register() -> None:
    """Make the environments known to Gymnasium; what is known already stays."""
    for name, told in ENVIRONMENTS.items():
        if name not in gymnasium.registry:
            gymnasium.register(name, **told)
