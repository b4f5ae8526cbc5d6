"""Strips as flat parts: styles, outlines, slots, drawings, solids, and limits of fabrication."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
