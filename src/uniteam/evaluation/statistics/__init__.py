"""What figures may be said to show: tests, intervals and power, for plain arrays of numbers."""
