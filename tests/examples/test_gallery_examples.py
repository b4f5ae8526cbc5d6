"""Every example of the gallery: what it makes can be cut, bent, stays in its shape, and hits nothing."""

import json
import runpy
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from scipy.integrate import trapezoid

import elastica_cad as ec
from elastica_cad.design import read_design
from elastica_cad.strip import CUT_OUTER

CARD = ec.Sheet.named("card-200gsm")
REALIZED = 0.1  # mm between the bent strip as made and its design


@pytest.fixture(scope="module")
def example(project_root):
    """The names of examples/NAME/NAME.py, run once as a module."""
    seen = {}

    def load(name):
        if name not in seen:
            seen[name] = runpy.run_path(str(project_root / "examples" / name / f"{name}.py"))
        return seen[name]

    return load


@pytest.fixture(scope="module")
def fins(example):
    """The fins of the Facade with their way from closed to open."""
    names = example("facade")
    return [names["fin"](k) for k in range(names["FINS"])]


@pytest.fixture(scope="module")
def built(example, fins, project_root):
    """The model of an example, built once."""
    seen = {}

    def build(name):
        if name not in seen and name == "pavilion":
            design = read_design(project_root / "examples" / name / "pavilion.toml", ec.read_curves)
            seen[name] = design.model()
        elif name not in seen:
            options = {"fins": fins} if name == "facade" else {}
            seen[name] = example(name)["build"](**options)
        return seen[name]

    return build


# strips, different ones, size of the model in mm, largest ratio
MODELS = {
    "spiral": (1, 1, None, 1.842),
    "vase": (20, 1, (260, 260, 140), 4.0),
    "lantern": (20, 2, (280, 280, 260), 3.0),
    "flower_pot": (16, 16, (300, 300, 170), 3.5),
    "shell": (60, 10, (480, 480, 100), 1.5),
    "horse": (40, 40, (560, 140, 260), 2.0),
    "lamp": (32, 32, (930, 660, 200), 2.4),
    "carpet": (15, 15, (460, 290, 115), 3.0),
    "pavilion": (31, 31, (540, 760, 130), 2.118),
    "facade": (8, 8, None, 3.0),
}


@pytest.mark.campaign
@pytest.mark.parametrize("name", MODELS)
def test_counts_and_sizes(name, built):
    model, (count, different, size, ratio) = built(name), MODELS[name]
    assert len(model.placed) == count
    assert len(model.parts) == different
    assert max(strip.rod.ratio for strip in model.strips) <= ratio * (1 + 1e-6)
    if size is not None:
        places = np.concatenate([p.frame.point(p.strip.rod.position) for p in model.placed])
        assert np.ptp(places, axis=0) == pytest.approx(size, rel=0.25)


@pytest.mark.campaign
@pytest.mark.parametrize("name", MODELS)
def test_strips_keep_their_shape(name, built):
    """In balance, stable with what they carry, within what the sheet bears, and as cut within 0.1 mm of the design.

    Slots of the Pavilion are filled by the neighbours: without them it gives way by a little more.
    """
    for part in built(name).parts:
        strip = part.strip
        assert strip.rod.residual < 1e-3
        verdict = ec.stability(strip.rod)
        assert verdict.stable
        assert verdict.margin > (0.0 if name in ("spiral", "vase", "pavilion") else 5.0 - 1e-2)
        assert strip.deviation_as_built < (0.3 if strip.slots else REALIZED)
        if strip.slots:
            assert replace(strip, slots=()).deviation_as_built < REALIZED
        assert strip.max_strain <= strip.strain_limit * (1 + 1e-6)


@pytest.mark.campaign
@pytest.mark.parametrize("name", sorted({*MODELS} - {"lamp", "pavilion"}))
def test_drawings_are_sound(name, built, check_drawing):
    """The first and the last part; those of the Pavilion in its own tests."""
    parts = built(name).parts
    for part in dict.fromkeys(parts[:: max(1, len(parts) - 1)]):
        for drawing in part.strip.drawings():
            assert len(drawing.on(CUT_OUTER)) == 1
            check_drawing(drawing)


@pytest.mark.campaign
def test_a_drawing_of_hundreds_of_diamonds_is_sound(built, check_drawing):
    for drawing in built("lamp").strips[0].drawings():
        assert len(drawing.on(CUT_OUTER)) == 1
        check_drawing(drawing)


