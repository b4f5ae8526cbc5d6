"""JSON record in the report of a finished strip, from which the strip can be made again."""

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass, replace
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np

from elastica_cad.design.records import BY_KIND
from elastica_cad.design.tables import with_present_keys
from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.cross_sections import LaidLeaves, LeavesLaw, RoundLaw, ThicknessLaw
from elastica_cad.mechanics.discrete_rod import Compression
from elastica_cad.mechanics.elements import ElementForce, Mount, PointForce
from elastica_cad.mechanics.loads import Weight, nodal_curvature
from elastica_cad.mechanics.optimal_balance import carried_weight, refuse_below_limits
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sections import PlainSection
from elastica_cad.mechanics.sheets import NominalRatio
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import Loads, StripSpec
from elastica_cad.strip.styles import Plain

SOLVED = ("curve", "frame", "limits", "keep", "smooth", "straight_ends", "seam_position", "ignore_limits")
"""Fields of `StripSpec` without effect on a finished strip."""


def _records_in(kind: Any, found: dict[str, Any]) -> dict[str, Any]:
    """Add the record classes in values of the type `kind` to `found`, by name."""
    # a family such as Style or Section is read as one of its kinds, made by classes or functions
    makers = [maker for family, kinds in BY_KIND.items() if family is kind for maker in kinds.values()]
    made = [get_type_hints(maker).get("return", maker) for maker in makers]
    for inner in (*get_args(kind), *made):
        _records_in(inner, found)
    if isinstance(kind, type) and is_dataclass(kind) and kind not in found.values():
        found[kind.__name__] = kind
        for name, inner in get_type_hints(kind).items():
            if kind is not StripSpec or name not in SOLVED:
                _records_in(inner, found)
    return found


NODAL: dict[str, Any] = {"Rod": Rod, "ElementForce": ElementForce, "Compression": Compression}
"""Records of a bent strip whose lists of numbers are arrays."""

RECORDS = _records_in(StripSpec | LaidLeaves, {
    "WidthLaw": PlainSection, "PlaneCurve": PlaneCurve, "Strip": Strip, "Mount": Mount, **NODAL,
})  # fmt: skip
"""Record classes in a request, by their names in a report. A name does not change with its class."""

STIFFNESS_TOLERANCE = 1e-6


