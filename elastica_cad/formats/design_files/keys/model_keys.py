"""Keys of the tables that tell of a whole model: patterns, joints, what holds strips, sheets, cutting."""

from elastica_cad.formats.design_files.keys.strip_keys import CURVE, MAKING
from elastica_cad.formats.design_files.keys.values import (
    COUNT,
    FLAG,
    NAMES,
    NUMBER,
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
from elastica_cad.formats.drawing_files.dxf_drawing import DXF_VERSIONS
from elastica_cad.mechanics.material.sheet_library import KEYS as SHEET_KEYS

TOP: Keys = {
    "schema": ({"enum": [1]}, "1: which version of these keys the file is written for"),
    "name": (TEXT, "of the model, and of its files"),
    "let": (NAMES, "names for formulae: each may use those before it"),
    "sheets": ({"type": "object", "additionalProperties": table("own sheet")}, "sheets of your own, [sheets.NAME]"),
    "sheets_file": (TEXT, "a file with sheets of your own"),
    **MAKING,
    "strips": (list_of(table("strips")), "one or several strips each"),
    "revolution": (table("revolution"), "a surface about z, tiled by equal strips"),
    "patterns": (
        list_of(either(table("mirror pattern"), table("rotate pattern"), table("repeat pattern"))),
        "copies of all strips, in order",
    ),
    "interlock": (table("interlock"), "slots wherever two strips cross"),
    "base": (one_or_more(table("base")), "a plate with a slot for every tab"),
    "rings": (one_or_more(table("rings")), "a plate for each end"),
    "frame": (one_or_more(table("frame")), "two rails with ribs between"),
    "fixtures": (one_or_more(table("fixtures")), "printed blocks"),
    "stand": (one_or_more(table("stand")), "the simplest of these that holds all tabs"),
    "nest": (table("nest"), "the sheets that parts are laid on"),
    "cut": (table("cut"), "how cutting files are written"),
    "extras": (table("extras"), "what is cut besides"),
}  # fmt: skip

_STRIPS: Keys = {"strips": (one_or_more(TEXT), 'labels of those it holds, "A*" for all that begin so')}
_PLATES: Keys = {
    **_STRIPS,
    "sheet": (TEXT, "of the plates"),
    "thickness": (NUMBER, "of that sheet where it is another, mm"),
    "sheet_size": (vector(2), "of the sheets that plates are cut from, mm"),
    "margin": (NUMBER, "least distance between parts on these sheets, mm"),
}  # fmt: skip
_FIT: Keys = {
    "play": (NUMBER, "room beside a tab on either side, mm"),
    "clearance": (NUMBER, "added to the width of slots, mm"),
    "border": (NUMBER, "least distance of slots from the edge, mm"),
    "gap": (NUMBER, "two plates so far apart hold inclined tabs, mm"),
    "feet": (NUMBER, "small plates of this size glued beside inclined tabs, mm"),
}  # fmt: skip
_ENDS: Keys = {"ends": (choice("start", "end"), "which tabs; all unless told")}
_SHAPE: Keys = {"shape": (choice("hull", "rectangle", "ring"), "the outline"), "name": (TEXT, "of its files")}

_KINDS: dict[str, Fragment] = {
    "number": NUMBER,
    "text": TEXT,
    "range": vector(2),
    "grain": either(NUMBER, TEXT),
}
_OWN_SHEET: Keys = {
    key: (_KINDS[kind], f"{name.replace('_', ' ')} of the sheet") for key, (name, kind) in SHEET_KEYS.items()
}

MODEL_TABLES: dict[str, Keys] = {
    "own sheet": _OWN_SHEET,
    "revolution": {
        "points": (points(2), "[distance from the axis, height] that the meridian goes through, mm"),
        "curve": (CURVE, "in place of points: a profile that the meridian comes near to"),
        "a": (NUMBER, "in place of points: moment at the origin over stiffness and distance"),
        "b": (vector(2), "change of that, 1/mm"),
        "start": (vector(2), "where the meridian begins, mm"),
        "angle": (NUMBER, "of its tangent there, rad"),
        "length": (NUMBER, "mm"),
        "ring": (NUMBER, "it ends at this distance from the axis, mm"),
        "strips": (COUNT, "16 unless told"),
        "sheet": (TEXT, "of the strips"),
        "thickness": (NUMBER, "of that sheet where it is another, mm"),
        "rings": (TEXT, "sheet of the rings at both ends"),
        "gap": (NUMBER, "two rings at either end, so far apart, mm"),
        "ends": MAKING["ends"],
        "shop": MAKING["shop"],
        "ignore_limits": MAKING["ignore_limits"],
    },
    "mirror pattern": {"mirror": (table("mirror"), "a mirror image")},
    "rotate pattern": {"rotate": (table("rotate"), "copies about an axis")},
    "repeat pattern": {"repeat": (table("repeat"), "copies in a row")},
    "mirror": {
        "point": (vector(3), "on the plane, mm"),
        "normal": (vector(3), "across the plane"),
        "keep": (FLAG, "keep the original too; true unless told"),
    },
    "rotate": {
        "count": (COUNT, "how many in all"),
        "axis": (vector(3), "z unless told"),
        "point": (vector(3), "on the axis, mm"),
        "step": (NUMBER, "between two, rad; all around unless told"),
    },
    "repeat": {"count": (COUNT, "how many in all"), "step": (vector(3), "from one to the next, mm")},
    "interlock": {
        "clearance": (NUMBER, "added to the width of slots, mm"),
        "fit": (choice("exact", "paper"), "slots for the exact angle, or as the paper cuts them"),
        "relief": (choice("square", "round"), "inner end of slots"),
        "above": (vector(3), "from where strips are pushed on"),
    },
    "base": {
        **_PLATES,
        "height": (NUMBER, "of its upper face, mm; 0 unless given"),
        **_SHAPE,
        **_ENDS,
        **_FIT,
        "slot_width": (NUMBER, "least width of slots, mm"),
    },
    "rings": {**_PLATES, **_SHAPE, **_ENDS, **_FIT},
    "frame": {
        **_PLATES,
        "ribs": (COUNT, "3 unless told"),
        "depth": (NUMBER, "of the ribs, mm"),
        "tongue": (NUMBER, "length of the tongues, mm"),
        **_FIT,
    },
    "fixtures": {
        **_STRIPS,
        "floor": (NUMBER, "height that the blocks stand on, mm"),
        **_ENDS,
        "clearance": (NUMBER, "added to the pocket, mm"),
        "wall": (NUMBER, "around the pocket, mm"),
        "foot": (NUMBER, "width of the foot, mm"),
        "foot_height": (NUMBER, "mm"),
        "screw": (NUMBER, "diameter of the foot's screw holes, mm"),
    },
    "stand": _PLATES,
    "nest": {
        "sheet_size": (vector(2), "width and height, mm"),
        "margin": (NUMBER, "least distance between parts, mm"),
    },
    "cut": {
        "kerf": (NUMBER, 'mm that the laser takes away, or "sheet" for what the sheet says; 0 unless told'),
        "curves": (choice("spline", "arc", "polyline"), "what curves are written as"),
        "tolerance": (NUMBER, "of arcs and polylines, mm"),
        "version": (choice(*DXF_VERSIONS), "of DXF"),
        "holding": (table("holding"), "bridges that hold parts in the sheet"),
    },
    "holding": {
        "width": (NUMBER, "of a bridge, mm"),
        "spacing": (NUMBER, "largest distance between two, mm"),
        "least": (COUNT, "how many each loop has at least"),
        "inner": (FLAG, "inner cuts too"),
    },
    "extras": {
        "coupon": (FLAG, "a coupon of every sheet"),
        "reference_bar": (NUMBER, "length of a bar to check the machine's scale with, mm"),
    },
}  # fmt: skip
