"""Strips in build123d: sketch objects, part objects, and an operation on pending edges."""

from importlib import import_module

from elastica_cad.kernel.ocp_import import library_trouble

try:
    import_module("build123d")
except ImportError as error:
    raise ImportError(
        f"elastica_cad.build123d needs build123d: {library_trouble('build123d', error)}"
    ) from error

from elastica_cad.build123d.strip_objects import (
    AngleSlider,
    BentStrip,
    EndFixture,
    FlatStrip,
    FlexurePart,
    PlacedStrip,
    Slider,
    StripOutline,
)
from elastica_cad.build123d.strip_operations import Elastica, elastic_strip, model_compound, section_strips
from elastica_cad.kernel.strip_body import StripWarning

__all__ = [
    "AngleSlider",
    "BentStrip",
    "Elastica",
    "EndFixture",
    "FlatStrip",
    "FlexurePart",
    "PlacedStrip",
    "Slider",
    "StripOutline",
    "StripWarning",
    "elastic_strip",
    "model_compound",
    "section_strips",
]
