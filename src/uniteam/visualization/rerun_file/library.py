"""The library of Rerun, which is imported only where a file of it is written."""

from types import ModuleType

from uniteam.errors import UnavailableError


def load_rerun() -> ModuleType:
    """Return the library; raises UnavailableError where it is not installed."""
    try:
        import rerun
        import rerun.blueprint
    except ImportError as error:
        raise UnavailableError(
            f"a file for Rerun needs rerun-sdk ({error}); install it with pip install 'uniteam[rerun]'"
        ) from error
    found: ModuleType = rerun
    return found
