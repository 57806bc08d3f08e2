"""The challenge's own episodes as a split: HomeRobot's OVMM files."""
