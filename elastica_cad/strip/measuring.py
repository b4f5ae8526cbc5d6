"""Measurements on a bent strip with ruler and protractor, their expected values, and causes of differences."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.refusals import Refusal, note
from elastica_cad.strip.held_shape import shape_responses
from elastica_cad.strip.strip import Strip

MARKS = (0.25, 0.5, 0.75)
"""Places at which heights are measured, as fractions of the length."""

LENGTHS, ANGLES = ("chord", "height_1", "height_2", "height_3"), ("start_angle", "end_angle")
"""Measured quantities: mm from end to end, mm from that line to the marks, degrees between line and tabs."""

SKETCHED = 60
"""Approximate number of points of the curve for a page."""

UNEVEN_SHARE = 0.02
"""Least relative difference of the stiffness at equal distances from both ends; else the ends are equivalent."""

EXPLAINED = 0.6
"""Least fraction of the differences that a reported cause must explain."""

MEANINGS: Mapping[str, str] = {
    "clamp at the start": "the clamp at the start lets the strip turn by {amount:.2g} degrees: tighten it",
    "clamp at the end": "the clamp at the end lets the strip turn by {amount:.2g} degrees: tighten it",
    "ends apart": "the ends are {amount:.2g} mm off their distance: a tab slips, or the holder is not as drawn",
    "thinner sheet": "the sheet is {amount:.2g} % off its thickness, so it sags otherwise: measure its thickness",
    "thickness": "the sheet is thicker at one place than at another, by {amount:.2g} %: measure it along the strip",
    "end for end": "it is mounted end for end: turn it round",
    "wrong side": "its backing lies on the wrong side of the bend: turn it over",
}
"""Meaning of each cause for a maker."""

ONCE = ("end for end", "wrong side")
"""Causes without a size, which are present or not."""

THICKEST_PERCENT = 6.0
"""Largest wave of the thickness of a sheet, in percent."""


@dataclass(frozen=True)
class Measuring:
    """Measurements on a strip, and their changes due to possible faults.

    Attributes
    ----------
    marks : tuple of float
        Places at which heights are measured, mm along the free part.
    expected : mapping of str to float
        "chord", "height_1" to "height_3" in mm, "start_angle" and "end_angle" in degrees.
    uncertain : mapping of str to float
        Uncertainty of each value due to model, sheet, cut and clamps.
    causes : mapping of str to tuple of mapping
        Changes of the values due to each of `MEANINGS`: for one degree, millimetre or percent, or in all. A wave
        has two such changes.
    shape : tuple of (float, float)
        Points of the curve, evenly along it, mm.

    Examples
    --------
    >>> measuring = Measuring((), {"chord": 100.0}, {"chord": 0.5}, {"ends apart": ({"chord": 1.0},)})
    >>> print(*measuring.compare({"chord": 100.4}), sep="; ")
    chord: 100.4 measured, 100 +/- 0.5 expected; all measurements are within the expected uncertainty of sheet, \
