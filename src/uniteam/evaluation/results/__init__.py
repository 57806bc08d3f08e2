"""Results of episodes: as values, as files that can be taken up again, and summed up."""
