"""What the two ends of a rod are held by."""

from dataclasses import dataclass, field
from typing import Literal, TypeAlias, cast

import numpy as np

from elastica_cad.errors import InputError

EndName: TypeAlias = Literal["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]


@dataclass(frozen=True)
class End:
    """The quantities that one end of the rod fixes.

    Attributes
    ----------
    x, y : bool
        Is this coordinate of the end held? An end free in x slides horizontally.
    angle : bool
        Is the tangent held? If not, the moment and with it kappa - kappa_0 vanish at the end.
    """

    x: bool = True
    y: bool = True
    angle: bool = True

    def __post_init__(self) -> None:
        for name in ("x", "y", "angle"):
            if not isinstance(getattr(self, name), bool | np.bool_):
                raise InputError(
                    "{name} of an End is {given!r}: give True where it is held, False where it is free",
                    name=name,
                    given=getattr(self, name),
                )

    @classmethod
    def named(cls, name: EndName) -> "End":
        """The end called `name`: clamped, pinned, slide-x, slide-y (clamped sliders), guided (angle only), free."""
        ends = {
            "clamped": cls(),
            "pinned": cls(angle=False),
            "slide-x": cls(x=False),
            "slide-y": cls(y=False),
            "guided": cls(x=False, y=False),
            "free": cls(x=False, y=False, angle=False),
        }
        if not isinstance(name, str) or name not in ends:
            raise InputError(
                "unknown end support {name!r}: use one of {ends}, or an End record",
                name=name,
                ends=", ".join(ends),
            )
        return ends[name]


@dataclass(frozen=True)
class Supports:
    """Supports of both ends; the default is clamped at both (paper, section 4.1).

    Parameters
    ----------
    start, end : End or str
        An `End`, or a name that `End.named` knows.

    Raises
    ------
    InputError
        When the rod could move rigidly: a coordinate held at no end, or nothing that stops its rotation.

    Examples
    --------
    >>> Supports("clamped", "pinned").end
    End(x=True, y=True, angle=False)
    """

    start: End | EndName = field(default_factory=End)
    end: End | EndName = field(default_factory=End)

    def __post_init__(self) -> None:
        for side in ("start", "end"):
            value: End | EndName = getattr(self, side)
            if isinstance(value, str):
                object.__setattr__(self, side, End.named(value))
            elif not isinstance(value, End):
                raise InputError(
                    "the support of the {side} is {given!r}: give a name or an End record",
                    side=side,
                    given=value,
                )
        a, b = self.ends
        for axis in ("x", "y"):
            if not (getattr(a, axis) or getattr(b, axis)):
                raise InputError(
                    "the rod is free to fly: no end holds {axis}; hold {axis} at one end at least", axis=axis
                )
        if not (a.angle or b.angle or (a.x and b.x) or (a.y and b.y)):
            raise InputError("the rod is free to spin: hold the angle of one end, or the position of both")

    @property
    def ends(self) -> tuple[End, End]:
        """Both ends as `End` records."""
        return cast(End, self.start), cast(End, self.end)  # `__post_init__` leaves no names

    @property
    def clamped(self) -> bool:
        """True when both ends hold position and angle."""
        return self.ends == (End(), End())

    @property
    def transmits_force(self) -> tuple[bool, bool]:
        """Can a constant force along x, along y be carried? Only where both ends hold that coordinate."""
        a, b = self.ends
        return a.x and b.x, a.y and b.y

    def reversed(self) -> "Supports":
        """The supports of the rod run from its other end."""
        return Supports(self.end, self.start)
