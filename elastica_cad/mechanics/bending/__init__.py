"""Bending forward: from a rod and what is done to its ends to its rest shape."""