# so many strips in order around or along, which see all that the others see where the model repeats itself
NEIGHBOURS = {"lantern": 4, "flower_pot": 16, "shell": 21, "horse": 40, "lamp": 32, "carpet": 15, "facade": 8}


@pytest.mark.campaign
@pytest.mark.parametrize("name", NEIGHBOURS)
def test_bent_strips_do_not_collide(name, built, collisions):
    """As they are really cut, tabs and all: at least their thickness apart."""
    placed = built(name).placed
    if name == "shell":
        placed = sorted(placed, key=lambda one: np.arctan2(one.x_axis[1], one.x_axis[0]))
    bands = [collisions.band(one) for one in placed[: NEIGHBOURS[name]]]
    found = {
        (i, j): collisions.clearance(bands[i], bands[j])
        for i, j in combinations(range(len(bands)), 2)
        if j - i <= 3
    }
    assert min(found.values()) > 0.5


def test_strips_of_the_vase_touch_along_their_edges(built, collisions):
    """Middle surfaces meet and do not overlap; tabs keep apart."""
    bands = [collisions.band(one) for one in built("vase").placed[:3]]
    assert collisions.overlap(bands[0], bands[1]) < 1e-3
    assert collisions.clearance(bands[0], bands[1]) == pytest.approx(-0.2, abs=1e-3)
    assert collisions.clearance(bands[0], bands[2]) > 5


def test_windings_of_the_spiral_keep_apart(built, collisions):
    band = collisions.band(built("spiral").placed[0])
    assert collisions.self_clearance(band, 15.0) > 2


@pytest.mark.campaign
def test_the_pavilion_collides_in_its_slots_only(built, collisions):
    """In the shape that mates hold each other in: sheets cross where one of them is slotted, and nowhere else."""
    model = built("pavilion")
    plain = [collisions.band(one, as_built=False) for one in model.placed]
    slotted = [collisions.band(one, as_built=False, slots=True) for one in model.placed]
    near = [(i, j) for i, j in combinations(range(31), 2) if j - i <= 3]
    crossing = {pair for pair in near if collisions.overlap(*(plain[i] for i in pair)) > 0}
    assert crossing == {joint.members for joint in model.joints}
    assert all(collisions.overlap(slotted[i], slotted[j]) == 0 for i, j in crossing)
    assert min(collisions.clearance(plain[i], plain[j]) for i, j in near if (i, j) not in crossing) > 0.5


@pytest.mark.parametrize("shift", [0.0, 12.0])
def test_collisions_are_found(shift, collisions):
    """Two flat strips that cross at a right angle, and side by side with 3 mm between."""
    strip = ec.Strip(ec.Rod.straight(60.0), CARD, max_width=10, ends=(ec.Tab(5), ec.Tab(5)))
    one = collisions.band(ec.Placed(strip), as_built=False)
    through = ec.Placed(strip, (30.0 + shift, -30.0, 0.0), (0, 1, 0), (-1, 0, 0))
    assert collisions.overlap(one, collisions.band(through, as_built=False)) == pytest.approx(4.95, abs=0.1)
    beside = collisions.band(ec.Placed(strip, (shift, 0.0, 13.0)), as_built=False)
    assert collisions.clearance(one, beside) == pytest.approx(2.8, abs=1e-6)
    above = collisions.band(ec.Placed(strip, (shift, 1.0, 0.0)), as_built=False)
    assert collisions.clearance(one, above) == pytest.approx(0.8, abs=1e-6)
    assert collisions.overlap(one, above) == 0


def test_the_spiral_is_the_published_one(built):
    (strip,) = built("spiral").strips
    assert strip.rod.length == pytest.approx(345.83, abs=0.005)
    assert strip.rod.ratio == pytest.approx(1.84167, abs=2e-5)
    weighed = ec.optimal_rod(strip.rod.curve, gravity=CARD.gravity())
    assert weighed.ratio == pytest.approx(2.07087, rel=2e-3)


def test_the_spiral_of_card_is_reported_to_be_too_tight(example, built):
    """The published one went plastic in its innermost winding; paper of half the thickness does not."""
    names = example("spiral")
    (card,) = names["build"](names["CARD"]).strips
    result = [text for text in card.warnings if "allows 0.5 %" in text]
    assert len(result) == 1
    assert "strain is 0.66 % at 9.75 mm" in result[0]
    (paper,) = built("spiral").strips
    assert paper.max_strain == pytest.approx(card.max_strain / 2)
    assert not any("beyond" in text for text in paper.warnings)


