"""Readers and writers of files: curves, drawings, surfaces and meshes."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
