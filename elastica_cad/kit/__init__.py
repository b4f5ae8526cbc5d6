"""Kits: folders with all files of a strip or of a whole model."""
