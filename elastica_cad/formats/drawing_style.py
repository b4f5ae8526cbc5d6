"""Style of drawings in files: curves as splines, arcs or polylines; names and colours of layers."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from elastica_cad._values import is_number
from elastica_cad.errors import InputError, Length, quoted
from elastica_cad.geometry.approximations import as_arcs, as_beziers, as_cubics, as_polyline
from elastica_cad.geometry.path import Path, require_tolerance_mm
from elastica_cad.mechanics.sheets import require_name
from elastica_cad.strip.drawing import CUT_INNER, CUT_OUTER, ENGRAVE, LAYERS, MARK, SHEET

CURVES = ("spline", "bezier", "arc", "polyline")

EXACT = "exact"
"""Curve style for CAD programs: splines of any degree are unchanged."""

_SPLINE_TOLERANCE_MM = 1e-3
"""Largest tolerance of approximated splines, mm. A larger tolerance would hardly make files smaller."""

FINEST_MM = 1e-5
"""Smallest tolerance of arcs and polylines, mm. A smaller tolerance would only make files larger."""


def check_curve_style(curves: str) -> str:
    """Return the name of a curve style. Raise InputError if it is neither in `CURVES` nor `EXACT`."""
    if not isinstance(curves, str) or curves not in (*CURVES, EXACT):
        raise InputError(
            "curves is {curves!r}: use one of {curves_2}", curves=curves, curves_2=", ".join(CURVES)
        )
    return curves


def shape_paths(paths: Iterable[Path], curves: str, tolerance: float, *, rational: bool = True) -> list[Path]:
    """Convert paths to a curve style: splines up to degree 3, joined Bezier curves, arcs, or lines.

    Splines have weights only if `rational` is True. With the style `EXACT` and `rational`, splines of any
    degree are unchanged.
    """
    if not is_number(tolerance):
        raise InputError(
            "the tolerance is {tolerance!r}: give a number of mm, such as 0.02", tolerance=tolerance
        )
    if curves == EXACT and rational:
        return list(paths)
    if 0 < tolerance < FINEST_MM and curves in ("arc", "polyline"):
        raise InputError(
            "the tolerance is {tolerance:g}, finer than any machine cuts: set at least {finest_mm:g}",
            tolerance=Length(tolerance),
            finest_mm=Length(FINEST_MM),
        )
    if curves in ("spline", "bezier", EXACT):
        finest = _SPLINE_TOLERANCE_MM if curves == EXACT else min(tolerance, _SPLINE_TOLERANCE_MM)
        require_tolerance_mm(finest)
        cubic = [as_cubics(path, finest, rational=rational) if path.has_splines else path for path in paths]
        return [as_beziers(path) for path in cubic] if curves == "bezier" else cubic
    return [(as_arcs if curves == "arc" else as_polyline)(path, tolerance) for path in paths]


@dataclass(frozen=True)
class LayerStyle:
    """Name and colour of a layer in a file.

    Parameters
    ----------
    name : str
        Name without characters that CAD programs refuse.
    color : str
        "#rrggbb".
    """

    name: str
    color: str

    def __post_init__(self) -> None:
        name = require_name(self.name, "the name of a layer")
        if not name.strip() or re.search(r'[<>/\\":;?*|=`]', name) or len(name) > 255:
            raise InputError("{name!r} is not a layer name: use letters, digits, spaces, - and _", name=name)
        if not isinstance(self.color, str) or not re.fullmatch(r"#[0-9a-fA-F]{6}", self.color):
            raise InputError(
                "{color!r} is not a colour for layer {name!r}: write it as #rrggbb",
                color=self.color,
                name=self.name,
            )
        vars(self).update(name=name, color=self.color.lower())

    @property
    def rgb(self) -> tuple[int, int, int]:
        """Red, green and blue, 0 to 255."""
        return int(self.color[1:3], 16), int(self.color[3:5], 16), int(self.color[5:7], 16)


LayerChoice: TypeAlias = str | tuple[str, str] | LayerStyle


def _scheme(*colors: str) -> dict[str, LayerStyle]:
    layers = (CUT_OUTER, CUT_INNER, ENGRAVE, MARK, SHEET)
    return {layer: LayerStyle(layer, color) for layer, color in zip(layers, colors, strict=True)}


SCHEMES = {
    "elastica": _scheme("#ff0000", "#0000ff", "#000000", "#00ff00", "#808080"),
    # colours of boxes.py: outer cuts black, inner cuts blue, etching green and cyan, annotations red
    "boxes": _scheme("#000000", "#0000ff", "#00ff00", "#00ffff", "#ff0000"),
    # colours of LightBurn's layers C00 to C03, and of its tool layer T1, which is never cut
    "lightburn": _scheme("#ff0000", "#0000ff", "#000000", "#00e000", "#f36926"),
}
"""Colour schemes for programs in which the colour of a line selects the operation."""


def style_layers(choices: Mapping[str, LayerChoice] | str | None = None) -> dict[str, LayerStyle]:
    """Return the style of every layer: the user's choice or the default.

    Parameters
    ----------
    choices : mapping or str, optional
        Name of a colour scheme in `SCHEMES`; or a mapping from a layer of the drawing to a name, or to a name and a
        colour "#rrggbb".

    Examples
    --------
    >>> style_layers({"ENGRAVE": ("Raster", "#808080")})["ENGRAVE"].name
    'Raster'
    """
    if isinstance(choices, str):
        if choices not in SCHEMES:
            raise InputError(
                "{choices!r} is not a colour scheme: use one of {schemes}",
                choices=choices,
                schemes=", ".join(SCHEMES),
            )
        return dict(SCHEMES[choices])
    styles = dict(SCHEMES["elastica"])
    if not (choices is None or isinstance(choices, Mapping)):
        raise InputError(
            "layers are {choices}: give a mapping such as {{'ENGRAVE': 'Raster'}}", choices=quoted(choices)
        )
    for layer, choice in (choices or {}).items():
        if layer not in styles:
            raise InputError(
                "there is no layer {layer!r} to rename: use one of {layers}",
                layer=layer,
                layers=", ".join(LAYERS),
            )
        if isinstance(choice, LayerStyle):
            styles[layer] = choice
        elif isinstance(choice, str):
            styles[layer] = LayerStyle(choice, styles[layer].color)
        elif isinstance(choice, Sequence) and len(choice) == 2:
            styles[layer] = LayerStyle(*choice)
        else:
            raise InputError(
                "layer {layer} is {choice}: give a name, or a name and a colour '#rrggbb'",
                layer=layer,
                choice=quoted(choice),
            )
    names = [style.name.casefold() for style in styles.values()]
    if len(set(names)) < len(names):
        raise InputError("two layers have the same name: give each layer a different name")
    return styles
