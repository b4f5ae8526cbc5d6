"""A design file for strips along sections, written down so that it can be changed and made again."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.formats.design_files.toml_text import toml_text
from elastica_cad.forming.plane_sections.section_spec import (
    AlongPath,
    CornerSplit,
    ParallelCuts,
    PlaneSplit,
    PointSplit,
    RadialCuts,
    SectionSpec,
    Split,
)

ANGLE_DIGITS = 10
"""Decimals of degrees: what was typed comes back, without the rounding of pi."""


def compose_section_design(
    name: str, mesh: Mapping[str, Any], sections: SectionSpec, strips: Mapping[str, Any]
) -> str:
    """Return the text of a design file whose strips follow sections of a surface.

    Parameters
    ----------
    name : str
        Of the model.
    mesh : mapping
        The file as `mesh`, with its unit and scale where they were told.
    sections : SectionSpec
    strips : mapping
        Keys for all strips: sheet, max_width, limits and so on.

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
    head = {"schema": 1, "name": name, **strips}
    sections_of = {**mesh, **_section_keys(sections)}
    return toml_text({**head, "strips": [{"label": "S{i}", "sections": sections_of}]})


def _section_keys(spec: SectionSpec) -> dict[str, Any]:
    """The keys of the table `sections`; what is usual is left out, but for the tolerance and the planes."""
    keys: dict[str, Any] = {"tolerance": spec.tolerance}
    keys |= {"wavelength": spec.wavelength} if spec.wavelength else {}
    keys |= {} if spec.half is None else {"half": spec.half}
    keys |= {"longest": True} if spec.longest else {}
    keys |= {"split": [_split_keys(split) for split in spec.splits]} if spec.splits else {}
    match spec.cuts:
        case RadialCuts() as cuts:
            where: dict[str, Any] = {"point": cuts.point, "axis": cuts.axis, "zero": cuts.zero}
            turned = None if cuts.angles is None else [_degrees(angle) for angle in cuts.angles]
            planes: dict[str, Any] = {"count": cuts.count} if turned is None else {"angles": turned}
            return keys | {"radial": where | planes}
        case ParallelCuts() as cuts:
            where = {"point": cuts.point, "normal": cuts.normal, "up": cuts.up}
            planes = {"count": cuts.count} if cuts.offsets is None else {"offsets": list(cuts.offsets)}
            return keys | {"parallel": where | planes}
        case AlongPath() as cuts:
            path = np.asarray(cuts.path).tolist()
            return keys | {"along": {"path": path, "count": cuts.count, "ends": cuts.ends, "up": cuts.up}}
    raise InputError("{cuts!r} is no family of planes that a design file knows", cuts=spec.cuts)


def _split_keys(split: Split) -> dict[str, Any]:
    match split:
        case CornerSplit():
            return {"corners": _degrees(split.corners)}
        case PointSplit():
            return {"points": np.asarray(split.points).tolist()}
        case PlaneSplit():
            return {"point": split.point, "normal": split.normal}
    raise InputError("{split!r} is no split that a design file knows", split=split)


def _degrees(angle: float) -> str:
    """An angle, rad, as people write it."""
    return f"{float(np.round(np.degrees(angle), ANGLE_DIGITS))!r} * degrees"
