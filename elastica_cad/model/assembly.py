"""Parts of an assembly (bent strips and their holders) and the order of assembly."""

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias, TypeVar

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record, several, with_article
from elastica_cad.errors import InputError, note
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.model.fixtures import FIXTURE_COLOR, EndFixture, PlacedTab, tab_name
from elastica_cad.model.frames import Rib, SlottedFrame
from elastica_cad.model.model import Model
from elastica_cad.model.plates import BasePlate, Ring
from elastica_cad.strip.holding_template import angle_text, freedom_text, held_ends
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.solids import BentSolid, BodyRecord, PrismSolid, bent_colors, bent_sheets
from elastica_cad.strip.strip import Placed, Strip, strip_marks, strip_names

HOLDERS = "BasePlate, SlottedFrame, Ring and EndFixture"
"""Names of the classes that hold strips, for messages."""

SingleHolder: TypeAlias = BasePlate | Rib | EndFixture
Holder: TypeAlias = SingleHolder | SlottedFrame
"""Plate, frame or block that holds strips: see `Model.base_plate`, `slotted_frame` and `fixtures`."""

Shape = TypeVar("Shape")


@dataclass(frozen=True, eq=False)
class AssemblyPart:
    """A bent strip, a plate or a block of an assembly.

    Attributes
    ----------
    name : str
        Unique among the parts of the same kind in the assembly.
    solids : tuple of BentSolid, FlatSolid or PrismSolid
        Bodies of the part. A strip has a body for each sheet, with its curve in the xy plane. Equal strips share
        the tuple.
    colors : tuple of (red, green, blue)
        Screen colors of the solids, each component in 0..1. A fourth number is the opacity.
    frame : Frame
        Position of the solids in the assembly.
    strip : Strip or None
        The strip, or None if the part is a holder.
    """

    name: str
    solids: tuple[BodyRecord | PrismSolid, ...]
    colors: tuple[tuple[float, ...], ...]
    frame: Frame = field(default_factory=Frame)
    strip: Strip | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the solids."""
        return (self.name,) if self.strip is None else bent_names(self.name, self.strip)


def layer_names(name: str, strip: Strip) -> tuple[str, ...]:
    """Return the names of the sheets of a strip.

    The name of a glued sheet ends with "backing" or with the name of the ply.
    """
    return tuple(f"{name} {layer.name}".rstrip() for layer in strip.layers)


def bent_names(name: str, strip: Strip) -> tuple[str, ...]:
    """Return the names of the bent bodies: the sheets, and the lap of a closed strip."""
    return (*layer_names(name, strip), f"{name} lap")[: len(bent_sheets(strip))]


def require_model(model: object) -> None:
    """Raise InputError if the object is not a `Model`."""
    require_record(model, Model, "the model", "a Model, such as ec.Model([rib.placed, ...])")


def assembly_parts(placed: Sequence[Placed], holders: Iterable[Holder] = ()) -> tuple[AssemblyPart, ...]:
    """Return the strips and then the holders as parts. A number is added to equal names.

    Raises
    ------
    InputError, NotConvergedError
        An item of `holders` is not a holder. Errors of `BentSolid.of` are passed on.
    """
    solids: dict[int, tuple[BodyRecord, ...]] = {}
    strips = []
    for name, member in zip(strip_names(placed), placed, strict=True):
        strip = member.strip
        if id(strip) not in solids:
            solids[id(strip)] = BentSolid.layers(strip)
        colors = bent_colors(strip, member.color)
        strips.append(AssemblyPart(name, solids[id(strip)], colors, member.frame, strip))
    return (
        *_with_unique_names(strips),
        *_with_unique_names([_holder_part(holder) for holder in single_holders(holders)]),
    )


def shape_parts(
    parts: Iterable[AssemblyPart], make: Callable[[AssemblyPart], Shape]
) -> Iterator[tuple[AssemblyPart, Shape]]:
    """Yield each part with its shape. `make` is called once for parts that share their solids."""
    shapes: dict[int, Shape] = {}
    for part in parts:
        if id(part.solids) not in shapes:
            shapes[id(part.solids)] = make(part)
        yield part, shapes[id(part.solids)]


def single_holders(holders: Iterable[Holder]) -> Iterator[SingleHolder]:
    """Yield single holders. The holders in a slotted frame are its rails and ribs."""
    for holder in holders:
        if isinstance(holder, SlottedFrame):
            yield from holder.rails
            yield from holder.ribs
        elif isinstance(holder, SingleHolder):
            yield holder
        else:
            raise InputError(
                f"{with_article(type(holder))} is not a holder: give base plates, slotted frames and end fixtures"
            )


def _holder_part(holder: SingleHolder) -> AssemblyPart:
    if isinstance(holder, EndFixture):
        return AssemblyPart(holder.label, (holder.solid,), (FIXTURE_COLOR,))
    return AssemblyPart(holder.name, (holder.solid,), (sheet_color(holder.sheet),))


def _with_unique_names(parts: Sequence[AssemblyPart]) -> Iterator[AssemblyPart]:
    """Yield the parts; parts of the same name are numbered."""
    count = Counter(part.name for part in parts)
    used, names_in_use = Counter[str](), set(count)
    for part in parts:
        name = part.name
        while count[part.name] > 1 and name in names_in_use:
            used[part.name] += 1
            name = f"{part.name}_{used[part.name]}"
        names_in_use.add(name)
        yield replace(part, name=name)


FREE, TO_START = note("free"), note("glue to its start (1)")
"""Texts for a free end, and for the end of a closed strip, which is glued to its start."""


@dataclass(frozen=True)
class AssemblyStep:
    """Step of the assembly: placing a strip.

    Attributes
    ----------
    number : int
        Number of the step, from 1.
    strip : str
        Engraved name, with the number of the strip if several strips have the same name.
    part : str
        Name of the cut piece.
    ends : (str, str)
        Holders of end 1 and end 2. For a supported end without a holder, the text is "hold at (x, y, z)", mm.
        The text also gives the direction of the strip from the line between its ends. Other ends are "free" or
        glued.
    holders : (tuple of str, tuple of str)
        Short texts for both ends: "ring-bottom" for a slot, "on ring-bottom" for a glued tab, "its block".
    motions : (str, str)
        For both ends, how the end may move, such as "free to slide along x"; "" if it is fixed.
    locks_into : tuple of str
        Earlier strips into whose slots this strip is pushed.
    """

    number: int
    strip: str
    part: str
    ends: tuple[str, str]
    holders: tuple[tuple[str, ...], tuple[str, ...]]
    motions: tuple[str, str] = ("", "")
    locks_into: tuple[str, ...] = ()


def list_assembly_steps(model: Model, holders: Iterable[Holder] = ()) -> tuple[AssemblyStep, ...]:
    """Return one step for each strip, in the order of the model.

    Examples
    --------
    >>> from elastica_cad.strip.strip import Placed
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> bow = make_strip(PlaneCurve.arc((0, 0), 60, 3.1, 0.04), "birch-plywood-0.8", max_width=20, label="A")
    >>> model = Model([Placed(bow, (0, 0, 0), (1, 0, 0), (0, 0, 1))])
    >>> list_assembly_steps(model, [model.base_plate(Sheet.named("mdf-3"))])[0].ends
    ('slot A:1 of base', 'slot A:2 of base')
    """
    require_model(model)
    places = _places_of_tabs(model, holders)
    parts = {member: part.name for part in model.parts for member in part.members}
    marks = strip_marks(model.placed)
    steps = []
    for i in range(len(model.placed)):
        names = [tab_name(marks[i], end) for end in ENDS]
        by_hand = [_instruction_without_holder(model.placed[i], end) for end in ENDS]
        first, last = (" and ".join(places[name]) or hand for name, hand in zip(names, by_hand, strict=True))
        short, long = (
            tuple(places[name].values()) or (hand,) for name, hand in zip(names, by_hand, strict=True)
        )
        before = [min(j.members) for j in model.joints if max(j.members) == i]
        steps.append(
            AssemblyStep(
                i + 1,
                model.single_name_of(i),
                parts[i],
                (first, last),
                (short, long),
                _motions_in_space(model.placed[i]),
                tuple(dict.fromkeys(model.single_name_of(k) for k in before)),
            )
        )
    return tuple(steps)


def unheld_ends(model: Model, holders: Iterable[Holder] = ()) -> dict[int, tuple[StripEnd, ...]]:
    """Return, by the index of each strip, its supported ends that no holder holds."""
    places = _places_of_tabs(model, holders)
    by_hand = {
        i: tuple(
            end
            for end in ENDS
            if not places[tab_name(mark, end)]
            and _instruction_without_holder(strip, end) not in (FREE, TO_START)
        )
        for i, (strip, mark) in enumerate(zip(model.placed, strip_marks(model.placed), strict=True))
    }
    return {i: ends for i, ends in by_hand.items() if ends}


def engraved_marks(model: Model, holders: Sequence[Holder]) -> Iterator[str]:
    """Yield sentences on the text engraved at the ends of strips and on slots and blocks."""
    cut_only, first = is_unmarked(model), tab_name(strip_marks(model.placed)[0], ENDS[0])
    if cut_only:
        # printed blocks have their names even if nothing is engraved on the parts that are cut
        if any(isinstance(holder, EndFixture) for holder in single_holders(holders)):
            yield note("Each block has the name of its end, such as {name}.", name=first)
        return
    if any(strip.engraved for strip in model.strips):
        yield note("A strip starts (1) where its label starts.")
    if holders and not all(strip.engraved for strip in model.strips):
        yield note("A strip without a label has the numbers 1 and 2 at its start and its end.")
    if any(isinstance(holder, EndFixture | BasePlate) and not isinstance(holder, Ring)
           for holder in single_holders(holders)):  # fmt: skip
        yield note("Each slot and block has the name of its end, such as {name}.", name=first)


def is_unmarked(model: Model) -> bool:
    """Return True if nothing is engraved or marked on the parts, because a cutting service cuts them."""
    return all(strip.unmarked for strip in model.strips)


def _places_of_tabs(model: Model, holders: Iterable[Holder]) -> dict[str, dict[str, str]]:
    """Return, for each tab name, the places that hold the tab, each with a short text."""
    places = defaultdict[str, dict[str, str]](dict)
    for holder in single_holders([*model.plates, *several("holders", holders, Holder, HOLDERS)]):
        if isinstance(holder, BasePlate):
            for slot in holder.slots:
                place = note("slot {slot} of {holder}", slot=slot.name, holder=holder.name)
                places[slot.name][place] = holder.name
            for tab in holder.seated if isinstance(holder, Ring) else ():
                on_ring = note("on {ring}", ring=holder.name)
                places[tab][on_ring] = on_ring
        elif isinstance(holder, EndFixture):
            places[holder.tab.name][f"block {holder.engrave or holder.tab.name}"] = note("its block")
    return places


def _instruction_without_holder(member: Placed, end: StripEnd) -> str:
    """Return how to hold the end of a strip that no part holds: its place, mm, and angle in space."""
    k = ENDS.index(end)
    support = member.strip.rod.supports.ends[k]
    if member.strip.is_closed:
        return TO_START if k else FREE
    if not (support.x or support.y or support.angle):
        return FREE
    x, y, z = PlacedTab.of(member.strip, end, member.frame).frame.origin
    place = f"({x:z.1f}, {y:z.1f}, {z:z.1f})"
    if not support.angle:
        return note("hold at {place}", place=place)
    angle = angle_in_space(member, held_ends(member.strip)[k].tilt)
    return note("hold at {place}, {angle}", place=place, angle=angle)


def _motions_in_space(member: Placed) -> tuple[str, str]:
    """Return how each end of a placed strip may move, such as "free to slide along x", or "" if it is fixed."""
    x, y = (_axis_in_space(axis) for axis in (member.frame.x_axis, member.frame.y_axis))
    first, last = (
        "" if member.strip.is_closed or end.is_free else freedom_text(end, x, y)
        for end in member.strip.rod.supports.ends
    )
    return first, last


def _axis_in_space(axis: FloatArray) -> str:
    along = int(np.abs(axis).argmax())
    # the axis of a frame along x, y or z, except for rounding
    if abs(axis[along]) > 1 - 1e-4:
        return "xyz"[along]
    return f"({', '.join(f'{x:z.2f}' for x in axis)})"


def angle_in_space(member: Placed, degrees: float) -> str:
    """Return a direction relative to the line between the ends of a placed strip, as in `angle_text`.

    The text also states the side in space, such as "upward".
    """
    text, sign = angle_text(degrees), np.sign(round(degrees, 1))
    if sign == 0:
        return text
    position = member.strip.rod.position
    aside = member.frame.direction(sign * left_of(position[-1] - position[0]))
    return note("{angle} ({side})", angle=text, side=direction_in_space(aside))


def direction_in_space(vector: FloatArray) -> str:
    """Return the direction in space, such as "upward", nearest to a vector (3,). Upward is along z."""
    axis, sign = _nearest_axis(vector)
    return (
        note(("upward", "downward")[sign == "-"]) if axis == "z" else note("towards {axis}", axis=sign + axis)
    )


def side_in_space(vector: FloatArray) -> str:
    """Return the side of a strip, such as "below the strip", in the direction of a vector (3,)."""
    axis, sign = _nearest_axis(vector)
    if axis == "z":
        return note(("above the strip", "below the strip")[sign == "-"])
    return note("on the {axis} side of the strip", axis=sign + axis)


def _nearest_axis(vector: FloatArray) -> tuple[str, str]:
    along = int(np.abs(vector).argmax())
    return "xyz"[along], "-" if vector[along] < 0 else "+"
