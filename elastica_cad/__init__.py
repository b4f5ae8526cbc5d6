"""Strips that are cut flat and bend into a drawn curve."""
