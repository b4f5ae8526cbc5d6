"""The bent strips of a model as named bodies in their places, and the bodies that hold them."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeAlias

from elastica_cad.errors import InputError
from elastica_cad.fabrication.base import BasePlate
from elastica_cad.fabrication.boundary import Frame
from elastica_cad.fabrication.colors import FIXTURE_COLOR, sheet_color
from elastica_cad.fabrication.fixtures import EndFixture
from elastica_cad.fabrication.frames import Rib, SlottedFrame
from elastica_cad.fabrication.model import Model
from elastica_cad.fabrication.prisms import PrismSolid
from elastica_cad.fabrication.rings import Ring
from elastica_cad.fabrication.solids import BentSolid, FlatSolid
from elastica_cad.fabrication.strip import Strip

__all__ = ["BentPart", "Holder", "HolderBody", "bent_parts", "holder_bodies", "layer_names"]

Holder: TypeAlias = BasePlate | SlottedFrame | Rib | Ring | EndFixture
"""What holds the strips of a model: see `Model.base_plate`, `slotted_frame` and `Model.fixtures`."""


@dataclass(frozen=True, eq=False)
class BentPart:
    """One strip of an assembly.

    Attributes
    ----------
    name : str
        Unlike all other names of the assembly.
    strip : Strip
    solids : tuple of BentSolid
        One for each sheet, the curve's plane as their xy plane; bodies of the same strip share them.
    frame : Frame
        Where that plane lies.
    """

    name: str
    strip: Strip
    solids: tuple[BentSolid, ...]
    frame: Frame

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its solids."""
        return layer_names(self.name, self.strip)


def layer_names(name: str, strip: Strip) -> tuple[str, ...]:
    """Names of a strip's sheets: its own for the base, with "backing" for what is glued on."""
    return (name, f"{name} backing")[: len(strip.layers)]


def bent_parts(model: Model) -> tuple[BentPart, ...]:
    """The strips of a model in its order, those with the same name numbered.

    Raises
    ------
    InputError, NotConvergedError
        As `BentSolid.of`.
    """
    solids: dict[int, tuple[BentSolid, ...]] = {}
    wanted = [model.name_of(index) for index in range(len(model.placed))]
    often, used, taken = Counter(wanted), Counter[str](), set(wanted)
    parts = []
    for name, placed in zip(wanted, model.placed, strict=True):
        strip = placed.strip
        if id(strip) not in solids:
            solids[id(strip)] = BentSolid.layers(strip)
        unlike = name
        while often[name] > 1 and unlike in taken:
            used[name] += 1
            unlike = f"{name}_{used[name]}"
        taken.add(unlike)
        parts.append(BentPart(unlike, strip, solids[id(strip)], placed.frame))
    return tuple(parts)


@dataclass(frozen=True, eq=False)
class HolderBody:
    """A plate or a block of an assembly, in its place.

    Attributes
    ----------
    name : str
    solid : FlatSolid or PrismSolid
    color : (red, green, blue)
        In 0..1, as on a screen.
    """

    name: str
    solid: FlatSolid | PrismSolid
    color: tuple[float, float, float]


def holder_bodies(holders: Iterable[Holder]) -> tuple[HolderBody, ...]:
    """The bodies of base plates, frames and fixtures, those with the same name numbered.

    Raises
    ------
    InputError
        Something else among them.
    """
    found: list[HolderBody] = []
    for holder in holders:
        if isinstance(holder, SlottedFrame):
            plates: tuple[BasePlate | Rib, ...] = (*holder.rails, *holder.ribs)
            found += [_plate(plate) for plate in plates]
        elif isinstance(holder, BasePlate | Rib | Ring):
            found.append(_plate(holder))
        elif isinstance(holder, EndFixture):
            found.append(HolderBody(f"fixture {holder.number}", holder.solid, FIXTURE_COLOR))
        else:
            raise InputError(
                f"strips are held by base plates, slotted frames and end fixtures, not by {type(holder).__name__}"
            )
    names = Counter(body.name for body in found)
    used = Counter[str]()
    bodies = []
    for body in found:
        used[body.name] += 1
        name = f"{body.name}_{used[body.name]}" if names[body.name] > 1 else body.name
        bodies.append(HolderBody(name, body.solid, body.color))
    return tuple(bodies)


def _plate(plate: BasePlate | Rib | Ring) -> HolderBody:
    return HolderBody(plate.name, plate.solid, sheet_color(plate.sheet))
