"""Where compiled kernels are kept between runs: a folder that can be written must be found before numba is imported.

numba looks beside the source, then in the user's cache, and fails where neither can be written (containers, clusters).
"""

import os
import stat
import sys
from pathlib import Path

from uniteam.errors import InvalidInputError

VARIABLE = "NUMBA_CACHE_DIR"
THREADS = "NUMBA_NUM_THREADS"


def ensure_cache() -> None:
    """Have numba keep its kernels in a temporary folder where it would find no other; worker processes inherit it."""
    if not os.environ.get(VARIABLE) and not (_can_write(_beside_source()) or _can_write(_user_cache())):
        os.environ[VARIABLE] = _temporary_folder()


def cache_folder() -> tuple[Path, bool]:
    """Return the folder of the compiled kernels, and whether it lasts."""
    chosen = os.environ.get(VARIABLE)
    if chosen:
        return Path(chosen), not chosen.startswith(_temporary_prefix())
    return (_beside_source() if _can_write(_beside_source()) else _user_cache()), True


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

    return str(Path(tempfile.gettempdir()) / "uniteam-kernels-")


def _user() -> int:
    return os.getuid() if hasattr(os, "getuid") else 0
