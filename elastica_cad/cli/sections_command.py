"""`elastica sections`: write the curves of sections of a mesh or CAD body, and a design file for their
strips.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click
import numpy as np

from elastica_cad._text import file_word
from elastica_cad.cli.options import (
    LENGTH,
    SPACE_POINT,
    Chosen,
    Length,
    given_of,
    output_options,
    refuse_idle,
    requested_sheet,
    sheet_options,
)
from elastica_cad.cli.voice import answer, say_rows, say_step, wrote
from elastica_cad.defaults import RATIO
from elastica_cad.design.sections_table import compose_section_design
from elastica_cad.design.toml_text import seen_from
from elastica_cad.errors import InputError, NotConvergedError, Refusal
from elastica_cad.files import read_surface
from elastica_cad.form_finding.section_lines import AT_CORNERS, AT_TWO_PLACES, SectionCurve
from elastica_cad.form_finding.section_spec import (
    AlongPath,
    CornerSplit,
    ParallelCuts,
    PlaneSplit,
    PointSplit,
    RadialCuts,
    SectionSpec,
    Split,
    Surface,
)
from elastica_cad.formats.curve_writer import write_curves
from elastica_cad.formats.json_curves import curves_json
from elastica_cad.formats.mesh_files import read_sized_surface
from elastica_cad.formats.point_files import read_path_points
from elastica_cad.formats.source_file import require_file
from elastica_cad.formats.write_files import File, text_file, write_files
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.least_ratio import optimal_rod
from elastica_cad.report_rows import Row, warning_row
from elastica_cad.strip.curve_check import check_equilibrium

ALONG = 10
"""Default number of cutting planes along a path."""

_IDLE = {
    "radial": ("up",), "angles": ("up",), "parallel": ("zero",), "offsets": ("zero",),
    "along": ("point", "axis", "zero"),
}  # fmt: skip
"""Parameters without effect, by the parameter that defines the planes."""

Triple = tuple[float, float, float]
TRIPLE = (float, float, float)


@click.command()
@click.argument("mesh", type=click.Path(path_type=Path))
@click.option("--unit", type=click.Choice(["mm", "cm", "m", "um", "in", "ft"]),
              help="Unit of a mesh, whose file names none [default: mm]. A STEP file names it; leave out --unit "
                   "there, because it would scale the body again.")  # fmt: skip
@click.option("--scale", type=click.FloatRange(0, min_open=True), metavar="FACTOR",
              help="Scale factor from file to model, in addition to the unit.")  # fmt: skip
@click.option(
    "--radial",
    type=click.IntRange(1, 1000),
    metavar="N",
    help="Cut by N half planes that begin at the axis, at equal angles, as a cake is cut.",
)
@click.option("--angle", "angles", type=float, multiple=True, metavar="DEG",
              help="Cut by the half plane at this angle around the axis; repeatable.")  # fmt: skip
@click.option("--parallel", type=click.IntRange(1, 1000), metavar="N",
              help="Cut by N planes perpendicular to the axis, through the middles of equal slices.")  # fmt: skip
@click.option("--offset", "offsets", type=LENGTH, multiple=True, metavar="MM",
              help="Cut by the plane perpendicular to the axis, this far from --point; repeatable.")  # fmt: skip
@click.option("--along", type=click.Path(path_type=Path), metavar="FILE",
              help="Cut by planes perpendicular to a path: a text or CSV file of rows x, y, z in mm.")  # fmt: skip
@click.option("--count", type=click.IntRange(1, 1000), metavar="N",
              help=f"Number of planes along the path  [default: {ALONG}]")  # fmt: skip
@click.option(
    "--point",
    type=SPACE_POINT,
    metavar="X Y Z",
    help=("Point on the axis [default: the middle of the mesh's bounding box]."),
)
@click.option("--axis", type=TRIPLE, metavar="X Y Z",
              help=("Direction of the axis [default: up; for parallel planes the longest side of the bounding "
                    "box]."))  # fmt: skip
@click.option(
    "--zero",
    type=TRIPLE,
    metavar="X Y Z",
    help="Direction, seen from the axis, of the half plane at angle 0 [default: x].",
)
@click.option(
    "--up",
    type=TRIPLE,
    metavar="X Y Z",
    help="Direction in space that points up in the drawn sections [default: z]; not with --radial and --angle.",
)
@click.option("--split", "splits", type=(*SPACE_POINT, *TRIPLE), multiple=True, metavar="X Y Z NX NY NZ",
              help="Split sections at a plane: one of its points, and a direction perpendicular to it; "
                   "repeatable.")  # fmt: skip
@click.option("--split-at", "split_at", type=SPACE_POINT, multiple=True, metavar="X Y Z",
              help="Split sections at the place nearest to this point; repeatable.")  # fmt: skip
@click.option("--split-corners", type=click.FloatRange(0, 180, min_open=True, max_open=True), metavar="DEG",
              help="Split sections at corners where the line turns by more than this angle.")  # fmt: skip
@click.option("--longest", is_flag=True, help="Keep only the longest line of every section.")
@click.option("--tolerance", type=Length(positive=True), default=0.3, show_default=True, metavar="MM",
              help="Largest distance of the curves from the sections.")  # fmt: skip
@click.option("--wavelength", type=Length(positive=True), metavar="MM",
              help="Smooth waves of the sections shorter than this, before curves are fitted  "
                   "[default: no smoothing]")  # fmt: skip
@sheet_options(required=False, use="Material of the strips, to write a design file for `elastica model`")
@click.option("--max-width", type=Length(positive=True), default=20.0, show_default=True, metavar="MM",
              help="Largest width of the strips, in the design file.")  # fmt: skip
@click.option("--ratio", type=click.FloatRange(1), default=RATIO, show_default=True, metavar="R",
              help="Largest stiffness ratio, in the design file: the widest place is at most R times as stiff as "
                   "the narrowest. For this, curves change as little as possible.")  # fmt: skip
@click.option("--margin", type=float, metavar="MU",
              help="Least stability margin, in the design file; a strip is stable above 0, safely stable "
                   "from 5  [default: none]")  # fmt: skip
@click.option("--gravity", is_flag=True, help="Include the weight of strips, along -z, in the design file.")
@click.option("--stand", metavar="NAME", default="hdf-1.5", show_default=True,
              help="Sheet of the plates that hold the strips, in the design file; none for no plates.")  # fmt: skip
@output_options
def sections(mesh: Path, output: Path, force: bool, **chosen: Any) -> None:
    """Cut a mesh or a CAD body into curves for strips.

    MESH is an OBJ, STL, PLY or STEP file. It is cut by planes, and a curve is fitted to each section.

    \b
      elastica sections pot.obj --unit cm --radial 16 --sheet card-200gsm -o out
      elastica sections horse.stl --parallel 20 --axis 1 0 0 --split 0 0 0 0 1 0 --sheet card-200gsm -o out
      elastica model out/horse-sections.toml -o kit          make the strips, cutting files and cut list

    Writes NAME-sections.json (the exact curves), NAME-sections.dxf (the curves side by side) and, with --sheet,
    NAME-sections.toml, a design file for `elastica model`. A section to which no curve
    can be fitted is reported and left out.
    """
    if chosen["sheet"] is not None:
        requested_sheet(chosen)
    if chosen["stand"] != "none":
        requested_sheet({"sheet": chosen["stand"], "thickness": None})
    require_file(mesh)
    size_options = given_of(chosen, ("unit", "scale"))
    families = {
        "--radial": chosen["radial"], "--angle": chosen["angles"], "--parallel": chosen["parallel"],
        "--offset": chosen["offsets"], "--along": chosen["along"],
    }  # fmt: skip
    options = [option for option, value in families.items() if value]
    if len(options) != 1:
        selected = f", not {' and '.join(options)}" if options else ""
        raise InputError(
            f"Exactly one option for the cutting planes is needed{selected}. Use one of "
            f"{', '.join(families)}."
        )
    of_design = ("margin", "gravity", "thickness", "max_width", "ratio", "stand")
    refuse_idle(dict.fromkeys(of_design, ("sheet",)) | {"count": ("along",)}, _IDLE)
    try:
        surface = read_sized_surface(read_surface, mesh, **size_options)
        spec = _spec(chosen, surface)
        say_step("cutting the surface and fitting curves")
        curves, reports = spec.curves(surface)
    except InputError as problem:
        message = str(problem) if str(mesh) in str(problem) else str(problem.at(file=mesh))
        raise InputError(
            "{told}{option}", told=message, option=_option_that_splits(message, chosen)
        ) from None
    verdicts = []
    for number, curve in enumerate(curves, start=1):
        say_step(f"judged {curve.name}", number, len(curves))
        verdicts.append(_verdict(curve))
        verdict = (
            verdicts[-1]["problem"] or f"a strip can take it, stiffness ratio {verdicts[-1]['ratio']:.4g}"
        )
        text = (
            f"{curve.name.removeprefix('section ')}: {curve.curve.length:.2f} mm long, "
            f"{curve.deviation:.2g} mm from the section at most; {verdict}"
        )
        say_rows(Row("Section", text))
    say_rows(*(warning_row(f"{text}{_option_that_splits(text, chosen)}", "Note") for text in reports))
    answer({"sections": verdicts})
    name = f"{file_word(mesh.stem)}-sections"
    plane_curves = [curve.curve for curve in curves]
    files = [
        text_file(f"{name}.json", curves_json(plane_curves)),
        File(f"{name}.dxf", lambda path: write_curves(_side_by_side(plane_curves), path)),
    ]
    if chosen["sheet"] is not None:
        mesh_table = {"mesh": seen_from(str(mesh), output)} | size_options
        sheet = chosen["sheet"]
        keys = {
            "sheet": seen_from(sheet, output) if ".toml" in sheet else sheet, "thickness": chosen["thickness"],
            "max_width": chosen["max_width"], "limits": given_of(chosen, ("ratio", "margin")),
            "gravity": chosen["gravity"] or None,
            "stand": None if chosen["stand"] == "none" else {"sheet": chosen["stand"]},
        }  # fmt: skip
        text = compose_section_design(name, mesh_table, spec, given_of(keys, keys))
        files.append(text_file(f"{name}.toml", text))
    wrote(write_files(files, output, force=force))
    if chosen["sheet"] is None:
        say_rows(
            Row("Next", "for strips along the curves add --sheet NAME, or run elastica strip with the curves")
        )


def _option_that_splits(message: str, chosen: Chosen) -> str:
    # the option for a split that the message suggests, in brackets, or ""
    changes = message.all_changes if isinstance(message, Refusal) else ()
    if AT_CORNERS in changes and chosen["split_corners"] is None:
        return " (--split-corners 20)"
    unsplit = not (chosen["splits"] or chosen["split_at"] or chosen["split_corners"])
    return " (--split X Y Z NX NY NZ, a point and a normal)" if AT_TWO_PLACES in changes and unsplit else ""


def _spec(chosen: Chosen, surface: Surface) -> SectionSpec:
    splits: list[Split] = [PlaneSplit(normal=numbers[3:], point=numbers[:3]) for numbers in chosen["splits"]]
    splits += [PointSplit(np.array(chosen["split_at"]))] if chosen["split_at"] else []
    if chosen["split_corners"] is not None:
        splits.append(CornerSplit(float(np.radians(chosen["split_corners"]))))
    return SectionSpec(
        _cuts(chosen, surface),
        longest=chosen["longest"],
        splits=tuple(splits),
        tolerance=chosen["tolerance"],
        wavelength=chosen["wavelength"] or 0.0,
    )


def _cuts(chosen: Chosen, surface: Surface) -> RadialCuts | ParallelCuts | AlongPath:
    """Return the cutting planes; by default through the middle of the surface, and across its longest extent."""
    if chosen["along"]:
        path = read_path_points(chosen["along"])
        if len(path) < 2:
            raise InputError(
                "{path} has {count} points, and a path needs at least 2. Write each point as a row x, y, z.",
                path=chosen["along"],
                count=len(path),
            )
        return AlongPath(path, chosen["count"] or ALONG, up=_up(chosen, np.ptp(path, axis=0)))
    x, y, z = surface.middle.round(6).tolist()
    point = chosen["point"] or (x, y, z)
    if chosen["radial"] or chosen["angles"]:
        axis = chosen["axis"] or (0.0, 0.0, 1.0)
        along_x = not np.any(np.cross(axis, (1.0, 0.0, 0.0)))
        zero = chosen["zero"] or ((0.0, 1.0, 0.0) if along_x else (1.0, 0.0, 0.0))
        angles = tuple(np.radians(chosen["angles"]).tolist()) or None
        return RadialCuts(chosen["radial"] or RadialCuts.count, angles, point, axis, zero)
    x, y, z = np.eye(3)[int(np.argmax(np.ptp(surface.points, axis=0)))].tolist()
    normal = chosen["axis"] or (x, y, z)
    count, offsets = chosen["parallel"] or ParallelCuts.count, chosen["offsets"] or None
    return ParallelCuts(normal, count, offsets, point, _up(chosen, np.array(normal)))


def _up(chosen: Chosen, along: Any) -> Triple:
    # parallel to z apart from rounding errors
    upright = np.abs(along[:2]).max() <= 1e-9 * np.abs(along).max()
    up: Triple = chosen["up"] or ((0.0, 1.0, 0.0) if upright else (0.0, 0.0, 1.0))
    return up


def _verdict(curve: SectionCurve) -> dict[str, Any]:
    """Return whether a strip can take the curve of a section, with the least ratio or the problem."""
    verdict: dict[str, Any] = {
        "name": curve.name, "length": curve.curve.length, "deviation": curve.deviation, "realizable": False,
        "ratio": None, "problem": None,
    }  # fmt: skip
    try:
        check = check_equilibrium(curve.curve)
        if check.realizable:
            return verdict | {"realizable": True, "ratio": optimal_rod(curve.curve, check=check).ratio}
    except (InputError, NotConvergedError) as problem:
        return verdict | {"problem": f"no strip: {problem}"}
    return verdict | {"problem": f"no strip can take it: {check.reasons[0]}"}


def _side_by_side(curves: Sequence[PlaneCurve]) -> list[PlaneCurve]:
    """Return the curves side by side, for one drawing."""
    placed, x = [], 0.0
    for curve in curves:
        (lowest_x, low), (highest_x, _) = curve.bounds
        placed.append(curve.transformed([[1, 0, x - lowest_x], [0, 1, -low], [0, 0, 1]]))
        x += highest_x - lowest_x + 20.0  # mm between neighbouring curves
    return placed
