"""The report of runs as one page that a browser opens from the disk, without a network."""
