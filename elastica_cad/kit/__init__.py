"""Kits: folders with all files of a strip or a model."""
