"""Where to go and how: goals, and plans that lead to them."""
