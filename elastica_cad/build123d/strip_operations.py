"""The line of a bent strip, an operation on pending edges, strips of sections, and models as compounds."""

from collections.abc import Iterable, Sequence
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any, Literal, Unpack

import build123d as bd

from elastica_cad.build123d.strip_objects import (
    BentStrip,
    Drawn,
    FlatStrip,
    PlacedStrip,
    StripOutline,
    add_joints,
    make_solids,
)
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.segments import Spline
from elastica_cad.kernel import occt
from elastica_cad.kernel.option_help import lists
from elastica_cad.kernel.strip_body import MadeStrip, end_angles, warn_of_missing_slots
from elastica_cad.kernel.strip_on_path import section_requests
from elastica_cad.kernel.strip_options import StripOptions
from elastica_cad.mechanics.between_clamps import elastica_between
from elastica_cad.mechanics.loads import Gravity, whole_number
from elastica_cad.mechanics.sheets import Sheet

if TYPE_CHECKING:
    from elastica_cad.forming.section_spec import SectionSpec
    from elastica_cad.model.assembly import AssemblyPart, Holder
    from elastica_cad.model.model import Model


@lists(StripOptions, drawn=True)
def elastic_strip(
    path: Drawn | None = None,
    *,
    sheet: Sheet | str | None = None,
    max_width: float | None = None,
    form: Literal["bent", "flat", "outline"] = "bent",
    mode: bd.Mode = bd.Mode.ADD,
    **options: Unpack[StripOptions],
) -> Any:
    """Operation: the strip of a curve, of the builder's pending edges unless `path` is given.

    Parameters
    ----------
    form : "bent", "flat" or "outline"
        The strip as bent (`BentStrip`), as cut (`FlatStrip`, which is `.flat` of a bent one too), or its flat
        pattern (`StripOutline`). Bent it stands on the pending edges where these are, as locations put them
        there; flat it lies at each active location.
    mode : Mode
        How it joins the builder's part or sketch.

    Returns
    -------
    BentStrip, FlatStrip or StripOutline
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
    """The strips that follow the lines in which planes cut a face or a body.

    Parameters
    ----------
    body : Face, Shell or Solid
    planes : Plane, planes, or SectionSpec
        A `SectionSpec` also splits closed lines, keeps the longest and smooths.
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        The largest width of each strip, mm.
    limits : Limits
        Most sections bend within limits only.
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


class Elastica(bd.BaseLineObject):
    """Line object: the curve that a strip of given length takes between two clamps, or from one to its free end.

    Which of its many shapes is stated by `branch`, and chosen by `side` and `buckling`.

    Parameters
    ----------
    start, end : point
        In the plane of the workplane, mm; `end=None` leaves the end free, with the start clamped.
    length : float
        Of the strip, mm: more than the distance of its ends.
    angles : pair of float or None
        Of the tangents at start and end, degrees, whole turns not counted; None leaves the strip free to turn
        there.
    stiffness : float, sequence or Profile
        Of a tapered strip: its widths at even stations, in any unit.
    gravity : Gravity, optional
        The strip's own weight, as `Sheet.gravity` gives it.
    force : pair of float, optional
        At a free end, newtons over the strip's least bending stiffness in N mm2 (`Sheet.bending_stiffness`).
    side : {+1, -1}
        Bulge to the left or the right of the way from start to end.
    buckling : int
        Buckling mode; above 1 the shape is unstable as a rule.
    mode : Mode
        How it joins the builder's line.

    Raises
    ------
    InputError
        A length that does not reach, points off the plane, a force at an end that is held.

    Examples
    --------
    >>> line = Elastica((0, 0), (70, 0), 100, angles=(0, 0))
    >>> round(line.length, 3), str(line.branch)
    (100.0, 'the strip bulges to the left of its chord, with 2 inflections (mode 1)')
    """

    def __init__(
        self,
        start: bd.VectorLike,
        end: bd.VectorLike | None,
        length: float,
        *,
        angles: tuple[float | None, float | None] = (None, None),
        stiffness: "float | Sequence[float] | Profile" = 1.0,
        gravity: Gravity | None = None,
        force: tuple[float, float] | None = None,
        side: int = 1,
        buckling: int = 1,
        mode: bd.Mode = bd.Mode.ADD,
    ) -> None:
        self.branch = elastica_between(
            start,
            end,
            length,
            angles=end_angles(angles),
            stiffness=stiffness,
            gravity=gravity,
            force=force,
            side=side,
            mode=whole_number(buckling, "buckling", 1),
        )
        wire = occt.make_wire(Path([Spline(self.branch.curve)]))
        super().__init__(bd.Wire(wire), mode)


def model_compound(model: "Model", *, others: "Iterable[Holder]" = ()) -> bd.Compound:
    """The bent strips of a model as an assembly: a compound whose children are called like the parts.

    Equal strips share one body. Every child has the joints of `BentStrip` and knows its `strip`; the sheets of a
    laminate are its children.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        What holds the strips, as further children: plates and blocks, these with their joint "tab".

    Returns
    -------
    Compound
        Called like the model, with one `PlacedStrip` a strip.

    Raises
    ------
    InputError
        Something else among `others`.
    """
    from elastica_cad.model.assembly import assembly_parts, require_model, shape_parts

    require_model(model)
    parts = assembly_parts(model.placed, (*model.plates, *others))
    warn_of_missing_slots(model)
    children = [
        _child(part, solids) for part, solids in shape_parts(parts, lambda part: make_solids(part.solids))
    ]
    return bd.Compound(label=model.name, children=children)


def _child(part: "AssemblyPart", solids: list[bd.Solid]) -> bd.Part:
    """A part of an assembly in its place; of a strip one that knows it."""
    child: Any = bd.Part(solids[0].wrapped)
    if part.strip is not None:
        child = PlacedStrip(bd.Compound(solids).wrapped)
        base: Any = part.solids[0]
        child._made = MadeStrip(part.strip, Frame(), home=base.joints["start"])
        if len(solids) > 1:
            # new wrappers: equal strips share shapes, but a child has one parent
            layers = [bd.Solid(solid.wrapped) for solid in solids]
            for layer, name, color in zip(layers, part.names, part.colors, strict=True):
                layer.label, layer.color = name, bd.Color(*color)
            child.children = layers
    add_joints(child, part.solids[0])
    child.label, child.color = part.name, bd.Color(*part.colors[0])
    child.location = bd.Location(occt.make_location(part.frame))
    occt.lock(child.wrapped)
    return child
