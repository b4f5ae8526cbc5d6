"""The parts of an assembly: bent strips in their places, and what holds them, named, coloured, shared."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias, TypeVar

from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.sheet_colors import FIXTURE_COLOR, Color, sheet_color
from elastica_cad.fabrication.holders.base_plate import BasePlate
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.ring_plate import Ring
from elastica_cad.fabrication.holders.slotted_frame import Rib, SlottedFrame
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.placed_strip import Placed, strip_names
from elastica_cad.fabrication.solids.strip_solids import BentSolid, BodyRecord, PrismSolid, bent_sheets
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame

HOLDERS = "BasePlate, SlottedFrame, Ring and EndFixture"
"""What strips are held by, as messages say it."""

SingleHolder: TypeAlias = BasePlate | Rib | Ring | EndFixture
Holder: TypeAlias = SingleHolder | SlottedFrame
"""What holds the strips of a model: see `Model.base_plate`, `Model.slotted_frame` and `Model.fixtures`."""

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
        """Of its solids."""
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
    """Each part with what `make` makes of it, made once for all parts that share their solids."""
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
                f"strips are held by base plates, slotted frames and end fixtures, not by {type(holder).__name__}"
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
