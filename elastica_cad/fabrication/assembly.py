"""The bent strips of a model as named bodies in their places."""

from collections import Counter
from dataclasses import dataclass

from elastica_cad.fabrication.boundary import Frame
from elastica_cad.fabrication.model import Model
from elastica_cad.fabrication.solids import BentSolid
from elastica_cad.fabrication.strip import Strip

__all__ = ["BentPart", "bent_parts", "layer_names"]


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
