"""Keys of the tables that tell of strips: the curve, how it is made, what it may change."""

from typing import get_args

from elastica_cad.formats.design_files.keys.values import (
    COUNT,
    FLAG,
    NAMES,
    NUMBER,
    NUMBERS,
    TEXT,
    Fragment,
    Keys,
    choice,
    either,
    list_of,
    one_or_more,
    points,
    table,
    vector,
)
from elastica_cad.mechanics.loads.supports import EndName

CURVE = either(
    TEXT, table("curve file"), table("curve formulae"), table("curve ellipse"), table("curve spline")
)

MAKING: Keys = {
    "sheet": (TEXT, 'name of a sheet, or "my.toml" beside the design'),
    "thickness": (NUMBER, "of the sheet where it is another than its own, mm"),
    "max_width": (NUMBER, "width of the widest place, mm"),
    "min_width": (NUMBER, "width of the narrowest place, mm"),
    "gravity": (
        either(FLAG, vector(3), table("gravity")),
        "true: the strip carries its own weight; or where things fall in space; or a length of its own",
    ),
    "loads": (either(list_of(table("mass")), table("loads")), "masses hung on the strip, or all weight in newtons"),
    "supports": (list_of(choice(*get_args(EndName)), 2), "what holds start and end; clamped unless told"),
    "natural_curvature": (
        either(NUMBER, table("blank"), table("blank drawn")),
        "of the strip before it is bent, 1/mm; or a blank that is bent beforehand",
    ),
    "samples": (COUNT, "nodes of the rod; chosen unless told"),
    "limits": (table("limits"), "the curve may change, as little as these ask for"),
    "keep": (table("keep"), "what a curve that may change keeps"),
    "ends": (either(table("tab"), list_of(table("tab"), 2)), "tabs of both ends, or of start and end"),
    "style": (
        either(table("style plain"), table("style perforated"), table("style laminated")),
        "how stiffness becomes material",
    ),
    "smooth": (NUMBER, "how far the curve may move to become fair, mm; 0: exactly as drawn"),
    "shop": (table("shop"), "what the workshop can make"),
    "joint": (NUMBER, "where a closed strip is joined, mm along its curve; where it is bent least unless given"),
    "compensate": (
        FLAG,
        "true: change the widths so that the strip as made and held takes the curve; false: proportional to its "
        "stiffness; unless given they make up for anticlastic bending, where the sheet's nu is known",
    ),
    "creep": (NUMBER, "creep factor of the sheet in the long run; tells sag and springback"),
    "law": (
        either(table("law thickness"), table("law rod"), table("law tube"), table("law leaves")),
        "what stiffness is made of in place of width",
    ),
    "ignore_limits": (FLAG, "make what the workshop cannot, and say so"),
    "tolerance": (table("tolerance"), "what is assumed to be off in sheet, cut and clamps; what that adds is told"),
}  # fmt: skip
"""Keys that may stand for all strips at the top of the file or for some in [[strips]]."""

STRIP: Keys = {
    **MAKING,
    "label": (TEXT, "engraved, and its name in messages; {i} is the number"),
    "count": (COUNT, "so many strips, i = 1, 2, ..."),
    "let": (NAMES, "names for formulae of this strip"),
    "curve": (CURVE, "a file, formulae, an ellipse or a spline"),
    "sections": (table("sections"), "in place of the curve: a strip for every section of a surface"),
    "origin": (vector(3), "where the drawing's origin lies in space, mm"),
    "x_axis": (vector(3), "where the drawing's x axis points"),
    "y_axis": (vector(3), "where the drawing's y axis points; up unless told"),
    "slots": (list_of(table("slot")), "slots from the edge"),
}  # fmt: skip

_RESHAPE: Keys = {"reshape": (table("reshape"), "pull the curve by four handles")}

_CUTS_UP = (vector(3), "y axis of the sections; z unless told")

