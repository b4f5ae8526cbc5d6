"""The operation on pending edges, and the strips of a body's sections."""

from collections.abc import Iterable
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any, Literal, Unpack

import build123d as bd

from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.strip_on_path import StripOptions, section_requests
from elastica_cad.mechanics.material.sheet import Sheet

if TYPE_CHECKING:
    from elastica_cad.forming.plane_sections.section_spec import SectionSpec

from elastica_cad.build123d.strip_objects import BentStrip, Drawn, FlatStrip, StripOutline


def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str | None = None,
    max_width: float | None = None,
    form: Literal["flat", "bent", "outline"] = "flat",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> Any:
    """Operation: the strip of a curve, of the builder's pending edges unless `path` is given.

    Parameters
    ----------
    path : Edge, Wire, edges or PlaneCurve, optional
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        As in `StripOutline`.
    form : "flat", "bent" or "outline"
        The strip as cut (`FlatStrip`), as bent (`BentStrip`), or its flat pattern (`StripOutline`). Bent it stands
        on the pending edges where these are, as locations put them there; flat it lies at each active location.
    mode : Mode
        How it joins the builder's part or sketch.
    **options
        All others of `StripOutline`.

    Returns
    -------
    FlatStrip, BentStrip or StripOutline
        Where pending edges make several chains a `ShapeList` of them, one a chain.

    Raises
    ------
    InputError
        No path and no pending edges, an unknown form, and as `StripOutline`.
    """
    forms: dict[str, Any] = {"flat": FlatStrip, "bent": BentStrip, "outline": StripOutline}
    if not isinstance(form, str) or form not in forms:
        raise InputError(f"form {form!r} is not known: choose one of {', '.join(forms)}")
    builder = bd.BuildSketch if form == "outline" else bd.BuildPart
    context = builder._get_context("elastic_strip")
    if path is None:
        if isinstance(context, bd.BuildLine):
            raise InputError(
                "elastic_strip stands inside BuildLine: end that first, a strip follows its line"
            )
        path = list(context.pending_edges) if context is not None else []
        if not path:
            raise InputError(
                "there is no curve: give a path, or draw one with BuildLine in the builder first"
            )
        context.pending_edges = bd.ShapeList()
        path = list(bd.Wire.combine(path)) if len(path) > 1 else path
        # pending edges are where the active locations put them, once for each
        drawn = bd.LocationList([bd.Location()]) if form == "bent" else nullcontext()
        with drawn:
            strips: list[Any] = [
                forms[form](chain, sheet, max_width=max_width, mode=mode, **options) for chain in path
            ]
        return strips[0] if len(strips) == 1 else bd.ShapeList(strips)
    return forms[form](path, sheet, max_width=max_width, mode=mode, **options)


def section_strips(
    body: bd.Shape,
    planes: "bd.Plane | Frame | Iterable[bd.Plane | Frame] | SectionSpec",
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    half: bool = False,
    **options: Unpack[StripOptions],
) -> "bd.ShapeList[BentStrip]":
    """The strips that follow the lines in which planes cut a face or a body.

    Parameters
    ----------
    body : Face, Shell or Solid
    planes : Plane, planes, or SectionSpec
        A `SectionSpec` also splits closed lines, keeps the longest and smooths.
    sheet, max_width, **options
        As in `StripOutline`; most sections bend within `limits` only.
    half : bool
        Only what lies on the side to which a plane's x axis points.

    Returns
    -------
    ShapeList of BentStrip
        Standing in the section's plane, with its z axis to the strip's upper edge; called by `label` and a number.

    Raises
    ------
    InputError
        No section that a strip could follow, and as `StripOutline`.

    Warns
    -----
    StripWarning
        Of lines that are left out.

    Examples
    --------
    >>> dome = bd.Sphere(60, arc_size1=20)
    >>> planes = [bd.Plane.XZ.offset(y) for y in (-20, 0, 20)]
    >>> ribs = section_strips(dome.faces().sort_by(bd.Axis.Z)[-1], planes, "card-200gsm", max_width=8)
    >>> len(ribs)
    3
    """
    return bd.ShapeList(
        BentStrip(curve, sheet, max_width=max_width, mode=bd.Mode.PRIVATE, **placed)
        for curve, placed in section_requests(body, planes, options, half=half)
    )
