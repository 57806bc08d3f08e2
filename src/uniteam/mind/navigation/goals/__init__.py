"""What to head for: frontiers, objects, receptacles, and where to stand before them."""
