"""Read what a peer pickled without running anything of it.

The bridge of stretch_ai sends pickles, which may call whatever they name. Here three fences stand one behind the other:
only opcodes that build plain values are let through, and none that reserves more than was sent; every global becomes a
stand-in of this file, or is refused; and NumPy sees no state of a peer's, for arrays are built afterwards of a checked
type, a checked shape and bytes. (What `numpy.ndarray` and `numpy.dtype` make of a crafted state is not defined.)
"""

import pickle
import pickletools
import re
from io import BytesIO
from math import prod
from typing import Any

import numpy as np

from uniteam.world.real.robot_errors import StrangeMessageError

MOST_BYTES = 16 * 1024 * 1024
"""Of a message; a full-size observation has less than one mebibyte."""
MOST_OPCODES = 20_000
"""Of a message; an observation has about 300, a long pose graph or a scan some thousands."""
MOST_VALUES = 20_000
"""How many values a message may come to, for one that is named often is counted often."""
DEEPEST = 6
"""How deep values may lie in others."""

_BUILD_VALUES = """
    PROTO FRAME STOP MARK NONE NEWTRUE NEWFALSE BININT BININT1 BININT2 LONG1 BINFLOAT SHORT_BINUNICODE BINUNICODE
    SHORT_BINBYTES BINBYTES BINBYTES8 BYTEARRAY8 EMPTY_DICT EMPTY_LIST EMPTY_TUPLE TUPLE TUPLE1 TUPLE2 TUPLE3 APPEND
    APPENDS SETITEM SETITEMS MEMOIZE BINPUT LONG_BINPUT BINGET LONG_BINGET GLOBAL STACK_GLOBAL REDUCE BUILD
"""
_OPCODES = frozenset(_BUILD_VALUES.split())
_PUTS = frozenset(("BINPUT", "LONG_BINPUT"))
_DTYPE = re.compile(r"b1|[iu][1248]|f[248]")
_ORDERS = ("<", ">", "=", "|")


def read_pickle(data: bytes) -> Any:
    """Return the value of a pickle that is made of None, bool, int, float, str, bytes, list, tuple, dict and arrays.

    Scalars of NumPy come as Python's own; arrays are read-only, of bool, int, uint or float.

    Raises:
        StrangeMessageError: it is none, is cut short, holds or calls anything else, or is too large.
    """
    if len(data) > MOST_BYTES:
        raise StrangeMessageError(f"a message of {len(data)} bytes was refused; a Stretch sends at most {MOST_BYTES}")
    try:
        _check_opcodes(data)
        return _Values().plain(_StandIns(BytesIO(data)).load(), 0)
    except StrangeMessageError:
        raise
    except Exception as error:  # a pickle that is none can raise nearly anything
        raise StrangeMessageError(
            f"a message of {len(data)} bytes was refused, for it is no whole pickle ({type(error).__name__}); see that "
            "a Stretch, and nobody else, sends on this port"
        ) from error


def _check_opcodes(data: bytes) -> None:
    for count, (opcode, argument, _) in enumerate(pickletools.genops(data)):
        if opcode.name not in _OPCODES:
            raise StrangeMessageError(f"a message was refused, for it uses the pickle opcode {opcode.name}")
        if count >= MOST_OPCODES or (opcode.name in _PUTS and int(argument or 0) > MOST_OPCODES):
            raise StrangeMessageError(f"a message was refused, for it has more than {MOST_OPCODES} opcodes")


class _Sealed:
    """Something that a pickle may name, but not change."""

    __slots__ = ()

    def __setstate__(self, state: object) -> None:
        raise StrangeMessageError("a message was refused, for it changes what it was only to name")


class _NdarrayName(_Sealed):
    """Stands for the class `numpy.ndarray`, which is only handed on."""

    __slots__ = ()


class _Dtype:
    """Stands for a `numpy.dtype`."""

    __slots__ = ("code", "order")

    def __init__(self, code: object) -> None:
        if not isinstance(code, str) or not _DTYPE.fullmatch(code):
            raise StrangeMessageError(f"a message was refused, for it holds an array of type {str(code)[:20]!r}")
        self.code, self.order = code, "="

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        if len(state) < 2 or state[1] not in _ORDERS or any(part is not None for part in state[2:5]):
            raise StrangeMessageError("a message was refused, for the type of an array in it is not a plain one")
        self.order = state[1]

    def real(self) -> np.dtype[Any]:
        return np.dtype(self.code).newbyteorder(self.order)  # type: ignore[arg-type]


