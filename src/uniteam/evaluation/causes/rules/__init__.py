"""The rules by what they are about; `decide` has them in their order."""
