"""Parts with two rest shapes: two drawn curves, one strip."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
