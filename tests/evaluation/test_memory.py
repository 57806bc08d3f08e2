"""What a process says of its memory is its own."""

import subprocess
import sys

import numpy as np
import pytest

from uniteam.evaluation.memory import peak_memory


@pytest.mark.skipif(sys.platform != "linux", reason="other systems tell nothing but what getrusage does")
def test_a_process_does_not_count_the_memory_of_the_one_that_started_it() -> None:
    large = np.ones(60_000_000)
    assert peak_memory() > large.nbytes / 1e6
    code = "from uniteam.evaluation.memory import peak_memory; print(peak_memory())"
    child = float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
    assert 5.0 < child < 300.0
