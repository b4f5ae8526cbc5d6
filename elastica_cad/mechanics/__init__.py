"""Rods and what holds them: materials, balance, Theorem 1, optimal stiffness, bending, stability."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
