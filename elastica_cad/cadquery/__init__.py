"""Strips in CadQuery: free functions, and methods of Workplane and Sketch after `register()`."""

from importlib import import_module

from elastica_cad.kernel.ocp_import import library_trouble

try:
    import_module("cadquery")
except ImportError as error:
    raise ImportError(
        f"elastica_cad.cadquery needs CadQuery: {library_trouble('cadquery', error)}"
    ) from error

from elastica_cad.cadquery.strip_operations import (
    Sketch,
    Workplane,
    elastica,
    model_assembly,
    register,
    section_strips,
)
from elastica_cad.cadquery.strip_shapes import (
    FixtureSolid,
    FlexureSolid,
    Slider,
    StripCompound,
    StripFace,
    StripSolid,
    bent_strip,
    end_fixture,
    flat_strip,
    flexure_solid,
    strip_outline,
)
from elastica_cad.kernel.strip_body import StripWarning

__all__ = [
    "FixtureSolid",
    "FlexureSolid",
    "Sketch",
    "Slider",
    "StripCompound",
    "StripFace",
    "StripSolid",
    "StripWarning",
    "Workplane",
    "bent_strip",
    "elastica",
    "end_fixture",
    "flat_strip",
    "flexure_solid",
    "model_assembly",
    "register",
    "section_strips",
    "strip_outline",
]
