"""Files are tried before the work and written whole."""

from pathlib import Path

import pytest

from uniteam.errors import InvalidInputError
from uniteam.files import UnwritableError, new_folder, try_folder, try_output, write_whole


def test_what_is_written_whole_replaces_what_was_there_and_leaves_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "figures.json"
    write_whole(path, b"old")
    write_whole(path, b"new")
    assert path.read_bytes() == b"new"
    assert list(tmp_path.iterdir()) == [path]


def test_a_link_stays_a_link_and_its_target_is_written(tmp_path: Path) -> None:
    (tmp_path / "target").write_bytes(b"old")
    (tmp_path / "link").symlink_to(tmp_path / "target")
    write_whole(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").read_bytes() == b"new"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no device that is always full")
def test_a_full_disk_is_told_and_a_device_is_never_replaced(tmp_path: Path) -> None:
    link = tmp_path / "full"
    link.symlink_to("/dev/full")
    with pytest.raises(UnwritableError, match=r"'.*full' cannot be written \(No space left on device\)"):
        write_whole(link, b"x" * 100_000)
    assert Path("/dev/full").is_char_device()


def test_an_output_is_tried_without_touching_what_it_holds(tmp_path: Path) -> None:
    path = tmp_path / "new" / "folder" / "bench.json"
    try_output(path)
    assert list(path.parent.iterdir()) == []
    path.write_text("kept")
    try_output(path)
    assert path.read_text() == "kept"


@pytest.mark.parametrize("name", ["", ".", "folder"])
def test_a_folder_is_no_file_to_write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.chdir(tmp_path)
    Path("folder").mkdir()
    with pytest.raises(InvalidInputError, match="is a folder; give the name of a file"):
        try_output(Path(name))


def test_a_name_of_another_ending_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match=r"must end in \.mp4"):
        try_output(tmp_path / "film.avi", (".mp4",))


@pytest.mark.parametrize("name", ["file/film.mp4", "x" * 300, "a\0b/c"])
def test_what_cannot_be_written_is_one_sentence(tmp_path: Path, name: str) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(UnwritableError, match="cannot be written"):
        try_output(tmp_path / name / "out.json")
    with pytest.raises(UnwritableError, match="cannot be written"):
        try_folder(tmp_path / name / "out")


def test_a_new_folder_is_there_whole_or_not_at_all(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError), new_folder(tmp_path / "a" / "new") as folder:
        (folder / "half").write_text("of it")
        raise ZeroDivisionError
    assert list((tmp_path / "a").iterdir()) == []
    with new_folder(tmp_path / "a" / "new") as folder:
        (folder / "file").write_text("all of it")
        assert not (tmp_path / "a" / "new").exists()
    assert [path.name for path in (tmp_path / "a").iterdir()] == ["new"]
    assert (tmp_path / "a" / "new" / "file").read_text() == "all of it"


def test_a_new_folder_takes_the_place_of_nothing(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    with pytest.raises(InvalidInputError, match="is there already"), new_folder(tmp_path / "mine"):
        pass
    (tmp_path / "file").touch()
    with pytest.raises(UnwritableError, match="cannot be written"), new_folder(tmp_path / "file" / "new"):
        pass
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "mine"]
