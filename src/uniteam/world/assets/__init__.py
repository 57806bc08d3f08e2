"""Libraries of models and textures, and how their files are read."""
