"""The parts of an assembly: bent strips and what holds them, and the order in which they are put together."""

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias, TypeVar

from elastica_cad._values import several
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.sheets import Color, sheet_color
from elastica_cad.model.fixtures import EndFixture, PlacedTab, tab_name
from elastica_cad.model.frames import Rib, SlottedFrame
from elastica_cad.model.model import FIXTURE_COLOR, Model
from elastica_cad.model.plates import BasePlate, Ring
from elastica_cad.refusals import note
from elastica_cad.strip.holding_template import held_ends
from elastica_cad.strip.outline import ENDS, StripEnd
from elastica_cad.strip.solids import BentSolid, BodyRecord, PrismSolid, bent_sheets
from elastica_cad.strip.strip import Placed, Strip, strip_names

HOLDERS = "BasePlate, SlottedFrame, Ring and EndFixture"
"""Names of the records that hold strips, for messages."""

SingleHolder: TypeAlias = BasePlate | Rib | EndFixture
Holder: TypeAlias = SingleHolder | SlottedFrame
"""Record that holds strips of a model: see `Model.base_plate`, `Model.slotted_frame` and `Model.fixtures`."""

Shape = TypeVar("Shape")


@dataclass(frozen=True, eq=False)
class AssemblyPart:
    """A bent strip, a plate or a block of an assembly.

    Attributes
    ----------
    name : str
        Unlike all other names of its kind in the assembly.
    solids : tuple of BentSolid, FlatSolid or PrismSolid
        Of a strip one for each sheet, the curve's plane as their xy plane; equal strips share the tuple.
    colors : tuple of (red, green, blue)
        Of the solids, in 0..1, as on a screen.
    frame : Frame
        Where the solids' frame lies.
    strip : Strip or None
        None for what holds strips.
    """

    name: str
    solids: tuple[BodyRecord | PrismSolid, ...]
    colors: tuple[Color, ...]
    frame: Frame = field(default_factory=Frame)
    strip: Strip | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its solids."""
        return (self.name,) if self.strip is None else bent_names(self.name, self.strip)


def layer_names(name: str, strip: Strip) -> tuple[str, ...]:
    """Names of a strip's sheets: its own for the base, with "backing" or the leaf for what is glued on."""
    return tuple(f"{name} {layer.name}".rstrip() for layer in strip.layers)


def bent_names(name: str, strip: Strip) -> tuple[str, ...]:
    """Names of its bodies when bent: those of its sheets, and of the lap that closes it."""
    return (*layer_names(name, strip), f"{name} lap")[: len(bent_sheets(strip))]


def require_model(model: object) -> None:
    """Refuse what is no `Model`."""
    if not isinstance(model, Model):
        raise InputError(f"a {type(model).__name__} is no model: give ec.Model([rib.placed, ...])")


def assembly_parts(placed: Sequence[Placed], holders: Iterable[Holder] = ()) -> tuple[AssemblyPart, ...]:
    """The strips in their order, then what holds them; those with the same name are numbered.

    Raises
    ------
    InputError, NotConvergedError
        Something else among the holders, and as `BentSolid.of`.
    """
    solids: dict[int, tuple[BodyRecord, ...]] = {}
    strips = []
    for name, one in zip(strip_names(placed), placed, strict=True):
        strip = one.strip
        if id(strip) not in solids:
            solids[id(strip)] = BentSolid.layers(strip)
        colors = tuple(sheet_color(sheet) for sheet in bent_sheets(strip))
        strips.append(AssemblyPart(name, solids[id(strip)], colors, one.frame, strip))
    return (*_numbered(strips), *_numbered([_holder_part(holder) for holder in single_holders(holders)]))


def shape_parts(
    parts: Iterable[AssemblyPart], make: Callable[[AssemblyPart], Shape]
) -> Iterator[tuple[AssemblyPart, Shape]]:
    """Yield each part with the shape that `make` makes of it, made once for all parts that share their solids."""
    made: dict[int, Shape] = {}
    for part in parts:
        if id(part.solids) not in made:
            made[id(part.solids)] = make(part)
        yield part, made[id(part.solids)]


def single_holders(holders: Iterable[Holder]) -> Iterator[SingleHolder]:
    """Holders one by one: of slotted frames their rails and ribs.

    Raises
    ------
    InputError
        Something else among them.
    """
    for holder in holders:
        if isinstance(holder, SlottedFrame):
            yield from holder.rails
            yield from holder.ribs
        elif isinstance(holder, SingleHolder):
            yield holder
        else:
            raise InputError(
                "strips are held by base plates, slotted frames and end fixtures, not by "
                f"{type(holder).__name__}"
            )


