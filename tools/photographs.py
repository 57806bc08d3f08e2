"""Name the photographs of things that a Debian package carries: a smoke test of perception `learned` on real pictures.

The package (GPL-2) is fetched, never shipped. Its stamps are cut out along the thing's outline, and there is neither
depth nor a room: this shows whether the namer knows anything beyond renders, and not what a robot would see.

    apt-get download tuxpaint-stamps-default
    python tools/photographs.py tuxpaint-stamps-default_*.deb
"""

import argparse
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.mind.perception.learned.crops import region_crop
from uniteam.mind.perception.learned.networks import WEIGHTS, Network, as_input, read_card
from uniteam.mind.perception.learned.region_shape import SHAPE_NUMBERS
from uniteam.mind.perception.words.meaning import load_words, plain_words

STAMPS = "usr/share/tuxpaint/stamps"
PHOTOGRAPHS = {
    "apple": ("apple_green", "apple_granny_smith", "apple_red", "apple_fuji", "apple_sierra_beauty"),
    "orange": ("orange", "orange_seville", "mandarine"),
    "lemon": ("lemon",),
    "tomato": ("tomato",),
    "cup": ("mug",),
    "pitcher": ("pitcher_small",),
    "kettle": ("kettle",),
    "scissors": ("scissors_small_closed", "scissors_small_open"),
    "saw": ("saw",),
    "pliers": ("plyers",),
    "sock": ("t_sock",),
    "glove": ("t_glove",),
    "ball": ("basketball", "soccer", "tennis_ball", "football", "cricketball"),
    "marker": ("pen_dryerase", "highlighter"),
    "banana": ("banana",),
    "pear": ("pear",),
    "carrot": ("carrot",),
    "teapot": ("teapot",),
    "hammer": ("hammer",),
    "camera": ("camera_35mm",),
    "trophy": ("trophy_cup",),
    "hat": ("t_baseballcap", "green_fedora", "blue_fedora", "tophat", "sombrero"),
}
"""By category, the names of the stamps that are photographs of one."""
FRAME, MARGIN = 240, 40
GREY = 150


def main() -> None:
    """Read the arguments, name every photograph, and print how many names were right."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package", type=Path, help="the Debian package tuxpaint-stamps-default")
    parser.add_argument("--weights", type=Path, default=WEIGHTS, help="folder of the networks")
    arguments = parser.parse_args()
    namer, card, words = Network(arguments.weights / "namer.onnx"), read_card(arguments.weights), load_words()
    trained = [plain_words(name) for name in card.names["object"]]
    names = [*trained, *(name for name in PHOTOGRAPHS if name not in trained)]
    vectors = np.stack([words.meaning(name).vector for name in names])
    ranks: dict[bool, list[int]] = {True: [], False: []}
    for category, stamp, rgb, mask in photographs(arguments.package):
        vector, _ = namer(as_input(region_crop(rgb, mask)[None]), np.zeros((1, SHAPE_NUMBERS), np.float32))
        order = np.argsort(-(vectors @ vector[0]), kind="stable")
        among = [k for k in order if names[k] in trained or names[k] == category]
        rank = among.index(names.index(category))
        ranks[category in trained].append(rank)
        print(f"{category:10} {stamp:24} rank {rank + 1:3}: {', '.join(names[k] for k in among[:4])}")
    for is_trained, of in ranks.items():
        kind = "categories of the training" if is_trained else "other categories"
        first, five = sum(rank == 0 for rank in of), sum(rank < 5 for rank in of)
        print(f"{kind}: {len(of)} photographs, first name right {first}, among the first five {five}")


def photographs(package: Path) -> Iterator[tuple[str, str, NDArray[np.uint8], NDArray[np.bool_]]]:
    """Yield category, stamp, (H, W, 3) picture before plain grey, and (H, W) mask of each photograph."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["dpkg-deb", "-x", str(package), folder], check=True)
        found = {p.stem: p for p in sorted(Path(folder, STAMPS).rglob("*.png")) if "cartoon" not in p.parts}
        for category, stamps in PHOTOGRAPHS.items():
            for stamp in stamps:
                yield category, stamp, *before_grey(cv2.imread(str(found[stamp]), cv2.IMREAD_UNCHANGED))


def before_grey(bgra: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.bool_]]:
    """Return an (H, W, 4) cut-out as a square picture with a margin, and its mask."""
    scale = (FRAME - 2 * MARGIN) / max(bgra.shape[:2])
    size = max(1, round(bgra.shape[1] * scale)), max(1, round(bgra.shape[0] * scale))
    small = cv2.resize(bgra, size, interpolation=cv2.INTER_AREA)
    top, left = (FRAME - size[1]) // 2, (FRAME - size[0]) // 2
    alpha = np.zeros((FRAME, FRAME, 1), np.float32)
    alpha[top : top + size[1], left : left + size[0]] = small[..., 3:] / np.float32(255.0)
    rgb = np.full((FRAME, FRAME, 3), GREY, np.float32)
    rgb[top : top + size[1], left : left + size[0]] = small[..., 2::-1]
    return np.asarray(alpha * rgb + (1.0 - alpha) * GREY).astype(np.uint8), alpha[..., 0] > 0.5


if __name__ == "__main__":
    main()
