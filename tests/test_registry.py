"""Names, and names with an argument."""

import sys
from pathlib import Path

import pytest

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.registry import Family, Registry, UnimportableError


def word(name: str, value: object) -> str:
    """Return what was found where it is text."""
    if not isinstance(value, str):
        raise InvalidInputError(f"word '{name}' must be text, got {type(value).__name__}")
    return value


def louder(argument: str) -> str:
    return argument.upper()


@pytest.fixture
def words() -> Registry[str]:
    """A registry of a word, of a family that needs an argument, and of one that has a default."""
    registry: Registry[str] = Registry("word", "uniteam.tests.words", word)
    registry.register("plain", "plain")
    registry.register("loud", Family("louder words", "WORD", "hello", louder))
    registry.register("often", Family("words twice", "WORD", "hello", lambda w: w * 2, default="yes"))
    return registry


def test_an_argument_chooses_a_value_of_the_family(words: Registry[str]) -> None:
    assert words.get("loud:hello") == "HELLO"
    assert words.get("loud:a:b") == "A:B"
    assert words.get("often:no") == "nono"


def test_a_family_without_an_argument_takes_its_default_or_asks_for_one(words: Registry[str]) -> None:
    assert words.get("often") == words.get("often:") == "yesyes"
    with pytest.raises(InvalidInputError, match="'loud' needs WORD after a colon, such as loud:hello"):
        words.get("loud")


def test_what_a_family_makes_is_checked(words: Registry[str]) -> None:
    words.register("broken", Family("numbers", "N", "1", lambda n: int(n)))  # type: ignore[arg-type, return-value]
    with pytest.raises(InvalidInputError, match="word 'broken:1' must be text, got int"):
        words.get("broken:1")


def test_a_family_is_looked_up_without_choosing(words: Registry[str]) -> None:
    family = words.look_up("loud")
    assert isinstance(family, Family) and family.summary == "louder words"
    assert words.look_up("plain") == "plain"
    assert words.names() == ("plain", "loud", "often")


def test_a_name_that_is_no_family_leaves_the_colon_to_references(
    words: Registry[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "plain.py").write_text("mine = 'my own'\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "plain", raising=False)
    assert words.get("plain:mine") == "my own"
    with pytest.raises(UnimportableError, match="names nothing"):
        words.get("plain:yours")


def test_an_unknown_name_is_answered_with_the_nearest(words: Registry[str]) -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'loud'"):
        words.get("lound")
