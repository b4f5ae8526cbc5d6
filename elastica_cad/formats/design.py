"""Design files: a whole model written down in TOML, read, checked and made.

Every number may be a formula in quotes (see `formulae`); lengths are mm, angles rad (30 * degrees). Keys:

    schema = 1, name, let = {names for formulae}, sheets_file or [sheets.NAME] (as `load_sheets`)
    for all strips, or in [[strips]] for some: sheet, max_width, min_width, gravity (true, or where things fall),
        supports, natural_curvature, limits and keep (the curve may then change), style, and ends =
        {length, width, corner_radius, chamfer, taper, holes = [{at, diameter, across}],
        t_slot = {depth, screw, nut, wall}} or two of them
    [[strips]] count (i = 1, 2, ...), label ("P{i}"), let, origin, x_axis, y_axis (the plane of the curve), slots,
        sections = {mesh (or STEP body), unit, scale, half, longest, split = {point, normal}, {points}, {corners =
        angle} or a list of such, tolerance, wavelength, and one of radial = {point, axis, zero, count or angles},
        parallel = {point, normal, offsets or count, up}, along = {path, count, ends, up}}: a strip each, or
        curve = "file", {file, number, unit}, {x, y, t = [from, to], breaks = [[t, continuity]]},
        {spline = [[x, y]], degree} or {ellipse = {center, semi_axes, rotation, start, end or above}}, any of them
        with reshape = {bottom_left, bottom_right, top_right, top_left: where corners of its box go} or
        {handles = four points, to = four points}
    revolution = {points = [[x, y]] from the axis, or curve (as above), or a, b, start, angle and length; strips,
        ring, rings = "SHEET", sheet, ends}: a surface of revolution about z, tiled by equal strips
    [[patterns]] mirror = {point, normal, keep}, rotate = {count, axis, point, step}, repeat = {count, step}
    interlock = {clearance, fit, relief, above}, fixtures = {floor, clearance, wall, foot, foot_height, screw}
    base = {sheet, height, play, clearance, slot_width, border, shape, sheet_size}
    frame = {sheet, ribs, depth, tongue, play, clearance, border, sheet_size}
    nest = {sheet_size, margin}, extras = {coupon, reference_bar}
    cut = {kerf, curves, tolerance, version, holding = {width, spacing, least, inner}}
"""

import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad.errors import ElasticaError, InputError, NotConvergedError
from elastica_cad.fabrication import (
    BasePlate,
    Model,
    Piece,
    Placed,
    Ring,
    SlottedFrame,
    Strip,
    coupon_drawing,
    reference_bar,
)
from elastica_cad.fabrication.making import make_strip
from elastica_cad.formats.kit_wishes import (
    Cutting,
    Nesting,
    base_wish,
    cutting_wish,
    fixtures_wish,
    frame_wish,
    interlock_wish,
    nesting_wish,
)
from elastica_cad.formats.opening import existing_file
from elastica_cad.formats.revolution_wish import RevolutionWish, revolution_wish
from elastica_cad.formats.section_wishes import sections_of
from elastica_cad.formats.surfaces import SurfaceReader, mesh_surface
from elastica_cad.formats.tables import Table
from elastica_cad.formats.wishes import (
    MAKING_KEYS,
    STRIP_KEYS,
    CurveReader,
    StripWish,
    strip_wish,
)
from elastica_cad.forming import SectionCurve
from elastica_cad.mechanics import (
    NotRealizable,
    Sheet,
    load_sheets,
)
from elastica_cad.mechanics.sheet import sheets_from_table

__all__ = ["DESIGN_SCHEMA", "Cutting", "Design", "Nesting", "read_design"]

DESIGN_SCHEMA = 1

