"""Measurements on a bent strip with ruler and protractor, their expected values, and causes of differences."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_positive, require_record
from elastica_cad.errors import Degrees, InputError, Length, Quantity, number_text
from elastica_cad.geometry.plane_points import norm, points_at, turn_between, unit
from elastica_cad.mechanics.stability import stability
from elastica_cad.report_rows import Row, warning_row
from elastica_cad.strip.held_shape import shape_responses
from elastica_cad.strip.holding_template import MARKS, distance_of_tips, heights_of_marks, held_ends, upward
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.summary import instability_in_plane

LENGTHS, ANGLES = ("chord", "height_1", "height_2", "height_3"), ("start_angle", "end_angle")
"""Names of the measured quantities: distance of the ends, heights of marks, and angles of tabs.

Lengths are in mm and angles in degrees. Heights and angles are measured from the line between the ends."""

KINDS: dict[str, type[Quantity]] = dict.fromkeys(LENGTHS, Length) | dict.fromkeys(ANGLES, Degrees)


CHANCE = 0.03
"""Probability that errors of reading alone are mistaken for a cause."""

NONLINEAR = 0.2
"""Fraction of the measured differences that a cause may leave unexplained, because the changes are computed
to first order."""

MEANINGS: Mapping[str, str] = {
    "clamp at the start": "The clamp at the start lets the strip turn by {amount:.2g} degrees. Tighten it.",
    "clamp at the end": "The clamp at the end lets the strip turn by {amount:.2g} degrees. Tighten it.",
    "ends apart": (
        "The distance between the ends is {amount:.2g} mm off. Check whether a tab slips, and measure the fixture."
    ),
    "thinner sheet": (
        "The thickness of the sheet is {amount:.2g} % off, so the strip sags differently. Measure the thickness."
    ),
    "thickness": (
        "The thickness varies by +/- {amount:.2g} % along the strip. Measure it at several places."
    ),
    "end for end": "The strip is mounted end for end. Turn it round.",
    "wrong side": "The backing is on the wrong side of the bend. Turn the strip over.",
}
"""Message for each cause of a difference."""

NO_ANGLES = "Not read. Read the angles too, because a clamp that turns is rarely found without them."

READING_ERROR_MM = 2.0
"""Default standard error of a length read with a ruler.

