"""The tables of a dataset as Parquet: the steps, the episodes, the tasks."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.lerobot.layout import DATA_FILE_MB, FileNumber, data_file
from uniteam.errors import UnavailableError

try:
    import pyarrow as pa
    import pyarrow.parquet as pq
except ImportError as error:
    raise UnavailableError(
        f"a dataset of LeRobot needs pyarrow ({error}); install it with pip install 'uniteam[lerobot]'"
    ) from error


class StepTable:
    """Takes the rows of episodes in; a group of rows each, a new file once one is large."""

    def __init__(self, root: Path) -> None:
        """Begin without a file, in the folder of a dataset."""
        self._root = root
        self._number: FileNumber | None = None
        self._writer: Any = None
        self._bytes = 0

    def add(self, columns: Mapping[str, NDArray[Any]]) -> FileNumber:
        """Append the rows of an episode, (T,) or (T, D) by column, and return the file that they are in."""
        table = pa.table({name: _column(values) for name, values in columns.items()})
        if self._number is None:
            self._open(FileNumber(0, 0), table.schema)
        elif self._bytes >= DATA_FILE_MB << 20:
            self.close()
            self._open(self._number.next(), table.schema)
        self._writer.write_table(table)
        self._bytes += table.nbytes
        assert self._number is not None, "it has been opened"
        return self._number

    def close(self) -> None:
        """Finish the file."""
        if self._writer is not None:
            self._writer.close()
            self._writer = None

    def _open(self, number: FileNumber, schema: Any) -> None:
        path = self._root / data_file(number)
        path.parent.mkdir(parents=True, exist_ok=True)
        self._writer = pq.ParquetWriter(path, schema, compression="snappy", use_dictionary=True)
        self._number, self._bytes = number, 0


def _column(values: NDArray[Any]) -> Any:
    if values.ndim == 1:
        return pa.array(values)
    return pa.FixedSizeListArray.from_arrays(pa.array(values.ravel()), values.shape[1])


def write_episodes(path: Path, episodes: Sequence[Mapping[str, Any]]) -> None:
    """Write one row an episode, all with the same columns."""
    path.parent.mkdir(parents=True, exist_ok=True)
    pq.write_table(pa.Table.from_pylist([dict(episode) for episode in episodes]), path, compression="snappy")


def write_tasks(path: Path, tasks: Sequence[str]) -> None:
    """Write the instructions, each with its number.

    LeRobot reads them as a frame of pandas whose index they are; the file says so, in the words of pandas.
    """
    table = pa.table({"task_index": np.arange(len(tasks), dtype=np.int64), "task": pa.array(list(tasks), pa.string())})
    described = {
        "index_columns": ["task"],
        "column_indexes": [],
        "columns": [
            {"name": "task_index", "field_name": "task_index", "pandas_type": "int64", "numpy_type": "int64"},
            {"name": "task", "field_name": "task", "pandas_type": "unicode", "numpy_type": "object"},
        ],
        "pandas_version": "2.0.0",
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    pq.write_table(table.replace_schema_metadata({"pandas": json.dumps(described)}), path, compression="snappy")