STRIP_TABLES: dict[str, Keys] = {
    "gravity": {
        "length": (NUMBER, "elasto-gravity length, mm"),
        "direction": (vector(2), "in which things fall in the curve's plane"),
    },
    "blank": {
        "stations": (NUMBERS, "from 0 to the length of the strip, mm; one twice is a step"),
        "curvatures": (NUMBERS, "at each of them, 1/mm, positive to the left; straight between"),
    },
    "blank drawn": {"curve": (CURVE, "in which it lies before it is bent")},
    "mass": {"at": (NUMBER, "place along the strip, mm"), "mass": (NUMBER, "g")},
    "loads": {
        "alpha": (NUMBER, "weight per length, N/mm"),
        "beta": (NUMBER, "weight per length that goes with the stiffness K, N/mm"),
        "own": (FLAG, "the strip's own weight besides"),
        "masses": (list_of(table("mass")), "masses hung on it"),
    },
    "limits": {
        "ratio": (NUMBER, "largest stiffness over least"),
        "margin": (NUMBER, "least stability: 0 is where it would snap away, 5 stands safely"),
        "curvature": (NUMBER, "largest, 1/mm"),
        "strain": (either(FLAG, NUMBER), "true: what the sheet bears; or a number"),
        "length": (vector(2), "least and largest, mm"),
        "width": (vector(2), "least and largest, mm"),
        "keep_out": (list_of(either(table("half plane"), table("box"))), "where the strip may not go"),
        "stiffness_bounds": (table("stiffness bounds"), "of stiffness over the least, along the strip"),
    },
    "half plane": {
        "point": (vector(2), "on the wall, mm"),
        "normal": (vector(2), "points to where the strip may be"),
    },
    "box": {
        "lower": (vector(2), "corner of least x and y, mm"),
        "upper": (vector(2), "corner of largest x and y, mm"),
    },
    "stiffness bounds": {
        "lower": (either(NUMBER, NUMBERS), "one, or values at equal distances"),
        "upper": (either(NUMBER, NUMBERS), "one, or values at equal distances"),
    },
    "keep": {
        "ends": (either(FLAG, list_of(FLAG, 2)), "where the ends are; true unless told"),
        "tangents": (either(FLAG, list_of(FLAG, 2)), "where the ends point"),
        "length": (FLAG, "the length"),
        "symmetry": (choice("mirror", "turn"), "mirror image or half turn"),
        "points": (list_of(NUMBER), "places along the drawn curve that stay on the strip, mm"),
        "line": (either(FLAG, points(2, 2)), "true: inflections stay on their line; or on the line of two points"),
    },
    "tab": {
        "length": (NUMBER, "mm; 0 for none, 10 unless told"),
        "width": (NUMBER, "mm; the strip's own unless told"),
        "corner_radius": (NUMBER, "of the outer corners, mm"),
        "chamfer": (NUMBER, "of the outer corners, mm"),
        "taper": (NUMBER, "how much it narrows on either side, mm"),
        "holes": (list_of(table("hole")), "round holes"),
        "t_slot": (table("t-slot"), "slot for a screw with its nut"),
    },
    "hole": {
        "at": (NUMBER, "from where the tab begins, mm"),
        "diameter": (NUMBER, "mm"),
        "across": (NUMBER, "off the centre line, mm"),
    },
    "t-slot": {
        "depth": (NUMBER, "from the outer edge inward, mm"),
        "screw": (NUMBER, "width of the slot, mm"),
        "nut": (vector(2), "pocket across and along the screw, mm"),
        "wall": (NUMBER, "between outer edge and nut, mm"),
    },
    "style plain": {"kind": (choice("plain"), "width follows stiffness")},
    "style perforated": {
        "kind": (choice("perforated"), "holes take away what is too stiff"),
        "width": (NUMBER, "of the outline, mm"),
        "columns": (COUNT, "diamonds across"),
        "rows": (COUNT, "diamonds along"),
        "hole_ratio": (NUMBER, "largest share of the width that holes take"),
        "least_ligament": (NUMBER, "between holes, mm"),
        "least_hole": (NUMBER, "widest place of a hole at least, mm"),
        "corner_radius": (NUMBER, "of the holes, mm"),
        "sides": (choice("spline", "arc"), "what the sides of holes are made of"),
    },
    "style laminated": {
        "kind": (choice("laminated"), "a second layer is glued on"),
        "width": (NUMBER, "of the base, mm"),
        "backing": (TEXT, "sheet that is glued on"),
        "least_backing": (NUMBER, "narrowest that can be cut and glued, mm"),
        "dots": (NUMBER, "diameter of alignment holes, mm; 0 for none"),
    },
    "shop": {
        "least_width": (NUMBER, "of a strip, a tab or a tongue, mm"),
        "least_ligament": (NUMBER, "between the holes of a perforated strip, mm"),
        "least_bridge": (NUMBER, "between the cuts of a plate, mm"),
        "stock": (vector(2), "sides of the largest sheet, mm"),
        "lap": (NUMBER, "length of the plates that join pieces of a strip longer than the stock, mm"),
    },
    "tolerance": {
        "thickness_wave": (NUMBER, "amplitude of a wave of thickness along the strip, as a share of it; 0.01"),
        "grain": (NUMBER, "by how much the grain wanders to either side, rad; 2 * degrees"),
        "clamps": (NUMBER, "by how much each clamp is turned, rad; 0.5 * degrees"),
        "kerf": (NUMBER, "width that is lost beyond the kerf that was corrected for, mm; 0.05"),
    },
    "law thickness": {
        "kind": (choice("thickness"), "a batten of one width, planed thinner"),
        "limits": (vector(2), "least and largest thickness, mm"),
        "width": (NUMBER, "of the batten, mm"),
    },
    "law rod": {
        "kind": (choice("rod"), "a round rod, turned thinner"),
        "limits": (vector(2), "least and largest diameter, mm"),
    },
    "law tube": {
        "kind": (choice("tube"), "a tube, turned thinner"),
        "limits": (vector(2), "least and largest diameter, mm"),
        "bore": (NUMBER, "inner over outer diameter"),
    },
    "law leaves": {
        "kind": (choice("leaves"), "glued leaves of the sheet, some end before others; needs limits or keep"),
        "leaves": (COUNT, "at most"),
        "fewest": (COUNT, "that go all the way; 1 unless given"),
        "width": (NUMBER, "of the leaves, mm"),
    },
    "curve file": {
        "file": (TEXT, "beside the design: DXF, SVG, CSV, JSON, STEP"),
        "number": (COUNT, "which curve of the file"),
        "id": (TEXT, "which curve, by its name in the file"),
        "layer": (TEXT, "which curve, by its layer"),
        "unit": (TEXT, "of the file, where it does not say"),
        **_RESHAPE,
    },
    "curve formulae": {
        "x": (NUMBER, "formula in t, mm"),
        "y": (NUMBER, "formula in t, mm"),
        "t": (vector(2), "range of t"),
        "breaks": (list_of(vector(2)), "[t, continuity] where the formula has a joint"),
        **_RESHAPE,
    },
    "curve ellipse": {"ellipse": (table("ellipse"), "an exact arc of an ellipse"), **_RESHAPE},
    "curve spline": {
        "spline": (points(2), "control points, mm"),
        "degree": (COUNT, "4 unless told"),
        **_RESHAPE,
    },
    "ellipse": {
        "center": (vector(2), "mm"),
        "semi_axes": (vector(2), "mm"),
        "rotation": (NUMBER, "of the first axis, rad"),
        "start": (NUMBER, "parameter where it begins, rad"),
        "end": (NUMBER, "parameter where it ends, rad"),
        "above": (NUMBER, "in place of start and end: what lies above this height, mm"),
    },
    "reshape": {
        **{name: (vector(2), "where this corner of the curve's box goes, mm")
           for name in ("bottom_left", "bottom_right", "top_right", "top_left")},
        "handles": (points(2, 4), "in place of corners: four points, mm"),
        "to": (points(2, 4), "where the handles go, mm"),
    },
    "slot": {
        "at": (NUMBER, "place along the strip, mm"),
        "width": (NUMBER, "mm"),
        "depth": (NUMBER, "from the edge, mm; to the centre line unless told"),
        "side": (choice("upper", "lower"), "where it opens"),
        "lean": (NUMBER, "to the ruling, rad"),
        "relief": (choice("square", "round"), "its inner end"),
        "mate": (TEXT, "what goes in; written beside it"),
    },
    "sections": {
        "mesh": (TEXT, "OBJ, STL, PLY or STEP beside the design"),
        "unit": (TEXT, "of the mesh"),
        "scale": (NUMBER, "factor on the mesh"),
        "half": (FLAG, "only what lies at x >= 0 of each plane"),
        "longest": (FLAG, "only the longest line of each section"),
        "split": (
            one_or_more(either(table("split plane"), table("split points"), table("split corners"))),
            "where lines are divided",
        ),
        "tolerance": (NUMBER, "largest distance from the section, mm"),
        "wavelength": (NUMBER, "shorter waves are smoothed away, mm"),
        "radial": (table("radial"), "half planes about an axis"),
        "parallel": (table("parallel"), "parallel planes"),
        "along": (table("along"), "planes across a path"),
    },
    "split plane": {"point": (vector(3), "of the plane, mm"), "normal": (vector(3), "of the plane")},
    "split points": {"points": (points(3), "at the places nearest to these, mm")},
    "split corners": {"corners": (NUMBER, "where the line turns by more than this, rad")},
    "radial": {
        "point": (vector(3), "on the axis, mm"),
        "axis": (vector(3), "its direction; z unless told"),
        "zero": (vector(3), "where angles begin; x unless told"),
        "count": (COUNT, "so many all around"),
        "angles": (NUMBERS, "in place of count, rad"),
    },
    "parallel": {
        "point": (vector(3), "from which offsets are measured, mm"),
        "normal": (vector(3), "across the planes"),
        "offsets": (NUMBERS, "from the point, mm"),
        "count": (COUNT, "in place of offsets: so many equal slices"),
        "up": _CUTS_UP,
    },
    "along": {
        "path": (points(3), "mm"),
        "count": (COUNT, "so many planes"),
        "ends": (FLAG, "the first and the last at the path's ends"),
        "up": _CUTS_UP,
    },
}  # fmt: skip


def fragment_of(keys: Keys) -> Fragment:
    """The table as JSON schema: these keys and no others."""
    return {
        "type": "object",
        "additionalProperties": False,
        "properties": {
            key: {"description": text, **({"allOf": [value]} if "$ref" in value else value)}
            for key, (value, text) in keys.items()
        },
    }
