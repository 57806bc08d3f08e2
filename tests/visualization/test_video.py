"""Films: what another reader finds in them, whole or cut off."""

import os
import subprocess
import sys
from pathlib import Path

import av
import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.filled import filled

from uniteam.errors import InvalidInputError
from uniteam.files import UnwritableError
from uniteam.visualization.video import VideoWriter

LEVELS = (40, 120, 200)


def colored(level: int) -> NDArray[np.uint8]:
    return np.full((240, 320, 3), (level, 0, 255 - level), np.uint8)


def frames(path: Path) -> list[NDArray[np.uint8]]:
    """Return the frames that OpenCV reads, RGB."""
    capture = cv2.VideoCapture(str(path))
    return [np.asarray(frame[..., ::-1], np.uint8) for ok, frame in iter(capture.read, (False, None)) if ok]


def boxes(path: Path) -> list[str]:
    """Return the names of the file's outermost boxes, in order (ISO 14496-12)."""
    content, names = path.read_bytes(), []
    while content:
        names.append(content[4:8].decode())
        content = content[int.from_bytes(content[:4]) or len(content) :]
    return names


def test_a_film_plays_back_as_it_was_written(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "film.mp4"
    video = VideoWriter(path, 320, 240, frames_per_second=10)
    for level in LEVELS:
        video.add(colored(level), repeat=2)
    video.close()
    read = frames(path)
    assert len(read) == 6
    assert cv2.VideoCapture(str(path)).get(cv2.CAP_PROP_FPS) == 10
    for frame, level in filled(zip(read[::2], LEVELS, strict=True)):
        assert frame[120, 160].astype(int) == pytest.approx([level, 0, 255 - level], abs=12)
    assert os.listdir(path.parent) == ["film.mp4"]  # noqa: PTH208


def test_a_film_is_what_browsers_play_with_its_index_at_the_beginning(tmp_path: Path) -> None:
    video = VideoWriter(tmp_path / "film.mp4", 320, 240)
    video.add(colored(40), repeat=50)
    video.close()
    with av.open(str(tmp_path / "film.mp4")) as film:
        assert film.streams.video[0].codec_context.name == "h264"
        assert film.streams.video[0].codec_context.pix_fmt == "yuv420p"
        assert film.streams.video[0].frames == 50
    found = boxes(tmp_path / "film.mp4")
    assert found.index("moov") < found.index("mdat")


def test_a_film_that_is_cut_off_plays_up_to_there(tmp_path: Path) -> None:
    path = tmp_path / "film.mp4"
    code = (
        "import os, sys\nimport numpy as np\nfrom pathlib import Path\n"
        "from uniteam.visualization.video import VideoWriter\n"
        "video = VideoWriter(Path(sys.argv[1]), 320, 240)\n"
        "for level in range(100):\n    video.add(np.full((240, 320, 3), level, np.uint8))\n"
        "os.kill(os.getpid(), 9)\n"
    )
    subprocess.run([sys.executable, "-c", code, str(path)], check=False)
    read = frames(path)
    assert 60 <= len(read) <= 100
    assert read[50].mean() == pytest.approx(50, abs=4)


@pytest.mark.parametrize("name", ["film.avi", "", ".", "folder.mp4"])
def test_a_film_of_another_kind_is_refused_in_words(tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("folder.mp4").mkdir()
    with pytest.raises(InvalidInputError, match=r"must end in \.mp4|is a folder"):
        VideoWriter(Path(name), 320, 240)


def test_a_film_that_cannot_be_written_is_refused_in_words(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(UnwritableError, match="cannot be written"):
        VideoWriter(tmp_path / "file" / "film.mp4", 320, 240)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no device that is always full")
def test_a_film_that_did_not_get_onto_the_disk_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "film.mp4").symlink_to("/dev/full")
    video = VideoWriter(tmp_path / "film.mp4", 320, 240)
    with pytest.raises(UnwritableError, match="No space left"):
        for _ in range(100):
            video.add(colored(40))
        video.close()
