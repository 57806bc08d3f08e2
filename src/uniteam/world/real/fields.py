"""Take single things out of a message, each of the kind it must be: a number that is finite, a pose that is rigid."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.world.real.robot_errors import StrangeMessageError

FARTHEST = 1000.0
"""m; no home is larger."""
_RIGID = 1e-3


class Fields:
    """The dictionary of a message, with a name for sentences ("state message")."""

    def __init__(self, data: Any, name: str) -> None:
        """Take what was unpickled; raises StrangeMessageError where it is no dictionary."""
        if not isinstance(data, dict):
            raise StrangeMessageError(f"a {name} must be a dictionary, got a {type(data).__name__}")
        self._data, self._name = data, name

    def has(self, key: str) -> bool:
        """Return whether there is such a field, and it is not None."""
        return self._data.get(key) is not None

    def boolean(self, key: str) -> bool:
        """Return a truth value."""
        value = self._get(key)
        if not isinstance(value, bool):
            raise self._strange(key, "True or False", value)
        return value

    def integer(self, key: str) -> int:
        """Return a whole number of at most 62 bits."""
        value = self._get(key)
        if isinstance(value, bool) or not isinstance(value, int) or abs(value) >= 2**62:
            raise self._strange(key, "a whole number", value)
        return value

    def number(self, key: str, most: float) -> float:
        """Return a number of at most a size, either way."""
        value = self._get(key)
        if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= most:
            raise self._strange(key, f"a number from {-most:g} to {most:g}", value)
        return float(value)

    def part(self, key: str) -> "Fields":
        """Return a dictionary within this one."""
        return Fields(self._get(key), f"'{key}' of a {self._name}")

    def word(self, key: str) -> str:
        """Return a short text."""
        value = self._get(key)
        if not isinstance(value, str) or len(value) > 100:
            raise self._strange(key, "a word", value)
        return value

    def words(self, key: str) -> list[str]:
        """Return a list of short texts."""
        value = self._get(key)
        if not isinstance(value, list) or not all(isinstance(each, str) and len(each) <= 100 for each in value):
            raise self._strange(key, "a list of words", value)
        return value

    def numbers(self, key: str, count: int) -> NDArray[np.float64]:
        """Return (count,) finite numbers."""
        return self._array(key, (count,))

    def image(self, key: str) -> bytes:
        """Return the bytes of a packed image, whether they came as bytes or as an array of them."""
        value = self._get(key)
        if isinstance(value, np.ndarray) and value.dtype == np.uint8 and 1 <= value.ndim <= 2:
            return value.tobytes()
        if isinstance(value, bytes | bytearray):
            return bytes(value)
        raise self._strange(key, "the bytes of an image", value)

    def matrix(self, key: str) -> NDArray[np.float64]:
        """Return (3, 3) finite numbers."""
        return self._array(key, (3, 3))

    def transform(self, key: str) -> NDArray[np.float64]:
        """Return a (4, 4) rigid transform, its rotation made exact."""
        value = self._array(key, (4, 4))
        rotation = value[:3, :3]
        is_rotation = np.abs(rotation @ rotation.T - np.eye(3)).max() < _RIGID and np.linalg.det(rotation) > 0.0
        if not is_rotation or np.abs(value[3] - (0.0, 0.0, 0.0, 1.0)).max() > _RIGID:
            raise self._strange(key, "a rigid transform", value)
        left, _, right = np.linalg.svd(rotation)
        exact = np.eye(4)
        exact[:3, :3], exact[:3, 3] = left @ right, value[:3, 3]
        return exact

    def _array(self, key: str, shape: tuple[int, ...]) -> NDArray[np.float64]:
        value = self._get(key)
        try:
            array = np.asarray(value, np.float64)
        except (TypeError, ValueError, OverflowError) as error:
            raise self._strange(key, f"numbers of shape {shape}", value) from error
        if array.shape != shape:
            raise self._strange(key, f"numbers of shape {shape}", value)
        if not np.isfinite(array).all() or np.abs(array).max() > FARTHEST * 10:
            raise StrangeMessageError(
                f"'{key}' of a {self._name} is not finite, or too large; see that the robot's localisation runs"
            )
        return array

    def _get(self, key: str) -> Any:
        if key not in self._data:
            raise StrangeMessageError(
                f"a {self._name} lacks '{key}'; see that the robot runs a bridge of stretch_ai of 2025 or later"
            )
        return self._data[key]

    def _strange(self, key: str, wanted: str, value: Any) -> StrangeMessageError:
        shape = f" of shape {value.shape}" if isinstance(value, np.ndarray) else ""
        return StrangeMessageError(f"'{key}' of a {self._name} must be {wanted}, got a {type(value).__name__}{shape}")
