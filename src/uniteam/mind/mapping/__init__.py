"""The map: from frames to what is known of the floor from above."""
