"""Functions that read curves from files and save drawings to files. The suffix determines the format.

Readers and writers are imported on first use, because a command usually reads a single file.
"""

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from elastica_cad._units import look_up_unit
from elastica_cad.errors import (
    InputError,
    MissingDependencyError,
    how_to_install,
    missing_library,
    refuse_options_unlike,
)
from elastica_cad.formats.chains import JOIN_TOLERANCE
from elastica_cad.formats.drawn_file import CurveList, DrawnFile
from elastica_cad.formats.source_file import KERNEL_SUFFIXES, MESH_SUFFIXES, name_source, require_file
from elastica_cad.geometry.fairing import FIT_TOLERANCE

if TYPE_CHECKING:
    from elastica_cad.form_finding.section_spec import Surface
    from elastica_cad.kernel.flexure_body import FlexureBody
    from elastica_cad.kernel.strip_body import StripBody
    from elastica_cad.model.model import Model
    from elastica_cad.pairs.flexure import Flexure
    from elastica_cad.strip.drawing import Drawing
    from elastica_cad.strip.strip import Strip


class CurveFormat(NamedTuple):
    """A kind of file with curves. Messages, help of the commands and the page follow from `CURVE_FORMATS`.

    Attributes
    ----------
    name : str
        Name in messages and help.
    suffixes : tuple of str
    read : callable
        Function that returns the `DrawnFile` of a path. It gets all other arguments of `read_drawing`.
    remark : str
        What such a file contains, or needs, if its name does not tell.
    begins : bytes
        Pattern of the first bytes, by which standard input is recognised. Other input is read as CSV.
    is_text : bool
        True if the page can read such a file.
    """

    name: str
    suffixes: tuple[str, ...]
    read: Callable[..., DrawnFile]
    remark: str = ""
    begins: bytes = b"(?!)"
    is_text: bool = True


def _read_dxf(path: Path, **settings: Any) -> DrawnFile:
    from elastica_cad.formats.dxf_curves import read_dxf_drawing

    return read_dxf_drawing(path, **settings)


def _read_svg(path: Path, **settings: Any) -> DrawnFile:
    try:
        from elastica_cad.formats.svg_curves import read_svg_drawing
    except ImportError as error:
        raise missing_library(f"reading {path.name} needs cssselect2", "cssselect2") from error
    return read_svg_drawing(path, **settings)


def _read_csv(path: Path, **settings: Any) -> DrawnFile:
    from elastica_cad.formats.point_files import read_csv_drawing

    return read_csv_drawing(path, **settings)


def _read_text(path: Path, **settings: Any) -> DrawnFile:
    from elastica_cad.formats.point_files import read_text_drawing

    return read_text_drawing(path, **settings)


def _read_json(path: Path, **settings: Any) -> DrawnFile:
    from elastica_cad.formats.json_curves import read_json_drawing

    return read_json_drawing(path, **settings)


def _read_step(path: Path, **settings: Any) -> DrawnFile:
    try:
        from elastica_cad.kernel.step_files import read_step_drawing
    except ImportError as error:
        raise _no_kernel(path) from error
    return read_step_drawing(path, **settings)


CURVE_FORMATS = (
    CurveFormat(
        "DXF", (".dxf",), _read_dxf, begins=rb"AutoCAD Binary DXF|(999\s.*\s+)?0\s+SECTION"
    ),
    CurveFormat("SVG", (".svg",), _read_svg, begins=b"<"),
    CurveFormat("compressed SVG", (".svgz",), _read_svg, begins=rb"\x1f\x8b", is_text=False),
    CurveFormat("CSV", (".csv",), _read_csv, "measured points"),
    CurveFormat(
        "TXT", (".txt",), _read_text, "measured points, or control points of a spline",
        rb"\d+[ \t]+\d+[ \t]*\r?\n",
    ),
    CurveFormat("JSON", (".json",), _read_json, "written by this program", rb"[{\[]"),
    CurveFormat(
        "STEP", KERNEL_SUFFIXES, _read_step, "needs build123d or CadQuery", b"ISO-10303-21", is_text=False
    ),
)  # fmt: skip


