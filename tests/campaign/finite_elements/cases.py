"""The bank: strips whose cut files are bent, by what could lead them astray."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from elastica_cad import Laminated, Perforated, PlaneCurve, Sheet, Slot, StripSpec, Tab

__all__ = ["CASES", "CURVES", "Case"]


def arcs(*parts: tuple[float, float]) -> PlaneCurve:
    """Arcs (radius, angle) joined smoothly, as one rational quadratic: the width steps where they meet."""
    p, theta = np.zeros(2), 0.0
    points, weights, knots = [p], [1.0], [0.0] * 3
    for i, (radius, angle) in enumerate(parts):
        reach = radius * np.tan(angle / 2)
        middle = p + reach * np.array([np.cos(theta), np.sin(theta)])
        theta += angle
        p = middle + reach * np.array([np.cos(theta), np.sin(theta)])
        points += [middle, p]
        weights += [np.cos(angle / 2), 1.0]
        knots += [i + 1.0] * 2
    return PlaneCurve(np.array([*knots, knots[-1]]), np.array(points), 2, np.array(weights))


CURVES: Mapping[str, PlaneCurve] = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4),
    "bow": PlaneCurve.spline([(0, 0), (40, 80), (110, 100), (190, 50), (240, 0)], degree=4),
    "S": PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)], degree=4),
    "tall ellipse": PlaneCurve.ellipse((5, 3), (60, 120), 0.3, 0.3, 2.5),
    "hook": PlaneCurve.spline([(0, 0), (80, 0), (120, 40), (90, 90), (50, 70)], degree=3),
    "two arcs": arcs((70, 1.6), (140, 1.2)),
    "three arcs": arcs((120, 0.9), (60, 1.5), (120, 0.9)),
    "four arcs": arcs((60, 1.0), (90, 0.8), (60, 1.0), (110, 0.7)),
}


@dataclass(frozen=True)
class Case:
    """One strip: what is asked of it, and how fine it is meshed.

    Attributes
    ----------
    group : str
        What could lead it astray.
    name : str
    curve : str
    length : float
        To which the curve is scaled, mm.
    sheet : Sheet
    size : float
        Of elements, mm.
    asked : mapping
        More of `StripSpec`.
    """

    group: str
    name: str
    curve: str
    length: float
    sheet: Sheet
    size: float
    asked: Mapping[str, Any] = field(default_factory=dict)

    @property
    def spec(self) -> StripSpec:
        """The request."""
        drawn = CURVES[self.curve]
        scaled = drawn.transformed(np.diag([1.0, 1.0, drawn.length / self.length]))
        return StripSpec(scaled, self.sheet, **self.asked)

    @property
    def has_default_widths(self) -> bool:
        """Are its widths by default others than the stiffness alone asks for?"""
        return self.spec.makes_up_for_curl


def ply(thickness: float = 0.8, poisson_ratio: float = 0.3) -> Sheet:
    """A sheet like birch plywood."""
    return Sheet(f"ply {thickness:g}", thickness, 9000.0, 680.0, max_strain=0.02, poisson_ratio=poisson_ratio)


CARD = Sheet.named("card-200gsm")


def _plain() -> Iterator[Case]:
    for nu in (0.0, 0.3):
        for curve in CURVES:
            if "arcs" in curve:
                continue
            yield Case(f"plain, nu {nu:g}", curve, curve, 300.0, ply(0.8, nu), 4.0, {"max_width": 30.0})
        small = {"max_width": 6.0, "ends": (Tab(2.0), Tab(2.0)), "ignore_limits": True}
        yield Case(f"plain, nu {nu:g}", "small arch", "arch", 50.0, ply(0.2, nu), 0.8, small)
        large = {"max_width": 200.0, "ends": (Tab(60.0), Tab(60.0)), "ignore_limits": True}
        yield Case(f"plain, nu {nu:g}", "arch of 3 m", "arch", 3000.0, ply(6.0, nu), 25.0, large)
        yield Case(f"plain, nu {nu:g}", "wide bow", "bow", 300.0, ply(0.8, nu), 5.0, {"max_width": 80.0})


def _heavy() -> Iterator[Case]:
    for nu in (0.0, 0.3):
        card = replace(CARD, poisson_ratio=nu)
        for curve, width, length in (("arch", 45.0, 300.0), ("arch", 60.0, 450.0), ("bow", 45.0, 300.0),
                                     ("bow", 60.0, 500.0), ("tall ellipse", 45.0, 300.0)):  # fmt: skip
            request = {"max_width": width, "gravity": True}
            name = f"{curve}, {length:g} mm long, {width:g} mm wide"
            yield Case(f"heavy, nu {nu:g}", name, curve, length, card, 5.0, request)
        large = {"max_width": 300.0, "ends": (Tab(60.0), Tab(60.0)), "ignore_limits": True, "gravity": True}
        yield Case(f"heavy, nu {nu:g}", "arch of 3 m", "arch", 3000.0, ply(4.0, nu), 40.0, large)


def _perforated() -> Iterator[Case]:
    for nu, curve, rows in ((0.0, "arch", 3), (0.0, "arch", 12), (0.3, "bow", 6)):
        yield _holed(nu, curve, rows, 30.0, 2.5)
    for nu, curve, rows in ((0.0, "arch", 6), (0.0, "arch", 12), (0.3, "bow", 9)):
        yield _holed(nu, curve, rows, 60.0, 2.5)
    yield _holed(0.3, "bow", 9, 90.0, 3.0)  # ligaments lean by up to 48 degrees


def _holed(nu: float, curve: str, rows: int, width: float, size: float) -> Case:
    style = Perforated(width=width, columns=2, rows=rows, least_ligament=0.2, least_hole=0.2)
    name = f"{curve}, 2 x {rows}, {width:g} mm wide"
    request = {"style": style, "max_width": width / 3, "ignore_limits": True}
    return Case(f"perforated, nu {nu:g}", name, curve, 300.0, ply(0.8, nu), size, request)


def _laminated() -> Iterator[Case]:
    for nu, curve, width, length in ((0.0, "arch", 24.0, 300.0), (0.0, "arch", 24.0, 900.0),
                                     (0.0, "bow", 12.0, 300.0), (0.3, "arch", 12.0, 300.0),
                                     (0.3, "S", 12.0, 300.0)):  # fmt: skip
        style = Laminated(width=width, backing=ply(0.5, nu), dots=0.0)
        request = {"style": style, "max_width": 0.85 * width}
        name = f"{curve}, {length:g} mm long, {width:g} mm wide"
        yield Case(f"laminated, nu {nu:g}", name, curve, length, ply(0.5, nu), 5.0, request)


def _slotted() -> Iterator[Case]:
    places: Mapping[str, tuple[Slot, ...]] = {
        "one slot": (Slot(105.0, width=1.0),),
        "two slots": (Slot(105.0, width=1.0), Slot(210.0, width=1.0, side="lower")),
        "four slots": tuple(
            Slot(60.0 * i, width=1.0, side="upper" if i % 2 else "lower") for i in (1, 2, 3, 4)
        ),
    }
    for nu, curve, slots in ((0.0, "arch", "one slot"), (0.0, "arch", "two slots"), (0.3, "arch", "two slots"),
                             (0.3, "bow", "four slots"), (0.3, "S", "two slots")):  # fmt: skip
        request = {"max_width": 30.0, "slots": places[slots]}
        yield Case(f"slotted, nu {nu:g}", f"{curve}, {slots}", curve, 300.0, ply(0.8, nu), 3.5, request)


def _narrow_tabs() -> Iterator[Case]:
    for nu, curve, width in ((0.0, "arch", 8.0), (0.0, "bow", 14.0), (0.3, "arch", 8.0), (0.3, "bow", 8.0),
                             (0.3, "S", 8.0)):  # fmt: skip
        request = {"max_width": 30.0, "ends": (Tab(12.0, width=width), Tab(12.0, width=width))}
        name = f"{curve}, tabs of {width:g} mm"
        yield Case(f"narrow tabs, nu {nu:g}", name, curve, 300.0, ply(0.8, nu), 3.5, request)


def _stepped() -> Iterator[Case]:
    for nu, curve, width in (
        (0.0, "two arcs", 30.0),
        (0.0, "two arcs", 60.0),
        (0.0, "three arcs", 30.0),
        (0.0, "four arcs", 30.0),
        (0.3, "two arcs", 30.0),
        (0.3, "three arcs", 30.0),
    ):
        name = f"{curve}, {width:g} mm wide"
        request = {"max_width": width, "ignore_limits": True, "smooth": 0.0}
        yield Case(f"steps of width, nu {nu:g}", name, curve, 300.0, ply(0.8, nu), 3.0, request)


CASES: tuple[Case, ...] = (
    *_plain(),
    *_stepped(),
    *_heavy(),
    *_perforated(),
    *_laminated(),
    *_slotted(),
    *_narrow_tabs(),
)
