"""A miniature of the challenge's data in its own layout, made of homes of our generator and models of the pack."""