@dataclass(frozen=True, eq=False)
class FinishedStrip:
    """A finished strip: its stiffness, and a request whose curve is the rest shape of the strip.

    Attributes
    ----------
    spec : StripSpec
    stiffness : Profile
        Stiffness along the strip, divided by the least stiffness.
    bending_stiffness : float
        Least bending stiffness, N mm2.
    designed : StripSpec, optional
        Original request of the report, if `spec` was changed.
    """

    spec: StripSpec
    stiffness: Profile
    bending_stiffness: float
    designed: StripSpec | None = None

    @classmethod
    def read(cls, record: Any, curve: PlaneCurve) -> "FinishedStrip":
        """Read the record of `request_record` in a report whose rest shape is `curve`."""
        with _as_input_error("request"):
            values = _decoded(with_present_keys(dict(record)))
            stiffness, scale = values.pop("stiffness"), values.pop("bending_stiffness")
            spec = StripSpec(curve, smooth=0.0, straight_ends=False, ignore_limits=True, **values)
            return cls(spec, stiffness, scale)

    def changed(self, **fields: Any) -> "FinishedStrip":
        """Return the strip with other values of some fields of its request, and with the same stiffness.

        A new width replaces both widths. A new section replaces widths, style, slots and the shapes of tabs. New
        widths or a new style replace a section. If the gravity is removed, the loads are removed too.
        """
        sheet, section = fields.get("sheet"), self.spec.section
        sized = {"max_width", "min_width", "style"} & set(fields)
        if "section" in fields:
            ends = tuple(tab.plain for tab in self.spec.ends)
            fields = {"style": Plain(), "slots": (), "ends": ends, **fields}
        elif sized and section is not None:
            fields = {"section": None, **fields}
        elif sheet is not None and section is not None:
            fields = {"section": replace(section, sheet=sheet), **fields}  # type: ignore[type-var]
        if "section" in fields or sized - {"style"}:
            fields = {"max_width": None, "min_width": None, **fields}
        if not fields.get("gravity", True):
            fields = {"loads": (), **fields}
        return replace(self, spec=self.spec.changed(**fields), designed=self.designed or self.spec)

    def make(self) -> Strip:
        """Make the strip again, with the stiffness in the report."""
        spec, designed = self.spec, self.designed or self.spec
        rod_spec = spec.rod_spec
        # the stiffness of plies is piecewise constant, unlike the stiffness of other rods
        laid = isinstance(rod_spec.section, LaidLeaves)
        # the rod is solved for the changed request only if its section matters: weight and size depend on the
        # section, or on the layers of a laminate with weight
        solved = spec if spec.section is not None or rod_spec.layers is not None else designed
        section = None if laid else solved.rod_spec.section
        if isinstance(section, ThicknessLaw | RoundLaw):
            # the rest shape of an even rod needs an almost even rod, which may be thinner than the limit
            section = replace(section, least=0.5 * section.least)
        rod = solve_rod(replace(solved.rod_spec, section=section))
        assert isinstance(rod, Rod)  # the request has no limits, so the result is not a NearestRod
        # `scale` is the least bending stiffness, N mm2, and `most` the largest stiffness divided by it
        scale, most = self.bending_stiffness, rod.profile.extremes[1]
        if not np.allclose(rod.stiffness, self.stiffness(rod.s), rtol=STIFFNESS_TOLERANCE):
            rod = rod.with_stiffness(self.stiffness)
        if spec is not designed and solved is spec:
            # the largest section of the finished strip is as large as that of the rod
            scale = (rod.bending_stiffness or scale) * most / rod.profile.extremes[1]
            if spec.section is not None and not laid:
                refuse_below_limits(spec.section, scale * rod.stiffness, rod.s)
        elif spec is not designed:
            # the changed strip has the same relative stiffness, so only the scale changes
            # widths that replace a section give the scale; other changes multiply the scale in the report
            size = _unloaded_stiffness(spec, rod)
            scale = (
                size if designed.section is not None else scale * size / _unloaded_stiffness(designed, rod)
            )
            weight = rod_spec.weight
            if weight is not None and rod_spec.gravity is not None:
                weight = carried_weight(weight, rod_spec.gravity, scale)
            rod = replace(
                rod, gravity=rod_spec.gravity, weight=weight, section=rod_spec.section,
                natural_curvature=nodal_curvature(rod_spec.natural_curvature, rod.s),
            )  # fmt: skip
        if rod.bending_stiffness is not None or rod.weight is not None or laid:
            rod = replace(rod, section=rod_spec.section, bending_stiffness=scale)
            # a plain strip also gets its largest width from the stiffness
            if isinstance(spec.style, Plain) and spec.section is None:
                widest = scale * rod.profile.extremes[1] / PlainSection(spec.material).rigidity
                spec = spec.changed(max_width=(1 + STIFFNESS_TOLERANCE) * widest, min_width=None)
        return spec.make(rod)


def _unloaded_stiffness(spec: StripSpec, rod: Rod) -> float:
    # least bending stiffness, N mm2, of the strip that `spec` requests for the stiffness of the rod, without loads
    unloaded = replace(rod, gravity=None, weight=None, section=None, bending_stiffness=None)
    return spec.changed(gravity=False, loads=(), compensate=False).make(unloaded).bending_stiffness


def read_request(path: Path, key: str = "request") -> Any:
    """Return the record `request`, or another record, of the report in a file, or None if there is none."""
    if path.suffix.lower() != ".json":
        return None
    try:
        data = json.loads(path.read_bytes())
    # the reader of curves reports the error later
    except (OSError, ValueError, RecursionError):
        return None
    return data.get(key) if isinstance(data, dict) else None


