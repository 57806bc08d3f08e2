"""How the networks of perception `learned` are made: views, crops, training, export, measurement."""
