"""Scattering objects on furniture, and letting them come to rest."""
