"""Texts where numbers belong, one number where records do: records say so when they are made, not numpy later."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    Drawing,
    End,
    FabricationLimits,
    Frame,
    Gravity,
    Hole,
    InputError,
    Keep,
    Laminated,
    Limits,
    Model,
    Path,
    Perforated,
    Placed,
    PlaneCurve,
    PointMass,
    Rod,
    Sheet,
    Slot,
    Strip,
    StripSpec,
    Tab,
    Weight,
    bend,
    bow,
    meridian,
    nearest_rods,
    read_curves,
    save_model,
    split,
    touching_widths,
    write_curves,
)
from elastica_cad.formats import write_drawing
from elastica_cad.geometry import Arc
from elastica_cad.mechanics import PolynomialLaw, RoundLaw, TabulatedLaw, anticlastic_factor
from elastica_cad.model import EndFixture, interlock, nest_pieces
from elastica_cad.strip import HoldingTabs, Piece, Text, TSlot, compensate_kerf
from elastica_cad.strip.pieces import strip_pieces

pytestmark = pytest.mark.core

SHEET = Sheet.named("birch-plywood-0.8")
ROD = Rod.straight(100.0, samples=21)
POINTS = [(0, 0), (20, 30), (50, 40), (80, 30), (100, 0)]
STRIP = Strip(ROD, SHEET, max_width=20)
PIECES = strip_pieces(Model([Placed(STRIP)]).parts)

SLIPS = {
    "tab length is '10'": lambda: Tab("10"),
    "tab length is 1e-09: use 0 for no tab, or 0.001 mm or more": lambda: Tab(1e-9),
    "tab width is '10'": lambda: Tab(10, width="10"),
    "tab chamfer is": lambda: Tab(10, chamfer=(1, 2)),
    "holes contain 3. Pass only Hole records": lambda: Tab(10, holes=3),
    "holes contain 'x'": lambda: Tab(10, holes="x"),
    "hole diameter is '3.2'": lambda: Hole(5, "3.2"),
    "t_slot is 12: give a TSlot": lambda: Tab(20, t_slot=12),
    "T-slot depth is '12'": lambda: TSlot("12"),
    "slot width is '3'": lambda: Slot(30, "3"),
    "slot depth is": lambda: Slot(30, 3, (1, 2)),
    "columns is '2'": lambda: Perforated(width=30, columns="2"),
    "rows is inf": lambda: Perforated(width=30, rows=np.inf),
    "hole_ratio is '0.8'": lambda: Perforated(width=30, hole_ratio="0.8"),
    "least_hole is '1'": lambda: Perforated(width=30, least_hole="1"),
    "least_backing is '1'": lambda: Laminated(20, SHEET, least_backing="1"),
    "dots is '1'": lambda: Laminated(20, SHEET, dots="1"),
    "least_width is '2'": lambda: FabricationLimits(least_width="2"),
    "stock is 300: give 2 numbers above 0, in mm": lambda: FabricationLimits(stock=300),
    r"stock is \('a', 3\)": lambda: FabricationLimits(stock=("a", 3)),
    "a point mass is '5'": lambda: PointMass(50, "5"),
    "weight alpha is '1'": lambda: Weight("1"),
    "gravity length is '96'": lambda: Gravity("96"),
    "direction of gravity is 'down'": lambda: Gravity(96, "down"),
    "max_width is '20': give a number above 0": lambda: Strip(ROD, SHEET, max_width="20"),
    "`ends` has 0 tabs: give two": lambda: Strip(ROD, SHEET, max_width=20, ends=()),
    "`ends` has 1 tab: give two": lambda: Strip(ROD, SHEET, max_width=20, ends=(Tab(5),)),
    "ends contain 5. Pass only Tab records": lambda: Strip(ROD, SHEET, max_width=20, ends=(5, 5)),
    "slots contain 3. Pass only Slot records": lambda: Strip(ROD, SHEET, max_width=20, slots=[3]),
    "the rod is a str. Pass a Rod": lambda: Strip("rod", SHEET, max_width=20),
    "style is 'plain': give": lambda: Strip(ROD, SHEET, max_width=20, style="plain"),
    "the label is 3: give text": lambda: Strip(ROD, SHEET, max_width=20, label=3),
    "wall is '4'": lambda: EndFixture.of(STRIP, "end", wall="4"),
    "clearance is": lambda: EndFixture.of(STRIP, "end", clearance=(1, 2)),
    r"placed contain 3. Pass only Placed records, of a strip ec.Placed\(strip\), of a body in CAD": lambda: (
        Model(3)
    ),
    "placed contain <Strip": lambda: Model([STRIP]),
    "clearance is '0.1': give a number from 0, in mm": lambda: interlock([Placed(STRIP)], clearance="0.1"),
    "`keep.ends` is 3": lambda: Keep(ends=3),
    "frame origin is 'x': give three finite numbers": lambda: Frame("x"),
    "angles are \\[1, 'a'\\]: give two numbers in rad": lambda: bend(ROD, end=(90, 0), angles=[1, "a"]),
    "moment is 'x': give one number or two": lambda: bend(ROD, moment="x"),
    "`guess` has the shape": lambda: bend(ROD, end=(90, 0), guess="x"),
    "The place of a point mass is nan": lambda: PointMass(float("nan"), 5),
    "The place of a point mass is '50'": lambda: PointMass("50", 5),
    "x of an End is '20': give True": lambda: End("20"),
    "angle of an End is None": lambda: End(angle=None),
    "width of the outline is None": lambda: Strip(ROD, SHEET, style=Perforated(None)),
    "width of the outline is '20'": lambda: Strip(ROD, SHEET, style=Perforated("20")),
    "placed contain array": lambda: Model(np.array(3.0)),
    "the tolerance of a fit is '0.1': give a number above 0": lambda: PlaneCurve.fit(POINTS, tolerance="0.1"),
    "the tolerance of a fit is None": lambda: PlaneCurve.fit(POINTS, tolerance=None),
    "the kerf is '0.15'": lambda: compensate_kerf(STRIP.drawing(), "0.15"),
    "the kerf is None": lambda: compensate_kerf(STRIP.drawing(), None),
    "the name of a sheet is a list": lambda: Sheet.named(["mdf-3"]),
    "the kerf is 'a': give a finite number, in mm": lambda: nest_pieces(PIECES, kerf="a"),
    "margin is '2': give a number from 0.01, in mm": lambda: nest_pieces(PIECES, margin="2"),
    "sheet_size is '600x400': give 2 numbers above 0, in mm": lambda: nest_pieces(
        PIECES, sheet_size="600x400"
    ),
    "sheet_size is 600": lambda: nest_pieces(PIECES, sheet_size=600),
    "nearest_rods was called with a str: give a list of curves": lambda: nearest_rods("arch.dxf", Limits()),
    "strips are 3: give a list of Placed": lambda: touching_widths(3),
    "strips are 'ab'": lambda: touching_widths("ab"),
    "3 is not the name of a file or folder": lambda: write_drawing(STRIP.drawing(), 3),
    "None is not the name of a file": lambda: write_curves([ROD.curve], None),
    r"\[1, 2\] is not the name of a file": lambda: read_curves([1, 2]),
    "model is a list. Pass a Model": lambda: save_model([STRIP], "out"),
    "a number of a meridian is": lambda: meridian("x", (0, 0.03), (150, -11.5), 2.2, 300),
    "b of a meridian cannot be 'up': give two finite numbers": lambda: meridian(
        -1.5, "up", (150, -11.5), 2.2, 300
    ),
    "the radius `ring` is 2 mm: give a number above 0": lambda: meridian(
        -1.5, (0, 0.03), (150, -11.5), 2.2, 300, ring="2 mm"
    ),
    "tolerance is '1e-4'": lambda: split(ROD.curve, tolerance="1e-4"),
    "quadratic coefficient of the material law is None": lambda: PolynomialLaw(None),
    "Poisson's ratio is wood": lambda: anticlastic_factor(40, 0.01, thickness=0.5, poisson_ratio="wood"),
    "the tolerance is '0.1 mm': give a number above 0": lambda: STRIP.outline.points("0.1 mm"),
    "the normal of a mirror is 'z': give three finite numbers": lambda: Model([Placed(STRIP)]).mirrored(
        (0, 0, 0), "z"
    ),
    "pattern count is '3': give a whole number from 1 up to 1000": lambda: Model([Placed(STRIP)]).rotated(
        "3"
    ),
    "the axis of a rotation is 1.0: give three": lambda: Model([Placed(STRIP)]).rotated(3, axis=1.0),
    "the point of a rotation is 5: give three": lambda: Model([Placed(STRIP)]).rotated(3, point=5),
    "rotation step is '1': give a number, in rad": lambda: Model([Placed(STRIP)]).rotated(3, step="1"),
    "pattern count is 2.5": lambda: Model([Placed(STRIP)]).repeated(2.5, (0, 0, 5)),
    "the step of a pattern is 5: give three": lambda: Model([Placed(STRIP)]).repeated(2, 5),
    "pattern count is 1001": lambda: Model([Placed(STRIP)]).rotated(1001),
    "101 strips repeated 1000 times are too many": lambda: Model([Placed(STRIP)] * 101).repeated(
        1000, (0, 0, 5)
    ),
    "arc radius is '2': give a finite number": lambda: Path.circle((0, 0), "2"),
    "the bulge of an arc is '1': give": lambda: Arc.from_bulge((0, 0), (1, 1), "1"),
    "a rectangle has sides of 3 and 4 mm": lambda: Path.rectangle("3", 4),
    "the segments of a path contain 'arch'. Pass only Line, Arc and Spline": lambda: Path("arch"),
    "the law's curvatures cannot be 'ab': give numbers": lambda: TabulatedLaw("ab", [1, 2]),
    r"paths contain Path.*. Pass only LayeredPath": lambda: Drawing("plate", [Path.circle((0, 0), 2)]),
    "text to engrave is 3: give a text": lambda: Text((0, 0), 3, 5.0),
    "give a finite position": lambda: Text((0, 0), "A", "5"),
    "holding tabs: least is '2'": lambda: HoldingTabs(least="2"),
    "masses contain 3. Pass only PointMass": lambda: Weight(1.0, masses=[3]),
    "the correction is a float. Pass a Profile": lambda: Strip(ROD, SHEET, max_width=20, correction=1.0),
    "^ends contain 5. Pass only Tab records": lambda: StripSpec(
        ROD.curve, SHEET, section=RoundLaw(SHEET, 1, 2), ends=5
    ),
    "the number of copies is '2'": lambda: Piece("a", STRIP.drawing(), SHEET, "2"),
    "rod stiffness cannot be 'x': give numbers": lambda: replace(ROD, stiffness="x"),
    "the center is .*: give two numbers": lambda: PlaneCurve.ellipse((0, 0, 0), (3, 2)),
    "give angles at most 100 turns apart": lambda: PlaneCurve.arc((0, 0), 3, 0, 1e300),
    "samples is .*: give a whole number, 1000000 at most": lambda: Rod.straight(100.0, samples=10**9),
}


@pytest.mark.parametrize("says", SLIPS)
def test_one_sentence(says):
    with pytest.raises(InputError, match=says):
        SLIPS[says]()


def test_one_record_stands_for_a_row_of_it():
    assert Tab(10, holes=Hole(5, 3)).holes == (Hole(5, 3),)
    assert Tab(10, holes=[Hole(5, 3)]).holes == (Hole(5, 3),)


@pytest.mark.parametrize(
    "make", [Tab, Rod.straight, lambda huge: Strip(ROD, SHEET, max_width=huge)], ids=["tab", "rod", "strip"]
)
def test_whole_numbers_beyond_all_floats_are_refused(make):
    with pytest.raises(InputError, match="give"):
        make(10**400)


ARC = PlaneCurve.arc((0, 0), 500, 0.8 * np.pi, 0.2 * np.pi)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Weight().along("0a"), "s cannot be '0a'"),
        (lambda: Weight().lumped((1, 2, 3), ["a"], 1), "stiffness cannot be"),
        (lambda: Weight().lumped((1, 2, 3), (1, 2), 1), "do not match"),
        (lambda: Weight().lumped(3, 1, 1), "at least two nodes"),
        (lambda: bow(ARC, "pom-3", hole=[[0, 1], [2, 3]]), "hole is"),
        (lambda: bow(ARC, "pom-3", hole=-1.0), "or 0 for no hole"),
        (lambda: bow(ARC, ["a", "b"], hole="x"), "the sheet is a list"),
        (lambda: StripSpec(ARC, "pom-3", max_width=20, gravity=np.array(1.0)), "gravity is array"),
    ],
)
def test_arrays_and_texts_where_one_number_belongs(call, message):
    with pytest.raises(InputError, match=message):
        call()
