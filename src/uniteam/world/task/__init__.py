"""The task: episodes and their files, the environment they are played in, and the measures."""
