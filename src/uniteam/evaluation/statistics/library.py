"""SciPy's distributions, which come with an extra: a run needs none of them, only what is said about runs."""

from types import ModuleType

from uniteam.errors import UnavailableError


def distributions() -> ModuleType:
    """Return `scipy.stats`; raises UnavailableError, which says what to install, where there is none."""
    try:
        from scipy import stats
    except ImportError as error:
        raise UnavailableError(
            f"comparing agents needs SciPy, which cannot be imported ({error}); pip install 'uniteam[study]'"
        ) from error
    module: ModuleType = stats
    return module
