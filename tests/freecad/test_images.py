"""Images and compounds of FreeCAD's Part workbench: strips are cut as often as they show them, and held there."""

import FreeCAD as App
import pytest
from freecad.elastica_wb.curves.copies import originals
from freecad.elastica_wb.features import model, strip
from freecad.elastica_wb.features.pieces import cuts_of

from elastica_cad import InputError
from tests.freecad.features import change, new

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
TURN = App.Placement(App.Vector(5, 7, 9), App.Rotation(App.Vector(1, 1, 0), 40))
ELSEWHERE = App.Placement(App.Vector(0, 30, 50), App.Rotation(App.Vector(0, 0, 1), 90))


@pytest.fixture
def slotted(document, drawn):
    """A strip that is not its own image: a slot opens to one side."""
    sketch = drawn(ARCH)
    sketch.Placement = TURN
    made = strip.create(document, sketch)
    change(made, MaxWidth=20, Slots=["at = 60, width = 2, side = 'lower'"])
    return made


def image_of(source, normal=(1, 0.3, 0.2)):
    made = source.Document.addObject("Part::Mirroring", "Image")
    made.Source, made.Base, made.Normal = source, App.Vector(-40, 0, 10), App.Vector(*normal)
    source.Document.recompute()
    return made


def counts(*sources):
    return [cut.piece.count for cut in cuts_of(sources)]


def held(*shown):
    """The bodies that fixtures and base plates hold."""
    return model.solids_of(model.strips_model(list(shown), name="shown"), App.Placement())


def assert_same(found, shown):
    """Bodies that fill the same room."""
    assert len(found) == len(shown)
    for one, other in zip(found, shown, strict=True):
        assert one.common(other).Volume == pytest.approx(other.Volume, rel=1e-4)
        assert one.Volume == pytest.approx(other.Volume, rel=1e-6)


def test_an_image_is_cut_and_held_as_the_strip_that_it_shows(document, slotted):
    image = image_of(slotted)
    change(image, Placement=ELSEWHERE)
    assert counts(image) == [1]
    assert counts(slotted, image) == [2]
    assert_same(held(image), image.Shape.Solids)


@pytest.mark.campaign
def test_an_image_of_an_image_is_the_strip_elsewhere(slotted):
    twice = image_of(image_of(slotted), normal=(0, 0, 1))
    assert_same(held(twice), twice.Shape.Solids)


@pytest.mark.campaign
def test_images_of_models_and_of_what_stands_in_containers(document, slotted):
    room = document.addObject("App::Part", "Room")
    room.Placement = ELSEWHERE
    room.addObject(slotted)
    of_room = image_of(room, normal=(0, 1, 0))
    assert_same(held(of_room), of_room.Shape.Solids)
    whole = new(model.create, document, [slotted], interlock=False)
    image = image_of(whole)
    assert counts(whole, image) == [2]
    assert_same(held(image), image.Shape.Solids)


@pytest.mark.campaign
def test_a_compound_stands_for_what_it_holds(document, slotted):
    image = image_of(slotted)
    both = document.addObject("Part::Compound", "Both")
    change(both, Links=[slotted, image], Placement=ELSEWHERE)
    assert counts(both) == [2]
    assert counts(slotted, image, both) == [2]
    assert counts(both, image_of(both)) == [4]
    assert_same(held(both), both.Shape.Solids)


def test_an_image_without_its_strip_shows_nothing(slotted):
    image = image_of(slotted)
    image.Source = None
    assert counts(slotted, image) == [1]


PATTERNS = {
    "Mirrored": {"MirrorPlane": "XZ_Plane"},
    "LinearPattern": {"Direction": "Z_Axis", "Length": 18, "Occurrences": 2},
    "PolarPattern": {"Axis": "Y_Axis", "Angle": 360, "Occurrences": 4},
}


@pytest.mark.campaign
@pytest.mark.parametrize("kind", PATTERNS)
def test_a_pattern_in_a_body_is_refused(document, drawn, kind):
    """Its copies are one solid with the strip, or none: it was cut once, and nothing said so."""
    body = document.addObject("PartDesign::Body", "Body")
    sketch = drawn(ARCH)
    body.addObject(sketch)
    made = new(strip.create, document, sketch)
    assert counts(made) == counts(body) == [1]
    pattern = body.newObject(f"PartDesign::{kind}", kind)
    pattern.Originals = [made]
    axes = {one.Role: one for one in body.Origin.OriginFeatures}
    for name, value in PATTERNS[kind].items():
        setattr(pattern, name, (axes[value], [""]) if value in axes else value)
    body.Tip = pattern
    link = document.addObject("App::Link", "Link")
    change(link, LinkedObject=body)
    assert pattern.State == ["Up-to-date"]
    assert originals(pattern) == [made]
    for shown in (pattern, body, link):
        with pytest.raises(InputError, match=f"{kind} joins the copies of Strip into one body.*array"):
            counts(shown)
        with pytest.raises(InputError, match="array"):
            held(shown)
    assert counts(made) == [1], "the strip alone"


@pytest.mark.campaign
def test_a_body_that_begins_with_a_strip_is_that_strip(document, slotted):
    body = document.addObject("PartDesign::Body", "Body")
    change(body, BaseFeature=slotted, Placement=ELSEWHERE)
    assert body.Shape.Volume == pytest.approx(slotted.Shape.Volume)
    (base,) = body.Group
    assert counts(body) == counts(base) == counts(base, slotted) == [1]
    moved = base.Shape.copy()
    moved.Placement = base.getGlobalPlacement()
    assert_same(held(body), [moved])