cut, clamps and model
    """

    marks: tuple[float, ...]
    expected: Mapping[str, float]
    uncertain: Mapping[str, float]
    causes: Mapping[str, Sequence[Mapping[str, float]]]
    shape: tuple[tuple[float, float], ...] = ()

    @classmethod
    def of(cls, strip: Strip) -> "Measuring":
        """Return the measurements on a strip whose ends are held as designed.

        Raises
        ------
        InputError
            The strip is closed.
        NotConvergedError
            The rest shape was not found.
        """
        require_record(strip, Strip, "the strip", "a Strip")
        if strip.is_closed:
            raise InputError("a closed strip has no ends to measure from: measure its widths instead")
        as_made, held = strip.as_made, strip.held()
        design, loaded = as_made.design, as_made.loaded
        n, M, s = design.s.size, loaded.moment, design.s
        phases = 2 * np.pi * s / design.length
        columns: dict[str, list[FloatArray]] = {
            "thickness": [0.03 * M * np.cos(phases), 0.03 * M * np.sin(phases)]
        }
        for k, name in enumerate(("start", "end")):
            turned = np.zeros(n)
            turned[-k] = np.radians(1.0) * loaded.stiffness[-k] / loaded.discrete.node_lengths[-k]
            columns[f"clamp at the {name}"] = [turned]
        reversed_share = design.stiffness[::-1] / design.stiffness - 1
        if np.abs(reversed_share).max() > UNEVEN_SHARE:
            columns["end for end"] = [M * reversed_share]
        if as_made.curl is not None and strip.layout.backing is not None:
            over = as_made.curl.factor(-design.curvature) / as_made.curl.factor(design.curvature) - 1
            columns["wrong side"] = [M * over]
        columns["ends apart"] = [np.zeros(n)]
        if loaded.gravity is not None:
            columns["thinner sheet"] = [np.zeros(n)]
        owners = [cause for cause, column_list in columns.items() for _ in column_list]
        chord = design.position[-1] - design.position[0]
        apart, loads = np.zeros((len(owners), 2)), np.zeros((n, len(owners), 2))
        apart[owners.index("ends apart")] = chord / np.hypot(*chord)
        if "thinner sheet" in owners:  # E I ~ h^3, weight ~ h
            loads[:, owners.index("thinner sheet")] = 0.02 * loaded.nodal_load
        moments = np.column_stack([column for column_list in columns.values() for column in column_list])
        moved = shape_responses(loaded, moments, loads, apart)
        expected = _measured(design.position)
        causes: dict[str, list[dict[str, float]]] = {}
        for k, cause in enumerate(owners):
            lengths = _measured(design.position + moved[:, k])
            causes.setdefault(cause, []).append({name: lengths[name] - expected[name] for name in expected})
        off = np.degrees(strip.tolerance.clamps + held.expected / design.length)
        uncertain = dict.fromkeys(LENGTHS, held.expected) | dict.fromkeys(ANGLES, float(off))
        return cls(
            tuple(share * design.length for share in MARKS),
            expected,
            uncertain,
            {cause: tuple(change_list) for cause, change_list in causes.items()},
            tuple(map(tuple, design.position[:: max(1, n // SKETCHED)].tolist())),
        )

    def compare(self, measured: Mapping[str, float]) -> tuple[Refusal, ...]:
        """Compare measured with expected values, and find the causes of the differences.

        Raises
        ------
        InputError
            None of the expected quantities was measured.
        """
        require_record(measured, Mapping, "what was measured", "a mapping from names to numbers")
        names = [name for name in self.expected if name in measured]
        unknown = [name for name in measured if name not in self.expected]
        if unknown or not names:
            raise InputError(
                f"{', '.join(unknown) or 'an empty file'} is not among the expected measurements: give some "
                f"of {', '.join(self.expected)}"
            )
        messages = [
            note(
                "{name}: {measured:.4g} measured, {expected:.4g} +/- {uncertain:.2g} expected",
                name=name, measured=measured[name], expected=self.expected[name], uncertain=self.uncertain[name],
            )
            for name in names
        ]  # fmt: skip
        weights = np.array([1 / self.uncertain[name] for name in names])
        off = weights * np.array([measured[name] - self.expected[name] for name in names])
        if np.abs(off).max() <= 1.0:
            return (
                *messages,
                note("all measurements are within the expected uncertainty of sheet, cut, clamps and model"),
            )
        best, amount, left = "", 0.0, 1.0
        for cause, changes in self.causes.items():
            G = weights[:, None] * np.array([[change[name] for change in changes] for name in names])
            answer = np.linalg.lstsq(G, off, rcond=None)[0]
            rest = float(np.linalg.norm(off - G @ answer) / np.linalg.norm(off))
            size = float(np.linalg.norm(answer))
            far = (cause in ONCE and not 0.5 < answer[0] < 1.5) or (
                cause == "thickness" and size > THICKEST_PERCENT
            )
            if len(names) > len(changes) and not far and rest < left:
                best, amount, left = cause, size, rest
        if left > 1 - EXPLAINED:
            return (
                *messages,
                note("no single cause explains the difference: measure again, and check sheet and side"),
            )
        return (*messages, note(MEANINGS[best], amount=amount))


def _measured(position: FloatArray) -> dict[str, float]:
    """Return the measured values of a shape (n, 2) on even nodes; the largest height is positive."""
    chord = position[-1] - position[0]
    length = float(np.hypot(*chord))
    along = chord / length
    at = np.array(MARKS) * (len(position) - 1)
    x, y = (np.interp(at, np.arange(len(position)), column) for column in (position - position[0]).T)
    heights = along[0] * y - along[1] * x
    side = float(np.sign(heights[np.abs(heights).argmax()]))
    first, last = position[1] - position[0], position[-1] - position[-2]
    angles = [np.degrees(np.arctan2(along[0] * d[1] - along[1] * d[0], along @ d)) for d in (first, last)]
    values = (length, *(side * heights), side * angles[0], -side * angles[1])
    return dict(zip((*LENGTHS, *ANGLES), map(float, values), strict=True))