def listed_formats() -> str:
    """Return the names of all `CURVE_FORMATS`, with their remarks, as a list in a sentence."""
    return ", ".join(f"{kind.name}{kind.remark and f' ({kind.remark})'}" for kind in CURVE_FORMATS)


def read_curves(
    path: str | Path,
    *,
    tolerance: float = JOIN_TOLERANCE,
    fit_tolerance: float = FIT_TOLERANCE,
    unit: str | None = None,
) -> CurveList:
    """Read the curves in a file, in mm.

    Splines, arcs and ellipses are read exactly. Curves are fitted to polylines and measured points. Pieces
    whose ends meet are joined to a curve, except named shapes of an SVG. The ends of a closed curve are
    equal. Corners that rounded decimals cause are removed. `PlaneCurve.provenance` states how far the curve
    was moved.

    A file may have at most 20,000 shapes (blocks and clones are counted for each use), 120,000 pieces and
    5,000 curves. A curve may have at most 3,000 pieces, and a size of 0.001 mm to 1 km. A file may have at
    most 64 MB, and a STEP file 256 MB.

    Parameters
    ----------
    path : str or Path
        .dxf; .svg, .svgz (y turned up); .csv: measured points x, y; .txt: the same, or "degree count", then
        control points of a uniform unclamped spline; .json: as written by this program; .step, .stp, .brep: with
        build123d or CadQuery.
    tolerance : float
        Largest distance of ends that are joined, mm.
    fit_tolerance : float
        Largest distance of measured points from their curve, mm.
    unit : str, optional
        Unit of the numbers in the file, instead of the unit that the file states: "mm", "cm", "m", "in", "ft"
        or "px".

    Returns
    -------
    list of PlaneCurve
        Curves in the order of the file. The list is not empty. Its `notes` report omitted items: invalid
        curves, texts, images. `read_drawing` also returns numbers, ids and layers.

    Raises
    ------
    MissingDependencyError
        The library that reads this format is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "arch.txt")
    ...     _ = file.write_text("2 3\\n0 0\\n50 80\\n100 0\\n")
    ...     round(read_curves(file)[0].length, 2)
    66.69
    """
    return read_drawing(path, tolerance=tolerance, fit_tolerance=fit_tolerance, unit=unit).read()


def read_drawing(
    path: str | Path,
    *,
    tolerance: float = JOIN_TOLERANCE,
    fit_tolerance: float = FIT_TOLERANCE,
    unit: str | None = None,
    corners: bool = True,
) -> DrawnFile:
    """Read the curves of a file with their numbers, names and layers. Omitted items are listed.

    The arguments and errors are those of `read_curves`. If a curve is not valid, its attribute `problem` states
    why.

    Parameters
    ----------
    corners : bool
        In DXF and SVG, also join ends that meet at a corner.
    """
    with name_source(path) as file:
        for kind in CURVE_FORMATS:
            if file.suffix.lower() in kind.suffixes:
                return kind.read(
                    file, tolerance=tolerance, fit_tolerance=fit_tolerance, unit=unit, corners=corners
                )
    raise InputError(
        "{path} ends in {suffix!r}, but files of curves end in {curve_suffixes}. Export the curve to such a file.",
        path=path,
        suffix=file.suffix.lower(),
        curve_suffixes=", ".join(suffix for kind in CURVE_FORMATS for suffix in kind.suffixes),
    )


def read_model(path: str | Path) -> "Model":
    """Read a design file (TOML), and make its model as `elastica model` does.

    Raises
    ------
    NotRealizable, NotConvergedError
        A strip is impossible. The error contains the messages of all impossible strips.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> text = '''
    ... sheet = "birch-plywood-0.8"
    ... max_width = 20
    ... [[strips]]
    ... label = "A"
    ... curve = { spline = [[0, 0], [30, 60], [70, 60], [100, 0]], degree = 3 }
    ... '''
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "arch.toml")
    ...     _ = file.write_text(text)
    ...     model = read_model(file)
    >>> [strip.label for strip in model.strips]
    ['A']
    """
    from elastica_cad.design.design_file import read_design

    return read_design(path, read_curves, read_surface).model()


