"""Houses of ProcTHOR, furnished with our models in the places of theirs."""
