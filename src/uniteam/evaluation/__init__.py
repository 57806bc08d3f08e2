"""Playing agents over a split: the loop of an episode, worker processes, results and the table of the measures."""
