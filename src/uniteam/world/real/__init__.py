"""A real Stretch as a body: through the bridge of stretch_ai on the network, or on the robot through stretch_body."""
