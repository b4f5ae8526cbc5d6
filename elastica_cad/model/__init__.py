"""Models of several strips: interlocking, plates, fixtures, nesting, cut list, battens."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
