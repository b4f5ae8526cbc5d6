"""Bodies made of prisms: some are put together, others taken away."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from elastica_cad.errors import InputError
from elastica_cad.fabrication.boundary import Frame
from elastica_cad.fabrication.solids import FlatSolid

__all__ = ["PrismSolid"]


@dataclass(frozen=True, eq=False)
class PrismSolid:
    """The union of the prisms `added`, less the prisms `removed`.

    Attributes
    ----------
    added, removed : tuple of FlatSolid
        Closed outlines with holes and thickness, each in its own frame.
    joints : mapping of str to Frame
        Places to join other parts to.

    Raises
    ------
    InputError
        Nothing added.
    """

    added: tuple[FlatSolid, ...]
    removed: tuple[FlatSolid, ...] = ()
    joints: Mapping[str, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if not self.added:
            raise InputError("a body of prisms needs at least one prism")
