"""Rods, their materials, loads and supports; Theorem 1, optimal stiffness, bending and stability."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
