"""What a design file says about sections of a surface: which file, which planes cut it, how it is divided."""

from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

from elastica_cad._values import require_positive
from elastica_cad.declared import Asked
from elastica_cad.errors import InputError
from elastica_cad.formats.design_files.records import Reader
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.formats.surface_files.mesh_files import SurfaceReader, mesh_surface, read_sized_surface
from elastica_cad.forming.plane_sections.section_curves import SectionCurve
from elastica_cad.forming.plane_sections.section_spec import (
    AlongPath,
    CornerSplit,
    ParallelCuts,
    PlaneSplit,
    PointSplit,
    RadialCuts,
    SectionSpec,
)

Split: TypeAlias = PlaneSplit | PointSplit | CornerSplit


@dataclass(frozen=True)
class SectionsTable:
    """The table `sections`: a surface, and how planes cut it into curves."""

    mesh: Annotated[str, Asked("Surface beside the design: OBJ, STL, PLY or STEP.")]
    radial: Annotated[RadialCuts | None, Asked("Half planes about an axis.")] = None
    parallel: Annotated[ParallelCuts | None, Asked("Parallel planes.")] = None
    along: Annotated[AlongPath | None, Asked("Planes across a path.")] = None
    unit: Annotated[str | None, Asked("Unit of the mesh.")] = None
    scale: Annotated[float | None, Asked("Factor on the mesh.", least=0)] = None
    half: Annotated[bool | None, Asked("Only what lies at x >= 0 of each plane.")] = None
    longest: Annotated[bool, Asked("Only the longest line of each section.")] = False
    split: Annotated[Split | tuple[Split, ...], Asked("Where lines are divided.")] = ()
    tolerance: Annotated[float, Asked("Largest distance from the section.", "mm", least=0)] = 0.3
    wavelength: Annotated[float, Asked("Shorter waves are smoothed away.", "mm", least=0)] = 0.0

    def __post_init__(self) -> None:
        if self.scale is not None:
            require_positive(self.scale, "scale", "times")
        if len(self._cuts) != 1:
            raise InputError(
                "sections must hold one of radial, parallel, along: the planes that cut the mesh"
            )

    @property
    def _cuts(self) -> list[Any]:
        return [one for one in (self.radial, self.parallel, self.along) if one is not None]

    @property
    def spec(self) -> SectionSpec:
        """Return the request for sections, without the surface."""
        splits = self.split if isinstance(self.split, tuple) else (self.split,)
        (cuts,) = self._cuts
        return SectionSpec(cuts, self.half, self.longest, splits, self.tolerance, self.wavelength)


IN_PLACE = {"radial": "angles", "parallel": "offsets"}
"""Keys that say where planes lie, in place of their count."""


def read_sections(
    table: Table, reader: Reader, read_surface: SurfaceReader | None
) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
    """Return the curves of the sections that a table requests, each with its plane, and sentences worth knowing.

    Raises
    ------
    InputError
        A missing surface, planes that make no sense, or no section that a strip could follow.
    MissingDependencyError
        trimesh is not installed, or for CAD bodies no kernel.
    """
    for name, key in IN_PLACE.items():
        cuts = table.table(name)
        if cuts.has("count") and cuts.has(key):
            raise InputError(
                "{place} means nothing beside {key}: leave one of them out",
                place=cuts.place("count"),
                key=key,
            )
    asked: SectionsTable = reader.record(SectionsTable, table)
    path = reader.folder / asked.mesh
    if not path.is_file():
        raise InputError(
            "{place}: there is no file {path}; names are relative to the design file",
            place=table.where,
            path=path,
        )
    with table.naming():
        surface = read_sized_surface(read_surface or mesh_surface, path, unit=asked.unit, scale=asked.scale)
        return asked.spec.curves(surface)
