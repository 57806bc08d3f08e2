"""Things by name: those that are built in, those that installed packages bring, and those of a reference.

A package brings its own by an entry point, in its `pyproject.toml`:

    [project.entry-points."uniteam.agents"]
    spinner = "my_package.my_module:Spinner"

and without installing anything the reference `my_module:Spinner` is a name too. References can be sent to other
processes, which import them anew.

A name may stand for a `Family` of values, one of which an argument after a colon chooses: `noisy:0.6`.
"""

import logging
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from hashlib import sha256
from importlib import import_module
from importlib.metadata import EntryPoint, PackageNotFoundError, entry_points, version
from importlib.util import find_spec
from pathlib import Path
from typing import Generic, TypeVar

from uniteam.errors import InvalidInputError, UnknownNameError

T = TypeVar("T")
Member = TypeVar("Member", covariant=True)

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.\-]*")
_log = logging.getLogger(__name__)


class UnimportableError(InvalidInputError):
    """A reference or an entry point whose module cannot be imported, or that names nothing in it."""


@dataclass(frozen=True)
class Family(Generic[Member]):
    """Values under one name that differ by an argument, which is given after a colon.

    Attributes:
        summary: what the values are, in one line.
        argument: what the argument is called ("LEVEL").
        example: one that can be given ("0.5").
        member: returns the value of an argument; raises InvalidInputError where it is none.
        default: the argument of the name by itself; None where one must be given.
    """

    summary: str
    argument: str
    example: str
    member: Callable[[str], Member]
    default: str | None = None

    def choose(self, name: str, argument: str) -> Member:
        """Return the value of `name:argument`; raises InvalidInputError, also where an argument is wanting."""
        chosen = argument or self.default
        if chosen is None:
            raise InvalidInputError(f"'{name}' needs {self.argument} after a colon, such as {name}:{self.example}")
        return self.member(chosen)


@dataclass(frozen=True)
class _Entry(Generic[T]):
    value: T | Family[T]
    module: str


