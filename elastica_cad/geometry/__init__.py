"""Plane curves, paths of line, arc and spline segments, offsets, and functions along a strip."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
