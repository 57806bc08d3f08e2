"""The example of an agent elsewhere works as its first lines say, in a process of its own."""

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("grpc", reason="the extra 'serve' is not installed")

from examples.conftest import EXAMPLES
from worlds.served import Offer, serve, write_episodes

CLIENT = EXAMPLES.parent / "packages" / "uniteam_client"


def test_the_wanderer_plays_from_a_process_of_its_own(tmp_path: Path) -> None:
    def wander(address: str) -> str:
        script = f"import sys; sys.path[:0] = [{str(CLIENT)!r}]; sys.argv = ['wander', '{address}']; "
        script += f"import runpy; runpy.run_path({str(EXAMPLES / 'wander_remote.py')!r}, run_name='__main__')"
        return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout

    served = serve(Offer(write_episodes(tmp_path / "two.jsonl.gz", 2), tmp_path / "out"), [wander])
    assert [result.measures.num_steps for result in served.results.values()] == [41, 41]
    assert served.returned[0].splitlines() == [f"{name}: {r.failure}" for name, r in served.results.items()]
