"""Surfaces in files, whatever their kind."""
