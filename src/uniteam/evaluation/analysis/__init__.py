"""What is made of results: the challenge's table."""
