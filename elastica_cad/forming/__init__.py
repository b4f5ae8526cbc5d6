"""Design changes: limits, the nearest rod that meets them, the paper's methods, and curves from surfaces."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
