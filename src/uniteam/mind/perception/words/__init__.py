"""What words mean: a table of names, other words for them, and descriptions of rare ones."""
