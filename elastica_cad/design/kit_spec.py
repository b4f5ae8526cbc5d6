"""Request for the files and parts of a kit: the tables `cut`, `nest`, `extras` and those of holders in a design."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from elastica_cad._text import plain_name
from elastica_cad._values import require_record
from elastica_cad.declared import Field, Option, Record, declared, require_declared
from elastica_cad.defaults import KERF, STROKE
from elastica_cad.errors import FieldName, InputError, Length, Refusal, note
from elastica_cad.formats.dxf_drawing import DxfVersion
from elastica_cad.mechanics.sheets import ROD_KIND, Sheet
from elastica_cad.model.nesting import Nesting
from elastica_cad.strip.drawing import Drawing, HoldingTabs, separate_parts
from elastica_cad.strip.pieces import Piece
from elastica_cad.strip.strip import strip_names
from elastica_cad.strip.uncuttable_parts import DEFAULT_LIMITS, FabricationLimits
from elastica_cad.translations import Language

if TYPE_CHECKING:
    from elastica_cad.model.fixtures import EndFixture
    from elastica_cad.model.frames import Rib
    from elastica_cad.model.model import Model
    from elastica_cad.model.plates import BasePlate


def cutting_keys() -> dict[str, Field]:
    """Return the fields of `Cutting` by their keys.

    Key and field have the same name, except the key `for`, a reserved word of Python.
    """
    return {"for" if option.name == "recipient" else option.name: option for option in declared(Cutting)}


def _curve_style(curves: str | None, recipient: object) -> str:
    return curves or ("arc" if recipient == "service" else "spline")


def _missing_for_tolerance(keys: Mapping[str, Any]) -> str:
    """Return the missing setting: splines and Bezier curves are exact, but DXF files of version R12 have arcs
    instead."""
    style = _curve_style(keys.get("curves"), keys.get("for"))
    is_exact = style not in ("arc", "polyline") and keys.get("version") != "R12"
    return "curves = arc or polyline" if is_exact else ""


def _missing_for_marks(keys: Mapping[str, Any]) -> str:
    """Return the missing setting: files for a service have cuts only."""
    return "for = workshop" if keys.get("for") == "service" else ""


@dataclass(frozen=True)
class Cutting:
    """Options of cutting files.

    `kerf` is in mm, or None for the kerf of each sheet. If `curves` is None, curves are arcs for a cutting
    service, and splines for a workshop. If `holding` is None, no bridges hold the parts in the sheet.
    """

    FIELDS: ClassVar[Callable[[], Mapping[str, Field]]] = staticmethod(cutting_keys)
    recipient: Annotated[
        Literal["workshop", "service"],
        Option(
            (
                "Recipient of the cutting files. A service cuts every line, so each file has a single part and "
                "only its cuts."
            ),
            group="files",
        ),
    ] = "workshop"
    marks: Annotated[
        bool,
        Option(
            "Draw guide lines and the names of mating strips on the parts.",
            group="files",
            needs=_missing_for_marks,
        ),
    ] = True
    kerf: Annotated[
        float | None,
        Option(
            "Width of the cut (kerf); the word sheet selects that of the sheet.",
            "mm",
            least=0,
            group="files",
            common=True,
            written=float | Literal["sheet"],
        ),
    ] = KERF
    curves: Annotated[
        str | None,
        Option(
            "Type of curve for curved edges: spline by default, arc for a service.",
            group="files",
            written=Literal["spline", "bezier", "arc", "polyline"],
        ),
    ] = None
    tolerance: Annotated[
        float,
        Option(
            "Largest error of arcs and polylines.",
            "mm",
            least=1e-4,
            most=10,
            group="files",
            needs=_missing_for_tolerance,
        ),
    ] = 0.02
    version: Annotated[str, Option("Version of the DXF files.", group="files", written=DxfVersion)] = "R2010"
    colors: Annotated[
        str,
        Option(
            "Colours of cuts and engraving, as expected by a laser program.",
            group="files",
            written=Literal["elastica", "boxes", "lightburn"],
        ),
    ] = "elastica"
    stroke: Annotated[
        float,
        Option(
            "Width of the lines in SVG files. Some laser programs cut only lines of at most 0.01 mm.",
            "mm",
            least=0.001,
            most=1,
            group="files",
        ),
    ] = STROKE
    holding: Annotated[
        HoldingTabs | None, Option("Bridges that hold the parts in the sheet.", group="files")
    ] = None

    def __post_init__(self) -> None:
        require_declared(Cutting, vars(self), "cutting")
        if self.service and self.holding is not None:
            raise InputError(
                "{holding} interrupts the outlines, but {recipient} = service needs closed outlines. Leave "
                "out one of these keys.",
                holding=FieldName("cut.holding"),
                recipient=FieldName("cut.for"),
            )

    @property
    def service(self) -> bool:
        """True if the files are for a cutting service."""
        return self.recipient == "service"

    def file_name(self, stem: str, suffix: str) -> str:
        """Return the name of a file.

        It includes the unit if the format does not store the unit, or if a cutting service gets the file.

        Examples
        --------
        >>> [Cutting(version="R12").file_name("arch", suffix) for suffix in ("dxf", "svg")]
        ['arch-mm.dxf', 'arch.svg']
        """
        for part in (stem, suffix):
            require_record(part, str, "part of a file name", "a text")
        drawn = self.service and suffix in ("dxf", "svg")
        return f"{stem}{'-mm' if drawn or (self.version, suffix) == ('R12', 'dxf') else ''}.{suffix}"

    def drawings(self, drawing: Drawing) -> tuple[Drawing, ...]:
        """Return a drawing for each file. A cutting service gets a file for each part."""
        return separate_parts(drawing) if self.service else (drawing,)

    def options(self, sheet: Sheet) -> dict[str, Any]:
        """Return the options of `save` for pieces of this sheet."""
        if self.kerf is None and sheet.kerf == 0:
            raise InputError(
                "The width of the cut is not known for {name}. Set {kerf} to a number in mm instead of 'sheet'.",
                name=sheet.name,
                kerf=FieldName("kerf"),
            )
        kerf = sheet.kerf if self.kerf is None else self.kerf
        return {
            "kerf": kerf,
            "curves": _curve_style(self.curves, self.recipient),
            "tolerance": self.tolerance,
            "version": self.version,
            "layers": self.colors,
            "stroke": self.stroke,
            "holding": self.holding,
            "marks": self.marks,
        }

    def kerf_note(self, sheets: Iterable[Sheet], *, of_sheet: bool = True) -> Refusal | None:
        """Return a note if the files for these sheets do not compensate the kerf, or None.

        `of_sheet` states whether the front end takes the word "sheet" for the kerf.
        """
        kerfs = [sheet.kerf for sheet in sheets if sheet.kind != ROD_KIND]
        if self.kerf != 0 or not kerfs:
            return None
        kerf = max(kerfs)
        return note(
            "The files do not compensate the kerf, which makes parts {kerf} narrower and slots wider. Accuracy "
            "assumes a compensated kerf. Set {field} to {value}, unless the laser program compensates it."
            if kerf else
            "The files do not compensate the kerf, which makes parts narrower and slots wider. Accuracy assumes a "
            "compensated kerf. Set {field} to the width of the cut, unless the laser program compensates it.",
            kerf=Length(kerf), field=FieldName("cut.kerf"), value="sheet" if of_sheet else Length(kerf),
        )  # fmt: skip


DEFAULT_CUTTING = Cutting()


@dataclass(frozen=True)
class PairCutting:
    """Keys of `Cutting` for a part with two states, which has no guide lines and no slots."""

    BESIDE: ClassVar[Record] = Cutting
    WITHOUT: ClassVar[tuple[str, ...]] = ("marks",)


HolderKind = Literal["base", "rings", "frame", "fixtures", "stand"]


@dataclass(frozen=True, eq=False)
class HolderSpec:
    """Request for holders of a kind for selected strips.

    Attributes
    ----------
    kind : "base", "rings", "frame", "fixtures" or "stand"
        One plate ("base"), a plate for each end ("rings"), two rails with ribs ("frame"), printed blocks
        ("fixtures"), or the simplest of these holders ("stand").
    sheet : Sheet or None
        Sheet of plates, or None for blocks.
    options : mapping
        Options of `base_plate`, `end_plates`, `slotted_frame` or `end_fixtures`.
    nesting : Nesting
        Stock sheets of the plates.
    strips : tuple of str
        Labels of the strips, which may contain the wildcards * and ?.
    where : str
        Name of the request in messages.
    """

    kind: HolderKind
    sheet: Sheet | None = None
    options: Mapping[str, Any] = field(default_factory=dict)
    nesting: Nesting = field(default_factory=Nesting)
    strips: tuple[str, ...] = ("*",)
    where: str = ""

    @property
    def name(self) -> str:
        """Name of the holder, by default its kind."""
        return str(self.options.get("name", self.kind))

    def made(
        self, model: "Model", shop: FabricationLimits = DEFAULT_LIMITS, *, ignore_limits: bool = False
    ) -> "tuple[tuple[BasePlate | Rib | EndFixture, ...], str]":
        """Make the plates, ribs and blocks. Also return a sentence on the choice of holder, or ""."""
        from elastica_cad.model.fixtures import end_fixtures
        from elastica_cad.model.frames import add_feet, slotted_frame
        from elastica_cad.model.model import stand
        from elastica_cad.model.plate_pairs import end_plates, plate_pair
        from elastica_cad.model.plates import base_plate
        from elastica_cad.model.spacers import add_spacers

        named = zip(model.placed, strip_names(model.placed), strict=True)
        placed = [
            strip for strip, name in named if any(fnmatchcase(name, plain_name(text)) for text in self.strips)
        ]
        if not placed:
            labels = ", ".join(dict.fromkeys(strip_names(model.placed)))
            raise InputError(
                "{place}: there is no strip {strips}. Use one of {labels}.",
                place=self.where,
                strips=" or ".join(self.strips),
                labels=labels,
            )
        # only printed blocks have no sheet
        if self.sheet is None:
            return end_fixtures(placed, **self.options), ""
        if self.kind == "stand":
            name = self.options.get("name")
            chosen = stand(placed, self.sheet, name=name, shop=shop, ignore_limits=ignore_limits)
            return chosen.holders, f"{model.name}: {chosen.sentence}"
        options = {**self.options, "shop": shop, "ignore_limits": ignore_limits}
        feet, spacers = options.pop("feet", None), options.pop("spacers", None)
        ribs: tuple[Rib, ...] = ()
        plates: tuple[BasePlate, ...]
        if self.kind == "frame":
            frame = slotted_frame(placed, self.sheet, **options)
            plates, ribs = frame.rails, frame.ribs
        elif self.kind == "rings":
            plates = end_plates(placed, self.sheet, **options)
        elif "gap" in options:
            plates = plate_pair(placed, self.sheet, **options)
        else:
            plates = (base_plate(placed, self.sheet, **options),)
        if spacers is not None:
            plates, ribs = add_spacers(placed, plates, spacers)
        return (*(plates if feet is None else add_feet(plates, feet)), *ribs), ""


@dataclass(frozen=True, eq=False)
class KitSpec:
    """Request for the parts of a kit that are not strips.

    Attributes
    ----------
    nesting : Nesting
    cutting : Cutting
    holders : tuple of HolderSpec
        Holders of the strips.
    coupon : bool
        True for a test coupon of every sheet.
    reference_bar : float or None
        Length of a bar for checking the scale of the machine, mm.
    pages : str or None
        Paper size of a PDF with every part at full size.
    shop : FabricationLimits
        Limits of the workshop.
    ignore_limits : bool
        Exceed these limits, with a note in the report.
    language : "en", "de", "zh-CN" or None
        Language of the assembly sheet; None for the language of the front end.
    """

    nesting: Nesting = field(default_factory=Nesting)
    cutting: Cutting = field(default_factory=Cutting)
    holders: tuple[HolderSpec, ...] = ()
    coupon: bool = False
    reference_bar: float | None = None
    pages: str | None = None
    shop: FabricationLimits = DEFAULT_LIMITS
    ignore_limits: bool = False
    language: Language | None = None

    def extras(self, model: "Model") -> "tuple[Piece, ...]":
        """Return the requested coupons of the sheets of the model, and the requested reference bar.

        A cutting service gets no bar, because it calibrates its own machine.
        """
        from elastica_cad.strip.coupon import coupon_drawing, reference_bar
        from elastica_cad.strip.lettering import engraved_names

        sheets = [
            sheet for sheet in dict.fromkeys(strip.sheet for strip in model.strips) if sheet.kind != ROD_KIND
        ]
        pieces = []
        if self.coupon:
            names = ["coupon"] if len(sheets) == 1 else [f"coupon-{n}" for n in range(1, len(sheets) + 1)]
            # a number in place of the name of a sheet could be that of a strip
            pieces += [
                Piece(name, coupon_drawing(s, label=engraved_names([s.name], {s.name: name})[s.name]), s)
                for name, s in zip(names, sheets, strict=True)
            ]
        if self.reference_bar is not None and sheets and not self.cutting.service:
            pieces.append(Piece("reference-bar", reference_bar(self.reference_bar), sheets[0]))
        return tuple(pieces)
