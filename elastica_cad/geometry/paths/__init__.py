"""Chains of lines, arcs and splines: offsets, trims, crossings, and numbers along a strip."""