@pytest.mark.parametrize(("name", "ring"), [("lantern", 60.0), ("vase", None)])
def test_rings_close(name, ring, built):
    """All strips start, and end, on one circle at one height."""
    model = built(name)
    for end in (0, -1):
        points = np.array([p.frame.point(p.strip.rod.position[end]) for p in model.placed])
        radius = np.hypot(points[:, 0], points[:, 1])
        assert np.ptp(radius) < 1e-6
        assert np.ptp(points[:, 2]) < 1e-6
        assert ring is None or radius[0] == pytest.approx(ring)
        widths = [p.strip.end_widths[end] for p in model.placed[:2]]
        gap = 2 * radius[0] * np.tan(np.pi / len(model.placed)) - sum(widths) / 2
        assert gap == pytest.approx(0, abs=1e-6) if name == "vase" else 1.0 < gap < 10.0


@pytest.mark.parametrize(("name", "deep"), [("lantern", 3.0), ("vase", 2.0)])
def test_every_tab_finds_its_slot_in_a_ring(name, deep, built):
    """Both rings are pieces of the kit; a slot for each strip lets its tab in, so many mm at least."""
    model = built(name)
    assert len(model.plates) == 2
    assert {ring.name for ring in model.plates} <= {piece.name for piece in model.pieces}
    for end, ring in zip(("start", "end"), model.plates, strict=True):
        assert len(ring.slots) == len(model.placed)
        for one, slot in zip(model.placed, ring.slots, strict=True):
            tab = ec.model.PlacedTab.of(one.strip, end, one.frame)
            corners, middle = ring.frame.local(tab.edges), ring.frame.local(tab.tip)
            assert middle[2] < -deep
            step = (middle - ring.frame.local(tab.frame.origin)) / tab.length
            for depth in (0.0, -ring.sheet.thickness):
                inside = corners - np.outer((corners[:, 2] - depth) / step[2], step)
                u = (slot.corners[1] - slot.corners[0]) / slot.size[0]
                v = np.array([-u[1], u[0]])
                placed = (inside[:, :2] - slot.corners[0]) @ np.array([u, v]).T
                assert np.all((placed > 0) & (placed < slot.size))


@pytest.mark.campaign
def test_the_carpet_hovers(built):
    """Bent as it is cut, under its own weight: between two inflections it comes near the ground, not onto it."""
    for placed in built("carpet").placed:
        rod = placed.strip.rod
        assert rod.gravity is not None
        assert rod.position[:, 1].min() >= 2.0 - 1e-6
        assert rod.curve.inflections.size == 2
        bent = ec.bend(placed.strip.as_built)
        lowest = int(np.argmin(bent.position[:, 1]))
        assert 1.9 < bent.position[lowest, 1] < 6.0
        first, second = rod.curve.inflections
        assert first < bent.s[lowest] < second


def test_the_lamp_stays_under_its_strain_limit(built):
    birch = ec.Sheet.named("birch-plywood-0.8")
    for strip in built("lamp").strips:
        assert strip.sheet == birch
        assert strip.max_strain <= 0.9 * birch.max_strain


@pytest.mark.campaign
def test_the_flower_pot_on_the_published_surface(example, reference_data):
    file = reference_data / "hafner" / "flower-pot" / "flower-pot.obj"
    model = example("flower_pot")["build"](
        ec.formats.read_mesh(file, unit="cm").scaled(6.0), least_radius=None
    )
    assert len(model.placed) == 16
    for strip in model.strips:
        assert strip.rod.ratio <= 3.5 * (1 + 1e-6)
        assert ec.stability(strip.rod).stable
        assert strip.deviation_as_built < REALIZED
        # its radii of 13 mm and more are too tight for card, as the paper built it
        assert 1 < strip.max_strain / strip.strain_limit < 2.5
        assert any("allows 0.5 %" in text for text in strip.warnings)


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["flower_pot", "shell", "lamp", "carpet", "facade", "vase"])
def test_surfaces_bend_both_ways(name, built):
    """Every strip has an inflection, as those of the paper."""
    assert all(part.strip.rod.curve.inflections.size >= 1 for part in built(name).parts)


