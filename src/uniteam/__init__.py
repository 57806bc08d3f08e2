"""Open-vocabulary mobile manipulation: simulated homes, a Stretch robot, and the agents that tidy them."""

from importlib.metadata import PackageNotFoundError, version

from uniteam.kernel_cache import ensure_cache

try:
    __version__ = version("uniteam")
except PackageNotFoundError:  # a source tree that was never installed
    __version__ = "0+unknown"

ensure_cache()
