"""Write a miniature of the challenge's data, in its own layout, to try the readers with: two homes, four episodes.

pip install '.[test]' && python tools/make_ovmm_miniature.py /tmp/miniature
uniteam data check /tmp/miniature/data/datasets/ovmm/minival
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "tests"))

from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.miniature import original, write_miniature


def main() -> None:
    """Write the miniature into the folder that is given."""
    if len(sys.argv) != 2:
        sys.exit(f"give the folder to write into: python {sys.argv[0]} /tmp/miniature")
    print(write_miniature(original(), Path(sys.argv[1]), Ktx2Pictures()))


if __name__ == "__main__":
    main()
