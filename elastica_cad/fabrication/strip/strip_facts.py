"""What a body of a strip tells about it."""

from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck

__all__ = ["StripFacts"]


class StripFacts:
    """What a body of a strip tells about it; for the classes of CAD skins."""

    @property
    def strip(self) -> Strip:
        """The strip: widths, outline, strain, mass."""
        raise NotImplementedError

    @property
    def deviation(self) -> float:
        """How far limits moved the strip off the drawn curve, mm."""
        raise NotImplementedError

    @property
    def frame(self) -> Frame:
        """The plane in which the strip's curve lies."""
        raise NotImplementedError

    @property
    def rod(self) -> Rod:
        """The bent rod: shape, stiffness, moment, force."""
        return self.strip.rod

    @property
    def check(self) -> EquilibriumCheck | None:
        """The verdict of Theorem 1 on the drawn curve, where one was asked for."""
        return self.rod.check

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a maker should know before cutting."""
        return self.strip.warnings
