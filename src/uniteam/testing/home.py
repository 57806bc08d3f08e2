"""Check a home, or a source of homes."""

from pathlib import Path
from tempfile import TemporaryDirectory

from uniteam.geometry import BasePose
from uniteam.interface import DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.testing.failure import CheckFailedError, called, name_of
from uniteam.world.assets.verify import library_problems
from uniteam.world.generation.registry import HOMES, HomeSource
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import check_home as check_fields
from uniteam.world.homes.serialization import home_digest, read_home, write_home
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor
from uniteam.world.simulation.graspable import TAKE_NOTHING
from uniteam.world.simulation.simulator import Simulator

ROOM_TO_STAND = 0.5
"""The robot's centre reaches at least so much of the floor (m2)."""


def check_home(home: Home | HomeSource | str, seed: int = 0) -> None:
    """Check that a home, or the homes of a source, can be used for all that homes are used for.

    - Its fields are what a file could say: sound outlines, unique names, models that its library has.
    - The library's files are there and unchanged.
    - The robot fits in somewhere, and there is something to see for it.
    - It is the same home after it was written into a file and read again.
    - Of a source: the same seed gives the same home, whatever was made in between; another seed, another name.

    In a test of your own:

        def test_my_loft() -> None:
            check_home("my_package.my_homes:loft")

        def test_the_home_of_my_scan() -> None:
            check_home(read_home(Path("scan.json")))

    Args:
        home: a home, or what makes one of a seed: a name, a reference "module:function", or a function.
        seed: of a source, the first seed that is tried; the next one is tried too.

    Raises:
        CheckFailedError: what is wrong with the home.
        UnknownNameError: there is no source of this name.
    """
    if isinstance(home, Home):
        _check_one(home, f"home '{home.name}'")
        return
    make = HOMES.get(home) if isinstance(home, str) else home
    name = f"source of homes '{name_of(home)}'"
    first = _made(make, seed, name)
    _check_one(first, f"{name}: home '{first.name}'")
    _check_source(make, seed, name, first)


def _made(make: HomeSource, seed: int, name: str) -> Home:
    home = called(f"{name}: making the home of seed {seed}", lambda: make(seed))
    if not isinstance(home, Home):
        raise CheckFailedError(f"{name} returned a {type(home).__name__} for seed {seed}; it must return a Home")
    return home


def _check_source(make: HomeSource, seed: int, name: str, first: Home) -> None:
    other, again = _made(make, seed + 1, name), _made(make, seed, name)
    if other.name == first.name:
        raise CheckFailedError(
            f"{name} gives the homes of the seeds {seed} and {seed + 1} the same name, '{first.name}'; "
            "a split tells its homes by their names"
        )
    if home_digest(first) != home_digest(again):
        what = "name" if first.name != again.name else "stage" if first.stage != again.stage else "instances"
        raise CheckFailedError(f"{name} makes another home of seed {seed} when it is asked again: its {what} differ")


def _check_one(home: Home, name: str) -> None:
    called(f"{name}: its fields", lambda: check_fields(home))
    problem = called(f"{name}: its library", lambda: next(library_problems(home.library), None))
    if problem is not None:
        raise CheckFailedError(f"{name}: its library lacks something: {problem}")
    _check_robot_fits(home, name)
    _check_file(home, name)


def _check_robot_fits(home: Home, name: str) -> None:
    floor = called(f"{name}: its floor", lambda: NavigableFloor(home))
    cells = floor.largest_component.nonzero()
    area = len(cells[0]) * CELL_SIZE**2
    if area < ROOM_TO_STAND:
        raise CheckFailedError(
            f"{name}: the robot's centre reaches {area:.2f} m2 of its floor, less than {ROOM_TO_STAND} m2; "
            "leave more room between walls and furniture"
        )
    middle = len(cells[0]) // 2
    x, y = floor.to_point(int(cells[0][middle]), int(cells[1][middle]))
    simulator = called(f"{name}: building it in the simulator", lambda: Simulator(home, HEAD_CAMERA_HALF))
    simulator.reset(BasePose(x, y, 0.0))
    called(f"{name}: a first step in it", lambda: simulator.apply(DiscreteAction.TURN_LEFT, TAKE_NOTHING))
    if not (called(f"{name}: a first look", simulator.render).depth > 0.0).any():
        raise CheckFailedError(f"{name}: the camera sees nothing at all from ({x:.2f}, {y:.2f}); are there walls?")


def _check_file(home: Home, name: str) -> None:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "home.json"
        called(f"{name}: writing it into a file", lambda: write_home(home, path))
        back = called(f"{name}: reading it from its file", lambda: read_home(path))
    if home_digest(back) != home_digest(home):
        raise CheckFailedError(f"{name} is another home once it was written into a file and read again")
