"""Glued leaves as they are cut and laid: a list, and a pattern with marks where the next leaf goes."""

from dataclasses import dataclass

from elastica_cad.fabrication.drawings.drawing import CUT_OUTER, MARK, Drawing, LayeredPath
from elastica_cad.fabrication.drawings.lettering import Text
from elastica_cad.fabrication.sheets.cut_list import CutList, CutListRow
from elastica_cad.forming.leaf_ends import Leaf, LeafedRod
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line
from elastica_cad.mechanics.loads.weight import STANDARD_GRAVITY_M_S2

APART_MM = 5.0
"""Between the leaves of the pattern."""

LETTER_SHARE = 0.4
"""Of a leaf's width: the height of its letters."""

HIGHEST_LETTER_MM = 4.0


@dataclass(frozen=True, eq=False)
class LeafStack:
    """What a workshop makes of a `LeafedRod`.

    Attributes
    ----------
    leafed : LeafedRod
    label : str
    """

    leafed: LeafedRod
    label: str = "stack"

    @property
    def names(self) -> tuple[str, ...]:
        """One a leaf: its number, and a letter where it is in pieces."""
        numbers = [leaf.number for leaf in self.leafed.leaves]
        seen: dict[int, int] = {}
        found = []
        for number in numbers:
            piece = seen[number] = seen.get(number, -1) + 1
            found.append(f"{number}{chr(ord('a') + piece) if numbers.count(number) > 1 else ''}")
        return tuple(found)

    @property
    def cut_list(self) -> CutList:
        """A row for every leaf, the through one first."""
        law = self.leafed.law
        rows = [
            CutListRow(
                part=f"{self.label} {name}",
                sheet=law.sheet.name,
                thickness=law.sheet.thickness,
                length=leaf.length,
                width=law.width,
                count=1,
                cut_length=2 * (leaf.length + law.width),
                mass=float(law.weight_per_length(1)) * leaf.length / (STANDARD_GRAVITY_M_S2 * 1e-3),
                file="",
            )
            for name, leaf in zip(self.names, self.leafed.leaves, strict=True)
        ]
        return CutList(tuple(rows))

    @property
    def drawing(self) -> Drawing:
        """Every leaf at full size, where it lies along the stack, one below another; on each a mark across at the
        ends of the leaves that are glued on it."""
        leaves, width = self.leafed.leaves, self.leafed.law.width
        pitch, height = width + APART_MM, min(HIGHEST_LETTER_MM, LETTER_SHARE * width)
        paths, texts = [], []
        for i, (leaf, name) in enumerate(zip(leaves, self.names, strict=True)):
            low = -i * pitch
            paths += [
                LayeredPath(MARK, Path((Line((s, low), (s, low + width)),))) for s in _marks(leaf, leaves)
            ]
            corners = [(leaf.start, low), (leaf.end, low), (leaf.end, low + width), (leaf.start, low + width)]
            sides = tuple(Line(a, b) for a, b in zip(corners, corners[1:] + corners[:1], strict=True))
            paths.append(LayeredPath(CUT_OUTER, Path(sides, closed=True)))
            place = (leaf.start + height, low + (width - height) / 2)
            texts.append(Text(place, f"{self.label} {name}: {leaf.start:.0f} - {leaf.end:.0f}", height, 0.0))
        return Drawing(self.label, tuple(paths), tuple(texts))


def _marks(leaf: Leaf, leaves: tuple[Leaf, ...]) -> list[float]:
    """Where, strictly inside a leaf, leaves of the next number begin and end."""
    above = [one for one in leaves if one.number == leaf.number + 1]
    return [s for one in above for s in (one.start, one.end) if leaf.start < s < leaf.end]