class _Array:
    """Stands for a `numpy.ndarray`."""

    __slots__ = ("content", "dtype", "is_fortran", "shape")

    def __init__(self) -> None:
        self.shape: tuple[int, ...] = ()
        self.dtype, self.is_fortran, self.content = _Dtype("u1"), False, b""

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        _, shape, dtype, is_fortran, content = state
        self.fill(content, dtype, shape, bool(is_fortran))

    def fill(self, content: object, dtype: object, shape: object, is_fortran: bool) -> None:
        is_shape = isinstance(shape, tuple) and len(shape) <= 4 and all(type(n) is int and n >= 0 for n in shape)
        if not (is_shape and isinstance(dtype, _Dtype) and isinstance(content, bytes | bytearray)):
            raise StrangeMessageError("a message was refused, for an array in it has no plain shape, type or content")
        self.shape, self.dtype, self.is_fortran = shape, dtype, is_fortran  # type: ignore[assignment]
        self.content = bytes(content)

    def real(self) -> np.ndarray[Any, np.dtype[Any]]:
        dtype = self.dtype.real()
        if prod(self.shape) * dtype.itemsize != len(self.content):
            raise StrangeMessageError(f"a message was refused: {len(self.content)} bytes are no array of {self.shape}")
        flat = np.frombuffer(self.content, dtype)
        return flat.reshape(self.shape, order="F" if self.is_fortran else "C")


class _MakeDtype(_Sealed):
    __slots__ = ()

    def __call__(self, code: object, align: object = False, copy: object = False) -> _Dtype:
        return _Dtype(code)


class _MakeEmptyArray(_Sealed):
    __slots__ = ()

    def __call__(self, kind: object, shape: object, code: object) -> _Array:
        return _Array()


class _MakeArray(_Sealed):
    __slots__ = ()

    def __call__(self, content: object, dtype: object, shape: object, order: object) -> _Array:
        array = _Array()
        array.fill(content, dtype, shape, order == "F")
        return array


class _MakeScalar(_Sealed):
    __slots__ = ()

    def __call__(self, dtype: object, content: object) -> _Array:
        array = _Array()
        array.fill(content, dtype, (), False)
        return array


_GLOBALS: dict[tuple[str, str], _Sealed] = {
    ("numpy", "ndarray"): _NdarrayName(),
    ("numpy", "dtype"): _MakeDtype(),
    ("numpy._core.multiarray", "_reconstruct"): _MakeEmptyArray(),
    ("numpy._core.multiarray", "scalar"): _MakeScalar(),
    ("numpy._core.numeric", "_frombuffer"): _MakeArray(),
}


class _StandIns(pickle.Unpickler):
    """An unpickler that knows nothing but `_GLOBALS`."""

    def find_class(self, module: str, name: str) -> Any:
        """Return a stand-in; NumPy 1 and 2 call the module of theirs by different names."""
        known = _GLOBALS.get((module.replace("numpy.core.", "numpy._core.", 1), name))
        if known is None:
            raise StrangeMessageError(
                f"a message was refused, and nothing of it run: it asks for {module[:60]}.{name[:60]}, which no "
                "message of a Stretch needs; see who sends on this port"
            )
        return known


class _Values:
    """Takes stand-ins out of a value, and counts how much it comes to."""

    def __init__(self) -> None:
        self._count = 0

    def plain(self, value: Any, depth: int) -> Any:
        """Return the value with arrays in place of their stand-ins."""
        self._count += 1
        if depth > DEEPEST or self._count > MOST_VALUES:
            raise StrangeMessageError("a message was refused, for it is nested too deeply or holds too many values")
        if isinstance(value, _Array):
            array = value.real()
            return array.item() if array.shape == () else array
        if isinstance(value, dict):
            return {self._key(key): self.plain(item, depth + 1) for key, item in value.items()}
        if isinstance(value, list | tuple):
            return type(value)(self.plain(item, depth + 1) for item in value)
        if value is None or isinstance(value, bool | int | float | str | bytes | bytearray):
            return value
        raise StrangeMessageError("a message was refused, for it holds a name where a value should be")

    def _key(self, key: object) -> str:
        if not isinstance(key, str):
            raise StrangeMessageError("a message was refused, for a key in it is not a word")
        return key
