"""The table of a design file for a strip: its curve and `length`, its position in space, and its request."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, TypeAlias

from elastica_cad._types import Triple
from elastica_cad._values import require_positive
from elastica_cad.declared import Option, Record
from elastica_cad.design.drawn_curves import read_drawn_curve
from elastica_cad.design.records import Reader, fields_of, names_of
from elastica_cad.design.tables import Table
from elastica_cad.errors import InputError
from elastica_cad.form_finding.limits import Keep, Limits
from elastica_cad.form_finding.splitting import Splitting, split
from elastica_cad.formats.drawn_file import DrawnCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import End, Supports
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.strip_spec import DOWN, StripSpec

if TYPE_CHECKING:
    from elastica_cad.form_finding.section_lines import SectionCurve


@dataclass(frozen=True)
class SharedKeys:
    """Keys of a strip that may also be written at the top of a design file, where they apply to all strips."""

    BESIDE: ClassVar[Record] = StripSpec
    WITHOUT: ClassVar[tuple[str, ...]] = ("curve", "slots", "label")
    thickness: Annotated[
        float | None,
        Option(
            "Thickness of the sheet, if it differs from the listed one.",
            "mm",
            least=0,
            group="sheet",
            common=True,
        ),
    ] = None


CurveLength: TypeAlias = Annotated[
    float | None,
    Option(
        "Length of the curve, which is scaled about its start, with the drawn shape. At the top of a design file, "
        "all curves get this length.",
        "mm",
        least=0,
        group="curve",
    ),
]


SHARED = (*names_of(SharedKeys), "length")
"""Keys at the top of a design file that apply to the strips, and to other parts that have these keys."""


@dataclass(frozen=True)
class StripKeys(SharedKeys):
    """All keys of a table in [[strips]]."""

    WITHOUT: ClassVar[tuple[str, ...]] = ()
    length: CurveLength = None
    count: Annotated[int, Option("Number of strips, i = 1, 2, ...", least=1)] = 1
    split: Annotated[
        int | Literal["fewest"] | None,
        Option(
            "Number of strips into which the curve is split. They are clamped where they meet.",
            least=1,
            group="curve",
            replaces=("slots", "between", "loads", "natural_curvature", "seam_position"),
        ),
    ] = None
    let: Annotated[dict[str, float] | None, Option("Names for formulae of this strip.")] = None
    sections: Annotated[
        Any,
        Option(
            "Sections of a surface, each with a strip, instead of the curve.",
            written="elastica_cad.design.sections_table:SectionsTable",
            replaces=("curve", "length", "count", "origin", "x_axis", "y_axis"),
        ),
    ] = None
    origin: Annotated[Triple, Option("Position of the drawing's origin in space.", "mm", group="weight")] = (
        0,
        0,
        0,
    )
    x_axis: Annotated[Triple, Option("Direction of the drawing's x axis in space.", group="weight")] = (
        1,
        0,
        0,
    )
    y_axis: Annotated[Triple, Option("Direction of the drawing's y axis in space.", group="weight")] = (
        0,
        0,
        1,
    )


@dataclass(frozen=True, eq=False)
class StripEntry:
    """A strip of a design file.

    Attributes
    ----------
    spec : StripSpec
        Request for the strip.
    section : str
        Name of the section that the strip follows, with the position of its start, or "".
    off_section : float
        Largest distance, mm, between the points of the section and the curve.
    scale : float
        Factor by which the curve was scaled to the length that the table sets.
    joints : (str, str)
        Names of the joints at the start and the end, where another strip of a split curve continues, or "".
    """

    spec: StripSpec
    section: str = ""
    off_section: float = 0.0
    scale: float = 1.0
    joints: tuple[str, str] = ("", "")

    @property
    def label(self) -> str:
        """Label of the strip, which is engraved and used in messages."""
        return self.spec.label

    @property
    def curve(self) -> PlaneCurve:
        """The drawn curve, mm."""
        return self.spec.curve

    @property
    def sheet(self) -> Sheet:
        """The sheet that the strip is cut from."""
        return self.spec.material

    @property
    def frame(self) -> Frame:
        """Plane of the drawn curve."""
        return self.spec.frame or Frame()

    @property
    def called(self) -> str:
        """Name of the strip in messages: its label, with its section if it has one."""
        return f"{self.label} ({self.section})" if self.section else self.label


def read_strip(table: Table, label: str, reader: Reader, section: "SectionCurve | None" = None) -> StripEntry:
    """Read the strip that a table in [[strips]] requests.

    Curve and plane are those of `section`, if given.
    """
    frame = _plane(reader, table) if section is None else section.frame
    values = read_fields(table, reader) | {"label": label}
    drawn = read_drawn_curve(reader, table) if section is None else section.curve
    curve = _with_length(table, drawn)
    spec = _spec(table, curve, frame, values)
    if section is None:
        return StripEntry(spec, scale=curve.length / drawn.length)
    return StripEntry(spec, section.called, section.deviation)


def split_curve(table: Table, spec: StripSpec) -> Splitting:
    """Return the pieces into which the key `split` of a table divides the curve of its request."""
    count = None if table.raw("split") == "fewest" else table.count("split")
    with table.naming("split"):
        return split(spec.curve, ratio=spec.largest_ratio, supports=spec.supports, count=count)


def clamped_at(joints: Sequence[str], spec: StripSpec) -> StripSpec:
    """Return the request for a piece of a split curve, which is clamped at its joints."""
    ends = (End() if joint else end for joint, end in zip(joints, spec.supports.ends, strict=True))
    return spec.changed(supports=Supports(*ends))


def split_entry(entry: StripEntry, pieces: Sequence[PlaneCurve]) -> list[StripEntry]:
    """Return a strip for each piece of the curve of an entry. Their labels end with their numbers."""
    spec = entry.spec
    return [
        replace(
            entry,
            spec=clamped_at(
                piece.joints, spec.changed(curve=piece.curve, label=f"{spec.label}{piece.suffix}")
            ),
            joints=piece.joints,
        )
        for piece in DrawnCurve(1, lambda: spec.curve).split(lambda _: pieces)
    ]


def read_fields(table: Table, reader: Reader) -> dict[str, Any]:
    """Return the fields of `StripSpec` in a table, except curve and plane."""
    known = {entry.name: entry for entry in fields_of(StripSpec) if entry.name != "curve"}
    if not table.has("sheet"):
        raise InputError(
            '{key} is missing. Name a sheet, such as sheet = "birch-plywood-0.8".', key=table.place("sheet")
        )
    sheet: Sheet = reader.value(known["sheet"].kind, table, "sheet")
    reader = replace(reader, sheet=sheet)
    values = {name: reader.value(entry.kind, table, name) for name, entry in known.items() if table.has(name)}
    # one of both keys allows the curve to change, which needs both records
    if "limits" in values or "keep" in values:
        values = {"limits": Limits(), "keep": Keep(), **values}
    return values


def read_request(table: Table, reader: Reader, curve: PlaneCurve, frame: Frame | None = None) -> StripSpec:
    """Make the request for a strip from a table and a curve.

    The plane is `frame` or, by default, read from the table. Without a plane in space, gravity acts along -y
    of the drawing.
    """
    values = read_fields(table, reader)
    direction = values.get("gravity")
    in_space = isinstance(direction, tuple) and len(direction) == len(DOWN)
    if frame is None and (in_space or any(table.has(name) for name in PLANE)):
        frame = _plane(reader, table)
    return _spec(table, _with_length(table, curve), frame, values)


def _with_length(table: Table, curve: PlaneCurve) -> PlaneCurve:
    """Return the curve, scaled about its start to the length in the table, if there is one."""
    length = table.maybe("length")
    if length is None:
        return curve
    with table.naming("length"):
        require_positive(length, "the length of the curve")
    scale = length / curve.length
    x, y = (1 - scale) * curve.control_points[0]
    return curve.transformed([[scale, 0.0, x], [0.0, scale, y], [0.0, 0.0, 1.0]])


def _spec(table: Table, curve: PlaneCurve, frame: Frame | None, values: Mapping[str, Any]) -> StripSpec:
    gravity = values.get("gravity")
    # the value true means downwards: -z in space, or -y of a drawing without a plane
    if isinstance(gravity, bool):
        values = {**values, "gravity": (DOWN if frame is not None else True) if gravity else None}
    with table.naming():
        return StripSpec(curve, frame=frame, **values)


TIE_KEYS = {"between": ("start", "end"), "loads": ("at",)}
"""Keys of a tie (in the list `between`) and of a load (in `loads`) whose values are positions along the curve."""


def scaled_places(table: Mapping[str, Any], factor: float) -> dict[str, list[dict[str, Any]]]:
    """Return the lists `between` and `loads` of a table, changed for a curve that is longer by a factor.

    Positions (mm) of ties and loads along the curve are multiplied by the factor. Points, and positions of
    rails and pins, are unchanged.

    Examples
    --------
    >>> scaled_places({"between": [{"at": 40}, {"kind": "tie", "start": 0, "end": 300}]}, 1.1)
    {'between': [{'at': 40}, {'kind': 'tie', 'start': 0.0, 'end': 330.0}]}
    """

    def places(record: Mapping[str, Any], names: tuple[str, ...]) -> Iterator[tuple[str, float]]:
        for name in names:
            if isinstance(record.get(name), int | float):
                yield name, round(factor * record[name], 6)

    return {
        key: [{**record, **dict(places(record, names))} for record in table[key]]
        for key, names in TIE_KEYS.items()
        if isinstance(table.get(key), list)
    }


# keys of the plane of the drawing in space, which are fields of `Frame`
PLANE = ("origin", "x_axis", "y_axis")


def _plane(reader: Reader, table: Table) -> Frame:
    axes: Mapping[str, Any] = {
        entry.name: reader.value(entry.kind, table, entry.name) if table.has(entry.name) else entry.default
        for entry in fields_of(StripKeys)
        if entry.name in PLANE
    }
    with table.naming():
        return Frame(**axes)
