"""Where the files of a LeRobotDataset lie, version 3.0 (lerobot 0.6, `lerobot.datasets.utils`)."""

from dataclasses import dataclass

VERSION = "v3.0"
FRAMES_PER_SECOND = 10
"""As films of uniteam have them. A step has no duration of its own in the simulator's time: it is counted as 0.1 s."""

FILES_PER_CHUNK = 1000
DATA_FILE_MB, VIDEO_FILE_MB = 100, 200
"""An episode begins a new file where the last one is larger."""

DATA_PATH = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
VIDEO_PATH = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
EPISODES_FILE = "meta/episodes/chunk-000/file-000.parquet"
TASKS_FILE, INFO_FILE, STATS_FILE = "meta/tasks.parquet", "meta/info.json", "meta/stats.json"


@dataclass(frozen=True)
class FileNumber:
    """One file of a series.

    Attributes:
        chunk: number of its folder.
        file: its number there.
    """

    chunk: int
    file: int

    def next(self) -> "FileNumber":
        """Return the one after it."""
        if self.file + 1 == FILES_PER_CHUNK:
            return FileNumber(self.chunk + 1, 0)
        return FileNumber(self.chunk, self.file + 1)


def data_file(number: FileNumber) -> str:
    """Return where a file of steps lies in the dataset."""
    return DATA_PATH.format(chunk_index=number.chunk, file_index=number.file)


def video_file(key: str, number: FileNumber) -> str:
    """Return where a film of a feature lies in the dataset."""
    return VIDEO_PATH.format(video_key=key, chunk_index=number.chunk, file_index=number.file)
