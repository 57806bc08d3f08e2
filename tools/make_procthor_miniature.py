"""Write two small houses of our own in the layout of ProcTHOR-10k, to try the reader with.

python tools/make_procthor_miniature.py /tmp/procthor
uniteam home 0 --source procthor:/tmp/procthor/houses.jsonl.gz
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "tests"))

from worlds.procthor_miniature import write_miniature


def main() -> None:
    """Write the miniature into the folder that is given."""
    if len(sys.argv) != 2:
        sys.exit(f"give the folder to write into: python {sys.argv[0]} /tmp/procthor")
    print(write_miniature(Path(sys.argv[1])))


if __name__ == "__main__":
    main()
