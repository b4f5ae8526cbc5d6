"""Methods of the code published with the paper, for comparisons only; no other module imports them."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