TOP_KEYS = (
    *MAKING_KEYS, "schema", "name", "let", "sheets", "sheets_file", "strips", "patterns", "interlock", "base",
    "frame", "fixtures", "nest", "cut", "extras", "revolution",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Design:
    """A design file, read and checked; `model` makes it.

    Attributes
    ----------
    name : str
    wishes : tuple of StripWish
        Strips in the order of the file.
    patterns : tuple of (name, options)
        "mirror", "rotate", "repeat", applied in order.
    interlock, fixtures : dict or None
        Options of `Model.interlock` and `Model.fixtures`, where asked for.
    base, frame : (Sheet, dict, Nesting) or None
        Sheet and options of the base plate, of the slotted frame, and the sheet size they are cut from.
    nesting : Nesting
    cutting : Cutting
    coupon : bool
        Cut a coupon of every sheet.
    reference_bar : float or None
        Length of a bar to check the machine's scale with, mm.
    reports : tuple of str
        What sections of meshes and meridians have to say.
    revolution : RevolutionWish or None
        A surface of revolution, made before all strips.
    """

    name: str
    wishes: tuple[StripWish, ...]
    patterns: tuple[tuple[str, dict[str, Any]], ...] = ()
    interlock: dict[str, Any] | None = None
    fixtures: dict[str, Any] | None = None
    base: tuple[Sheet, dict[str, Any], Nesting] | None = None
    frame: tuple[Sheet, dict[str, Any], Nesting] | None = None
    nesting: Nesting = field(default_factory=Nesting)
    cutting: Cutting = field(default_factory=Cutting)
    coupon: bool = False
    reference_bar: float | None = None
    reports: tuple[str, ...] = ()
    revolution: RevolutionWish | None = None

    def model(self, done: Callable[[str], None] | None = None) -> Model:
        """Make all strips, put them in their places, repeat and interlock them.

        Parameters
        ----------
        done : callable, optional
            Called with the label of each strip that has been made.

        Raises
        ------
        NotRealizable, NotConvergedError, InputError
            What `make_strip` and `Model.interlock` refuse, with the part's name. A section that no strip can
            follow is left out and reported; the first is raised where none is left.
        """
        made: dict[Any, Strip] = {}
        placed: list[Placed] = []
        failed: list[ElasticaError] = []
        for wish in self.wishes:
            key = _likeness(wish)
            if key not in made:
                try:
                    made[key] = _made(wish)
                except (NotRealizable, NotConvergedError, InputError) as problem:
                    if not wish.section:
                        raise
                    failed.append(problem)
                    continue
            strip = replace(made[key], label=wish.label, slots=wish.making["slots"])
            placed.append(Placed(strip, wish.frame.origin, wish.frame.x_axis, wish.frame.y_axis))
            if done is not None:
                done(wish.label)
        plates: tuple[Ring, ...] = ()
        if self.revolution is not None:
            surface = self.revolution.model(self.name)
            placed, plates = [*surface.placed, *placed], surface.plates
        if failed and not placed:
            raise failed[0]
        without = tuple(f"{problem} This section is left out." for problem in failed)
        model = Model(tuple(placed), self.name, reports=(*without, *self.reports), plates=plates)
        for kind, options in self.patterns:
            model = getattr(model, _PATTERNS[kind])(**options)
        return model if self.interlock is None else model.interlock(**self.interlock)

    def base_plate(self, model: Model) -> BasePlate | None:
        """The base plate, where the design has one."""
        if self.base is None:
            return None
        sheet, options, _ = self.base
        return model.base_plate(sheet, **options)

    def slotted_frame(self, model: Model) -> SlottedFrame | None:
        """The slotted frame, where the design has one."""
        if self.frame is None:
            return None
        sheet, options, _ = self.frame
        return model.slotted_frame(sheet, **options)

    def extras(self) -> tuple[Piece, ...]:
        """Coupons and the reference bar, where the design asks for them."""
        used = [wish.sheet for wish in self.wishes]
        sheets = list(dict.fromkeys(used if self.revolution is None else [self.revolution.sheet, *used]))
        pieces = []
        if self.coupon:
            names = ["coupon"] if len(sheets) == 1 else [f"coupon-{n}" for n in range(1, len(sheets) + 1)]
            pieces += [Piece(name, coupon_drawing(s), s) for name, s in zip(names, sheets, strict=True)]
        if self.reference_bar is not None:
            pieces.append(Piece("reference-bar", reference_bar(self.reference_bar), sheets[0]))
        return tuple(pieces)


_PATTERNS = {"mirror": "mirrored", "rotate": "rotated", "repeat": "repeated"}


def read_design(
    path: str | Path, read_curves: CurveReader, read_surface: SurfaceReader = mesh_surface
) -> Design:
    """A design file, every formula computed and every curve file read.

    Parameters
    ----------
    path : path-like
        TOML with `schema = 1`; files in it are relative to its folder.
    read_curves : callable
        Reads a curve file: `elastica_cad.read_curves`.
    read_surface : callable
        Reads a surface for sections: of meshes alone, or of STEP bodies too, `elastica_cad.files.read_surface`.

    Raises
    ------
    InputError
        No TOML, unknown keys, missing files or values that make no sense: the place in the file is named.
    """
    path = existing_file(path)
    try:
        data = tomllib.loads(path.read_bytes().decode("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"{path} is no TOML file: {error}") from error
    top = Table(data, str(path), {}).only(*TOP_KEYS)
    if data.get("schema") != DESIGN_SCHEMA:
        raise InputError(
            f"{path}: schema is {data.get('schema')!r}; this version reads schema = {DESIGN_SCHEMA}"
        )
    top.scope = top.within(data.get("let", {}))
    sheets = _own_sheets(top, path)
    revolution = None
    if top.has("revolution"):
        inner = top.table("revolution")
        inner.defaults = Table(
            {key: top.raw(key) for key in ("sheet", "ends") if top.has(key)}, top.where, top.scope
        )
        revolution = revolution_wish(inner, path.parent, sheets, read_curves)
    wishes, reports = _wishes(top, path.parent, sheets, read_curves, read_surface)
    if not wishes and revolution is None:
        raise InputError(f"{top.where} has no strips: write at least one table [[strips]]")
    twice = sorted({w.label for w in wishes if sum(w.label == v.label for v in wishes) > 1})
    if twice:
        raise InputError(
            f"{path}: two strips are labelled {twice[0]!r}; give each its own label, with {{i}} for the count"
        )
    nesting = nesting_wish(top.table("nest"))
    extras = top.table("extras").only("coupon", "reference_bar")
    return Design(
        name=top.text("name", path.stem),
        wishes=tuple(wishes),
        patterns=tuple(_pattern(table) for table in top.tables("patterns")),
        interlock=interlock_wish(top.table("interlock")) if top.has("interlock") else None,
        fixtures=fixtures_wish(top.table("fixtures")) if top.has("fixtures") else None,
        base=base_wish(top.table("base"), sheets, nesting) if top.has("base") else None,
        frame=frame_wish(top.table("frame"), sheets, nesting) if top.has("frame") else None,
        nesting=nesting,
        cutting=cutting_wish(top.table("cut")),
        coupon=extras.flag("coupon"),
        reference_bar=extras.maybe("reference_bar"),
        reports=reports if revolution is None else (*revolution.reports, *reports),
        revolution=revolution,
    )


def _own_sheets(top: Table, path: Path) -> dict[str, Sheet]:
    """Sheets that the design brings along."""
    sheets: dict[str, Sheet] = {}
    if top.has("sheets_file"):
        sheets |= load_sheets(path.parent / top.text("sheets_file"))
    if top.has("sheets"):
        sheets |= sheets_from_table(top.raw("sheets"), where=str(path))
    return sheets


def _wishes(
    top: Table,
    folder: Path,
    sheets: dict[str, Sheet],
    read_curves: CurveReader,
    read_surface: SurfaceReader,
) -> tuple[list[StripWish], tuple[str, ...]]:
    """All strips in order, and what sections of meshes have to say."""
    wishes: list[StripWish] = []
    reports: list[str] = []
    for table in top.tables("strips"):
        table.only(*STRIP_KEYS)
        sections: tuple[SectionCurve | None, ...]
        if table.has("sections"):
            sections, told = sections_of(_only_sections(table), folder, read_surface)
            reports += told
        else:
            sections = (None,) * table.count("count", 1)
        for i, section in enumerate(sections, start=1):
            where = f"{table.where}, i = {i}" if len(sections) > 1 else table.where
            one = Table(table.data, where, {**top.scope, "i": float(i)}, top)
            one.scope = one.within(table.data.get("let", {}))
            label = table.text("label", f"S{len(wishes) + 1}").replace("{i}", str(i))
            one.where = f"{where} ({label})"
            wishes.append(strip_wish(one, label, folder, sheets, read_curves, section))
    return wishes, tuple(reports)


def _only_sections(table: Table) -> Table:
    """The table of sections, which say themselves how many there are and where they lie."""
    idle = [key for key in ("count", "curve", "origin", "x_axis", "y_axis") if key in table.data]
    if idle:
        raise InputError(f"{table.place(idle[0])} means nothing beside sections: leave it out")
    return table.table("sections")


def _pattern(table: Table) -> tuple[str, dict[str, Any]]:
    """One of mirror, rotate and repeat."""
    table.only(*_PATTERNS)
    if len(table.data) != 1:
        raise InputError(f"{table.where} must hold one of {', '.join(_PATTERNS)}")
    (kind,) = table.data
    inner = table.table(kind)
    if kind == "mirror":
        inner.only("point", "normal", "keep")
        point, normal = inner.vector("point", 3, (0.0, 0.0, 0.0)), inner.vector("normal", 3)
        return kind, {"point": point, "normal": normal, "keep": inner.flag("keep", True)}
    if kind == "repeat":
        inner.only("count", "step")
        return kind, {"count": inner.count("count", 1), "step": inner.vector("step", 3)}
    inner.only("count", "axis", "point", "step")
    axis, point = inner.vector("axis", 3, (0.0, 0.0, 1.0)), inner.vector("point", 3, (0.0, 0.0, 0.0))
    return kind, {"count": inner.count("count", 1), "axis": axis, "point": point, "step": inner.maybe("step")}


def _likeness(wish: StripWish) -> Any:
    """Strips with equal keys are made alike: the same curve but for rounding, the same options."""
    curve, making = wish.curve, dict(wish.making)
    gravity = making.pop("gravity")
    numbers = [curve.knots - curve.knots[0], curve.control_points.ravel()]
    numbers += [] if curve.weights is None else [curve.weights]
    numbers += [] if gravity is None else [[gravity.length, *gravity.direction]]
    digits = np.round(np.concatenate(numbers) / curve.length, 11) + 0.0
    making.pop("slots")
    return digits.tobytes(), wish.sheet, repr(making)


def _made(wish: StripWish) -> Strip:
    """The strip, with complaints that name it."""
    making = dict(wish.making, slots=())
    try:
        return make_strip(wish.curve, wish.sheet, label=wish.label, **making)
    except NotRealizable as problem:
        named = NotRealizable(problem.check)
        named.args = (f"{wish.called}: {problem}",)
        raise named from problem
    except (InputError, NotConvergedError) as problem:
        raise type(problem)(f"{wish.called}: {problem}") from problem
