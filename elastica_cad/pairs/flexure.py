"""Part with two rest shapes, cut from a sheet or printed: thickness and its least value, outline, pads, holder,
strain, and path between the shapes.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Annotated, Any, Literal, TypeAlias, get_args

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, Takes, required
from elastica_cad._values import (
    distinct_digits,
    is_number,
    is_one_of,
    is_series,
    numbers,
    require_flag,
    require_number,
    require_positive,
    require_record,
)
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import (
    FaultError,
    FieldName,
    Force,
    InputError,
    Length,
    NotConvergedError,
    Refusal,
    StrainError,
    note,
    quoted,
    rounded_down,
    rounded_up,
)
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Line, Path, Spline
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    angle_of,
    box_about,
    dot,
    left_of,
    lengths_along,
    norm,
    rotated,
    transform_points,
    unit_vectors,
)
from elastica_cad.geometry.splines import SplineFunction, adaptive_spline, spline_through
from elastica_cad.mechanics.bending import Leg, path_legs
from elastica_cad.mechanics.rod import Rod, csv_text
from elastica_cad.mechanics.section_limits import judge_strain
from elastica_cad.mechanics.sheets import Sheet, require_flat, require_name
from elastica_cad.mechanics.sideways import SidewaysStability
from elastica_cad.pairs.pushed_rod import PushPath, RestShape, push_path, rest_shape
from elastica_cad.pairs.two_state_rods import TwoStateRod
from elastica_cad.strip.corner_rounding import round_corners
from elastica_cad.strip.drawing import Drawing, cut_paths
from elastica_cad.strip.flat_pattern import in_short_pieces
from elastica_cad.strip.lettering import (
    LEAST_LABEL_MM,
    Text,
    centred_text,
    engravable,
    engraved_names,
    fit_label,
    numbers_note,
    text_width,
)
from elastica_cad.strip.outline import ENDS
from elastica_cad.strip.solids import FlatSolid, turned

LEAST_CUT_MM, LEAST_PRINTED_MM = 0.8, 0.9
"""Least thickness in the plane, mm, of parts cut by laser, and of printed parts (two lines of a 0.4 mm
nozzle)."""

SIDE_MM = 1e-3
"""Largest distance, mm, between the sides of the part and the splines that replace them in its outline."""

LEAST_GAP_MM = 0.3
"""Least gap between parts of the outline, mm; smaller gaps close or fuse during cutting or printing."""

NAME_MM = 3.0  # height of the engraved names of both states on the holder, mm

TRAVEL_STEPS = 48
SHAPES = 8  # number of shapes on a path in which the part is checked for contact with itself
State: TypeAlias = Literal["first", "second"]
STATES = get_args(State)
FAR_SHARE = 0.05
"""A part is pushed at its middle if the middle moves at least this fraction of the largest displacement."""

REST_SHARE = 1e-3
"""Largest distance of a rest shape from the drawn state without a warning, as a fraction of the length.

Rest shapes that are closer together than this distance count as the same shape."""

SPARE = 0.98
"""Fraction of the strain limit that is used.

