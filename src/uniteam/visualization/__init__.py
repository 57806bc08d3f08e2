"""Films, maps and pictures for people."""
