"""Plane sections of triangle meshes, and the curves fitted to them."""
