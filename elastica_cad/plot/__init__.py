"""Pictures of rods, strips, drawings, models and bodies, drawn by matplotlib."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
