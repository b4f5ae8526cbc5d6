"""The bent strips of a model as named bodies in their places."""

from collections import Counter
from dataclasses import dataclass

from elastica_cad.fabrication.boundary import Frame
from elastica_cad.fabrication.model import Model
from elastica_cad.fabrication.solids import BentSolid
from elastica_cad.fabrication.strip import Strip

__all__ = ["BentPart", "bent_parts"]


@dataclass(frozen=True, eq=False)
class BentPart:
    """One body of an assembly.

    Attributes
    ----------
    name : str
        Unlike all other names of the assembly.
    strip : Strip
    solid : BentSolid
        With the curve's plane as its xy plane; bodies of the same strip share it.
    frame : Frame
        Where that plane lies.
    """

    name: str
    strip: Strip
    solid: BentSolid
    frame: Frame


def bent_parts(model: Model) -> tuple[BentPart, ...]:
    """The strips of a model in its order, those with the same name numbered.

    Raises
    ------
    InputError, NotConvergedError
        As `BentSolid.of`.
    """
    solids: dict[int, BentSolid] = {}
    wanted = [model.name_of(index) for index in range(len(model.placed))]
    often, used, taken = Counter(wanted), Counter[str](), set(wanted)
    parts = []
    for name, placed in zip(wanted, model.placed, strict=True):
        strip = placed.strip
        if id(strip) not in solids:
            solids[id(strip)] = BentSolid.of(strip)
        unlike = name
        while often[name] > 1 and unlike in taken:
            used[name] += 1
            unlike = f"{name}_{used[name]}"
        taken.add(unlike)
        parts.append(BentPart(unlike, strip, solids[id(strip)], placed.frame))
    return tuple(parts)
