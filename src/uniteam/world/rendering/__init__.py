"""What the head camera sees: colour, depth, and which instance each pixel shows."""