def read_surface(path: str | Path, *, unit: str | None = None, scale: float = 1.0) -> "Surface":
    """Read a surface for sections by planes: a mesh (.obj, .stl, .ply) or a CAD body (.step, .stp, .brep).

    Raises
    ------
    MissingDependencyError
        trimesh (for meshes) or a CAD kernel (for bodies) is not installed.
    """
    path = require_file(path)
    suffix = path.suffix.lower()
    if suffix not in KERNEL_SUFFIXES:
        from elastica_cad.formats.mesh_files import mesh_surface

        if suffix not in MESH_SUFFIXES:
            raise InputError(
                "{path} ends in {suffix!r}, but files of meshes and CAD bodies end in {known}. Export the "
                "body to such a file.",
                path=path,
                suffix=suffix,
                known=", ".join((*MESH_SUFFIXES, *KERNEL_SUFFIXES)),
            )
        return mesh_surface(path, unit=unit, scale=scale)
    try:
        from elastica_cad.kernel.shape_sections import shape_surface
        from elastica_cad.kernel.step_files import read_step_shape
    except ImportError as error:
        raise _no_kernel(path) from error
    with name_source(path):
        return shape_surface(read_step_shape(path), look_up_unit(unit or "mm") * scale)


def step_trouble() -> str:
    """Return why STEP files cannot be written, with the command that installs the library, or "" if they can."""
    if find_spec("OCP") is None:
        return how_to_install("build123d")
    from elastica_cad.kernel.ocp_import import kernel_trouble

    return kernel_trouble()


def _no_kernel(path: Path, doing: str = "reading") -> MissingDependencyError:
    return missing_library(f"{doing} {path.name} needs a CAD kernel", "build123d")


def save(
    made: "Drawing | Strip | Flexure | StripBody | FlexureBody", path: str | Path, **options: Any
) -> Path:
    """Write a drawing, a strip, a part with two states, or a body. The suffix of `path` selects the format.

    The formats are .dxf and .svg, and .step for strips and parts. The .step file of a strip contains the flat
    and the bent strip. The .step file of a two-state part contains the unloaded part or, with `state` "first"
    or "second", the part in this state. The options are those of `formats.write_drawing`: kerf, curves,
    tolerance, version, layers, stroke, force. For STEP, the only other option is force.

    A body of build123d or CadQuery, such as a `BentStrip`, is written at its position to .step, .stl or .glb, and
    its flat pattern to .dxf or .svg.

    Raises
    ------
    MissingDependencyError
        STEP needs build123d or CadQuery.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from elastica_cad.strip.drawing import CUT_OUTER, Drawing, LayeredPath
    >>> from elastica_cad.geometry.path import Path as Chain
    >>> card = Drawing("card", [LayeredPath(CUT_OUTER, Chain.rectangle(85, 55))])
    >>> with TemporaryDirectory() as folder:
    ...     save(card, Path(folder, "card.svg"), kerf=0.15).name
    'card.svg'
    """
    from elastica_cad.formats.drawing_files import write_drawing
    from elastica_cad.strip.drawing import Drawing
    from elastica_cad.strip.strip import Strip

    drawing: Any = made
    # a body of build123d or CadQuery has the record of the strip or part from which it was made
    is_strip, is_body = isinstance(made, Strip), hasattr(made, "_made")
    if is_strip or is_body or (not isinstance(made, Drawing) and _is_flexure(made)):
        file = Path(path)
        if file.suffix.lower() in (".step", ".stp", *((".stl", ".glb") if is_body else ())):
            try:
                from elastica_cad.kernel.mesh_files import write_body
                from elastica_cad.kernel.step_files import write_flexure_step, write_strip_step
            except ImportError as error:
                raise _no_kernel(file, "writing") from error
            write: Any = write_body if is_body else write_strip_step if is_strip else write_flexure_step
            refuse_options_unlike(options, write, f"a {file.suffix[1:].upper()} file")
            write(made, file, **options)
            return file
        drawing = drawing.drawing()
    refuse_options_unlike(options, write_drawing, "a drawing's file")
    return write_drawing(drawing, path, **options)


def _is_flexure(part: object) -> bool:
    from elastica_cad.pairs.flexure import Flexure

    return isinstance(part, Flexure)
