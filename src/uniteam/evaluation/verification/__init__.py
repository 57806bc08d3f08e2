"""Whether results that somebody hands in are what comes of the actions that were recorded with them."""