def _holder_part(holder: SingleHolder) -> AssemblyPart:
    if isinstance(holder, EndFixture):
        return AssemblyPart(holder.label, (holder.solid,), (FIXTURE_COLOR,))
    return AssemblyPart(holder.name, (holder.solid,), (sheet_color(holder.sheet),))


def _numbered(parts: Sequence[AssemblyPart]) -> Iterator[AssemblyPart]:
    """The parts, those with the same name told apart by a number that no other name has."""
    count = Counter(part.name for part in parts)
    used, taken = Counter[str](), set(count)
    for part in parts:
        name = part.name
        while count[part.name] > 1 and name in taken:
            used[part.name] += 1
            name = f"{part.name}_{used[part.name]}"
        taken.add(name)
        yield replace(part, name=name)


FREE = "free"


@dataclass(frozen=True)
class AssemblyStep:
    """One strip to be put in.

    Attributes
    ----------
    number : int
        From 1.
    strip : str
        As it is engraved, with its place where several are called so.
    part : str
        The piece that is cut for it.
    ends : (str, str)
        What holds end 1 and end 2, by name; "hold at (x, y, z)", mm, and the angle from the line between both
        ends, where nothing of the model does; "free".
    locks_into : tuple of str
        Strips that are there already and cross it in a slot.
    """

    number: int
    strip: str
    part: str
    ends: tuple[str, str]
    locks_into: tuple[str, ...] = ()


def list_assembly_steps(model: Model, holders: Iterable[Holder] = ()) -> tuple[AssemblyStep, ...]:
    """The strips in the order of the model, each with its places.

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
    places = _held_at(model, holders)
    parts = {member: part.name for part in model.parts for member in part.members}
    steps = []
    for i in range(len(model.placed)):
        first, last = (
            " and ".join(places[tab_name(model.name_of(i), end)]) or _by_hand(model.placed[i], end)
            for end in ENDS
        )
        before = [min(j.members) for j in model.joints if max(j.members) == i]
        mates = tuple(dict.fromkeys(model.single_name_of(k) for k in before))
        steps.append(AssemblyStep(i + 1, model.single_name_of(i), parts[i], (first, last), mates))
    return tuple(steps)


def unheld_ends(model: Model, holders: Iterable[Holder] = ()) -> dict[int, tuple[StripEnd, ...]]:
    """Ends that the design holds and nothing of the model does, by the place of their strip in the model."""
    places = _held_at(model, holders)
    found = {
        i: tuple(
            end for end in ENDS if not places[tab_name(model.name_of(i), end)] and _by_hand(one, end) != FREE
        )
        for i, one in enumerate(model.placed)
    }
    return {i: ends for i, ends in found.items() if ends}


def _held_at(model: Model, holders: Iterable[Holder]) -> dict[str, list[str]]:
    """Names of what holds each tab, by the name of the tab."""
    places = defaultdict[str, list[str]](list)
    for tab, place in _places([*model.plates, *several("holders", holders, Holder, HOLDERS)]):
        if place not in places[tab]:
            places[tab].append(place)
    return places


def _by_hand(one: Placed, end: StripEnd) -> str:
    """Sentence on where, and how steeply, to hold an end that no part of the model holds."""
    k = ENDS.index(end)
    support = one.strip.rod.supports.ends[k]
    if one.strip.is_closed or not (support.x or support.y or support.angle):
        return FREE
    x, y, z = PlacedTab.of(one.strip, end, one.frame).frame.origin
    turned = f", {held_ends(one.strip)[k].tilt:z.1f} degrees from the line" if support.angle else ""
    return f"hold at ({x:z.1f}, {y:z.1f}, {z:z.1f}){turned}"


def _places(holders: Iterable[Holder]) -> Iterable[tuple[str, str]]:
    """Names of tabs with what holds them."""
    for holder in single_holders(holders):
        if isinstance(holder, BasePlate):
            yield from (
                (slot.name, note("slot {slot} of {holder}", slot=slot.name, holder=holder.name))
                for slot in holder.slots
            )
            if isinstance(holder, Ring):
                yield from ((name, f"on {holder.name}") for name in holder.seated)
        elif isinstance(holder, EndFixture):
            yield holder.tab.name, f"block {holder.engrave or holder.tab.name}"
