"""Where the base can stand, and how objects fall and rest."""
