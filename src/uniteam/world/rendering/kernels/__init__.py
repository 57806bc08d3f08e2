"""The renderer's compiled inner loops, and the arrays that they read and write."""
