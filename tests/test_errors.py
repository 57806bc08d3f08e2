"""An error of the package is one sentence, whatever it quotes."""

import pickle

import pytest

from uniteam.errors import InvalidInputError, UniteamError, UnknownNameError


@pytest.mark.parametrize(
    ("quoted", "written"), [("a\nb", "a\\nb"), ("\x1b[31m", "\\x1b[31m"), ("\udc80", "\\udc80"), ("Stühle", "Stühle")]
)
def test_what_an_error_quotes_stays_in_its_line_and_can_be_printed(quoted: str, written: str) -> None:
    assert str(InvalidInputError(f"'{quoted}' is no name")) == f"'{written}' is no name"
    assert f"unknown agent '{written}'" in str(UnknownNameError("agent", quoted, ["baseline"]))


def test_an_error_that_was_sent_says_the_same() -> None:
    error = UniteamError("'a\nb' is no name")
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
