"""The simulated world: homes, a robot in them, episodes, and the oracle that certifies these."""
