"""What other systems lack is not needed to import the package."""

import subprocess
import sys

CODE = """
import os, signal, sys
sys.modules["resource"] = sys.modules["fcntl"] = None
for name in ("pthread_sigmask", "SIGHUP", "SIGKILL"):
    delattr(signal, name)
for name in ("sysconf", "sysconf_names", "sched_getaffinity", "getuid"):
    delattr(os, name)
import pathlib, tempfile
from uniteam.cli import bench, doctor, evaluate, run
from uniteam.evaluation.backends.capacity import allowed_cores, most_workers
from uniteam.evaluation.memory import peak_memory
from uniteam.evaluation.results.lock import FolderLock
assert allowed_cores() >= 1 and most_workers() >= 1
FolderLock(pathlib.Path(tempfile.mkdtemp())).release()
print(peak_memory())
"""


def test_the_package_can_be_imported_without_what_windows_lacks() -> None:
    done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True)
    assert done.stderr.strip() == "this system has no file locks: start no second run in the same folder"
    assert float(done.stdout) >= 0.0
