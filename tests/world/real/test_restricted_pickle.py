"""A pickle is read without running anything of it, and without reserving more memory than it has bytes."""

import os
import pickle
import resource
import struct
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from uniteam.world.real.restricted_pickle import read_pickle
from uniteam.world.real.robot_errors import StrangeMessageError

MESSAGE = {
    "camera_K": np.eye(3),
    "joint": np.arange(11.0),
    "joint_velocities": np.arange(22.0, dtype=np.float32)[::2],
    "transposed": np.asfortranarray(np.arange(6, dtype=np.int16).reshape(2, 3)),
    "rgb": np.frombuffer(b"image", np.uint8),
    "depth": b"image",
    "compass": np.array([0.5]),
    "big_endian": np.array([1.5, 2.5], ">f8"),
    "nobody": np.zeros((0, 3)),
    "at_goal": np.bool_(True),
    "speed": np.float64(2.5),
    "step": np.int64(7),
    "shape": (48, 64, 3),
    "pose_graph": [[0.0, 1.0, 2.0, 3.0]],
    "lidar_points": None,
    "mode": "navigation",
    "base_velocity": {"v": 0.1, "w": -3},
}


class Payload:
    """Calls something where it is unpickled."""

    def __init__(self, function: Any, *arguments: Any) -> None:
        self.call = (function, arguments)

    def __reduce__(self) -> Any:
        return self.call


def refusal(data: bytes) -> str:
    with pytest.raises(StrangeMessageError) as raised:
        read_pickle(data)
    assert "\n" not in str(raised.value)
    return str(raised.value)


@pytest.mark.parametrize("protocol", [3, 4, 5])
def test_every_kind_of_value_of_a_message_comes_out_as_it_was(protocol: int) -> None:
    read = read_pickle(pickle.dumps(MESSAGE, protocol))
    assert set(read) == set(MESSAGE)
    np.testing.assert_equal({k: v for k, v in read.items()}, MESSAGE)
    assert type(read["at_goal"]) is bool
    assert type(read["speed"]) is float
    assert type(read["step"]) is int
    assert read["big_endian"].tolist() == [1.5, 2.5]
    assert not read["joint"].flags.writeable


def test_what_an_older_numpy_wrote_is_read() -> None:
    old = pickle.dumps(MESSAGE, 3).replace(b"numpy._core.", b"numpy.core.")
    assert old != pickle.dumps(MESSAGE, 3)
    np.testing.assert_equal(read_pickle(old)["camera_K"], np.eye(3))


@pytest.mark.parametrize(
    "nested",
    [
        lambda p: p,
        lambda p: {"rgb": p},
        lambda p: [1, (2, p)],
        lambda p: np.array([p, 0], object),
        lambda p: {"joint": np.array([[p]], object)},
    ],
)
@pytest.mark.parametrize("protocol", [2, 3, 4, 5])
def test_no_payload_runs_wherever_it_is_hidden(nested: Any, protocol: int, tmp_path: Path) -> None:
    marker = tmp_path / "it_ran"
    assert "was refused" in refusal(pickle.dumps(nested(Payload(os.mkdir, str(marker))), protocol))
    assert not marker.exists()
    pickle.loads(pickle.dumps(nested(Payload(os.mkdir, str(marker))), protocol))
    assert marker.exists()  # it would have


@pytest.mark.parametrize(
    "function",
    [eval, exec, open, getattr, __import__, np.load, np.fromfile, np.frombuffer, np.array, pickle.loads, list],
)
def test_nothing_but_numpys_own_constructors_may_be_called(function: Any) -> None:
    said = refusal(pickle.dumps(Payload(function, "1")))
    assert "nothing of it run: it asks for" in said


def opcodes(*parts: bytes) -> bytes:
    return b"\x80\x04" + b"".join(parts) + b"."


def name(module: bytes, attribute: bytes) -> bytes:
    return b"c" + module + b"\n" + attribute + b"\n"


NDARRAY, DTYPE = name(b"numpy", b"ndarray"), name(b"numpy", b"dtype")
RECONSTRUCT = name(b"numpy._core.multiarray", b"_reconstruct")
FLOAT64 = DTYPE + b"\x8c\x02f8\x89\x88\x87R"


def array_of(shape: bytes, dtype: bytes, content: bytes) -> bytes:
    """Return the opcodes of an array with a state of one's own."""
    state = b"(K\x01" + shape + dtype + b"\x89" + b"C" + bytes([len(content)]) + content + b"t"
    return RECONSTRUCT + NDARRAY + b"K\x00\x85C\x01b\x87R" + state + b"b"


