"""Parts with two rest shapes: one strip for two drawn curves."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
