"""Properties that bodies of flexures have in every CAD library. A flexure is a part with two rest shapes."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from elastica_cad._values import require_record
from elastica_cad.kernel.strip_body import color_numbers
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.strip.drawing import Drawing
from elastica_cad.strip.solids import FlatSolid

if TYPE_CHECKING:
    from elastica_cad.pairs.flexure import Flexure, State


@dataclass(frozen=True, eq=False)
class MadeFlexure:
    """Flexure, state and colour of a body, shared by its copies."""

    flexure: "Flexure"
    state: "State | None"
    color: tuple[float, ...]

    @classmethod
    def of(cls, flexure: "Flexure", state: "State | None", color: Any) -> "MadeFlexure":
        """Return the record. `color` is a colour of the library, a name, or numbers; None is the sheet's colour."""
        from elastica_cad.pairs.flexure import Flexure

        require_record(flexure, Flexure, "the part", "a Flexure")
        return cls(flexure, state, sheet_color(flexure.sheet) if color is None else color_numbers(color))

    def __deepcopy__(self, memo: dict[int, Any]) -> "MadeFlexure":
        return self

    @property
    def name(self) -> str:
        """Name of the body."""
        return self.flexure.label or "flexure"

    @property
    def solid(self) -> FlatSolid:
        """Solid of the flexure in the state of the body."""
        return self.flexure.solid_in(self.state)


class FlexureBody:
    """Properties that a body of a flexure has in every CAD library."""

    _made: MadeFlexure
    label: str
    color: Any
    wrapped: Any

    def __repr__(self) -> str:
        state = f", {self.state} state" if self.state else ""
        return f"<{type(self).__name__} {self.label!r} of {self.flexure!r}{state}>"

    def drawing(self) -> Drawing:
        """Return the drawing of the unloaded part."""
        return self.flexure.drawing()

    def _named_parts(self) -> tuple["FlexureBody"]:
        return (self,)

    @property
    def flexure(self) -> "Flexure":
        """Flexure with its thickness, strain, forces and the path between its states."""
        return self._made.flexure

    @property
    def state(self) -> "State | None":
        """State of the body: "first", "second", or None for the unloaded shape."""
        return self._made.state
