"""Homes as files for other programs: a MuJoCo model, and one glTF binary."""
