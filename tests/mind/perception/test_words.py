"""What words mean: names, other words for them, phrases, and what is spelled nearly so."""

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.errors import UnknownNameError
from uniteam.mind.perception.words import encoder
from uniteam.mind.perception.words.meaning import DIMENSIONS, Words, load_words, plain_words
from uniteam.world.assets.catalogue import load_catalogue


@pytest.mark.parametrize(
    ("phrase", "name"),
    [
        ("cup", "cup"),
        ("mug", "cup"),
        ("Coffee_Mugs", "cup"),
        ("the red coffee mug", "cup"),
        ("a mug of tea", "cup"),
        ("chest_of_drawers", "chest of drawers"),
        ("dresser", "chest of drawers"),
        ("pair of scissors", "scissors"),
        ("sofa", "couch"),
        ("glass", "glass"),
        ("glasses", "spectacles"),
        ("dishes", "plate"),
        ("teddybear", "stuffed toy"),
        ("umbrela", "umbrella"),
        ("box for shoes", "box"),
        ("giraffe", "giraffe"),
    ],
)
def test_a_phrase_is_taken_for_a_name(phrase: str, name: str) -> None:
    assert load_words().meaning(phrase).name == name


def test_every_category_of_the_pack_means_itself() -> None:
    categories = {model.category for model in load_catalogue().models.values()}
    for category in filled(categories):
        assert load_words().meaning(category).name == plain_words(category)


def test_vectors_are_of_unit_length_and_near_where_the_meaning_is() -> None:
    cup, glass, hammer = (load_words().meaning(name).vector for name in ("cup", "glass", "hammer"))
    assert cup.shape == (DIMENSIONS,) and cup.dtype == np.float32
    assert np.linalg.norm(cup) == pytest.approx(1.0, abs=1e-3)
    assert cup @ glass > cup @ hammer + 0.1


def test_an_unknown_word_is_refused_unless_an_encoder_reads_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(encoder, "find_spec", lambda name: None)
    with pytest.raises(UnknownNameError, match=r"zzyzx.*uniteam\[words\]"):
        load_words().meaning("zzyzx qwghlm")
    vector = np.eye(DIMENSIONS, dtype=np.float32)[0]
    words = Words({"cup": vector}, {}, lambda phrase: -vector)
    assert (words.meaning("zzyzx").vector == -vector).all()
    assert (words.meaning("cup").vector == vector).all()


def test_an_exact_name_goes_before_another_word_for_something_else() -> None:
    one, other = np.eye(DIMENSIONS, dtype=np.float32)[:2]
    words = Words({"glass": one, "cup": other}, {"glass": "glass", "cup": "cup", "tumbler": "glass"})
    assert (words.meaning("glass").vector == one).all()
    assert (words.meaning("tumbler").vector == one).all()


def test_pieces_of_words_are_the_longest_that_are_known() -> None:
    pieces = {"[UNK]": 0, "tea": 1, "##pot": 2, "##po": 3, "##s": 4, "-": 5}
    assert encoder.pieces_of("Teapots - tea", pieces) == [1, 2, 4, 5, 1]
    assert encoder.pieces_of("teaz tea", pieces) == [1, 0, 1]


@pytest.mark.skipif(not encoder.is_installed(), reason="needs the extra 'words'")
def test_the_encoder_reads_what_the_table_lacks() -> None:
    nearest = max(("bed", "hammer", "apple"), key=lambda name: load_words().meaning(name).vector @ found())
    assert nearest == "bed"


def found() -> np.ndarray:
    vector = encoder.encode("somewhere to sleep")
    assert vector is not None
    return vector