@pytest.mark.parametrize("opened", [0.5, 1.0])
def test_fins_on_their_way_do_not_collide_or_break(opened, example, fins, collisions):
    """Half open and open: the same strips, bent further."""
    model = example("facade")["build"](opened, fins)
    for placed, fin in zip(model.placed, fins, strict=True):
        assert placed.strip.width.extremes == pytest.approx(fin.strip.width.extremes, rel=1e-9)
        assert placed.strip.deviation_as_built < REALIZED
        assert ec.stability(placed.strip.rod).stable
        assert placed.strip.max_strain <= placed.strip.strain_limit
    bands = [collisions.band(one) for one in model.placed]
    assert all(collisions.clearance(bands[i], bands[i + 1]) > 0.5 for i in range(7))


def test_the_facade_opens(example, fins):
    """Travel, force and margin of every fin from closed to open; strains bearable all the way."""
    names = example("facade")
    for fin in fins:
        assert fin.travel[-1] == pytest.approx(14)
        for rod, travel in zip(fin.shapes, fin.travel, strict=True):
            assert rod.position[-1] == pytest.approx(fin.shapes[0].position[-1] - (0, travel), abs=1e-6)
        bulge = [np.ptp(rod.position[:, 0]) for rod in fin.shapes]
        assert np.all(np.diff(bulge) > 0)
        assert bulge[-1] > 1.8 * bulge[0]
        assert np.all(fin.margin > 0)
        assert np.all(fin.force > 0)
        # the work of the pressing force is the energy that the fin takes up
        energy = [
            fin.strip.bending_stiffness * trapezoid(rod.moment**2 / rod.stiffness, rod.s) / 2
            for rod in fin.shapes
        ]
        work = trapezoid(fin.force, fin.travel)
        assert energy[-1] - energy[0] == pytest.approx(work, rel=0.02)
        opened = names["build"](1.0, [fin]).strips[0]
        assert opened.max_strain < opened.strain_limit


def test_the_s_curve_is_made_stable(example):
    drawn, found = example("s_curve")["build"]()
    assert not ec.stability(drawn).stable
    assert found.met
    assert ec.stability(found.rod).margin >= 5.0 - 1e-3
    assert 0 < found.deviation < 10
    gone = example("s_curve")["snapped"](drawn)
    assert ec.stability(gone).stable
    assert gone.position[[0, -1]] == pytest.approx(drawn.position[[0, -1]], abs=1e-6)
    assert np.abs(gone.position - drawn.position).max() > 50


def test_robustness_has_the_form_of_the_published_study(example):
    """Nothing strays where nothing is off; twice or half is worse than 1.4 times."""
    for values in example("robustness")["build"]().values():
        assert values[2] < 0.01
        assert values[0] > values[1] > values[2] < values[3] < values[4]


def test_projective_maps_keep_curves_realizable(example):
    names = example("projective")
    before, after = names["build"]()
    for handle, moved in zip(names["HANDLES"], names["MOVED"], strict=True):
        image = ec.four_point_map(names["HANDLES"], names["MOVED"]) @ [*handle, 1]
        assert image[:2] / image[2] == pytest.approx(moved)
    checks = [ec.check_equilibrium(curve) for curve in (before, after)]
    assert all(check.realizable for check in checks)
    assert len(checks[0].inflections) == len(checks[1].inflections) == 3
    assert all(ec.bend(ec.optimal_rod(curve)).residual < 1e-3 for curve in (before, after))


def test_the_six_published_surfaces_of_revolution(example, reference_data):
    """The numbers are those of Fig. 22, in other sizes; each is closed by its strips, which hold their shape."""
    names = example("revolution")
    published = json.loads((reference_data / "reference" / "revolution.json").read_text())["examples"]
    for (label, surface), record in zip(names["SURFACES"].items(), published, strict=True):
        assert surface.a == record["a"]
        assert surface.b == pytest.approx(record["b"])
        assert surface.start == pytest.approx(record["gamma0"])
        assert surface.angle == pytest.approx(record["alpha0"])
        assert surface.length == pytest.approx(record["total_length"])
        assert surface.strips == record["num_strips"]
        assert len(surface.model(label).strips[0].rod.curve.inflections) == record["inflections"]


