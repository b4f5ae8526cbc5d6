"""Table of a design file for sections of a surface: file of the surface, planes, and division of curves."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from elastica_cad.declared import Option
from elastica_cad.design.records import Reader
from elastica_cad.design.tables import Table
from elastica_cad.design.toml_text import toml_text
from elastica_cad.errors import InputError
from elastica_cad.form_finding.section_lines import SectionCurve
from elastica_cad.form_finding.section_spec import (
    AlongPath,
    CornerSplit,
    ParallelCuts,
    PlaneSplit,
    PointSplit,
    RadialCuts,
    SectionSpec,
)
from elastica_cad.formats.mesh_files import mesh_surface, read_sized_surface
from elastica_cad.formats.source_file import file_in


@dataclass(frozen=True)
class SectionsTable:
    """The table `sections`: a surface, and the planes that cut it into curves."""

    mesh: Annotated[
        str, Option("File name of the surface, relative to the design file: OBJ, STL, PLY or STEP.")
    ]
    radial: Annotated[RadialCuts | None, Option("Half planes around an axis.")] = None
    parallel: Annotated[ParallelCuts | None, Option("Parallel planes.")] = None
    along: Annotated[AlongPath | None, Option("Planes perpendicular to a path.")] = None
    unit: Annotated[str | None, Option("Unit of the mesh.")] = None
    scale: Annotated[float | None, Option("Scale factor of the mesh.", above=0)] = None
    half: Annotated[bool | None, Option("Only the part of each section at x >= 0 of its plane.")] = None
    longest: Annotated[bool, Option("Only the longest line of each section.")] = False
    split: Annotated[
        PlaneSplit | PointSplit | CornerSplit | tuple[PlaneSplit | PointSplit | CornerSplit, ...],
        Option("Places where sections are split."),
    ] = ()
    tolerance: Annotated[float, Option("Largest distance of the curve from the section.", "mm", least=0)] = (
        0.3
    )
    wavelength: Annotated[float, Option("Wavelength below which waves are removed.", "mm", least=0)] = 0.0

    def __post_init__(self) -> None:
        if len(self._cuts) != 1:
            raise InputError(
                "Cutting planes are missing. Add one of the keys 'radial', 'parallel' and 'along'."
            )

    @property
    def _cuts(self) -> list[Any]:
        return [cut for cut in (self.radial, self.parallel, self.along) if cut is not None]

    @property
    def spec(self) -> SectionSpec:
        """Return the request for sections, without the surface."""
        splits = self.split if isinstance(self.split, tuple) else (self.split,)
        (cuts,) = self._cuts
        return SectionSpec(cuts, self.half, self.longest, splits, self.tolerance, self.wavelength)


def read_sections(table: Table, reader: Reader) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
    """Return the section curves that a table requests, with their planes, and messages.

    Raises
    ------
    MissingDependencyError
        trimesh (for meshes) or a CAD kernel (for bodies) is not installed.
    """
    sections: SectionsTable = reader.record(SectionsTable, table)
    with table.naming():
        path = file_in(reader.folder, sections.mesh)
        surface = read_sized_surface(
            reader.read_surface or mesh_surface, path, unit=sections.unit, scale=sections.scale
        )
        return sections.spec.curves(surface)


def compose_section_design(
    name: str, mesh: Mapping[str, Any], sections: SectionSpec, strips: Mapping[str, Any]
) -> str:
    """Return the text of a design file whose strips follow sections of a surface.

    Parameters
    ----------
    name : str
        Name of the model.
    mesh : mapping
        Keys of the surface: `mesh`, which is the file, and optionally `unit` and `scale`.
    sections : SectionSpec
    strips : mapping
        Keys of all strips: sheet, max_width, limits, etc.

    Examples
    --------
    >>> print(compose_section_design("pot", {"mesh": "pot.obj"}, SectionSpec(RadialCuts()), {"sheet": "pom-1"}))
    schema = 1
    name = "pot"
    sheet = "pom-1"
    <BLANKLINE>
    [[strips]]
    label = "S{i}"
    <BLANKLINE>
    [strips.sections]
    mesh = "pot.obj"
    tolerance = 0.3
    radial = { point = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 1.0], zero = [1.0, 0.0, 0.0], count = 8 }
    <BLANKLINE>
    """
    # default values are omitted, except tolerance and planes
    planes = {RadialCuts: "radial", ParallelCuts: "parallel", AlongPath: "along"}[type(sections.cuts)]
    given = {
        "tolerance": sections.tolerance, "wavelength": sections.wavelength or None, "half": sections.half,
        "longest": sections.longest or None, "split": [_table_of(split) for split in sections.splits] or None,
        planes: _table_of(sections.cuts),
    }  # fmt: skip
    keys = {key: value for key, value in given.items() if value is not None}
    rows = [{"label": "S{i}", "sections": {**mesh, **keys}}]
    return toml_text({"schema": 1, "name": name, **strips, "strips": rows})


def _table_of(record: Any) -> dict[str, Any]:
    """Return the table of planes, or of the places where sections are split."""
    values = {key: getattr(record, key) for key in WRITTEN_KEYS[type(record)]}
    # listed planes replace a number of planes
    if values.get("angles", values.get("offsets")) is not None:
        del values["count"]
    return {
        key: _formulae_in_degrees(value) if key in ("angles", "corners") else np.asarray(value).tolist()
        for key, value in values.items()
        if value is not None
    }


WRITTEN_KEYS: dict[type, tuple[str, ...]] = {
    RadialCuts: ("point", "axis", "zero", "count", "angles"),
    ParallelCuts: ("point", "normal", "up", "count", "offsets"),
    AlongPath: ("path", "count", "ends", "up"),
    CornerSplit: ("corners",),
    PointSplit: ("points",),
    PlaneSplit: ("point", "normal"),
}
"""Fields that a design file states of each kind of planes and splits. `angles` and `offsets` replace `count`."""


def _formulae_in_degrees(angles: float | tuple[float, ...]) -> str | list[str]:
    """Return angles in rad as formulae in degrees, so that the file has no rounded multiples of pi."""
    if isinstance(angles, tuple):
        return [str(_formulae_in_degrees(angle)) for angle in angles]
    # remove rounding errors of the conversion
    return f"{float(np.round(np.degrees(angles), 10))!r} * degrees"
