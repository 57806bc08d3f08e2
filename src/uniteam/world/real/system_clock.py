"""The machine's own time."""

import time


class SystemClock:
    """Time that passes by itself, and never goes back."""

    def now(self) -> float:
        """Return seconds since some moment."""
        return time.monotonic()

    def sleep(self, seconds: float) -> None:
        """Wait."""
        time.sleep(seconds)