The default was chosen by 400 simulated readings with an error of 1.5 mm. A default of 1 mm raised 23 % false alarms
and found 86 % of the clamps that turned by 4 degrees. With 2 mm, these numbers were 3 % and 93 %."""

SLIPS: Mapping[str, str] = {
    "centimetres": "The lengths agree with the design if they are in centimetres. Write them in mm.",
    "inches": "The lengths agree with the design if they are in inches. Write them in mm.",
    "other end": "The marks are counted from the other end. Exchange height_1 and height_3.",
    "ends exchanged": (
        "The strip is read from the other end. Exchange height_1 and height_3, and start_angle and end_angle."
    ),
    "signs": "All heights and angles have the opposite sign. Read their signs from the measuring page.",
    "turned": (
        "The readings agree with the design turned by 180 degrees. Read them again, with the strip in the position "
        "that the measuring page shows. If they do not change, the strip is mounted end for end: exchange its ends."
    ),
    "tips": "The chord is measured between the tips of the tabs. Measure it where the bend begins.",
}
"""Message for each mistake in taking the readings."""

UNEXPLAINED = "No single cause explains the differences. Measure again, and check the sheet and its side."

SNAPPED = (
    "No single cause explains the differences. The strip may have snapped into another shape, because it is "
    "unstable or close to snapping. Compare its shape with the drawing. If it has the drawn shape, measure again."
)

EXCHANGES: Mapping[str, Mapping[str, str]] = {
    "other end": {"height_1": "height_3", "height_3": "height_1"},
    "ends exchanged": {
        "height_1": "height_3", "height_3": "height_1", "start_angle": "end_angle", "end_angle": "start_angle",
    },
}  # fmt: skip
"""Mistakes that exchange readings. For each mistake, a mapping from the right name of a reading to the name under
which it was written."""


@dataclass(frozen=True)
class Measuring:
    """Expected measurements on a strip, and how possible errors change them.

    Attributes
    ----------
    marks : tuple of float
        Arc lengths at which heights are measured, mm from the start of the bent part.
    expected : mapping of str to float
        Expected values: "chord" and "height_1" to "height_3" in mm, "start_angle" and "end_angle" in degrees.
    uncertain : mapping of str to float
        Uncertainty of each expected value due to model, sheet, cut and clamps.
    causes : mapping of str to tuple of mapping
        Changes of the expected values due to each cause of `MEANINGS`, per degree, millimetre or percent. Causes
        without an amount have their whole change. A periodic variation of the thickness has two sets of changes,
        for sine and cosine.
    shape : tuple of (float, float)
        Evenly spaced points of the curve, mm.
    tips : float or None
        Distance between the tips of the tabs, mm.
    can_snap : bool
        True if the strip is unstable or close to snapping.

    Examples
    --------
    >>> from elastica_cad.report_rows import printed_row
    >>> measuring = Measuring((), {"chord": 100.0}, {"chord": 0.5}, {"ends apart": ({"chord": 1.0},)})
    >>> for row in measuring.compare({"chord": 100.4}):
    ...     print(printed_row(row))
    Verdict     All differences are within the reading error and the uncertainty of sheet, cut, clamps and model.
    Readings    Measured values are assumed to be exact to 2 mm and 1 degree.
    Angles      Not read. Read the angles too, because a clamp that turns is rarely found without them.
    Chord       100.4 mm measured, 100 +/- 0.5 mm expected
    """

    marks: tuple[float, ...]
    expected: Mapping[str, float]
    uncertain: Mapping[str, float]
    causes: Mapping[str, Sequence[Mapping[str, float]]]
    shape: tuple[tuple[float, float], ...] = ()
    tips: float | None = None
    can_snap: bool = False

    @classmethod
    def of(cls, strip: Strip) -> "Measuring":
        """Return the measurements on a strip whose ends are held as designed.

        Raises
        ------
        NotConvergedError
            The rest shape was not found.
        """
        require_record(strip, Strip, "the strip", "a Strip")
        if strip.is_closed:
            raise InputError("a closed strip has no ends to measure from. Measure its widths instead.")
        as_made, held = strip.as_made, strip.held()
        design, loaded = as_made.design, as_made.loaded
        n, M, s = design.s.size, loaded.moment, design.s
        phases = 2 * np.pi * s / design.length
        # (cause, changes of the moments (n,) at fixed edge angles), as in `shape_responses`, for a unit amount.
        # 1 % of thickness is 3 % of stiffness, and a clamp turned by 1 degree bends the last half edge
        moments = [("thickness", 0.03 * M * np.cos(phases)), ("thickness", 0.03 * M * np.sin(phases))]
        for k, name in enumerate(("start", "end")):
            turned = np.zeros(n)
            turned[-k] = np.radians(1.0) * loaded.stiffness[-k] / loaded.discrete.node_lengths[-k]
            moments.append((f"clamp at the {name}", turned))
        reversed_share = design.stiffness[::-1] / design.stiffness - 1
        # if the stiffness is symmetric, a strip that is mounted end for end cannot be recognized
        if np.abs(reversed_share).max() > 0.02:
            moments.append(("end for end", M * reversed_share))
        if as_made.curl is not None and strip.layout.backing is not None:
            over = as_made.curl.factor(-design.curvature) / as_made.curl.factor(design.curvature) - 1
            moments.append(("wrong side", M * over))
        # these causes change no moment, but the distance of the ends or the weight below
        moments.append(("ends apart", np.zeros(n)))
        if loaded.gravity is not None:
            moments.append(("thinner sheet", np.zeros(n)))
        owners, columns = zip(*moments, strict=True)
        apart, loads = np.zeros((len(owners), 2)), np.zeros((n, len(owners), 2))
        apart[owners.index("ends apart")] = unit(design.chord)
        if loaded.gravity is not None:  # weight / E I is proportional to 1 / thickness^2
            loads[:, owners.index("thinner sheet")] = 0.02 * loaded.nodal_load
        moved = shape_responses(loaded, np.column_stack(columns), loads, apart)
        unmoved = _measured(design.position, design.position)
        expected = unmoved | dict(zip(ANGLES, rising_angles(strip), strict=True))
        causes: dict[str, tuple[dict[str, float], ...]] = {}
        for k, cause in enumerate(owners):
            lengths = _measured(design.position + moved[:, k], design.position)
            change = {name: lengths[name] - unmoved[name] for name in unmoved}
            causes[cause] = (*causes.get(cause, ()), change)
        shape = points_at(np.linspace(0, n - 1, 61), np.arange(float(n)), design.position)
        # error of the clamps, and turn of a shape that deviates by `expected` over its length
        off = np.degrees(strip.tolerance.clamps + held.expected / design.length)
        return cls(
            tuple(share * design.length for share in MARKS),
            expected,
            dict.fromkeys(LENGTHS, held.expected) | dict.fromkeys(ANGLES, float(off)),
            causes,
            tuple((x, y) for x, y in shape.tolist()),
            distance_of_tips(held_ends(strip)),
            instability_in_plane(strip, stability(strip.rod)) is not None,
        )

    def compare(
        self,
        measured: Mapping[str, float],
        *,
        reading_error: float = READING_ERROR_MM,
        angle_error: float = 1.0,
    ) -> tuple[Row, ...]:
        """Return rows with a verdict, further likely causes, the reading errors, and each measured value.

        A cause is reported on two conditions. Without the cause, the readings are improbable. With the cause,
        they agree within reading errors and expected uncertainty. The likeliest cause by least squares is first.

        Parameters
        ----------
        measured : mapping of str to float
            Measured values by the names of `expected`.
        reading_error, angle_error : float
            Standard errors of the readings of lengths, mm, and angles, degrees.
        """
        require_record(measured, Mapping, "what was measured", "a mapping from names to numbers")
        require_positive(reading_error, "reading_error")
        require_positive(angle_error, "angle_error", "degrees")
        names = [name for name in self.expected if name in measured]
        unknown = [name for name in measured if name not in self.expected]
        if unknown or not names:
            raise InputError(
                f"{', '.join(unknown) or 'an empty file'} is not among the expected measurements. Use some of "
                f"the names {', '.join(self.expected)}."
            )
        errors = dict.fromkeys(LENGTHS, reading_error) | dict.fromkeys(ANGLES, angle_error)
        degrees = "degree" if angle_error == 1 else "degrees"
        return (
            *self._verdict(
                measured, {name: float(np.hypot(self.uncertain[name], errors[name])) for name in names}
            ),
            Row(
                "Readings",
                f"Measured values are assumed to be exact to {reading_error:g} mm and {angle_error:g} {degrees}.",
            ),
            *([] if set(ANGLES) & set(names) else [Row("Angles", NO_ANGLES)]),
            *(self._row(name, measured[name]) for name in names),
        )

    def _row(self, name: str, measured: float) -> Row:
        expected, kind = self.expected[name], KINDS[name]
        uncertain, difference = kind(self.uncertain[name]), kind(measured - expected)
        text = f"{kind(measured):.4g} measured, {number_text(expected, '.4g')} +/- {uncertain:.2g} expected"
        outside = f": difference {difference:+.2g}" if abs(difference) > uncertain else ""
        return Row(row_label(name), text + outside)

    def _verdict(self, measured: Mapping[str, float], errors: Mapping[str, float]) -> list[Row]:
        """Return the rows on the likely causes of the differences from the expected values, the likeliest first.

        Each cause is fitted to the differences, in units of the `errors`. A cause is likely if it explains them
        by an amount that is possible.
        """
        from scipy.special import chdtri

        # differences in standard errors; sums of their squares follow a chi-square distribution
        off = np.array([(measured[name] - self.expected[name]) / errors[name] for name in errors])
        squares = float(off @ off)
        improbable = squares > chdtri(len(errors), CHANCE)
        likely = []  # sum of squares that a cause leaves unexplained, and its message
        for cause, changes in self.causes.items():
            G = np.array([[change[name] / errors[name] for change in changes] for name in errors])
            answer = np.linalg.lstsq(G, off, rcond=None)[0]
            rest = float(np.sum((off - G @ answer) ** 2))
            size = float(np.linalg.norm(answer))
            # `far` is True if the cause cannot explain the differences
            far = (
                # a cause with as many amounts as readings would explain any readings
                len(errors) <= len(changes)
                # these causes have no amount, so their fitted factor must be near 1
                or (cause in ("end for end", "wrong side") and not 0.5 < answer[0] < 1.5)
                # the thickness of a sheet varies by at most 6 %
                or (cause == "thickness" and size > 6.0)
                or (cause == "ends apart" and self._mirrors(size, changes[0]))
                # the cause explains no more than chance, or leaves too much unexplained
                or squares - rest < chdtri(len(changes), CHANCE)
                or rest > chdtri(len(errors) - len(changes), CHANCE) + NONLINEAR**2 * squares
            )
            if not far:
                likely.append((rest, MEANINGS[cause].format(amount=size)))
        if improbable:
            likely += self._slips(measured, errors)
        likely.sort()
        if likely:
            # causes that explain the differences almost as well are reported too
            texts = [text for rest, text in likely if rest < likely[0][0] + 4.0]
            return [warning_row(text, "Or" if k else "Verdict") for k, text in enumerate(texts)]
        if improbable:
            return [warning_row(SNAPPED if self.can_snap else UNEXPLAINED, "Verdict")]
        return [
            Row(
                "Verdict",
                "All differences are within the reading error and the uncertainty of sheet, cut, clamps and model.",
            )
        ]

    def _slips(
        self, measured: Mapping[str, float], errors: Mapping[str, float]
    ) -> Iterator[tuple[float, str]]:
        """Yield the sum of squared errors, and the message, of each mistake that alone explains all
        readings."""
        from scipy.special import chdtri

        # for each mistake, the right values of the readings that it changes
        lengths = {name: measured[name] for name in errors if name in LENGTHS}
        corrected: dict[str, dict[str, float]] = {
            slip: {name: scale * value for name, value in lengths.items()}
            for slip, scale in {"centimetres": 10.0, "inches": 25.4}.items()
        }
        for slip, exchange in EXCHANGES.items():
            if all(name in errors for name in exchange):
                corrected[slip] = {name: measured[other] for name, other in exchange.items()}
        if signed := {name: -measured[name] for name in errors if name != "chord"}:
            corrected["signs"] = signed
            opposite = EXCHANGES["ends exchanged"]
            if all(opposite.get(name, name) in signed for name in signed):
                corrected["turned"] = {name: signed[opposite.get(name, name)] for name in signed}
        if self.tips is not None and "chord" in errors:
            corrected["tips"] = {"chord": measured["chord"] - (self.tips - self.expected["chord"])}
        for slip, values in corrected.items():
            right = {**measured, **values}
            rest = float(sum(((right[name] - self.expected[name]) / errors[name]) ** 2 for name in errors))
            if rest <= chdtri(len(errors), CHANCE):
                yield rest, SLIPS[slip]

    def _mirrors(self, amount: float, change: Mapping[str, float]) -> bool:
        # return True if a cause would move a mark by more than the largest height, as if the strip were mirrored.
        # `change` has the changes of the expected values per unit of `amount`, which hold only for small changes
        heights = [name for name in self.expected if name.startswith("height")]
        largest = max((abs(self.expected[name]) for name in heights), default=0.0)
        return any(amount * abs(change[name]) > largest for name in heights)


def row_label(name: str) -> str:
    """Return the label of a measured quantity.

    Examples
    --------
    >>> row_label("height_1")
    'Height 1'
    """
    return name.replace("_", " ").capitalize()


def _measured(position: FloatArray, design: FloatArray) -> dict[str, float]:
    """Return the values to be measured on a shape with evenly spaced nodes (n, 2), mm.

    The design decides which side of the chord is positive, see `upward`. Small changes of an S-shaped strip
    therefore do not change the signs. An angle is positive if the strip rises from that end towards its middle.
    """
    chord, side = position[-1] - position[0], upward(heights_of_marks(design))
    edges = np.array([position[1] - position[0], position[-1] - position[-2]])
    first, last = np.degrees(turn_between(chord, edges))
    values = (norm(chord), *(side * heights_of_marks(position)), side * first, -side * last)
    return dict(zip((*LENGTHS, *ANGLES), map(float, values), strict=True))


def rising_angles(strip: Strip) -> tuple[float, float]:
    """Return the angles of the ends from the line between them, degrees, with the signs of `upward`.

    Examples
    --------
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 100, 0, np.pi / 3), "card-200gsm", max_width=20)
    >>> np.round(rising_angles(arch), 6).tolist()
    [30.0, 30.0]
    """
    (first, last), rod = held_ends(strip), strip.rod
    side = upward(heights_of_marks(rod.position, rod.s))
    return side * first.tilt, -side * last.tilt
