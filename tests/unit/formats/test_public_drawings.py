"""Public drawings: what each gives, curve by curve, is what a person sees in it."""

import warnings
from collections import Counter
from pathlib import Path

import pytest

from elastica_cad import ElasticaError, InputError, check_equilibrium
from elastica_cad.files import read_drawing
from elastica_cad.form_finding import smooth_curve
from elastica_cad.form_finding.fairing_request import SEEN
from elastica_cad.mechanics.theorem1 import require_bendable

pytest.importorskip("cssselect2")
pytest.importorskip("ezdxf")

PUBLIC = Path(__file__).parents[2] / "data" / "public"

GIVES = {
    "ezdxf/AC1003_LINE_Example.dxf": {"corner": 2, "bends": 3},
    "ezdxf/ASCII_R12.dxf": {"corner": 1, "skipped": 1},
    "ezdxf/Leica_Disto_S910.dxf": {"no curve": 1, "skipped": 22},
    "ezdxf/MODEL.dxf": "no curve",
    "ezdxf/R12_with_trash_beyond_EOF.dxf": {"bends": 1},
    "ezdxf/bin_dxf_r12.dxf": {"corner": 1},
    "ezdxf/bin_dxf_r14.dxf": {"corner": 1},
    "ezdxf/bin_dxf_r2000.dxf": "no curve",
    "ezdxf/cc_dxflib.dxf": {"closed": 1},
    "ezdxf/empty_handles.dxf": {"corner": 2},
    "ezdxf/issue1106.dxf": {"bends": 9},
    "ezdxf/layout_missing_block_definition.dxf": "no curve",
    "ezdxf/no_layouts.dxf": {"no curve": 2},
    "ezdxf/r12_blocks_with_no_names.dxf": "no curve",
    "ezdxf/small_r13.dxf": {"bends": 3, "closed": 3, "corner": 1},
    "ezdxf/small_r14.dxf": "no curve",
    "svgpathtools/circle.svg": {"bends": 1},
    "svgpathtools/decorated_ellipse.svg": {"bends": 9},
    "svgpathtools/donate-button.svg": {"refused": 1, "skipped": 2},
    "svgpathtools/ellipse.svg": {"bends": 1},
    "svgpathtools/groups.svg": {"bends": 9, "corner": 1},
    "svgpathtools/negative-scale.svg": {"corner": 1},
    "svgpathtools/output1.svg": {"bends": 3, "faired": 1, "corner": 1},
    "svgpathtools/output2.svg": {"bends": 13, "faired": 1, "corner": 1},
    "svgpathtools/output_intersections.svg": {"bends": 7, "faired": 1, "corner": 1},
    "svgpathtools/path.svg": {"corner": 1},
    "svgpathtools/polygons.svg": {"corner": 2},
    "svgpathtools/polygons_no_points.svg": "no curve",
    "svgpathtools/polyline.svg": {"corner": 2},
    "svgpathtools/rects.svg": {"corner": 2},
    "svgpathtools/test-2.svg": {"corner": 2},
    "svgpathtools/test.svg": {"bends": 3, "faired": 1, "corner": 1},
    "svgpathtools/transforms.svg": {"bends": 9, "corner": 1, "skipped": 3},
    "svgpathtools/vectorframes.svg": {"bends": 4, "corner": 2, "skipped": 2},
}


def verdict(curve):
    try:
        require_bendable(curve)
    except InputError as problem:
        return next((kind for kind in ("closed", "undecided") if kind in str(problem)), "corner")
    return "bends" if check_equilibrium(smooth_curve(curve).curve).realizable else "refused"


def given(path):
    """How many of its curves there are of each kind; or that there is none."""
    try:
        drawing = read_drawing(path)
    except ElasticaError as problem:
        return "no curve" if "has no curve" in str(problem) else str(problem)
    found = Counter()
    for one in drawing:
        kind = "no curve" if one.problem else verdict(one.curve)
        found[kind] += 1
        if kind == "bends":
            smoothing = smooth_curve(one.curve)
            found["healed"] += smoothing.healed > SEEN
            found["faired"] += smoothing.moved > 0
    found["skipped"] = sum(drawing.skipped.values())
    return {kind: count for kind, count in found.items() if count}


@pytest.mark.parametrize("name", GIVES)
def test_public_drawings_give_what_is_drawn_in_them(name):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert given(PUBLIC / name) == GIVES[name]


def test_every_public_drawing_is_requested_about():
    files = [path for path in PUBLIC.rglob("*") if path.suffix in (".svg", ".dxf")]
    assert {f"{path.parent.name}/{path.name}" for path in files} == set(GIVES)
