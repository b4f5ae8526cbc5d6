"""The curves of a file, and the report on reading it."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any, Literal

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import counted
from elastica_cad.errors import InputError, Length, Listed, NotConvergedError, Point, note, sentences
from elastica_cad.formats.chains import JoinedRuns, curve_from_run, holes_on_chains, join_runs, near_ends
from elastica_cad.formats.edges import Edge, Run, Source, sample_run
from elastica_cad.formats.source_file import MOST_CURVES, check_count, check_tolerance, name_source
from elastica_cad.geometry.fairing import largest_distance
from elastica_cad.geometry.measured_points import Provenance
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import cross, lengths_along, near_pairs, norm, points_at

# number of samples along a stroke for each stroke width
_SAMPLES_PER_WIDTH = 4


def _stroke_width(run: Sequence[Edge], tolerance: float) -> float | None:
    """Return the width, mm, of a stroke of constant width whose outline is the closed run, or None.

    Examples
    --------
    >>> bar = Edge.polyline([(0, 0), (100, 0), (100, 4), (0, 4), (0, 0)])
    >>> round(_stroke_width([bar], 0.01), 2), _stroke_width([Edge.polyline(bar.points * (1, 10))], 0.01)
    (4.0, None)
    """
    if float(np.linalg.norm(run[0].start - run[-1].end)) > tolerance or run[0].points.shape[1] != 2:
        return None
    drawn = sample_run(run)
    drawn -= drawn[0]
    s, area = lengths_along(drawn), abs(float(cross(drawn[:-1], drawn[1:]).sum())) / 2
    # width of a rectangle with this perimeter and area
    width = (s[-1] - np.sqrt(max(s[-1] ** 2 - 16 * area, 0.0))) / 4
    # at most 8000 samples are compared, and a loop shorter than 12 widths is not the outline of a stroke
    if not _SAMPLES_PER_WIDTH * s[-1] / 8000 < width < s[-1] / 12:
        return None
    count = int(np.ceil(_SAMPLES_PER_WIDTH * s[-1] / width))
    at = np.arange(count) / count * s[-1]
    points = points_at(at, s, drawn)
    # of near samples, those far apart along the outline are on the other side of the stroke
    i, j = near_pairs(points, points, 3 * width)
    between = np.abs(i - j)
    across = np.minimum(between, count - between) > 2 * _SAMPLES_PER_WIDTH
    i, j = i[across], j[across]
    # distance of each sample from the other side
    opposite = np.full(count, np.inf)
    np.minimum.at(opposite, i, norm(points[i] - points[j]))
    middle = float(np.median(opposite))
    even = np.abs(opposite - middle) <= 0.05 * middle
    # the outline around both ends, up to 6 widths long, has no opposite side
    return middle if np.isfinite(middle) and even.mean() >= 1 - 6 * width / s[-1] else None


KEYS_OF_FILES = ("$INSUNITS", "a comment", "width and height", "units", "STEP")
"""Keys that state the unit in a file. Reports then say that the unit is "from the file"."""

EXACT_MM = 1e-3
"""Largest distance from the drawing, mm, at which a curve counts as exact."""


@dataclass(frozen=True)
class ReadUnit:
    """The unit of a drawing, and its source.

    Attributes
    ----------
    name : str
        "mm", "in".
    known : str
        "stated" by the file or by an option, "guessed" from the program that wrote the file, or "assumed".
    source : str
        What states the unit, such as the header variable "$INSUNITS"; empty if the unit is assumed.
    note : str
        Message on how to change the unit if it is not stated; else empty.
    """

    name: str = "mm"
    known: Literal["stated", "guessed", "assumed"] = "assumed"
    source: str = ""
    note: str = ""

    @classmethod
    def requested(cls, name: str) -> "ReadUnit":
        """Return the record of a unit that the user has set by an option."""
        return cls(name, "stated", "the option unit")

    def __str__(self) -> str:
        if self.known == "stated":
            source = note("the file") if self.source in KEYS_OF_FILES else self.source
            text = "unit from {source}" if self.name == "mm" else "unit: {unit}, from {source}"
            return note(text, unit=self.name, source=source)
        text = "unit {known}" if self.name == "mm" else "unit: {unit}, {known}"
        return note(text, unit=self.name, known=self.known)


@dataclass(frozen=True)
class ReadReport:
    """Report on the curves read from a drawing.

    Attributes
    ----------
    size : (float, float)
        Width and height of the curves, mm.
    unit : ReadUnit
    kinds : mapping
        Number of shapes of each kind: {"spline": 1}.
    done : tuple of str
        Operations on the curves: "joined", "fitted", "turned", "smoothed".
    distance : float
        Largest distance between drawing and curve, mm.
    """

    size: tuple[float, float]
    unit: ReadUnit
    kinds: Mapping[str, int] = field(default_factory=dict)
    done: tuple[str, ...] = ()
    distance: float = 0.0

    def __str__(self) -> str:
        width, height = self.size
        size = note("{width:.1f} x {height:.1f} mm ({unit})", width=width, height=height, unit=str(self.unit))
        kinds = [counted(count, kind) for kind, count in self.kinds.items()]
        done = ["small corners at joints rounded" if name == "smoothed" else name for name in self.done]
        if self.distance > EXACT_MM:
            away = note("within {distance:.2g} of the drawing", distance=Length(self.distance))
            return sentences([size, *kinds, *done, away], ", ")
        exact = "curve through all points" if "fitted" in self.done else "read without approximation"
        return sentences([size, *kinds, *(name for name in done if name != "fitted"), exact], ", ")

    def as_dict(self) -> dict[str, Any]:
        """Return the report as a dict for JSON."""
        return {
            "size": list(self.size),
            "unit": self.unit.name,
            "unit_known": self.unit.known,
            "unit_source": self.unit.source,
            "kinds": dict(self.kinds),
            "done": list(self.done),
            "distance": self.distance,
            "summary": str(self),
        }


def kinds_of(chain: Run) -> Counter[str]:
    """Return the number of shapes of each kind in a chain; a shape is counted once even if it has several
    edges.
    """
    shapes = {
        (id(edge.source) if edge.source else number, _kind(edge.degree, len(edge.points), edge.weights))
        for number, edge in enumerate(chain)
    }
    return Counter(kind for _, kind in sorted(shapes, key=lambda shape: shape[1]))


def _kind(degree: int, count: int, weights: FloatArray | None) -> str:
    if degree == 1:
        return "line" if count == 2 else "polyline"
    return "arc" if degree == 2 and weights is not None else "spline"


@dataclass(frozen=True, eq=False)
class DrawnCurve:
    """A curve of a file, computed on first access.

    Attributes
    ----------
    number : int
        Number of the curve in the file, from 1.
    name, layer : str
        Label, id or handle of the curve, and its layer, as displayed by the drawing program. Empty if the
        file does not name them.
    make : callable
        Function that computes the curve.
    id : str
        Id of the curve, or the handle (2F for a shape named "SPLINE 2F").
    piece, pieces : int
        Number of this piece, from 1, and count of pieces, for a curve that was split.
    joints : (str, str)
        Names, such as "J1", of its start and end if they join it to another piece. Empty for other ends.
    kinds : mapping
        Number of shapes of each kind that form the curve: {"spline": 1}.
    chain : Run
        Edges of the curve as drawn; empty if it was not drawn as edges.
    flatten : callable, optional
        Function that maps edges in space to the plane of the curve.
    chosen_name : str
        Name that a person chose: of the shape, or of a layer that contains no other curve. Otherwise empty.
    """

    number: int
    make: Callable[[], PlaneCurve] = field(repr=False)
    name: str = ""
    layer: str = ""
    id: str = ""
    piece: int = 1
    pieces: int = 1
    joints: tuple[str, str] = ("", "")
    kinds: Mapping[str, int] = field(default_factory=dict)
    chain: Run = field(default=(), repr=False)
    flatten: Callable[[Run], Run] | None = field(default=None, repr=False)
    chosen_name: str = ""

    @cached_property
    def curve(self) -> PlaneCurve:
        """The curve, mm.

        Raises
        ------
        InputError, NotConvergedError
            The numbers in the file do not define a curve.
        """
        return self.make()

    @cached_property
    def problem(self) -> str:
        """Reason why the curve is not valid, or "" if it is valid."""
        try:
            _ = self.curve
        except (InputError, NotConvergedError) as error:
            return str(error)
        return ""

    @property
    def called(self) -> str:
        """Name of the curve in messages: number, id and layer, as in "curve 2 (path12, layer CUT)"."""
        known = [*([self.name] if self.name else []), *([f"layer {self.layer}"] if self.layer else [])]
        part = f"piece {self.piece} of " if self.pieces > 1 else ""
        return f"{part}curve {self.number}" + (f" ({', '.join(known)})" if known else "")

    @property
    def suffix(self) -> str:
        """End of the names of a piece: a hyphen and its number; "" for a curve that was not split."""
        return f"-{self.piece}" if self.pieces > 1 else ""

    def split(self, divide: Callable[[PlaneCurve], Sequence[PlaneCurve]]) -> tuple["DrawnCurve", ...]:
        """Return the pieces that a function makes of the curve. An invalid or undivided curve stays unchanged."""
        cut = () if self.problem else divide(self.curve)
        if len(cut) < 2:
            return (self,)
        around = f"J{len(cut)}" if self.curve.is_closed else ""
        # piece k is between names k and k + 1; the ends of a closed curve are one joint
        names = [around, *(f"J{k}" for k in range(1, len(cut))), around]
        return tuple(
            replace(
                self,
                make=partial(cut.__getitem__, k),
                piece=k + 1,
                pieces=len(cut),
                joints=(names[k], names[k + 1]),
            )
            for k in range(len(cut))
        )


@dataclass(frozen=True, eq=False)
class DrawnFile:
    """Curves of a file, with a record of skipped shapes.

    Attributes
    ----------
    path : Path
    curves : sequence of DrawnCurve
    skipped : mapping
        Number of skipped items of each kind: {"TEXT": 3}.
    unit : ReadUnit
        Unit of the file, and its source.
    remarks : tuple of str
        Messages on curves that were not joined, are displayed differently, or are probably not strips.
    """

    path: Path
    curves: Sequence[DrawnCurve]
    skipped: Mapping[str, int] = field(default_factory=dict)
    unit: ReadUnit = field(default_factory=ReadUnit)
    remarks: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        check_count(len(self.curves), MOST_CURVES, "curves", "leave out what is no strip")

    def __iter__(self) -> Iterator[DrawnCurve]:
        return iter(self.curves)

    def __len__(self) -> int:
        return len(self.curves)

    @property
    def notes(self) -> tuple[str, ...]:
        """Messages on the unit and on skipped items, followed by the remarks."""
        left_out = note("left out because they are not curves: {things}", things=list_things(self.skipped))
        return (*filter(None, [self.unit.note, left_out if self.skipped else ""]), *self.remarks)

    @property
    def bad(self) -> tuple[DrawnCurve, ...]:
        """The curves whose numbers do not define a valid curve, such as a curve without length."""
        return tuple(curve for curve in self.curves if curve.problem)

    def report(self, curves: Sequence[DrawnCurve] | None = None) -> ReadReport | None:
        """Return the report on `curves` (by default all), or None if none of them is valid."""
        return report_on(self.curves if curves is None else curves, self.unit)

    def chosen(self, which: str | None = None, layer: str | None = None) -> tuple[DrawnCurve, ...]:
        """Return the curves selected by `which` (number or id) and by layer, by default all curves."""
        curves = [curve for curve in self.curves if layer is None or curve.layer == layer]
        if which is not None:
            # first the whole name, then the id or the names of clone and shape, which / separates, then the number
            named = [curve for curve in curves if which and which in (curve.name, curve.chosen_name)]
            named = named or [
                curve
                for curve in curves
                if which and which in (curve.id, *curve.name.split("/"), *curve.id.split("/"))
            ]
            curves = named or [curve for curve in curves if str(curve.number) == which.strip()]
        return tuple(curves)

    def one(self, which: str | None, layer: str | None, how: str) -> DrawnCurve:
        """Return the curve that `which` and `layer` select.

        `how` is the part of the error message that explains how to select a curve. In `how`, {count} stands for
        the number of curves in the file.
        """
        curves = self.chosen(which, layer)
        how = how.format(count=len(self.curves))
        if not curves:
            selection = " on layer ".join(word for word in (which or "", layer or "") if word)
            raise InputError(
                "{path} contains {curves}, but not {asked}: choose a curve with {how}; {known}",
                path=self.path,
                curves=counted(len(self.curves), "curve"),
                asked=selection,
                how=how,
                known=_list_of_curves(self.curves),
            )
        if len(curves) > 1:
            raise InputError(
                "{path} contains {count} curves: choose a curve with {how}; {known}",
                path=self.path,
                count=len(curves),
                how=how,
                known=_list_of_curves(curves),
            )
        return curves[0]

    def read(self) -> "CurveList":
        """Return all valid curves of the file.

        Raises
        ------
        InputError, NotConvergedError
            No curve is valid. The error is the error of the first curve.
        """
        good = [curve for curve in self.curves if not curve.problem]
        with name_source(self.path):
            return CurveList(
                [curve.curve for curve in good or self.curves[:1]], self
            )  # if no curve is valid, curve 1 raises its error


class CurveList(list[PlaneCurve]):
    """List of the valid curves of a file.

    Attributes
    ----------
    file : DrawnFile
        All curves of the file, with numbers, names and layers.
    """

    def __init__(self, curves: Iterable[PlaneCurve], file: DrawnFile) -> None:
        super().__init__(curves)
        self.file = file

    @property
    def notes(self) -> tuple[str, ...]:
        """The notes of the file, and a message on each curve that is not valid."""
        bad = [
            note("{called} is left out: {problem}", called=curve.called, problem=curve.problem)
            for curve in self.file.bad
        ]
        return (*self.file.notes, *bad)


def report_on(curves: Iterable[DrawnCurve], unit: ReadUnit) -> ReadReport | None:
    """Return the report on the valid curves, or None if no curve is valid."""
    good = [curve for curve in curves if not curve.problem]
    if not good:
        return None
    width, height = np.ptp([corner for curve in good for corner in curve.curve.bounds], axis=0).tolist()
    kinds: Counter[str] = Counter()
    operations = {"joined": False, "fitted": False, "turned": False, "smoothed": False}
    distance = 0.0
    for curve in good:
        kinds.update(curve.kinds)
        drawn, flat = curve.curve.provenance, curve.chain
        if curve.flatten is not None:
            flat = curve.flatten(curve.chain)
            plane, read = (
                np.concatenate([edge.points[:, :2] for edge in run]) for run in (curve.chain, flat)
            )
            # smaller movements are noise of the drawing
            operations["turned"] |= bool(np.abs(plane - read).max() > 1e-3 * np.ptp(read, axis=0).max())
        away = _distance(curve.curve, flat)
        pointwise = "point" in curve.kinds and not curve.curve.is_straight
        operations["fitted"] |= pointwise or ("polyline" in curve.kinds and away > EXACT_MM)
        operations["joined"] |= len({id(edge.source or edge) for edge in curve.chain}) > 1
        operations["smoothed"] |= drawn is not None and drawn.healed > EXACT_MM
        distance = max(distance, away)
    done = tuple(name for name, is_done in operations.items() if is_done)
    return ReadReport((width, height), unit, kinds, done, distance)


# largest number of points of the drawing that are compared with the curve
_MOST_POINTS = 200


def _distance(curve: PlaneCurve, flat: Run) -> float:
    """Return the largest distance, mm, of a curve from its points or edges in the file; 0 if it is unchanged."""
    record = curve.provenance
    if flat:
        if len(flat) == 1 and np.array_equal(flat[0].points, curve.control_points):
            return 0.0
        points = sample_run(flat)
    elif record is not None and record.measured is not None:
        points = record.measured.points
    else:
        return 0.0
    return largest_distance(points[:: -(-len(points) // _MOST_POINTS)], curve)


def collect_curves(
    path: Path,
    runs: Iterable[Run],
    skipped: Mapping[str, int],
    *,
    nothing: str,
    tolerance: float,
    fit_tolerance: float,
    shown: Provenance | None = None,
    flat: Callable[..., Run] | None = None,
    corners: bool = True,
) -> DrawnFile:
    """Join runs of edges whose ends meet, and return the curves of the file.

    Parameters
    ----------
    nothing : str
        Message about a file without curves.
    tolerance, fit_tolerance : float
        Tolerances of joints and of fits to polylines' vertices, mm.
    flat : callable, optional
        Function that maps edges in space to their plane.
    corners : bool
        If True, join ends that meet at a corner too.
    """
    check_tolerance(fit_tolerance, "tolerance for fitting")
    runs = list(runs)
    joined = join_runs((run for run in runs if run), tolerance, corners=corners)
    if not joined.chains:
        counts = dict(sorted(skipped.items())) | ({"of no length": len(runs)} if runs else {})
        raise InputError(nothing + (f" (found only {list_things(counts)})" if counts else ""))

    chains, holes = holes_on_chains(joined.chains)

    def make(chain: Run, drilled: Sequence[Run]) -> PlaneCurve:
        # a curve in space and its holes are mapped to one plane, then divided again
        edges = (*chain, *(edge for circle in drilled for edge in circle))
        plane = iter(edges if flat is None else flat(edges, tolerance))
        parts = [tuple(islice(plane, len(part))) for part in (chain, *drilled)]
        closing = max(tolerance, joined.widest)
        return curve_from_run(
            parts[0], tolerance=closing, fit_tolerance=fit_tolerance, shown=shown, holes=parts[1:]
        )

    sources = [chain[0].source or Source() for chain in chains]
    on_layer = Counter(source.layer for source in sources)
    curves = [
        DrawnCurve(
            number,
            partial(make, chain, drilled),
            source.name,
            source.layer,
            source.id,
            kinds=kinds_of(chain),
            chain=chain,
            flatten=flat and partial(flat, tolerance=tolerance),
            chosen_name=source.name if source.is_named else source.layer * (on_layer[source.layer] == 1),
        )
        for number, (chain, drilled, source) in enumerate(zip(chains, holes, sources, strict=True), start=1)
    ]
    near = near_ends(chains, tolerance)
    gaps = [note(
        "{one} and {other} end {apart:.2g} apart near {place}, so they become two strips. To make one strip, "
        "close the gap in the drawing",
        one=curves[i].called, other=curves[j].called, apart=Length(apart), place=Point(place),
    )for apart, i, j, place in near if apart > tolerance]  # fmt: skip
    touching = dict.fromkeys((i, j) for apart, i, j, _ in near if apart <= tolerance)
    pairs = [note("{one} and {other}", one=curves[i].called, other=curves[j].called) for i, j in touching]
    names = [note(
        "shapes with names are not joined where they touch: {pairs}. To make one strip of two shapes, combine them "
        "into one path in the drawing program, or remove their names",
        pairs=Listed(pairs),
    )] if pairs else []  # fmt: skip
    meeting = (*names, *_joining_notes(joined, tolerance), *gaps[:_SHOWN])
    widths = [_stroke_width(chain, tolerance) for chain in chains]
    outlines = [note(
        "{curve} looks like the outline of a stroke about {width:.2g} wide: draw the centre line of the stroke, "
        "or undo the conversion to a path (Inkscape: Stroke to Path; Illustrator: Outline Stroke)",
        curve=curve.called, width=Length(width),
    )for curve, width in zip(curves, widths, strict=True) if width]  # fmt: skip
    return DrawnFile(
        path,
        curves,
        dict(sorted(skipped.items())),
        remarks=(*outlines[:_SHOWN], *(meeting if corners else ())),
    )


def _joining_notes(joined: JoinedRuns, tolerance: float) -> list[str]:
    """Return notes on shapes that were left out as duplicates, and on gaps that were closed."""
    notes: list[str] = []
    for kind, text in _OVERLAPS.items():
        pairs = dict.fromkeys(
            note("{one} lies on {other}", one=_shape(shape), other=_shape(other))
            for shape, other, how in joined.overlaps
            if how == kind
        )
        others = [note("{count} others", count=len(pairs) - _SHOWN)] if len(pairs) > _SHOWN else []
        if pairs:
            notes.append(note(text, pairs=Listed([*islice(pairs, _SHOWN), *others])))
    closed = [gap for gap in joined.closed if gap > tolerance]
    if closed:
        notes.append(note(
            "gaps as small as the last digit of the numbers in the file were closed: {count}, the widest "
            "{widest:.2g}",
            count=len(closed), widest=Length(max(closed)),
        ))  # fmt: skip
    return notes


_OVERLAPS = {
    "left out": "drawn twice, so the longer shape is used: {pairs}",
    "kept": "drawn twice with different layers or names, so both are used: {pairs}",
    "joined": "partly drawn twice, so the two shapes are joined into one curve: {pairs}",
    "in part": "partly drawn twice, and both shapes are used: {pairs}. Trim one of them in the drawing",
}
"""Messages about overlapping shapes, by the result that `JoinedRuns.overlaps` gives."""


def _shape(source: Source) -> str:
    name = source.name or note("a shape without a name")
    return note("{name} (layer {layer})", name=name, layer=source.layer) if source.layer else name


# largest number of curves and kinds that a message lists
_SHOWN = 6


def _list_of_curves(curves: Sequence[DrawnCurve]) -> str:
    first = ", ".join(curve.called.removeprefix("curve ") for curve in curves[:_SHOWN])
    return f"they are {first}" + (" ..." if len(curves) > _SHOWN else "")


def list_things(counted: Mapping[str, int]) -> str:
    """Return a list in words, such as "2 text, 1 image"; if there are many kinds, only the first kinds.

    Examples
    --------
    >>> list_things({"text": 2, "image": 1}), list_things({f"kind {n}": 1 for n in range(40)})[-31:]
    ('2 text, 1 image', '1 kind 5, and 34 of other kinds')
    """
    most = len(counted) if len(counted) <= _SHOWN + 1 else _SHOWN
    parts = [f"{count} {kind}" for kind, count in list(counted.items())[:most]]
    others = sum(list(counted.values())[most:])
    return ", ".join(parts) + (f", and {others} of other kinds" if others else "")
