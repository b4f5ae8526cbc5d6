"""Curves of bent strips, strips along sections, models as assemblies, and the methods `elasticStrip`."""

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, Literal, Self, TypeAlias, Unpack

import cadquery as cq

from elastica_cad.cadquery.strip_shapes import (
    StripCompound,
    StripFace,
    StripSolid,
    bent_strip,
    dress,
    flat_strip,
    free_name,
    make_location,
    strip_outline,
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
from elastica_cad.strip.outline import ENDS

if TYPE_CHECKING:
    from elastica_cad.form_finding.section_spec import SectionSpec
    from elastica_cad.model.assembly import AssemblyPart, Holder
    from elastica_cad.model.model import Model


def elastica(
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
) -> cq.Edge:
    """Return the curve of a strip of given length, between two clamped ends or with a free end, as an edge.

    Parameters
    ----------
    start, end : point
        Ends in the xy plane or, with the same z, in a parallel plane, mm. Without `end`, the end is free and the
        start is clamped.
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

    Raises
    ------
    InputError
        The length is too small, or a force acts on a held end.

    Examples
    --------
    >>> round(elastica((0, 0), (70, 0), 100, angles=(0, 0)).Length(), 3)
    100.0
    """
    _, wire = clamped_wire(
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
    return cq.Wire(wire).Edges()[0]


@lists(StripOptions)
def section_strips(
    body: "cq.Shape | cq.Workplane",
    planes: "cq.Plane | Frame | Iterable[cq.Plane | Frame] | SectionSpec",
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    half: bool = False,
    **options: Unpack[StripOptions],
) -> "list[StripSolid | StripCompound]":
    """Cut a face or body by planes, and return the strips along the section lines.

    Parameters
    ----------
    body : Face, Shell, Solid, or Workplane with such a shape
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
    list of StripSolid
        Strips in the planes of the sections. The name of each strip is `label` with a number, such as "strip-1".

    Raises
    ------
    InputError
        No section is suitable for a strip. Errors of `strip_outline` are passed on.

    Warns
    -----
    StripWarning
        Lines were omitted.

    Examples
    --------
    >>> dome = cq.Workplane().sphere(60, angle1=20).faces(">Z")
    >>> len(section_strips(dome, cq.Plane.XZ(), "card-200gsm", max_width=8))
    1
    """
    shape = body.val() if isinstance(body, cq.Workplane) else body
    return [
        bent_strip(curve, sheet, max_width=max_width, **placed)
        for curve, placed in section_requests(shape, planes, options, half=half)
    ]


def model_assembly(model: "Model", *, others: "Iterable[Holder]" = ()) -> cq.Assembly:
    """Return the bent strips of a model as an assembly with names, colours and positions.

    Constraints fix the end faces of the strips, so `solve()` moves only parts that are added later. Equal
    strips share a body.

    Parameters
    ----------
    model : Model
    others : iterable of BasePlate, SlottedFrame and EndFixture, optional
        Holders of the strips, as further children, which `solve()` does not move either.

    Returns
    -------
    Assembly
        Assembly with the name of the model. Its children are named after the parts; "_" replaces characters
        that CadQuery's queries do not permit. The faces of each strip have tags: "start", "end", "hole1",
        "hole1_top", "hole1_bottom", ... Its metadata "strip" is the `Strip`. For a laminate, this child is the
        base, and the backing is a child of the base.

    Raises
    ------
    InputError
        An item of `others` is not a holder.
    """
    parts = model_parts(model, others, _part_shapes)
    assembly = cq.Assembly(name=model.name)
    for part, (body, *glued_on) in parts:
        name, place = free_name(part.name, assembly), make_location(part.frame)
        color, *colors = (cq.Color(*each) for each in part.colors)
        if not isinstance(body, StripSolid):
            assembly.add(body, name=name, color=color, loc=place)
            assembly.constrain(name, "Fixed")
            continue
        work = cq.Workplane(obj=body)
        _tag_faces(work, [body])
        strip = cq.Assembly(work, name=name, loc=place, color=color, metadata={"strip": part.strip})
        for sheet, label, its_color in zip(glued_on, part.names[1:], colors, strict=True):
            strip.add(sheet, name=free_name(label, assembly), color=its_color)
        assembly.add(strip)
        for end in ENDS:
            there = body.end_face(end).moved(place)
            assembly.constrain(f"{name}?{end}", "FixedPoint", there.Center().toTuple())
            assembly.constrain(f"{name}?{end}", "FixedAxis", there.normalAt().toTuple())
    return assembly


def _tag_faces(work: cq.Workplane, bodies: "Sequence[StripSolid | StripCompound]") -> None:
    # tag the end faces of the bodies, and the faces in their holes
    found: dict[str, list[cq.Face]] = {}
    for body in bodies:
        for name, face in body.tagged_faces.items():
            found.setdefault(name, []).append(face)
    for name, faces in found.items():
        work.newObject(faces).tag(name)


def _part_shapes(part: "AssemblyPart") -> list[cq.Shape]:
    """Return the shapes of a part: the base, which keeps the strip and its joints, and sheets glued on it."""
    base, *glued_on = map(cq.Solid, occt.make_sheets(part.solids))
    if part.strip is not None:
        joints = part.solids[0].joints
        made_strip = MadeStrip(part.strip, Frame(), home=joints["start"])
        base = dress(StripSolid(base.wrapped), joints, made_strip)
    return [base, *glued_on]


Form: TypeAlias = Literal["flat", "bent", "outline"]

MAKERS: dict[Form, Callable[..., Any]] = {"flat": flat_strip, "bent": bent_strip, "outline": strip_outline}


def _edges(shapes: Iterable[cq.Edge | cq.Wire]) -> list[cq.Edge]:
    return [edge for item in shapes for edge in (item.Edges() if isinstance(item, cq.Wire) else [item])]


class Workplane(cq.Workplane):
    """CadQuery's Workplane with the method `elasticStrip`, declared for editors and type checkers."""

    @lists(StripOptions)
    def elasticStrip(
        self,
        sheet: Sheet | str,
        *,
        max_width: float | None = None,
        form: Form = "bent",
        combine: bool | str = False,
        clean: bool = True,
        **options: Unpack[StripOptions],
    ) -> Self:
        """Return the strip of the pending or selected edges and wires.

        Parameters
        ----------
        sheet : Sheet or str
            The sheet, or the name of a built-in sheet.
        max_width : float
            Largest width of the free part, mm; alternatively pass `min_width`, the least width.
        form : "bent", "flat" or "outline"
            A flat strip (also available as `.flat` of a bent strip) is on the workplane, with the start of its
            free part at the origin. The outline, a face that can be extruded, has the same position. A bent strip
            is at its edges, which are first moved to the points of the stack, if there are any.
        combine, clean
            The same as in `Workplane.eachpoint`, for solids only.

        Returns
        -------
        Workplane
            Its stack has a strip for every chain of edges at every point of the previous stack. The faces of solids
            have tags: "start", "end", "hole1", "hole1_top", "hole1_bottom", ...
        """
        if form not in MAKERS:
            raise InputError(f"`form` is {form!r}. Use one of flat, bent, outline.")
        if form == "outline" and combine:
            raise InputError(
                "An outline is a face and cannot be combined with a solid. Extrude it first, or choose form='flat'."
            )
        pending = [*self.ctx.popPendingEdges(False), *self.ctx.popPendingWires(False)]
        selected = pending or [item for item in self.objects if isinstance(item, cq.Edge | cq.Wire)]
        if not selected:
            raise InputError("There is no curve. Draw a curve on the workplane, or select edges.")
        # pending edges meet if their gap is at most 1e-4 mm
        bodies: list[StripFace | StripSolid | StripCompound] = [
            MAKERS[form](chain, sheet, max_width=max_width, workplane=self.plane, **options)
            for chain in cq.Wire.combine(_edges(selected), 1e-4)
        ]
        # clean only combined solids, because clean() deletes the data of a strip
        tidy = clean and bool(combine)
        points = [item for item in self.objects if not isinstance(item, cq.Edge | cq.Wire)]
        places = points or [cq.Location()]
        # a bent strip on its own curve is not moved
        local = form != "bent" or bool(points)
        if local and form == "bent":
            bodies = [body.moved(self.plane.location.inverse) for body in bodies]
        # `eachpoint` calls `at_place` at all places for the first body, then for the next
        remaining = iter([body for body in bodies for _ in places])
        placed = []

        def at_place(place: cq.Location) -> StripFace | StripSolid | StripCompound:
            placed.append(next(remaining).moved(place) if local else next(remaining))
            return placed[-1]

        strips: Self = self.newObject(places * len(bodies)).eachpoint(at_place, local, combine, tidy)
        _tag_faces(self, [body for body in placed if not isinstance(body, StripFace)])
        return strips


class Sketch(cq.Sketch):
    """CadQuery's Sketch with the method `elasticStrip`, declared for editors and type checkers."""

    @lists(StripOptions)
    def elasticStrip(
        self,
        sheet: Sheet | str,
        *,
        max_width: float | None = None,
        mode: str = "a",
        tag: str | None = None,
        **options: Unpack[StripOptions],
    ) -> Self:
        """Replace the edges of the sketch by the flat pattern of the strip that bends into them.

        Parameters
        ----------
        sheet : Sheet or str
            The sheet, or the name of a built-in sheet.
        max_width : float
            Largest width of the free part, mm; alternatively pass `min_width`, the least width.
        mode, tag
            As in `Sketch.face`.
        """
        if not self._edges:
            raise InputError("There is no curve. Draw edges in the sketch first.")
        face = strip_outline(list(self._edges), sheet, max_width=max_width, **options)
        self._edges.clear()
        sketch: Self = self.reset().face(face, mode=mode, tag=tag)
        return sketch


def register() -> None:
    """Add the method `elasticStrip` to cq.Workplane and cq.Sketch. Further calls have no effect.

    Raises
    ------
    InputError
        A class already has a method `elasticStrip` of another library.
    """
    methods: dict[Any, Any] = {cq.Workplane: Workplane.elasticStrip, cq.Sketch: Sketch.elasticStrip}
    for owner, method in methods.items():
        if getattr(owner, "elasticStrip", method) is not method:
            raise InputError(
                f"cq.{owner.__name__} already has a method elasticStrip of another library. Use the functions "
                "of elastica_cad.cadquery instead."
            )
    for owner, method in methods.items():
        owner.elasticStrip = method
