"""Where homes come from: the generator with its two pools of models, and what others bring.

A source of homes is a function from a seed to a home; the same seed gives the same home, each seed one of its own name.
It is named by its registered name or by "package.module:function", and can be brought by a package through the
entry-point group `uniteam.homes`.
"""

from collections.abc import Callable
from functools import partial
from typing import cast

from uniteam.errors import InvalidInputError, UniteamError
from uniteam.registry import Registry
from uniteam.world.generation.generate import POOLS, check_seed, generate_home
from uniteam.world.generation.procthor_homes import PROCTHOR
from uniteam.world.generation.style import STYLES, TIDY, style_of
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import check_home

HomeSource = Callable[[int], Home]
"""From a seed, which is not negative, to the home of that seed."""


OWN_STYLE = "own"
"""Of homes that are from no generator of ours."""


def source_name(source: str, style: str) -> str:
    """Return the name of what makes a source's homes in a style: "test" for tidy ones, "test-lived_in".

    Raises:
        UnknownNameError: there is no such style.
        InvalidInputError: the source is not one of ours, and has no styles but its own.
    """
    if style_of(style) is TIDY:
        return source
    if source not in POOLS:
        raise InvalidInputError(f"homes in the style '{style}' are made of {' or '.join(POOLS)}, not by '{source}'")
    return f"{source}-{style}"


def style_name(source: str) -> str:
    """Return the style in which a source of `HOMES` makes its homes, `OWN_STYLE` where it is not one of ours."""
    styles = {source_name(pool, style): style for pool in POOLS for style in STYLES}
    return styles.get(source, OWN_STYLE)


def _checked(name: str, value: object) -> HomeSource:
    if not callable(value):
        kind = type(value).__name__
        raise InvalidInputError(f"source of homes '{name}' must be a function from a seed to a Home, got {kind}")
    return cast(HomeSource, value)


HOMES: Registry[HomeSource] = Registry("source of homes", "uniteam.homes", _checked)
for _pool in POOLS:
    for _style in STYLES.values():
        HOMES.register(source_name(_pool, _style.name), partial(generate_home, pool=_pool, style=_style), __name__)
HOMES.register("procthor", PROCTHOR, __name__)


def home_of_seed(source: str, seed: int) -> Home:
    """Return the home that a source makes of a seed.

    Args:
        source: a name of `HOMES`, or "package.module:function".
        seed: not negative.

    Raises:
        UnknownNameError: there is no such source.
        InvalidInputError: the source fails, or what it returns is no sound home.
    """
    check_seed(seed)
    make = HOMES.get(source)
    try:
        home = make(seed)
    except UniteamError:
        raise
    except Exception as error:
        raise InvalidInputError(f"{source} failed at seed {seed}: {type(error).__name__}: {error}") from error
    if not isinstance(home, Home):
        raise InvalidInputError(f"{source} returned a {type(home).__name__} for seed {seed}, it must return a Home")
    check_home(home)
    return home