The remaining 2 % are a reserve, because the strain between the states also depends on the thickness.
"""

OFF_MM = 0.1
"""Error of the thickness in the plane after careful cutting or printing, mm."""

_GAUSS = np.polynomial.legendre.leggauss(24)


@dataclass(frozen=True)
class Pad:
    """End plate of a flexure, with two holes on its centre line.

    Attributes
    ----------
    length, width : float
        Sizes along and across the part, mm. The pad becomes wider if the end of the part and its fillets require
        it.
    hole : float
        Diameter of the holes, mm; 3.2 for M3 screws.
    inset : float
        Distance from the ends of the pad to the centres of the holes, mm.
    """

    length: Annotated[float, Option("Length of the pad, along the part.", "mm", above=0)] = 18.0
    width: Annotated[float, Option("Least width of the pad, across the part.", "mm", above=0)] = 10.0
    hole: Annotated[float, Option("Diameter of the two holes in the pad; 3.2 for M3.", "mm", above=0)] = 3.2
    inset: Annotated[
        float, Option("Distance from the ends of the pad to the centres of the holes.", "mm", above=0)
    ] = 4.5

    def __post_init__(self) -> None:
        require_declared(Pad, vars(self), "pad")
        if self.hole + 2 > min(self.width, self.length - 2 * self.inset, 2 * self.inset):
            raise InputError(
                "two holes of {hole:g} do not fit a pad of {length:g} by {width:g}: make the pad larger",
                hole=Length(self.hole), length=Length(self.length), width=Length(self.width),
            )  # fmt: skip


@dataclass(frozen=True, eq=False)
class FlexureTravel:
    """Path of a flexure from one state to the other.

    Attributes
    ----------
    travel : (k,) array
        Displacement of the pushed point, mm. If the part is not bistable: displacement of the end, mm, or rotation
        of an end that only turns, degrees.
    force : (k,) array
        Force along the push, N. If the part is not bistable: force on the moved end.
    energy : (k,) array
        Elastic energy, N mm.
    position : (k, n, 2) array
        Centre lines of the k shapes, mm.
    strain : (k,) array
        Largest strain of each shape.
    snap : float or None
        Travel at which the part snaps, or None.
    work : float
        Work of the push up to the snap, N mm.
    reached : bool
        True if the path ends in the other state.
    forces_at_snap : (float, float) or None
        Force on the moved end before and after the part snaps, N. None for a pushed part, or without a snap.
    unit : "mm" or "deg"
        Unit of `travel` and `snap`.
    direction : (k,) array or None
        Direction of the force on the moved end, degrees anticlockwise from the x axis of the first curve. None for
        a pushed part, because its push has one direction, `Flexure.force_direction`.
    moment : (k,) array or None
        Moment on the moved end, N mm, positive anticlockwise. None for a pushed part.
    """

    travel: FloatArray
    force: FloatArray
    energy: FloatArray
    position: FloatArray
    strain: FloatArray
    snap: float | None
    work: float
    reached: bool
    forces_at_snap: tuple[float, float] | None = None
    unit: Literal["mm", "deg"] = "mm"
    direction: FloatArray | None = None
    moment: FloatArray | None = None

    @property
    def largest_force(self) -> float:
        """Largest force, N: up to the snap for a pushed part, and over the whole travel for other parts."""
        end = self.travel[-1] if self.snap is None or self.forces_at_snap is not None else self.snap
        return float(self.force[self.travel <= end].max())


@dataclass(frozen=True, eq=False)
class Flexure:
    """Part cut from a sheet, with two rest shapes (states). Its thickness in the plane varies along it.

    Parameters
    ----------
    pair : TwoStateRod
    sheet : Sheet or str
        Sheet of the part. Its thickness is the depth of the part, and its `max_strain` is the limit for both states
        and the path between them.
    least_thickness : float, optional
        Least thickness in the plane, mm. By default, it is the largest value for which both states and the path are
        within the strain limit.
    pad : Pad
        Pads at both ends.
    fillet : float
        Radius of the fillets between the part and its pads, mm; 0 for no fillet.
    push_at : float, optional
        Arc length at which a bistable part is pushed, mm. By default it is the middle, or the point of largest
        displacement if the middle hardly moves.
    printed : bool
        True for a printed part, which must be at least 0.9 mm thick instead of 0.8 mm.
    label : str
        Text that is engraved on the first pad.
    ignore_limits : bool
        True to accept a part that is too thin, has too much strain, or touches itself.
    state_names : pair of str
        Names of both states, "" for "first state" and "second state".

    Raises
    ------
    StrainError
        The strain exceeds what the sheet can withstand.

    Notes
    -----
    The thickness in the plane is h = (12 B K / (E t))^(1/3). Here B is the least bending stiffness, K the
    relative stiffness, E the modulus of the sheet, and t the depth. The strain of a state on the inner side
    is |kappa - kappa_0| h / 2 times Winkler's factor for curved beams, plus the strain by the axial force. In
    the fillets the strain is multiplied by a notch factor. The fillets begin within the free length, so that
    the ends are as compliant as if clamped at the drawn points.

    Examples
    --------
    >>> from elastica_cad.pairs.two_state_rods import two_state_rod
    >>> arch = PlaneCurve.spline([(0, 0), (30, 10), (90, 10), (120, 0)], degree=3)
    >>> pair = two_state_rod(arch, arch.transformed(np.diag([1.0, -1.0, 1.0])))
    >>> part = Flexure(pair, "pom-2")
    >>> bool(max(part.strain) <= part.sheet.max_strain * 1.000001), part.outline.closed
    (True, True)
    """

    pair: TwoStateRod
    sheet: Takes[Sheet, Sheet | str] = required()  # noqa: RUF009
    least_thickness: float | None = None
    pad: Pad = field(default_factory=Pad)
    fillet: float = 1.0
    push_at: float | None = None
    printed: bool = False
    label: str = ""
    ignore_limits: bool = False
    state_names: tuple[str, str] = ("", "")

    def __post_init__(self) -> None:
        require_record(self.pair, TwoStateRod, "the pair", "a TwoStateRod, as two_state_rod gives")
        object.__setattr__(self, "sheet", require_flat(Sheet.of(self.sheet)))
        require_record(self.pad, Pad, "the pad", "a Pad")
        require_flag(self.printed, "printed")
        require_flag(self.ignore_limits, "ignore_limits")
        if self.least_thickness is not None:
            require_positive(self.least_thickness, "the least thickness")
        if not is_number(self.fillet) or self.fillet:
            require_positive(self.fillet, "the fillet")
        if (
            self.push_at is not None
            and not 0 < require_number(self.push_at, "push_at", "mm") < self.pair.length
        ):
            raise InputError(
                ("the part is {length} long between its pads and cannot be pushed {at} from its "
                 "start: push the part between the pads"),
                length=Length(self.pair.length), at=Length(self.push_at),
            )  # fmt: skip
        if not (is_series(self.state_names) and [type(name) for name in self.state_names] == [str, str]):
            raise InputError(f"state_names is {quoted(self.state_names)}. Pass two texts.")
        vars(self).update(
            label=require_name(self.label, "the label"),
            state_names=tuple(require_name(name, "the name of a state") for name in self.state_names),
        )
        if not self.ignore_limits:
            for fault in self._faults():
                raise fault

    def __repr__(self) -> str:
        low, high = self.thickness_range
        return f"<Flexure of {self.pair.length:.4g} mm, {self.sheet.name}, {low:.3g} to {high:.3g} mm thick>"

    @cached_property
    def state_labels(self) -> tuple[str, str]:
        """Names of both states in rows, warnings and pictures."""
        first, second = self.state_names
        return first or note("first state"), second or note("second state")

    @cached_property
    def _engraved(self) -> dict[str, str]:
        return engraved_names([self.label, *self.state_names])

    @cached_property
    def scale(self) -> float:
        """Least thickness in the plane, mm."""
        if self.least_thickness is not None:
            return self.least_thickness
        if self.pair.check.any_stiffness:
            raise InputError("the thickness of the part cannot be computed, because both curves have "
                             "the same shape: set {field}", field=FieldName("least_thickness"))  # fmt: skip
        states, most = self.pair.states, self.sheet.max_strain
        scale = self._thickest(self._bends_of(states), self._pull_of(states), most)
        reduced = SPARE * most
        # after a reduction of the thickness, the strain may use the reserve of `SPARE`
        # the path changes with the thickness, so the thickness is corrected; usually no correction is needed
        for enough in (reduced, *[most] * 3):
            try:
                bends, stretch = self._shapes_at(scale)
            except NotConvergedError:
                break  # `warnings` reports the missing path
            if self._strains(bends, stretch, scale).max() <= enough:
                break
            scale = min(scale, self._thickest(bends, stretch / scale**2, reduced))
        return scale

    def _shapes_at(self, scale: float) -> tuple[FloatArray, FloatArray]:
        """Return changes of curvature (k, n), 1/mm, and axial strains (k, n) for the least thickness `scale`, mm.

        The k rows are both states and shapes on the path between them.
        """
        rests = [rest_shape(rod, thickness=scale) for rod in self.rods]
        shapes = [(rest.bend, rest.stretch) for rest in rests]
        if self.pair.bistable:
            starts = self.rods if self._are_apart(*rests) else self.rods[:1]
            shapes += [self._push(start, scale, 1).visited for start in starts]
        else:
            rods = self._rods_with_moved_end
            shapes.append((self._bends_of(rods), scale**2 * self._pull_of(rods)))
        bends, stretch = map(np.vstack, zip(*shapes, strict=True))
        return bends, stretch

    def _thickest(self, bends: FloatArray, pull: FloatArray, most: float) -> float:
        """Return the least thickness of the part, mm, at which the largest strain of k shapes is `most`."""
        from scipy.optimize import brentq

        def excess(scale: float) -> float:
            return float(self._strains(bends, pull * scale**2, scale).max()) - most

        # thickness for bending alone; other causes of strain can only reduce the thickness, stretching by far
        high = 2 * most / float(np.abs(bends).max())
        return high if excess(high) <= 0 else float(brentq(excess, 1e-6 * high, high, xtol=1e-9 * high))

    @property
    def thickness_range(self) -> tuple[float, float]:
        """Least and largest thickness in the plane along the part, mm."""
        return self.scale, self.scale * self.pair.ratio ** (1 / 3)

    def thickness_at(self, s: FloatArray) -> FloatArray:
        """Return the thickness in the plane (n,), mm, at arc lengths (n,), mm; it is constant beyond the ends."""
        inside = numbers(s, "the arc lengths").clip(0.0, self.pair.length)
        return np.asarray(self.scale * self.pair.first.profile(inside) ** (1 / 3))

    @property
    def bending_stiffness(self) -> float:
        """Least bending stiffness, N mm2."""
        return self.sheet.youngs_modulus * self.sheet.thickness * self.scale**3 / 12

    def _strains(self, bends: FloatArray, stretch: FloatArray, scale: float) -> FloatArray:
        """Return the largest strain (..., n) at n nodes.

        `bends` are changes of curvature, 1/mm, `stretch` are axial strains, and `scale` is the least thickness,
        mm. All nodes within a fillet have the strain of the fillet.
        """
        s, h = self.pair.first.s, scale * self.pair.first.stiffness ** (1 / 3)
        bent = np.abs(bends) * h / 2 * curved_beam_factor(h * np.abs(self.pair.natural_curvature))
        strains = bent + np.abs(stretch)
        for end in (0, -1):
            inside = np.abs(s - s[end]) <= self.fillet - _overhang(float(h[end]), self.fillet)
            root = np.flatnonzero(inside)[-1 - end]  # the innermost node, where the fillet begins
            # without fillet, the corner has a radius of half the width of a laser cut
            bending, axial = root_factors(max(self.fillet, 0.1) / float(h[root]))
            strains[..., inside] = (bending * bent[..., root] + axial * np.abs(stretch[..., root]))[..., None]
        return strains

    def _bends_of(self, rods: Iterable[Rod]) -> FloatArray:
        return np.array([rod.curvature - self.pair.natural_curvature for rod in rods])

    def _pull_of(self, rods: Iterable[Rod]) -> FloatArray:
        """Return the axial strains (k, n) of k shapes, divided by the square of the least thickness, 1/mm2."""
        along = [dot(rod.force, unit_vectors(rod.angle)) for rod in rods]
        return np.asarray(along / self.pair.first.stiffness ** (1 / 3) / 12)

    @cached_property
    def strain(self) -> tuple[float, float]:
        """Largest strain of each state at rest."""
        first, second = (
            float(self._strains(rest.bend, rest.stretch, self.scale).max()) for rest in self.rests
        )
        return first, second

    @property
    def stretch(self) -> float:
        """Largest change of length due to the forces in the drawn states, mm."""
        strain = self.scale**2 * self._pull_of(self.pair.states)
        return float(np.abs(strain @ self.pair.first.node_lengths).max())

    @cached_property
    def rests(self) -> tuple[RestShape, RestShape]:
        """Shapes of the part when it is released in each of its states, computed with bending and stretching."""
        first, second = (rest_shape(rod, thickness=self.scale) for rod in self.rods)
        return first, second

    @property
    def rest_deviations(self) -> tuple[float, float]:
        """Largest distance of each rest shape from the drawn state, mm."""
        first, second = (
            _distance(rest.position, rod.position) for rest, rod in zip(self.rests, self.rods, strict=True)
        )
        return first, second

    @property
    def bistable(self) -> bool:
        """True if the part has two rest shapes in the same clamps."""
        return self.pair.bistable and self._are_apart(*self.rests)

    def _are_apart(self, first: RestShape, second: RestShape) -> bool:
        return _distance(first.position, second.position) > REST_SHARE * self.pair.length

    @cached_property
    def sideways(self) -> tuple[SidewaysStability, SidewaysStability]:
        """Stability of each state against tipping out of its plane."""
        return self.pair.sideways(
            self.sheet.thickness, self.thickness_at(self.pair.first.s), poisson_ratio=self.sheet.poisson_ratio
        )

    @cached_property
    def centre(self) -> "CentreLine":
        """Unloaded centre line, starting at the origin along x."""
        rod = self.pair.first
        turn = spline_through(rod.s, self.pair.natural_curvature, 3).integral()
        return CentreLine(rod.s, turn(rod.s), np.zeros(2))

    @property
    def second_moved(self) -> tuple[float, float]:
        """Turn, degrees, and largest distance, mm, of the second state in the clamp from its drawn position."""
        first, second = self.pair.states
        turn = np.degrees(first.angle[0] - second.angle[0])
        # the turn is above -180 and at most 180 degrees
        return float(180 - (180 - turn) % 360), _distance(self.rods[1].position, second.position)

    @cached_property
    def rods(self) -> tuple[Rod, Rod]:
        """Rods of both states, starting in the same clamp."""
        first, second = self.pair.states
        turn, matrix = float(first.angle[0] - second.angle[0]), np.eye(3)
        matrix[:2, :2] = rotated(np.eye(2), turn).T
        matrix[:2, 2] = first.position[0] - matrix[:2, :2] @ second.position[0]
        moved = replace(
            second, position=transform_points(matrix, second.position), angle=second.angle + turn,
            force=rotated(second.force, turn), shape=second.curve.transformed(matrix),
        )  # fmt: skip
        return first, moved

    @cached_property
    def states(self) -> tuple["CentreLine", "CentreLine"]:
        """Centre lines of `rods`."""
        first, second = map(CentreLine.of, self.rods)
        return first, second

    @cached_property
    def outline(self) -> Path:
        """Outline of the unloaded part, anticlockwise: sides as splines, pads, fillets."""
        return self._rounded_outline(self.centre)

    def _rounded_outline(self, line: "CentreLine") -> Path:
        corners = self.outline_along(line)
        return round_corners(corners, self.fillet) if self.fillet else corners

    def outline_along(self, line: "CentreLine") -> Path:
        """Return the outline of the part bent to a centre line, without fillets."""
        (start, end), (low, high) = self.pads_along(line), self._pad_edges

        def side(side_sign: int) -> PlaneCurve:
            def points(s: FloatArray) -> FloatArray:
                position, angle = line.at(s)
                return position + side_sign * self.thickness_at(s)[:, None] / 2 * left_of(unit_vectors(angle))

            breaks = [(place, 1) for place in (0.0, self.pair.length) if low < place < high]
            knots, rows = adaptive_spline(points, (low, high), degree=3, tolerance=SIDE_MM, breaks=breaks)
            return PlaneCurve(knots, rows, 3)

        right, left = Spline(side(-1)), Spline(side(1)).reversed()
        corners = [right.end, *end, left.start], [left.end, *start, right.start]
        beyond_end, beyond_start = ([Line(a, b) for a, b in pairwise(pad)] for pad in corners)
        return Path([right, *beyond_end, left, *beyond_start], closed=True)

    def overhang(self, s: float) -> float:
        """Return the distance, mm, from the end of the free length at `s` (0 or the length, mm) out to the pad.

        The fillet is thicker than the part, so it is as compliant as a shorter piece of the part. The fillet
        therefore begins within the free length. The pad is as compliant as a half-plane.
        """
        s = require_number(s, "the arc length", "mm")
        return _overhang(float(self.thickness_at(np.array([s]))[0]), self.fillet)

    @cached_property
    def pad_width(self) -> float:
        """Width of the pads, mm, enlarged for the part and its fillets if necessary."""
        thickest = float(self.thickness_at(np.array([0.0, self.pair.length])).max())
        # the width beyond the part is for the fillets and for straight edges beside the fillets
        return max(self.pad.width, thickest + 5 * self.fillet)

    def pads_along(self, line: "CentreLine") -> FloatArray:
        """Return the corners (pad, corner, coordinate) of both pads of the part bent to a centre line.

        The start pad is first, and the corners of each pad are anticlockwise.
        """
        position, along = self._roots(line)
        half, outer = self.pad_width / 2 * left_of(along), position + self.pad.length * along
        return np.stack([position - half, outer - half, outer + half, position + half], axis=1)

    @property
    def _pad_edges(self) -> tuple[float, float]:
        """Arc lengths of the inner edges of the start pad and the end pad, mm."""
        return -self.overhang(0.0), self.pair.length + self.overhang(self.pair.length)

    def _roots(self, line: "CentreLine") -> tuple[FloatArray, FloatArray]:
        """Return the middles (2, 2) of the inner edges of both pads, mm, and their outward unit vectors (2, 2)."""
        require_record(line, CentreLine, "the line", "a CentreLine, as `centre` and `states` are")
        position, angle = line.at(np.array(self._pad_edges))
        return position, unit_vectors(angle) * ((-1.0,), (1.0,))

    def hole_places(self, line: "CentreLine") -> FloatArray:
        """Return the centres of the holes as an array (pad, hole, coordinate).

        The start pad is first, and in each pad, the hole nearest to the strip is first.
        """
        position, along = self._roots(line)
        insets = np.array([[self.pad.inset], [self.pad.length - self.pad.inset]])
        return position[:, None] + insets * along[:, None]

    def holes_along(self, line: "CentreLine") -> tuple[Path, ...]:
        """Return the holes of the part bent to a centre line, in the order of `hole_places`."""
        return tuple(Path.circle(place, self.pad.hole / 2) for place in self.hole_places(line).reshape(-1, 2))

    @cached_property
    def holes(self) -> tuple[Path, ...]:
        """Holes of the unloaded part."""
        return self.holes_along(self.centre)

    def drawing(self) -> Drawing:
        """Return the cutting drawing of the unloaded part."""
        return Drawing(self.label or "flexure", cut_paths(self.outline, self.holes), self._label_texts)

    @property
    def _label_texts(self) -> tuple[Text, ...]:
        """The label on the pad, along or across it, whichever can be larger; none if it would be too small."""
        near, far = self.hole_places(self.centre)[0]
        along, across = float(norm(far - near)) - self.pad.hole - 2, self.pad_width - 2
        x, y = ((near + far) / 2).tolist()
        angle = float(angle_of(near - far))  # from the tip of the pad to the strip
        label = self._engraved[self.label]
        texts = (
            fit_label(label, (x, y), angle=angle, room=along, across=across),
            fit_label(label, (x, y), angle=angle + np.pi / 2, room=across, across=along),
        )
        text = max(texts, key=lambda text: text.height)
        return (text,) if self.label and text.height >= LEAST_LABEL_MM else ()

    def holder(self) -> Drawing:
        """Return a plate with holes for both pads.

        If the part is not bistable, there are holes for the end pad in each state, with the name of the state.
        """
        places = [self.hole_places(line) for line in self.states]
        settings = [] if self.pair.bistable else [group[1] for group in places]
        # holes of both pads in the first state and, if not bistable, of the end pad in the second
        distinct = np.concatenate([*places[0], *settings[1:]])
        # a hole may serve both states
        same = np.tril(norm(distinct[:, None] - distinct) <= 0.01, -1)
        distinct = distinct[~same.any(axis=1)]
        gaps = norm(distinct[:, None] - distinct)
        apart = float(gaps[gaps > 0].min())
        least, spacing = self.pad.hole + self.sheet.thickness / 2, self.pad.length - 2 * self.pad.inset
        if spacing < least:
            raise FaultError(
                "the two holes of a pad are {spacing} apart, but a holder {thickness} thick needs at least "
                "{least} between their centres. Set {field} to {longer:g} or more",
                spacing=Length(spacing), thickness=Length(self.sheet.thickness), least=Length(least),
                field=FieldName("pad.length"), longer=Length(rounded_up(least + 2 * self.pad.inset, 3)),
            )  # fmt: skip
        if apart < least * (1 - 1e-9):
            raise FaultError(
                "the holder's holes for the two states are only {apart} apart, but need at least {least} "
                "between their centres. Change the length of the pads, or turn the second curve so that its end "
                "is elsewhere",
                apart=Length(apart), least=Length(least),
            )  # fmt: skip
        texts = list[Text]()
        boxes = list[FloatArray]()
        for group, name, number in zip(settings, self.state_names, "12", strict=False):
            text = self._engraved[name] or number
            half = np.array([text_width(engravable(text), NAME_MM), NAME_MM]) / 2 + 1
            middle = _free_place(group.mean(axis=0), half, distinct, self.pad.hole / 2, boxes)
            texts.append(centred_text(text, middle, NAME_MM, np.inf))
            boxes.append(np.array([middle - half, middle + half]))
        margin = self.pad_width / 2 + self.pad.hole
        low, high = box_about(np.concatenate([distinct - margin, distinct + margin, *boxes]))
        plate = round_corners(Path.rectangle(*(high - low), corner=low), self.pad.hole)
        holes = [Path.circle(place, self.pad.hole / 2) for place in distinct]
        name = f"{self.label or 'flexure'}-holder"
        return Drawing(name, cut_paths(plate, holes), tuple(texts))

    @property
    def holder_solid(self) -> FlatSolid:
        """Body of the holder, as thick as the sheet, below the plane of the part."""
        *holes, plate = (item.path for item in self.holder().paths)  # the outline is cut last
        depth = self.sheet.thickness
        return FlatSolid(plate, tuple(holes), depth, Frame().shifted(z=-depth))

    @property
    def solid(self) -> FlatSolid:
        """Body of the unloaded part, from z = 0 to its depth."""
        return self.solid_in(None)

    def solid_in(self, state: State | None) -> FlatSolid:
        """Return the body of the part, from z = 0 to its depth, in the "first" or "second" state, or unloaded.

        In a state, the body is on the drawn curve; `states` are in the same start clamp instead.

        The joints are at half the depth: "start" and "end" on the inner edges of the pads, with x outward, and
        "hole1" to "hole4" at the holes from start to end, with x along the part.
        """
        if not is_one_of(state, (None, *STATES)):
            raise InputError(f'The state is {state!r}. Use "first", "second", or None for the unloaded part.')
        line = self.centre if state is None else CentreLine.of(self.pair.states[STATES.index(state)])
        middle = Frame((0.0, 0.0, self.sheet.thickness / 2))
        joints, holes = {}, []
        for name, position, outward, sign, near in zip(
            ENDS, *self._roots(line), (-1, 1), self.hole_places(line), strict=True
        ):
            place = Frame(middle.point(position), (*outward, 0.0), (*left_of(outward), 0.0))
            joints[str(name)] = place
            # from start to end, the outer hole of the start pad is the first
            holes += [
                turned(Frame(middle.point(at), place.x_axis, place.y_axis), sign) for at in near[::sign]
            ]
        joints |= {f"hole{number}": hole for number, hole in enumerate(holes, start=1)}
        return FlatSolid(
            in_short_pieces(self._rounded_outline(line)),
            self.holes_along(line),
            self.sheet.thickness,
            joints=joints,
        )

    @cached_property
    def pushed(self) -> tuple[float, FloatArray]:
        """Arc length of the pushed point of a bistable part, and its displacement (2,) between the states, mm."""
        first, second = self.rods
        distances = second.position - first.position
        sizes = norm(distances)
        i = np.abs(first.s - (first.length / 2 if self.push_at is None else self.push_at)).argmin()
        if self.push_at is None and sizes[i] < FAR_SHARE * sizes.max():
            i = sizes.argmax()
        return float(first.s[i]), distances[i]

    @cached_property
    def force_direction(self) -> float:
        """Direction of the force, in degrees anticlockwise from the x axis of the first curve.

        A bistable part is pushed in this direction. For other parts, the largest force on the end has this
        direction.
        """
        if self.pair.bistable:
            force = self.pushed[1]
        else:
            force = -self._rods_with_moved_end[int(self.travel.force.argmax())].force[-1]
        return float(np.degrees(angle_of(force)))

    @cached_property
    def travel(self) -> FlexureTravel:
        """Path from the first state to the second.

        A bistable part is pushed. If the part is not bistable, its end is moved.
        """
        return self._pushed(0) if self.pair.bistable else self._led()

    @cached_property
    def force_range(self) -> tuple[float, float]:
        """Least and largest value of `travel.largest_force` within the tolerances, N.

        The thickness in the plane varies by `OFF_MM`, and the properties of the sheet within their ranges.
        The least force is 0 if the part might not snap.
        """
        forces = [self.travel.largest_force]
        for off in (-OFF_MM, OFF_MM):
            fraction = 1 + 2 * off / sum(self.thickness_range)
            # in a part that is not bistable, the force is proportional to the bending stiffness
            force = forces[0] / self.bending_stiffness
            if self.bistable:
                path = self._push_finely(self.pair.first, fraction * self.scale)
                force = 0.0 if path.snap is None else path.largest_force
            forces.append(fraction**3 * self.bending_stiffness * force)
        ends = np.array([min(forces), max(forces)])
        for name in ("youngs_modulus", "thickness"):
            ends = ends * self.sheet.range_of(name) / getattr(self.sheet, name)
        low, high = ends
        return float(low), float(high)

    @property
    def force_text(self) -> Refusal:
        """Message with the largest force and its range."""
        low, high = self.force_range
        return note(
            "about {force:.2g} ({low:.2g} to {high:.2g} if the thickness is off by up to {off} and the "
            "sheet varies)"
            if self.sheet.youngs_modulus_range
            else "about {force:.2g} ({low:.2g} to {high:.2g} if the thickness is off by up to {off}; "
                 "the variation of the sheet is unknown)",
            force=Force(self.travel.largest_force), low=low, high=Force(high), off=Length(OFF_MM),
        )  # fmt: skip

    @cached_property
    def travel_back(self) -> FlexureTravel | None:
        """Path of a bistable part from the second state to the first, or None."""
        return self._pushed(1) if self.bistable else None

    def force_csv(self) -> str:
        """Return the path as comma-separated text: travel, force, energy and largest strain.

        The first column is `turn_deg` instead of `travel_mm` if the end only turns. If the part is not bistable,
        the direction of the force and the moment on the moved end are also included.
        """
        travel = self.travel
        columns = {"travel_mm" if travel.unit == "mm" else "turn_deg": travel.travel, "force_N": travel.force}
        if travel.direction is not None and travel.moment is not None:
            columns |= {"direction_deg": travel.direction, "moment_Nmm": travel.moment}
        return csv_text(columns | {"energy_Nmm": travel.energy, "largest_strain": travel.strain})

    @property
    def travel_strain(self) -> float:
        """Largest strain on the path between the states, and on the path back if the part is bistable."""
        return max(
            float(travel.strain.max()) for travel in (self.travel, self.travel_back) if travel is not None
        )

    def _pushed(self, state: int) -> FlexureTravel:
        """Return the path of the bistable part that is pushed from a state (0 or 1)."""
        path, B = self._push_finely(self.rods[state], self.scale), self.bending_stiffness
        goal = self.rests[1 - state]
        reached = _distance(path.released, goal.position) <= REST_SHARE * self.pair.length
        return FlexureTravel(
            path.travel, B * path.force, B * path.energy, path.position,
            self._strains(path.bend, path.stretch, self.scale).max(axis=1), path.snap, B * path.barrier,
            self.bistable and reached,
        )  # fmt: skip

    def _push(self, start: Rod, scale: float, steps: int) -> PushPath:
        """Return the path of a push to the other state."""
        at, push = self.pushed
        push = push if start is self.rods[0] else -push
        return push_path(start, at, push, np.linspace(0.0, float(norm(push)), steps + 1), thickness=scale)

    def _push_finely(self, start: Rod, scale: float) -> PushPath:
        path = self._push(start, scale, TRAVEL_STEPS)
        if path.snap is None:
            return path
        # more shapes around the largest force and the snap
        k = int(path.travel.searchsorted(path.snap))
        peak = int(path.force[:k].argmax())
        near = [(max(peak - 1, 0), peak), (peak, peak + 1), (k - 1, k)]
        low, high = path.travel[np.array(near)].T
        return path.finer(np.linspace(low, high, 5)[1:-1].ravel())

    @cached_property
    def _moving(self) -> Leg:
        """Straight path of the end, which turns uniformly."""
        first, second = self.rods
        (leg,) = path_legs(
            first, [{"end": second.position[-1], "angles": (first.angle[0], second.angle[-1])}]
        )
        return leg

    @cached_property
    def _rods_with_moved_end(self) -> Sequence[Rod]:
        """Rods at equal steps of the path, and just before and after a snap."""
        near = [share * event.t for event in self._moving.path.leaps[:1] for share in (1 - 1e-6, 1.0)]
        shares = np.union1d(np.linspace(0.0, 1.0, TRAVEL_STEPS + 1), near)
        return [self._moving.rod(t) for t in shares.tolist()]

    def _led(self) -> FlexureTravel:
        """Path from the first to the second state with the end moved: force, energy and strain at each step."""
        first, second = self.rods
        rods, B = self._rods_with_moved_end, self.bending_stiffness
        energy = B * np.array([rod.bending_energy for rod in rods])
        pulls = -B * np.array([rod.force[-1] for rod in rods])
        force, direction = norm(pulls), np.degrees(angle_of(pulls))
        strains = self._strains(self._bends_of(rods), self.scale**2 * self._pull_of(rods), self.scale)
        travel = np.append(0.0, norm(np.diff([rod.chord for rod in rods], axis=0)).cumsum())
        turns = bool(travel[-1] <= 1e-9 * first.length)
        if turns:
            travel = np.degrees(np.abs([rod.angle[-1] - first.angle[-1] for rod in rods]))
        snap, jump = None, None
        for event in self._moving.path.leaps[:1]:
            snap = event.t * float(travel[-1])
            k = int(travel.searchsorted(snap * (1 - 1e-9)))
            jump = float(force[k - 1]), float(force[k])
        return FlexureTravel(
            travel, force, energy, np.array([rod.position for rod in rods]), strains.max(axis=1), snap,
            float(energy[-1] - energy[0]),
            _distance(rods[-1].position, second.position) <= REST_SHARE * first.length, jump,
            "deg" if turns else "mm", direction, B * np.array([rod.moment[-1] for rod in rods]),
        )  # fmt: skip

    @cached_property
    def contacts(self) -> dict[str, float]:
        """Gaps below `LEAST_GAP_MM`, mm, by the name of the shape: unloaded, or a state."""
        lines = zip((note("unloaded"), *self.state_labels), (self.centre, *self.states), strict=True)
        gaps = {name: self._gap(line) for name, line in lines}
        return {name: gap for name, gap in gaps.items() if gap < LEAST_GAP_MM}

    def _gap(self, line: "CentreLine") -> float:
        """Return the least gap, mm, between points of the part that are not neighbours; negative for an overlap."""
        length, (low, high) = self.pair.length, self._pad_edges
        s = np.linspace(0.0, length, 241)
        beyond = np.arange(self.pad_width / 2, self.pad.length + 1e-9, self.pad_width / 4)
        s = np.concatenate([(low - beyond)[::-1], s, high + beyond])
        half = np.where((s < 0) | (s > length), self.pad_width / 2, self.thickness_at(s) / 2)
        position = line.at(s)[0]
        reach = half[:, None] + half
        apart = norm(position[:, None] - position) - reach
        # points along the part closer than three thicknesses are neighbours, whose gap is not checked
        near = np.abs(s[:, None] - s) <= 3.0 * reach + s[1] - s[0]
        return float(np.where(near, np.inf, apart).min())

    def line_through(self, positions: FloatArray) -> "CentreLine":
        """Return the centre line through the nodes (n, 2), mm, of a bent shape from `travel` or `rests`."""
        steps = lengths_along(positions)
        s = steps * self.pair.length / steps[-1]
        along = np.gradient(positions, s, axis=0, edge_order=2)
        return CentreLine(s, np.unwrap(angle_of(along)), positions[0])

    def _faults(self) -> Iterable[InputError]:
        """Yield the reasons why the part cannot be made or breaks.

        It may be too thin for the tool, overstrained, or touch itself.
        """
        thin, least = self.scale, LEAST_PRINTED_MM if self.printed else LEAST_CUT_MM
        if thin < least * (1 - 1e-6):
            verb = "printed" if self.printed else "cut"
            share = self._enlargement(least)
            yield FaultError(
                "{sheet} allows a strain of {strain:.2g} %, so the thinnest place may be at most {thin:.3g} "
                "thick, but parts must be at least {least:g} thick to be {made}. Draw both curves {share:g} "
                "times as large ({needs} long) or closer to each other, or use a sheet that allows more "
                "strain",
                sheet=self.sheet.name, strain=100 * self.sheet.max_strain,
                thin=Length(rounded_down(thin, 3)), least=Length(least), made=verb,
                share=share, needs=Length(share * self.pair.length),
            )  # fmt: skip
        worst = max(self.strain)
        if judge_strain(self.sheet, worst).refused:
            reached, limit = distinct_digits(100 * worst, 100 * self.sheet.max_strain, ".2g")
            yield StrainError(
                "the part breaks, because its strain is {worst:g} % and {sheet} allows {most:g} %: make "
                "the part thinner, or draw the curves closer to each other",
                worst=reached, sheet=self.sheet.name, most=limit,
            )  # fmt: skip
        for name, gap in self.contacts.items():
            yield FaultError(
                "two places of the part are only {gap} apart ({name}), so the part may touch itself. Draw "
                "the curves farther apart there" if gap > 0 else
                "two places of the part overlap ({name}). Draw the curves farther apart there",
                name=name, gap=Length(gap),
            )  # fmt: skip

    def _enlargement(self, least: float) -> float:
        """Return a factor that enlarges both curves until the least thickness is `least` mm or more.

        The fillet keeps its radius, so it is smaller relative to the enlarged part.
        """
        # the thickness of an enlarged part changes by up to 2 % if fillets begin at another node
        least *= 1.03
        share = rounded_up(least / self.scale, 3)
        # the second factor is usually sufficient
        for _ in range(4):
            thin = share * replace(self, fillet=self.fillet / share, ignore_limits=True).scale
            if thin >= least:
                break
            share = rounded_up(share * least / thin, 3)
        return share

    @cached_property
    def warnings(self) -> tuple[Refusal, ...]:
        """Warnings about the part."""
        messages = [note("{fault}", severity="warning", fault=str(fault)) for fault in self._faults()] \
            if self.ignore_limits else []  # fmt: skip
        worst = max(self.strain)
        verdict = judge_strain(self.sheet, worst)
        if not verdict.allowed and not verdict.refused:
            messages.append(note(("the strain is {worst:.2g} %, which is {percent} % of the strain that "
                                  "{sheet} withstands for long: {outcome}"),
                              severity="warning", worst=100 * worst, percent=verdict.percent, sheet=self.sheet.name,
                              outcome=verdict.outcome))  # fmt: skip
        for name, side in zip(self.state_labels, self.sideways, strict=True):
            if side.needs_guiding:
                messages.append(note("{name}: {side}", severity="warning", name=name, side=str(side)))
        messages += [*self.rest_warnings, *numbers_note(self._engraved)]
        if self.push_at is not None and not self.pair.bistable:
            messages.append(
                note("{field} has no effect, because the end of this part is moved between two positions. Leave it "
                     "out.", field=FieldName("push_at"))
            )  # fmt: skip
        if self.label and not self._label_texts:
            messages.append(
                note("The label {label} is not engraved, because the pad has no room for letters {height} high. "
                     "Write the name on the part.", label=self.label, height=Length(LEAST_LABEL_MM))
            )  # fmt: skip
        try:
            travel = self.travel
        except NotConvergedError as error:
            messages.append(
                note("no path between the states was found: {error}", severity="warning", error=str(error))
            )
        else:
            most = self.travel_strain
            if not judge_strain(self.sheet, most).allowed and most > worst:
                reached, limit = distinct_digits(100 * most, 100 * self.sheet.max_strain, ".2g")
                messages.append(note(
                    "between the states the strain reaches {most:g} %, but the sheet withstands "
                    "{limit:g} % for long. Make the part thinner, or use another sheet",
                    severity="warning", most=reached, limit=limit))  # fmt: skip
            shapes = travel.position[:: max(1, len(travel.position) // SHAPES)]
            gap = min(self._gap(self.line_through(shape)) for shape in shapes)
            if gap < LEAST_GAP_MM:
                messages.append(note(
                    "between the states, two places of the part come within {gap} of each other. Draw "
                    "these places farther apart" if gap > 0 else
                    "between the states, two places of the part overlap. Draw these places farther apart",
                    severity="warning", gap=Length(gap)))  # fmt: skip
            # `rest_warnings` reports a part of a bistable pair that is not bistable
            if not travel.reached and self.bistable == self.pair.bistable:
                messages.append(note("the pushed part does not end in the second state: push it at another "
                                     "place, or guide it by hand", severity="warning"))  # fmt: skip
        return tuple(messages)

    @property
    def rest_warnings(self) -> tuple[Refusal, ...]:
        """Warnings about unstable states and about rest shapes far from the drawn curves."""
        if self.pair.bistable and not self.bistable:
            return (note("the part is not bistable: its forces stretch the part, which then rests "
                         "near one curve only ({name}). Make the part thinner ({field}), or bend the "
                         "curves more",
                         severity="warning", field=FieldName("least_thickness"),
                         name=self.state_labels[np.argmin(self.rest_deviations)]),)  # fmt: skip
        messages = []
        for name, deviation, stays in zip(
            self.state_labels, self.rest_deviations, self.pair.stability, strict=True
        ):
            if not stays.stable:
                messages.append(note(
                    "a state is unstable ({name}): the part snaps into another shape, up to {far} away. "
                    "Change this curve",
                                     severity="warning", name=name, far=Length(deviation)))  # fmt: skip
            elif deviation > REST_SHARE * self.pair.length:
                messages.append(note("the part rests up to {far} ({percent:.2g} % of its length) "
                                     "from its curve ({name}), because its forces stretch the part. "
                                     "Make the part thinner ({field}), or bend the curves more",
                                     severity="warning", field=FieldName("least_thickness"), far=Length(deviation),
                                     name=name, percent=100 * deviation / self.pair.length))  # fmt: skip
        return tuple(messages)

    def as_dict(self) -> dict[str, Any]:
        """Return a dictionary of numbers, texts and lists for a report."""
        low, high = self.thickness_range
        travel, pair, (turned, moved) = self.travel, self.pair, self.second_moved
        report = {
            "sheet": self.sheet.name,
            "states": [str(label) for label in self.state_labels],
            "length_mm": pair.length,
            "bistable": self.bistable,
            "free": pair.free,
            "ratio": pair.ratio,
            "depth_mm": self.sheet.thickness,
            "least_thickness_mm": low,
            "largest_thickness_mm": high,
            "bending_stiffness_N_mm2": self.bending_stiffness,
            "strain": list(self.strain),
            "strain_on_the_way": self.travel_strain,
            "max_strain": self.sheet.max_strain,
            "margin": [verdict.margin for verdict in pair.stability],
            "stable": [verdict.stable for verdict in pair.stability],
            "sideways": [verdict.word for verdict in self.sideways],
            "stretch_mm": self.stretch,
            "rest_deviation_mm": list(self.rest_deviations),
            "second_state_turned_deg": turned,
            "second_state_moved_mm": moved,
            "largest_force_N": travel.largest_force,
            "largest_force_range_N": list(self.force_range),
            "force_direction_deg": self.force_direction,
            "snap_travel_mm": travel.snap if travel.unit == "mm" else None,
            "work_N_mm": travel.work,
            "reaches_second_state": travel.reached,
            "reports": [str(message) for message in self.warnings],
        }
        if travel.forces_at_snap is not None:
            report |= {"snap_turn_deg": travel.snap} if travel.unit == "deg" else {}
            report |= {"forces_at_snap_N": list(travel.forces_at_snap)}
        if pair.bistable:
            report["pushed_at_mm"] = self.pushed[0]
            if (back := self.travel_back) is not None:
                report |= {"largest_force_back_N": back.largest_force, "work_back_N_mm": back.work}
        return report


def _overhang(h: float, r: float) -> float:
    # `give` is the length of a part of thickness h that is as compliant as a fillet of radius r
    x, w = _GAUSS[0] * r / 2 + r / 2, _GAUSS[1] * r / 2
    wide = h + 2 * (r - np.sqrt(r**2 - x**2))
    give = float(w @ (h / wide) ** 3)
    root = h + 2 * r
    # a strip that ends in an elastic half-plane seems to be longer by 0.44 of its thickness (O'Donnell, J. Appl.
    # Mech. 27, 1960)
    return r - give - 0.44 * root * (h / root) ** 3


def _distance(positions: FloatArray, others: FloatArray) -> float:
    return float(norm(positions - others).max())


def root_factors(radius: float) -> tuple[float, float]:
    """Return the notch factors, for bending and for tension, of a fillet beside a wide pad.

    Plane finite elements agree within 1 % if the radius is 0.05 to 2.5 thicknesses and the pad is at least
    three times as wide as the strip. For narrower pads the factors are too large. Whole parts agree with
    finite elements (`tests/validation/test_pushed_parts.py`).

    Parameters
    ----------
    radius : float
        Radius divided by the thickness where the fillet begins.

    Examples
    --------
    >>> [round(factor, 2) for factor in root_factors(0.5)]
    [1.27, 1.51]
    """
    return 1 + 1 / (4.9 * radius + 1.8 * radius**0.5), 1 + 1 / (3.5 * radius + 0.2)


def curved_beam_factor(share: FloatArray) -> FloatArray:
    """Return the factors (n,) by which a curved beam has more strain on its inner side than a straight beam.

    In a straight beam the strain is h |kappa - kappa_0| / 2. Here h is the thickness, kappa the curvature and
    kappa_0 the natural curvature. `share` (n,) is h |kappa_0|. The factor of Winkler's theory is
    about 1 + share / 3.
    """
    # lengths in units of the radius of the centre line; with 2, the radius of the inner side would be 0
    x = share.clip(1e-3, 1.8)
    inner = 1 - x / 2
    neutral = x / np.log((1 + x / 2) / inner)
    factor = x * (neutral - inner) / (6 * (1 - neutral) * inner)
    return np.where(share < 1e-3, 1 + share / 3, factor)


@dataclass(frozen=True, eq=False)
class CentreLine:
    """Centre line as a function of arc length, extended straight beyond its ends.

    Attributes
    ----------
    s, angle : (n,) arrays
        Arc lengths, mm, and angles of the tangent, rad.
    start : (2,) array
        First point, mm.
    """

    s: FloatArray
    angle: FloatArray
    start: FloatArray

    @classmethod
    def of(cls, rod: Rod) -> "CentreLine":
        """Return the centre line of a rod."""
        return cls(rod.s, rod.angle, rod.position[0])

    @cached_property
    def _splines(self) -> tuple[SplineFunction, SplineFunction]:
        """Angle and position as functions of arc length."""
        return (
            spline_through(self.s, self.angle, 3),
            spline_through(self.s, unit_vectors(self.angle), 5).integral(),
        )

    def at(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return positions (n, 2), mm, and angles (n,), rad, at arc lengths s, mm; straight beyond the ends."""
        inside, (turn, place) = s.clip(self.s[0], self.s[-1]), self._splines
        angle, moved = turn(inside), place(inside) - place(self.s[:1])
        return self.start + moved + (s - inside)[:, None] * unit_vectors(angle), angle


def _free_place(
    middle: FloatArray, half: FloatArray, holes: FloatArray, radius: float, boxes: Sequence[FloatArray]
) -> FloatArray:
    """Return the centre nearest to `middle` for a box of half size `half` (2,) that touches no hole and no box."""
    reach = float(np.ptp(holes, axis=0).max() + 2 * half.max() + radius)
    steps = np.stack(np.meshgrid(*2 * [np.arange(-reach, reach, 1.0)]), axis=-1).reshape(-1, 2)
    centres = middle + steps[norm(steps).argsort(kind="stable")]
    apart = np.maximum(np.abs(centres[:, None] - holes) - half, 0.0)
    clear = (norm(apart) > radius).all(axis=1)
    for low, high in boxes:
        clear &= ((centres + half < low) | (centres - half > high)).any(axis=1)
    return np.asarray(centres[clear][0])
