"""Where compiled kernels are kept between runs: a folder that can be written must be found before numba is imported.

numba looks beside the source, then in the user's cache, and fails where neither can be written (containers, clusters).
It compiles a kernel anew when the kernel's own file changes, and not when another does that the kernel takes a type, a
constant or a function from: then it runs the old one, or cannot read its cache at all. So the kernels of other sources
are kept in another folder.
"""

import os
import stat
import sys
from hashlib import sha256
from pathlib import Path

from uniteam.errors import InvalidInputError

VARIABLE = "NUMBA_CACHE_DIR"
THREADS = "NUMBA_NUM_THREADS"

SOURCES = (
    "evaluation/recording/truth_track.py",
    "mind/manipulation/place/around_samples.py",
    "mind/mapping/block_projection.py",
    "mind/mapping/clearing.py",
    "mind/mapping/fine_obstacles.py",
    "mind/mapping/projection.py",
    "mind/mapping/view_on_map.py",
    "mind/navigation/planning/bucket_queue.py",
    "mind/perception/truth.py",
    "stretch.py",
    "world/oracle/true_paths.py",
    "world/rendering/kernels/culling.py",
    "world/rendering/kernels/lighting.py",
    "world/rendering/kernels/measuring.py",
    "world/rendering/kernels/rasteriser.py",
    "world/rendering/kernels/scene_buffers.py",
    "world/rendering/kernels/shading.py",
    "world/task/visible_truth.py",
)
"""The files of the package with kernels, and those from which kernels take anything."""

_PREFIX = "uniteam-kernels-"


def ensure_cache() -> None:
    """Have numba keep the kernels of these sources in a folder of their own; worker processes inherit it."""
    os.environ[VARIABLE] = str(_place() / f"{_PREFIX}{_digest()}")


def cache_folder() -> tuple[Path, bool]:
    """Return the folder of the compiled kernels, and whether it lasts."""
    chosen = os.environ[VARIABLE]
    return Path(chosen), not chosen.startswith(_temporary_prefix())


def _place() -> Path:
    """Return where the folder belongs: where the user wants it, or the first place that can be written."""
    chosen = os.environ.get(VARIABLE)
    if chosen:
        return Path(chosen).parent if Path(chosen).name.startswith(_PREFIX) else Path(chosen)
    lasting = next((place for place in (_beside_source(), _user_cache()) if _can_write(place)), None)
    return Path(_temporary_folder()) if lasting is None else lasting


def _digest() -> str:
    package = Path(__file__).parent
    content = sha256()
    for source in SOURCES:
        path = package / source
        content.update(sha256(path.read_bytes() if path.is_file() else b"").digest())
    return content.hexdigest()[:12]


def check_environment() -> None:
    """Refuse what would have numba fail when it is imported; raises InvalidInputError."""
    threads = os.environ.get(THREADS)
    if threads is not None and not (threads.strip().isdecimal() and int(threads) >= 1):
        raise InvalidInputError(f"{THREADS} is '{threads}'; it must be a whole number of at least 1, or unset")


def _beside_source() -> Path:
    return Path(__file__).parent / "__pycache__"


def _user_cache() -> Path:
    """Return where numba keeps a user's cache (`numba.misc.appdirs`)."""
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 - Path.home raises where there is none
    if sys.platform == "darwin":
        return home / "Library" / "Caches" / "numba"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", home)) / "numba"
    return Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache") / "numba"


def _can_write(folder: Path) -> bool:
    """Return whether the folder can be written, or made."""
    while not folder.exists() and folder != folder.parent:
        folder = folder.parent
    return folder.is_dir() and os.access(folder, os.W_OK | os.X_OK)


def _temporary_folder() -> str:
    """Return a folder that only this user can write: what lies in the cache is run.

    One of the same name by somebody else is left alone, and a new one is made.
    """
    import tempfile

    name = f"{_temporary_prefix()}{_user()}"
    try:
        Path(name).mkdir(mode=0o700, exist_ok=True)
        found = os.lstat(name)
        own = stat.S_ISDIR(found.st_mode) and found.st_uid == _user() and not found.st_mode & 0o077
    except OSError:
        own = False
    return name if own else tempfile.mkdtemp(prefix=f"{Path(name).name}-")


def _temporary_prefix() -> str:
    import tempfile

    return str(Path(tempfile.gettempdir()) / "uniteam-numba-")


def _user() -> int:
    return os.getuid() if hasattr(os, "getuid") else 0
