"""How jobs are done: worker processes, what runs inside them, and how many there is room for."""