def test_the_opcodes_written_by_hand_make_an_array() -> None:
    assert read_pickle(opcodes(array_of(b"K\x01\x85", FLOAT64, bytes(8)))).tolist() == [0.0]


@pytest.mark.parametrize(
    "data",
    {
        "a size that was not sent": array_of(b"J\xff\xff\xff\x7f\x85", FLOAT64, bytes(8)),
        "a negative size": array_of(b"J\xff\xff\xff\xff\x85", FLOAT64, bytes(8)),
        "a size that is none": array_of(b"N\x85", FLOAT64, bytes(8)),
        "an array of objects": array_of(b"K\x01\x85", DTYPE + b"\x8c\x01O\x89\x88\x87R", bytes(8)),
        "an array of structures": array_of(b"K\x01\x85", DTYPE + b"\x8c\x05f8,O\x89\x88\x87R"[:-1] + b"R", bytes(8)),
        "a type whose state was changed": array_of(
            b"K\x01\x85", FLOAT64 + b"(K\x04\x8c\x01<NN}J\xff\xff\xff\xffJ\xff\xff\xff\xffK\x3ftb", bytes(8)
        ),
        "a type that is no type": array_of(b"K\x01\x85", b"\x8c\x02f8", bytes(8)),
        "no state": RECONSTRUCT + NDARRAY + b"K\x00\x85C\x01b\x87RNb",
        "a name instead of a value": NDARRAY,
        "a constructor instead of a value": DTYPE,
        "a constructor that is changed": array_of(b"K\x01\x85", DTYPE + b"}b" + b"\x8c\x02f8\x89\x88\x87R", bytes(8)),
        "attributes of a name": NDARRAY + b"N}\x8c\x01aK\x01s\x86b",
        "a global by its stack": b"\x8c\x02os\x8c\x06system\x93",
        "an extension": b"\x82\x01",
        "a persistent identity": b"K\x01Q",
        "an instance": b"(i" + b"os\nsystem\n",
        "an object by its class": b"(" + name(b"os", b"system") + b"o",
        "a buffer from outside": b"\x97",
        "a set": b"\x8f",
        "a key that is no word": b"}K\x01K\x02s",
        "an unhashable key": b"}]K\x02s",
        "nothing at all": b"",
    }.items(),
    ids=lambda item: item[0],
)
def test_what_is_crafted_by_hand_is_refused(data: tuple[str, bytes]) -> None:
    assert "refused" in refusal(opcodes(data[1]))


def test_the_constructors_are_whole_after_all_that() -> None:
    np.testing.assert_equal(read_pickle(pickle.dumps(MESSAGE)), MESSAGE)


@pytest.mark.parametrize(
    "data",
    {
        "a memo of four milliards": opcodes(b"N", b"r" + struct.pack("<I", 2**32 - 1)),
        "bytes that were not sent": b"\x80\x04\x8e" + struct.pack("<Q", 2**40) + b".",
        "a text that was not sent": b"\x80\x04X" + struct.pack("<I", 2**31) + b".",
        "a frame that was not sent": b"\x80\x04\x95" + struct.pack("<Q", 2**40) + b".",
        "a number of four megabytes": b"\x80\x04\x8b" + struct.pack("<i", 2**22) + bytes(2**22) + b".",
        "a hundred thousand values": pickle.dumps(list(range(100_000))),
        "a milliard values by reference": opcodes(
            b"]q\x00", *(b"](" + b"h%c" % k * 60 + b"eq%c" % (k + 1) for k in range(5))
        ),
        "too deep": opcodes(b"]" * 9 + b"a" * 8),
        "itself": opcodes(b"]q\x00h\x00a"),
        "more bytes than a message has": pickle.dumps(bytes(17 * 2**20)),
    }.items(),
    ids=lambda item: item[0],
)
def test_no_message_takes_more_memory_than_it_has_bytes(data: tuple[str, bytes]) -> None:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert "refused" in refusal(data[1])
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 100_000  # kilobytes


@settings(max_examples=300, deadline=None)
@given(cut=st.integers(0, 5_000), at=st.integers(0, 5_000), byte=st.binary(min_size=1, max_size=4))
def test_a_message_that_was_cut_or_changed_is_read_or_refused(cut: int, at: int, byte: bytes) -> None:
    whole = pickle.dumps(MESSAGE, 4)
    spoiled = whole[: at % len(whole)] + byte + whole[(at + len(byte)) % len(whole) :]
    for data in (whole[: cut % len(whole)], spoiled):
        with suppress(StrangeMessageError):
            read_pickle(data)
