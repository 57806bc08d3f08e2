"""Arrays as a page carries them: typed, compressed, and written in letters."""

import base64
import gzip
from typing import Any

import numpy as np
from numpy.typing import NDArray

_KINDS = {"u1": "Uint8Array", "u2": "Uint16Array", "u4": "Uint32Array", "i2": "Int16Array", "f4": "Float32Array"}
"""What JavaScript calls the array of a NumPy type."""


def packed(array: NDArray[Any]) -> dict[str, str]:
    """Return an array, row by row, as the page's `unpacked` reads it; of uint8, uint16, uint32, int16 or float32."""
    content = np.ascontiguousarray(array.astype(array.dtype.newbyteorder("<"))).tobytes()
    return {"kind": _KINDS[array.dtype.str[1:]], "content": letters(gzip.compress(content, 6, mtime=0))}


def letters(content: bytes) -> str:
    """Return bytes in base64."""
    return base64.b64encode(content).decode()
