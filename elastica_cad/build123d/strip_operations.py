"""Line objects of bent strips, an operation on pending edges, strips along sections, and models as compounds."""

from collections.abc import Iterable, Sequence
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any, Literal, Unpack, overload

import build123d as bd

from elastica_cad.build123d.strip_objects import (
    BentStrip,
    Drawn,
    FlatStrip,
    Layer,
    PlacedStrip,
    StripOutline,
    add_joints,
    make_solids,
)
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.profile import Profile
from elastica_cad.kernel import occt
from elastica_cad.kernel.option_help import lists
from elastica_cad.kernel.strip_body import MadeStrip, Point, clamped_wire, model_parts
from elastica_cad.kernel.strip_on_path import section_requests
from elastica_cad.kernel.strip_options import StripOptions
from elastica_cad.mechanics.loads import Gravity
from elastica_cad.mechanics.sheets import Sheet

if TYPE_CHECKING:
    from elastica_cad.form_finding.section_spec import SectionSpec
    from elastica_cad.model.assembly import AssemblyPart, Holder
    from elastica_cad.model.model import Model


@overload
def elastic_strip(
    path: Drawn | None = None,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    form: Literal["bent"] = "bent",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> BentStrip: ...


@overload
def elastic_strip(
    path: Drawn | None = None,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    form: Literal["flat"],
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> FlatStrip: ...


@overload
def elastic_strip(
    path: Drawn | None = None,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    form: Literal["outline"],
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> StripOutline: ...


@lists(StripOptions, drawn=True)
def elastic_strip(
    path: Drawn | None = None,
    sheet: Sheet | str | None = None,
    *,
    max_width: float | None = None,
    form: Literal["bent", "flat", "outline"] = "bent",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> Any:
    """Operation: make the strip of a curve, by default the curve of the builder's pending edges.

    Parameters
    ----------
    form : "bent", "flat" or "outline"
        The bent strip (`BentStrip`), the flat strip (`FlatStrip`, also available as `.flat` of a bent strip),
        or its flat pattern (`StripOutline`). A bent strip is made at the position of its edges. A flat strip
        is placed at each active location.
    mode : Mode
        Combination with the builder's part or sketch.

    Returns
    -------
    BentStrip, FlatStrip or StripOutline
        If pending edges form several chains, a `ShapeList` with one strip per chain.

    Raises
    ------
    InputError
        There is neither a path nor pending edges, or the form is unknown. Errors of `StripOutline` are passed
        on.
    """
    forms: dict[str, Any] = {"flat": FlatStrip, "bent": BentStrip, "outline": StripOutline}
    if not isinstance(form, str) or form not in forms:
        raise InputError(f"`form` is {form!r}. Use one of {', '.join(forms)}.")
    builder = bd.BuildSketch if form == "outline" else bd.BuildPart
    context = builder._get_context("elastic_strip")
    if path is None:
        if isinstance(context, bd.BuildLine):
            raise InputError(
                "elastic_strip cannot be called inside BuildLine. End BuildLine first; the strip follows its "
                "line."
            )
        path = list(context.pending_edges) if context is not None else []
        if not path:
            raise InputError(
                "There is no curve. Pass a path, or draw a curve with BuildLine in the builder first."
            )
        context.pending_edges = bd.ShapeList()
        path = list(bd.Wire.combine(path)) if len(path) > 1 else path
        # a bent strip needs no location, because the builder has placed the pending edges
        location = bd.LocationList([bd.Location()]) if form == "bent" else nullcontext()
        with location:
            strips: list[Any] = [
                forms[form](chain, sheet, max_width=max_width, mode=mode, **options) for chain in path
            ]
        return strips[0] if len(strips) == 1 else bd.ShapeList(strips)
    return forms[form](path, sheet, max_width=max_width, mode=mode, **options)


@lists(StripOptions)
def section_strips(
    body: bd.Shape,
    planes: "bd.Plane | Frame | Iterable[bd.Plane | Frame] | SectionSpec",
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    half: bool = False,
    **options: Unpack[StripOptions],
) -> "bd.ShapeList[BentStrip]":
    """Cut a face or body by planes, and return the strips along the section lines.

    Parameters
    ----------
    body : Face, Shell or Solid
    planes : Plane, planes, or SectionSpec
        A `SectionSpec` also splits closed lines, selects the longest line and smooths lines.
    sheet : Sheet or str
        The sheet, or the name of a built-in sheet.
    max_width : float
        Largest width of each strip, mm.
    limits : Limits
        Limits for changes of the curves; most sections need them.
    half : bool
        If True, only the part with x >= 0 in each plane is used, for half planes about an axis.

    Returns
    -------
    ShapeList of BentStrip
        Strips in the planes of the sections, with z towards the strip's upper edge. The name of each strip is
        `label` with a number, such as "strip-1".

    Raises
    ------
    InputError
        No section is suitable for a strip. Errors of `StripOutline` are passed on.

    Warns
    -----
    StripWarning
        Lines were omitted.

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


@lists()
class Elastica(bd.BaseLineObject):
    """Line object: the curve of a strip of given length between two clamped ends, or between a clamped and a
    free end.

    `side` and `buckling` select one of several shapes; `branch` describes the shape.

    Parameters
    ----------
    start, end : point
        Points in the plane of the workplane or, with the same z, in a parallel plane, mm. Without `end`, the end is
        free and the start is clamped.
    length : float
        Length of the strip, mm. It must exceed the distance between the ends.
    angles : pair of float or None
        Directions of the tangents at start and end, degrees, without full turns. None means that an end
        rotates freely.
    stiffness : float, sequence or Profile
        Widths of a tapered strip at equally spaced stations, in any unit.
    gravity : Gravity, optional
        Weight of the strip, from `Sheet.gravity`.
    force : pair of float, optional
        Force at a free end, N, divided by the strip's least bending stiffness in N mm2 (`Sheet.bending_stiffness`).
    side : {+1, -1}
        Side of the bulge: +1 is left of the line from start to end, -1 is right.
    buckling : int
        Buckling mode; shapes with a mode above 1 are usually unstable.
    mode : Mode
        Combination with the builder's line.

    Raises
    ------
    InputError
        The length is too small, points are outside the plane, or a force acts on a held end.

    Examples
    --------
    >>> line = Elastica((0, 0), (70, 0), 100, angles=(0, 0))
    >>> round(line.length, 3), str(line.branch)
    (100.0, 'the strip bulges to the left of the line between its ends, with 2 inflections (mode 1)')
    """

    def __init__(
        self,
        start: Point,
        end: Point | None = None,
        length: float | None = None,
        *,
        angles: tuple[float | None, float | None] = (None, None),
        stiffness: "float | Sequence[float] | Profile" = 1.0,
        gravity: Gravity | None = None,
        force: tuple[float, float] | None = None,
        side: int = 1,
        buckling: int = 1,
        mode: bd.Mode = bd.Mode.ADD,
    ) -> None:
        self.branch, wire = clamped_wire(
            start,
            end,
            length,
            angles=angles,
            buckling=buckling,
            stiffness=stiffness,
            gravity=gravity,
            force=force,
            side=side,
        )
        super().__init__(bd.Wire(wire), mode)

    def __repr__(self) -> str:
        return f"<Elastica of {self.length:.4g} mm: {self.branch}>"


def model_compound(model: "Model", *, others: "Iterable[Holder]" = ()) -> bd.Compound:
    """Return the bent strips of a model as an assembly: a compound whose children are named after the parts.

    Equal strips share a body. Every child has the joints of `BentStrip` and a property `strip`. The sheets of a
    laminate are children of the strip.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        Holders of the strips, as further children: plates, and blocks with their joint "tab".

    Returns
    -------
    Compound
        Compound with the name of the model. Its children are a `PlacedStrip` for each strip, and the holders.

    Raises
    ------
    InputError
        An item of `others` is not a holder.
    """
    parts = model_parts(model, others, lambda part: make_solids(part.solids))
    return bd.Compound(label=model.name, children=[_placed_part(part, solids) for part, solids in parts])


def _placed_part(part: "AssemblyPart", solids: list[bd.Solid]) -> bd.Part:
    """Return a part at its place in the assembly, with names and colours of its layers."""
    child: Any = bd.Part(solids[0].wrapped)
    if part.strip is not None:
        child = PlacedStrip(bd.Compound(solids).wrapped, label=part.name)
        base: Any = part.solids[0]
        child._made = MadeStrip(part.strip, Frame(), home=base.joints["start"])
        if len(solids) > 1:
            # equal strips share one shape object, but an object has only one parent in the tree
            layers = [Layer(solid.wrapped) for solid in solids]
            for layer, name, color in zip(layers, part.names, part.colors, strict=True):
                layer.label, layer.color = name, bd.Color(*color)
            child.children = layers
    add_joints(child, part.solids[0])
    child.label, child.color = part.name, bd.Color(*part.colors[0])
    child.location = bd.Location(occt.make_location(part.frame))
    occt.lock(child.wrapped)
    return child
