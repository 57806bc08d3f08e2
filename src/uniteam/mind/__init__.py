"""The agents: perception, map, navigation, manipulation, and the state machine that joins them."""
