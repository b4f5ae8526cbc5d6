"""Cut list and cutting pattern of a strip of glued plies. Marks on a ply show the position of the next ply."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.model.cut_rows import CutList, cut_list
from elastica_cad.strip.drawing import Drawing
from elastica_cad.strip.pieces import Piece
from elastica_cad.strip.strip import Strip


@dataclass(frozen=True, eq=False)
class LeafStack:
    """Workshop documents of a strip of glued plies.

    Attributes
    ----------
    strip : Strip
        Strip with a `LeavesLaw`.
    """

    strip: Strip

    def __post_init__(self) -> None:
        require_record(self.strip, Strip, "what is of leaves", "a Strip")
        if self.strip.layout.stack is None:
            raise InputError("the strip has no plies: make it with section=LeavesLaw(sheet, leaves, width)")

    @property
    def cut_list(self) -> CutList:
        """Cut list with one row for each ply, the full-length ply first."""
        stack, label = self.strip.layout.stack, self.strip.label or "stack"
        assert stack is not None
        layers = zip(self.strip.drawings(), self.strip.layers, stack.names, strict=True)
        leaves = [Piece(f"{label} {name}", drawing, layer.sheet) for drawing, layer, name in layers]
        return cut_list(leaves, dict.fromkeys((leaf.name for leaf in leaves), ""))

    @property
    def drawing(self) -> Drawing:
        """Pattern of the plies at full size, one below another, at their positions along the stack.

        Marks across each ply show the ends of the next plies.
        """
        # the plies are at least 5 mm apart
        pitch = float(np.ptp(self.strip.outline.bounds[:, 1])) + 5.0
        moved = [
            path.transformed(np.array([[1, 0, 0], [0, 1, -i * pitch], [0, 0, 1]]))
            for i, path in enumerate(self.strip.drawings())
        ]
        return Drawing.merged(self.strip.label or "stack", moved)
