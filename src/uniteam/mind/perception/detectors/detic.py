"""Perception `detic`: Detic in a process of its own, of an installation of your own.

Detic needs detectron2, which no package index has and which is not built for the Pythons that uniteam runs on. So it
stays where it is, and `detic_process` is run there.
"""

import atexit
import json
import os
import subprocess
import tempfile
from functools import cache, partial
from pathlib import Path
from threading import Timer
from typing import Any

import msgspec
import numpy as np

from uniteam.errors import DamagedFileError, InvalidInputError, UnavailableError
from uniteam.interface import Detection, Observation
from uniteam.mind.perception.detectors.detector import DetectorFactory, Found, as_words
from uniteam.registry import Family

SCRIPT = Path(__file__).with_name("detic_process.py")
CONFIG = "configs/Detic_LCOCOI21k_CLIP_SwinB_896b32_4x_ft4x_max-size.yaml"
WEIGHTS = "models/Detic_LCOCOI21k_CLIP_SwinB_896b32_4x_ft4x_max-size.pth"
INSTALL = (
    "install detectron2 and Detic in an environment of their own, as https://github.com/facebookresearch/Detic says, "
    "and name that environment's Python in the file"
)


class DeticSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Where Detic is.

    Attributes:
        python: of the environment that has detectron2.
        detic: folder of Detic's repository, with its submodules.
        config: of the network, relative to that folder or absolute.
        weights: of the network, likewise.
        device: "cuda" or "cpu".
        starting_seconds: how long loading may take (s).
        frame_seconds: how long a frame may take (s).
    """

    python: str
    detic: str
    config: str = CONFIG
    weights: str = WEIGHTS
    device: str = "cpu"
    starting_seconds: float = 600.0
    frame_seconds: float = 120.0


class DeticError(UnavailableError):
    """The process of Detic cannot be had, has ended, or answers with an error."""


class DeticProcess:
    """Detic at work in another process, which ends with this one."""

    def __init__(self, settings: DeticSettings) -> None:
        """Start the process and wait until it has loaded; raises DeticError with what to do."""
        self._settings = settings
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - it is written into as long as the process runs
        given = {name: getattr(settings, name) for name in ("detic", "config", "weights", "device")}
        environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME")}
        try:
            self._process = subprocess.Popen(
                [settings.python, str(SCRIPT), json.dumps(given)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._errors,
                env=environment,
            )
        except OSError as error:
            raise DeticError(f"'{settings.python}' cannot be run ({error.strerror or error}); {INSTALL}") from error
        atexit.register(self._process.kill)
        self._answer(settings.starting_seconds, f"Detic cannot be loaded; {INSTALL}")

    def detect(self, observation: Observation, names: tuple[str, ...]) -> list[Found]:
        """Return what Detic finds; raises DeticError."""
        height, width = observation.depth.shape
        head = {"names": [as_words(name) for name in names], "height": height, "width": width}
        try:
            assert self._process.stdin is not None
            self._process.stdin.write(json.dumps(head).encode() + b"\n" + observation.rgb.tobytes())
            self._process.stdin.flush()
        except OSError:
            pass  # it has ended, which reading its answer will tell with the reason
        answer, bits = self._answer(self._settings.frame_seconds, "Detic failed at a frame")
        masks = np.unpackbits(np.frombuffer(bits, np.uint8), count=int(np.prod(answer["shape"])))
        of_each = masks.view(bool).reshape(-1, height, width)
        return [
            Found(mask, Detection(((names[index], min(max(float(score), 0.0), 1.0)),)))
            for mask, index, score in zip(of_each, answer["classes"], answer["scores"], strict=True)
        ]

    def _answer(self, seconds: float, trouble: str) -> tuple[dict[str, Any], bytes]:
        """Return the next answer; the process is ended where it takes too long."""
        timer = Timer(seconds, self._process.kill)
        timer.start()
        try:
            assert self._process.stdout is not None
            line = self._process.stdout.readline()
            answer: dict[str, Any] = json.loads(line) if line else {"error": self._last_words(seconds)}
            size = -(-int(np.prod(answer.get("shape", [0]))) // 8)
            bits = self._process.stdout.read(size)
        finally:
            timer.cancel()
        if "error" in answer or len(bits) != size:
            raise DeticError(f"{trouble} ({answer.get('error', 'its answer broke off')})")
        return answer, bits

    def _last_words(self, seconds: float) -> str:
        """Return why the process has ended: the last line of what it wrote, or that it was too slow."""
        code = self._process.wait()
        self._errors.seek(0)
        lines = [line for line in self._errors.read().decode(errors="replace").splitlines() if line.strip()]
        if code == -9:
            return f"it took more than {seconds:g} s and was ended"
        return lines[-1].strip() if lines else f"it ended with code {code}"


@cache
def load_detic(settings: DeticSettings) -> DeticProcess:
    """Return the process, one for each process of uniteam's; raises DeticError."""
    return DeticProcess(settings)


def detic_of(argument: str) -> DetectorFactory:
    """Return what makes perceptions by a file of settings.

    Raises:
        InvalidInputError: there is no such file.
        DamagedFileError: it holds no `DeticSettings`.
    """
    path = Path(argument)
    if not path.is_file():
        raise InvalidInputError(
            f"perception 'detic' needs a JSON file that says where Detic is, got '{argument}'; write one with "
            '{"python": "PATH/bin/python", "detic": "PATH/Detic"}'
        )
    try:
        settings = msgspec.json.decode(path.read_bytes(), type=DeticSettings)
    except (msgspec.MsgspecError, OSError, ValueError) as error:
        raise DamagedFileError(
            f'\'{path}\' must hold "python" and "detic", two paths, and may hold '
            f"{', '.join(DeticSettings.__struct_fields__[2:])}; but {error}"
        ) from error
    return DetectorFactory(partial(load_detic, settings))


DETIC = Family("Detic of an installation of your own, in a process of its own", "FILE.json", "detic.json", detic_of)
