"""The simulator in place of a Stretch: behind the bridge's four ports, and behind the calls of stretch_body."""
