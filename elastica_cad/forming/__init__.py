"""Changes of a design: limits, the nearest rod within them, the methods of the paper, and curves from surfaces."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
