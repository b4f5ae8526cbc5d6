"""Changes of a drawn curve: the nearest rod within limits, the methods of the paper, and curves from surfaces."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