class Registry(Generic[T]):
    """Values of one kind by name.

    Attributes:
        kind: what a value is, in the singular ("agent").
        group: the entry-point group in which packages bring theirs.
    """

    def __init__(self, kind: str, group: str, check: Callable[[str, object], T]) -> None:
        """Begin empty.

        Args:
            kind: what a value is, in the singular.
            group: the entry-point group.
            check: returns what was found under a name if it is of the kind, and raises InvalidInputError if not.
        """
        self.kind = kind
        self.group = group
        self._check = check
        self._entries: dict[str, _Entry[T]] = {}

    def register(self, name: str, value: T | Family[T], module: str | None = None) -> T | Family[T]:
        """Add a value, or a family of values, under a name, and return it.

        Worker processes know only what a module registers when it is imported; give the others by reference.

        Raises:
            InvalidInputError: a name that is taken or that no command line could hold, or not a value of the kind.
        """
        if not _NAME.fullmatch(name):
            raise InvalidInputError(
                f"'{name}' cannot be the name of {_article(self.kind)}: use letters, digits, '_', '.' and '-' only"
            )
        if name in self._entries:
            raise InvalidInputError(f"there is {_article(self.kind)} '{name}' already; choose another name")
        self._entries[name] = self._new_entry(name, value, module or _module_of(value))
        return value

    def get(self, name: str) -> T:
        """Return the value of a name, of a family's name and argument, or of a reference "package.module:attribute".

        Raises:
            UnknownNameError: there is none; the message offers the nearest.
            UnimportableError: its module cannot be imported, or holds nothing of that name.
            InvalidInputError: what is there is no value of the kind, or the family has none of that argument.
        """
        value = self._entry(name).value
        if isinstance(value, Family):
            family, _, argument = name.partition(":")
            return self._check(name, value.choose(family, argument))
        return value

    def look_up(self, name: str) -> T | Family[T]:
        """Return what stands under a name: a value, or a family of them. Raises what `get` does."""
        return self._entry(name).value

    def names(self) -> tuple[str, ...]:
        """Return every name, built-in ones first; what packages bring is listed without importing it."""
        return (*self._entries, *self._brought())

    def sources(self) -> dict[str, str]:
        """Return from where each name is: "uniteam", or a package and its version, or a module."""
        own = {name: _source_of_module(entry.module) for name, entry in self._entries.items()}
        return own | {name: _source_of_entry_point(point) for name, point in self._brought().items()}

    def outside_code(self, name: str) -> str:
        """Return a digest of the code outside of uniteam that a value is made of; empty where it is uniteam's alone.

        That is the source of the package or module that it comes from, and of what it names in an `outside_modules` of
        its own, and the versions of the packages that it names in `libraries`. Takes and raises what `get` does.
        """
        value, module = self.get(name), self._entry(name).module
        tops = {each.partition(".")[0] for each in (module, *getattr(value, "outside_modules", ()))} - {"uniteam"}
        libraries = [f"{library} {_version(library)}" for library in getattr(value, "libraries", ())]
        parts = [*(_source_digest(top) for top in sorted(tops)), *libraries]
        return " ".join(parts)

    def _entry(self, name: str) -> _Entry[T]:
        """Return the entry of a name, with or without an argument, or of a reference; a family goes before a module."""
        own, colon, _ = name.partition(":")
        entry = self._entries.get(own)
        if entry is None and (point := self._brought().get(own)) is not None:
            entry = self._load(own, point.value)
        if entry is not None and (not colon or isinstance(entry.value, Family)):
            return entry
        if colon:
            return self._load(name, name)
        raise UnknownNameError(self.kind, name, self.names(), hint="or give one of your own as 'module:attribute'")

    def _load(self, name: str, reference: str) -> _Entry[T]:
        module_name, _, attribute = reference.partition(":")
        what = f"{self.kind} '{name}'" if name == reference else f"{self.kind} '{name}' ({reference})"
        return self._new_entry(name, _attribute(_module(module_name, what), attribute, what), module_name)

    def _new_entry(self, name: str, value: object, module: str) -> _Entry[T]:
        return _Entry(value if isinstance(value, Family) else self._check(name, value), module)

    def _brought(self) -> Mapping[str, EntryPoint]:
        """Return the entry points of installed packages; a built-in name is not theirs to take."""
        brought: dict[str, EntryPoint] = {}
        for point in entry_points(group=self.group):
            if point.name in self._entries or point.name in brought:
                _log.warning("%s brings %s '%s', which is taken", point.dist, _article(self.kind), point.name)
            else:
                brought[point.name] = point
        return brought


def _module(name: str, what: str) -> object:
    try:
        return import_module(name)
    except Exception as error:  # whatever a module of the user's raises while it is imported
        missing = isinstance(error, ModuleNotFoundError) and (error.name or "") == name.partition(".")[0]
        remedy = (
            "run from its folder, or put that on PYTHONPATH" if missing else "see that it can be imported by itself"
        )
        raise UnimportableError(f"{what} cannot be imported ({type(error).__name__}: {error}); {remedy}") from error


def _attribute(module: object, path: str, what: str) -> object:
    value = module
    for name in path.split("."):
        try:
            value = getattr(value, name)
        except AttributeError as error:
            public = ", ".join(n for n in vars(module) if not n.startswith("_"))
            raise UnimportableError(f"{what} names nothing: its module holds {public or 'nothing'}") from error
    return value


def _module_of(value: object) -> str:
    made_by = value.member if isinstance(value, Family) else value
    return str(getattr(made_by, "__module__", __name__))


def _source_of_module(module: str) -> str:
    return "uniteam" if module.partition(".")[0] == "uniteam" else module


def _source_of_entry_point(point: EntryPoint) -> str:
    return point.value if point.dist is None else f"{point.dist.name} {point.dist.version} ({point.value})"


def _source_digest(top: str) -> str:
    """Return a digest of all Python source of a top-level package or module."""
    spec = find_spec(top)
    roots = list(spec.submodule_search_locations or ()) if spec is not None else []
    files = [path for root in roots for path in sorted(Path(root).rglob("*.py"))]
    if not roots and spec is not None and spec.origin is not None and Path(spec.origin).is_file():
        files = [Path(spec.origin)]
    together = sha256()
    for path in files:
        together.update(sha256(path.read_bytes()).digest())
    return together.hexdigest()[:12]


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:
        return "missing"


def _article(noun: str) -> str:
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"
