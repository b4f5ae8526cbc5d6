"""Reading and writing of design files, and reports as plain data for JSON."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