@pytest.mark.campaign
def test_surfaces_of_revolution_can_be_made(example, collisions):
    """No gaps, no overlaps, strains that card bears; what is cut takes the meridian."""
    names = example("revolution")
    assert len(names["build"]().parts) == 6
    for label, surface in names["SURFACES"].items():
        model = surface.model(label)
        strip = model.strips[0]
        assert ec.stability(strip.rod).stable
        assert strip.deviation_as_built < REALIZED
        assert strip.max_strain <= strip.strain_limit
        first, second = (collisions.band(one) for one in model.placed[:2])
        assert collisions.overlap(first, second) < 1e-3
        assert collisions.clearance(first, second) == pytest.approx(-0.2, abs=5e-3)


def test_a_model_is_saved_as_a_folder(built, tmp_path, check_drawing_file):
    saved = ec.save_model(built("vase"), tmp_path / "vase", step=False, pictures=False)
    folder = saved.folder
    names = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    assert folder == tmp_path / "vase"
    assert names == set(saved.files)
    assert saved.left_out == ()
    assert str(saved).splitlines() == [
        "vase: 20 strips (all the same) on 3 sheets",
        f"wrote {len(names)} files to {folder}",
    ]
    assert {"vase.json", "vase-cut-list.csv", "index.html", "sheets/vase-nest-1-card-200gsm.dxf"} <= names
    check_drawing_file(folder / "sheets" / "vase-nest-1-card-200gsm.dxf")


def test_the_table_comes_from_a_run(project_root):
    """A row has a cell for each column, counts from the model and seconds from the clock."""
    names = runpy.run_path(str(project_root / "docs" / "gallery.py"))
    model, found, solving, seconds = names["built"]("lantern")
    assert 0 < solving <= seconds
    cells = names["row"]("lantern", model, found, solving, seconds).strip("| ").split(" | ")
    assert cells[:4] == ["lantern", "pom-0.5", "20 (2)", "201"]
    assert len(cells) == 12
    request, made = (float(cell.split()[0]) for cell in cells[6:8])
    assert request == pytest.approx(max(near.deviation for near in found), abs=6e-4)
    assert made == pytest.approx(max(strip.held_deviation for strip in model.strips), abs=6e-4)
    table = (project_root / "docs" / "models_in_numbers.md").read_text()
    assert all(f"| {name.replace('_', ' ')} |" in table for name in names["PAPER"])


@pytest.mark.campaign
@pytest.mark.parametrize("name", [name for name in MODELS if name != "facade"])
def test_the_table_is_of_the_models_as_they_are(name, built, project_root):
    """Sheets, counts, samples, size, ratios and deviation as made; seconds are those of the run that wrote it."""
    names = runpy.run_path(str(project_root / "docs" / "gallery.py"))
    table = (project_root / "docs" / "models_in_numbers.md").read_text()
    (line,) = [
        one for one in table.split("\n") if one.startswith(f"| {name.replace('_', ' ')} | ") and "x" in one
    ]
    result = line.strip("| ").split(" | ")
    cells = names["row"](name, built(name), [], 0.0, 0.0).strip("| ").split(" | ")
    assert result[:5] == cells[:5]
    ratios = [[float(ratio) for ratio in one[5].split("-")] for one in (result, cells)]
    assert ratios[0] == pytest.approx(ratios[1], abs=0.03), "write it again: python docs/gallery.py"
    assert float(result[7].split()[0]) == pytest.approx(float(cells[7].split()[0]), abs=0.005, rel=2e-3)


def test_pictures_are_there_and_small(project_root):
    """One of each model and study."""
    for name in (*MODELS, "revolution", "s_curve", "projective", "robustness"):
        picture = project_root / "examples" / name / f"{name}.png"
        assert 5_000 < picture.stat().st_size < 200_000


@pytest.mark.parametrize("name", ["s_curve", "projective", "robustness"])
def test_studies_draw_themselves(name, example, project_root, tmp_path):
    """Texts of a picture do not overlap."""
    drawn = runpy.run_path(str(project_root / "docs" / "studies.py"))["STUDIES"][name](example(name))
    drawn.savefig(tmp_path / "drawn.png", dpi=drawn.dpi)
    texts = []
    for axes in drawn.axes:
        legend = axes.get_legend()
        texts += [*axes.texts, *(child for child in axes.get_children() if hasattr(child, "get_text"))]
        texts += [] if legend is None else legend.get_texts()
        texts += [axes.xaxis.label, axes.yaxis.label, *axes.get_xticklabels()] if axes.axison else []
    boxes = [text.get_window_extent() for text in set(texts) if text.get_text()]
    assert len(boxes) >= 4
    assert not any(a.overlaps(b) for a, b in combinations(boxes, 2))
