"""The method `elasticStrip` of workplanes and sketches."""

from collections.abc import Callable, Iterable
from typing import Any, Literal, TypeAlias, Unpack, get_args

import cadquery as cq

from elastica_cad.cadquery.strip_shapes import (
    StripCompound,
    StripFace,
    StripSolid,
    make_body,
    make_strip_of,
    strip_outline,
)
from elastica_cad.errors import InputError
from elastica_cad.fabrication.solids.strip_solids import BentSolid, FlatSolid
from elastica_cad.fabrication.strip.outline import ENDS
from elastica_cad.kernel.strip_on_path import StripOptions
from elastica_cad.mechanics.material.sheet import Sheet

Form: TypeAlias = Literal["flat", "bent", "outline"]

METHOD = "elasticStrip"
CHAIN = 1e-4  # mm: ends of pending edges that are meant to meet


def register() -> None:
    """Add `elasticStrip` to cq.Workplane and cq.Sketch; calling it again does no harm.

    Raises
    ------
    InputError
        Another library has put an `elasticStrip` there.
    """
    methods: dict[type, Callable[..., Any]] = {cq.Workplane: _workplane_strip, cq.Sketch: _sketch_strip}
    for owner, method in methods.items():
        if getattr(owner, METHOD, method) is not method:
            raise InputError(
                f"cq.{owner.__name__} has an {METHOD} of another library already: use the functions of "
                "elastica_cad.cadquery instead"
            )
    for owner, method in methods.items():
        setattr(owner, METHOD, method)


def _workplane_strip(
    self: cq.Workplane,
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    form: Form = "flat",
    combine: bool | str = False,
    clean: bool = True,
    **options: Unpack[StripOptions],
) -> cq.Workplane:
    """The strip of the pending edges and wires, or of the edges and wires selected.

    Parameters
    ----------
    sheet : Sheet or str
        The material, or the name of a built-in one.
    max_width : float
        As in `strip_outline`.
    form : "flat", "bent" or "outline"
        Flat it lies on the workplane, the start of its free part at the origin, as its outline does, which is a
        face to be extruded; bent it stands on the edges, which are moved to the points of the stack, where there
        are some.
    combine, clean
        As in `Workplane.eachpoint`; of solids only.
    **options
        As in `strip_outline`.

    Returns
    -------
    Workplane
        With a strip for every chain of edges on its stack, at every point of the stack; the end faces of solids
        are tagged "start" and "end".
    """
    if form not in get_args(Form):
        raise InputError(f"form {form!r} is not known: choose flat, bent or outline")
    if form == "outline" and combine:
        raise InputError(
            "an outline is a face, which joins no solid: extrude it first, or choose form='flat'"
        )
    pending = [*self.ctx.popPendingEdges(False), *self.ctx.popPendingWires(False)]
    drawn = pending or [item for item in self.objects if isinstance(item, cq.Edge | cq.Wire)]
    if not drawn:
        raise InputError("there is no curve: draw one on the workplane, or select edges")
    bodies: list[StripFace | StripSolid | StripCompound] = []
    for chain in cq.Wire.combine(_edges(drawn), CHAIN):
        made = make_strip_of(chain, sheet, max_width=max_width, workplane=self.plane, **options)
        if form == "outline":
            bodies.append(strip_outline(made.strip))
            continue
        records = FlatSolid.layers(made.strip) if form == "flat" else BentSolid.layers(made.strip, made.frame)
        bodies.append(make_body(records, made))
    tidy = clean and bool(combine)  # alone the strip is clean, and stays the object that knows its rod
    points = [item for item in self.objects if not isinstance(item, cq.Edge | cq.Wire)]
    places = points or [cq.Location()]
    local = form != "bent" or bool(points)  # what is drawn in place stays as it was made
    if local and form == "bent":
        bodies = [body.moved(self.plane.location.inverse) for body in bodies]
    left = iter([body for body in bodies for _ in places])
    put = []

    def at_place(place: cq.Location) -> StripFace | StripSolid | StripCompound:
        put.append(next(left).moved(place) if local else next(left))
        return put[-1]

    made = self.newObject(places * len(bodies)).eachpoint(at_place, local, combine, tidy)
    for end in ENDS:
        self.newObject([body.end_face(end) for body in put if not isinstance(body, StripFace)]).tag(end)
    return made


def _edges(drawn: Iterable[cq.Edge | cq.Wire]) -> list[cq.Edge]:
    return [edge for item in drawn for edge in (item.Edges() if isinstance(item, cq.Wire) else [item])]


def _sketch_strip(
    self: cq.Sketch,
    sheet: Sheet | str,
    *,
    max_width: float | None = None,
    mode: str = "a",
    tag: str | None = None,
    **options: Unpack[StripOptions],
) -> cq.Sketch:
    """Add the flat pattern of the strip that bends into the sketch's edges; these are used up.

    `mode` and `tag` as in `Sketch.face`, other arguments as in `strip_outline`.
    """
    if not self._edges:
        raise InputError("there is no curve: draw edges in the sketch first")
    face = strip_outline(list(self._edges), sheet, max_width=max_width, **options)
    self._edges = []
    return self.reset().face(face, mode=mode, tag=tag)
