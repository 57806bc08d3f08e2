"""A home, or a source of homes, that cannot be used is told why."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from worlds.own_home import made_home
from worlds.small_home import small_home

from uniteam.testing import CheckFailedError, check_home
from uniteam.world.homes.home import Home, Instance


@pytest.fixture(scope="module")
def loft(tmp_path_factory: pytest.TempPathFactory) -> Home:
    return made_home(tmp_path_factory.mktemp("loft"))


def with_first(home: Home, **changes: Any) -> Home:
    """Return the home with its first instance changed."""
    first, *rest = home.instances
    return replace(home, instances=(replace(first, **changes), *rest))


def walled_in(home: Home) -> Home:
    """Return the home full of tables."""
    table = home.instances[0]
    many = tuple(
        replace(table, name=f"table_{k}", position=(0.9 * (k % 7), 0.65 * (k // 7), 0.0)) for k in range(10, 73)
    )
    return replace(home, instances=many)


def test_a_sound_home_passes_and_so_does_a_source_of_it(loft: Home) -> None:
    check_home(loft)
    check_home(lambda seed: replace(loft, name=f"loft-{seed}", seed=seed))


def test_a_home_that_cannot_be_used_is_told_why(loft: Home) -> None:
    unseen = replace(loft.library, unseen_categories=frozenset({"cup"}))
    for home, sentence in (
        (
            with_first(loft, model="own_tabel"),
            r"its fields raised .*unknown model 'own_tabel': did you mean 'own_table'",
        ),
        (with_first(loft, position=(np.nan, 0.0, 0.0)), r"its fields raised .*position"),
        (small_home(), r"its library lacks something: .*table\.glb is missing"),
        (walled_in(loft), r"the robot's centre reaches 0\.\d\d m2 of its floor"),
        (replace(loft, stage=replace(loft.stage, mesh=Path("no.glb"))), r"its fields raised .*no\.glb"),
        (replace(loft, library=unseen), "is another home once it was written into a file and read again"),
        (
            replace(loft, library=replace(loft.library, folder=None)),
            "writing it into a file raised .*in no folder",
        ),
    ):
        with pytest.raises(CheckFailedError, match=sentence):
            check_home(home)


def test_a_source_that_cannot_be_relied_on_is_told_why(loft: Home) -> None:
    made: list[int] = []

    def shuffled(seed: int) -> Home:
        x = float(np.random.default_rng().uniform(3.9, 4.1))
        return replace(with_first(loft, position=(x, 2.5, 0.0)), name=f"loft-{seed}")

    def counting(seed: int) -> Home:
        made.append(seed)
        return replace(loft, name=f"loft-{len(made)}")

    def absent(seed: int) -> Home:
        return None  # type: ignore[return-value]

    def broken(seed: int) -> Home:
        raise KeyError("door")

    for source, sentence in (
        (shuffled, "makes another home of seed 0 when it is asked again: its instances differ"),
        (counting, "makes another home of seed 0 when it is asked again: its name differ"),
        (lambda seed: loft, "gives the homes of the seeds 0 and 1 the same name, 'loft'"),
        (absent, "returned a NoneType for seed 0; it must return a Home"),
        (broken, r"making the home of seed 0 raised KeyError: 'door'"),
    ):
        with pytest.raises(CheckFailedError, match=sentence):
            check_home(source)


def test_an_instance_is_no_home(loft: Home) -> None:
    instance: Instance = loft.instances[0]
    with pytest.raises(CheckFailedError, match="not callable"):
        check_home(instance)  # type: ignore[arg-type]