def strip_record(strip: Strip) -> dict[str, Any]:
    """Return all that determines how a strip bends as plain data for JSON, for `read_bent`."""
    names = ("sheet", "max_width", "min_width", "style", "ends", "slots", "correction")
    return {name: _as_json(getattr(strip, name)) for name in names} | {
        "record": "Strip", "rod": rod_record(strip.rod),
    }  # fmt: skip


def rod_record(rod: Rod) -> Any:
    """Return a rod as plain data for JSON, without its law, which follows from its strip."""
    shape = None if rod.shape is None else replace(rod.shape, provenance=None)
    return _as_json(replace(rod, law=None, check=None, warnings=(), shape=shape))


def read_bent(record: Any) -> tuple[Strip | None, Rod]:
    """Read the strip, or None, and the rod from the records of `strip_record` and `rod_record`.

    The strip has the shape of the rod, and can be bent further.
    """
    with _as_input_error("bent"):
        strip, rod = _decoded(record["strip"]), _decoded(record["rod"])
        if strip is None:
            return None, rod
        # `rod_record` has no law; the law follows from the designed strip, because curling changes the stiffness
        # relative to the designed shape
        bent = strip.bent_as(replace(rod, law=strip.rod_to_bend.following().law))
        return bent, bent.rod


@contextmanager
def _as_input_error(name: str) -> Iterator[None]:
    try:
        yield
    except (ElasticaError, AttributeError, KeyError, TypeError, ValueError) as problem:
        raise InputError(
            "The record `{name}` of the report cannot be read ({problem}). Make the report again.",
            name=name,
            problem=str(problem),
        ) from problem


def request_record(spec: StripSpec, strip: Strip) -> dict[str, Any]:
    """Return the request for a finished strip as plain data for JSON. The curve is its rest shape."""
    plane = spec.in_plane
    values = {field.name: getattr(plane, field.name) for field in fields(plane) if field.name not in SOLVED}
    rod = strip.rod
    values |= {
        "sheet": spec.material, "ends": spec.tabs, "samples": rod.s.size,
        "between": tuple(action.on_curve for action in rod.between),
        "loads": _placed_loads(spec, rod),
        "section": rod.section if isinstance(spec.section, LeavesLaw) else spec.section,
        "stiffness": rod.profile, "bending_stiffness": strip.bending_stiffness,
    }  # fmt: skip
    return {name: _as_json(value) for name, value in values.items()}


def _placed_loads(spec: StripSpec, rod: Rod) -> Loads:
    """Return the loads in the plane of the curve. Positions of point forces are arc lengths of the rest shape."""
    loads, forces = spec.in_plane.loads, iter(rod.point_forces)
    if isinstance(loads, Weight):
        return loads
    return tuple(next(forces).on_curve if isinstance(load, PointForce) else load for load in loads)


def _as_json(value: Any) -> Any:
    """Return a value as JSON.

    Records get the key `record` with their type, and infinite numbers are texts.
    """
    if is_dataclass(value):
        kind = next(name for name, record in RECORDS.items() if type(value) is record)
        return {"record": kind} | {
            field.name: _as_json(getattr(value, field.name)) for field in fields(value) if field.init
        }
    if isinstance(value, NominalRatio):
        return {"record": NominalRatio.__name__, "value": float(value)}
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [_as_json(item) for item in value]
    if isinstance(value, float) and not np.isfinite(value):
        return str(value)
    return value


def _decoded(value: Any) -> Any:
    """Return the value that `_as_json` converted."""
    if isinstance(value, Mapping):
        values = {key: _decoded(item) for key, item in value.items() if key != "record"}
        if value.get("record") == NominalRatio.__name__:
            return NominalRatio(values["value"])
        if value.get("record") in NODAL:
            values = {
                key: np.array(item)
                # numbers or points; an empty tuple stays a tuple
                if isinstance(item, tuple) and isinstance((*item, None)[0], float | tuple)
                else item
                for key, item in values.items()
            }
        return RECORDS[value["record"]](**values) if "record" in value else values
    if isinstance(value, list):
        return tuple(map(_decoded, value))
    return float(value) if value in ("inf", "-inf") else value
