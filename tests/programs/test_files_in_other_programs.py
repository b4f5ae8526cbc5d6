"""Our files opened by programs nobody here wrote: their size to 0.01 mm, their layers, their closed loops.

`tests/programs/setup.sh` installs Inkscape, LibreCAD, OpenSCAD and Poppler from Debian,
`tests/freecad/setup.sh` FreeCAD.
"""

import json
import re
import subprocess
import sys
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.plot import save_template

SIZE_MM = 0.01
DOT_MM = 0.0053  # in which LibreCAD prints
MM_PER_PX, MM_PER_PT = 25.4 / 96, 25.4 / 72


def run(*words, cwd, screen=False, seconds=120):
    words = (["xvfb-run", "-a", *words]) if screen else list(words)
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False, timeout=seconds)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


IN_FREECAD = """
import json
import FreeCAD, Import, Part, importSVG
def loops(edges):
    wires = [Part.Wire(group) for group in Part.sortEdges(edges)]
    points = [wire.discretize(40000) for wire in wires if wire.isClosed()]
    return [(max(p.x for p in line) - min(p.x for p in line), max(p.y for p in line) - min(p.y for p in line))
            for line in points]
found = {{}}
for kind, read in (("svg", importSVG.insert), ("dxf", Import.readDXF)):
    document = FreeCAD.newDocument()
    read({file!r} + "." + kind, document.Name)
    found[kind] = loops([edge for one in document.Objects if hasattr(one, "Shape") for edge in one.Shape.Edges])
solids = Part.Shape()
solids.read({file!r} + ".step")
found["step"] = [(one.isClosed() and one.isValid(), one.Volume) for one in solids.Solids]
open({file!r} + ".freecad.json", "w").write(json.dumps(found))
"""


@pytest.fixture(scope="module")
def cut(tmp_path_factory):
    """One strip as the command writes it: exact, as arcs, for old machines; and the strip itself."""
    folder = tmp_path_factory.mktemp("cut")
    curve = ec.PlaneCurve.spline([(0, 0), (40, 80), (110, 100), (190, 50), (240, 0)], degree=4)
    ec.formats.write_curves([curve], folder / "bow.dxf")
    asked = ["--sheet", "birch-plywood-0.8", "--max-width", "30", "--label", "BOW"]
    for name, options in {
        "exact": [], "arc": ["--curves", "arc"], "lines": ["--curves", "polyline"], "old": ["--dxf-version", "R12"],
        "paper": ["--paper", "A3"],
    }.items():  # fmt: skip
        run(
            sys.executable, "-m", "elastica_cad", "strip", "bow.dxf", *asked, *options, "-o", name, cwd=folder
        )
    sheet = ec.Sheet.named("birch-plywood-0.8")
    (drawn,) = ec.read_curves(folder / "bow.dxf")
    return folder, ec.Strip(ec.optimal_rod(drawn), sheet, max_width=30.0, label="BOW")


def cutting_file(kind):
    return f"{kind}/bow-mm.dxf" if kind == "old" else f"{kind}/bow.dxf"  # R12 holds no unit


def outline_size(strip):
    low, high = strip.outline.bounds
    return high - low


def test_inkscape_measures_the_svg(cut):
    folder, strip = cut
    said = run("inkscape", "--query-all", "exact/bow.svg", cwd=folder)
    rows = {row.split(",")[0]: np.array(row.split(",")[1:], float) for row in said.splitlines() if "," in row}
    assert {"CUT_OUTER", "ENGRAVE", "MARK"} <= set(rows)
    stroke = stroke_width(folder / "exact" / "bow.svg")
    measured = rows["CUT_OUTER"][2:] * MM_PER_PX - stroke
    np.testing.assert_allclose(measured, outline_size(strip), atol=SIZE_MM)


def test_inkscape_draws_closed_loops_on_the_layers(cut):
    folder, strip = cut
    words = ("exact/bow.svg", "--export-plain-svg", "--export-filename=plain.svg")
    run("inkscape", *words, cwd=folder)
    root = ElementTree.parse(folder / "plain.svg").getroot()
    groups = {group.get("id"): group for group in root.iter("{http://www.w3.org/2000/svg}g")}
    loops = [path.get("d") for path in groups["CUT_OUTER"].iter("{http://www.w3.org/2000/svg}path")]
    assert len(loops) == 1
    assert loops[0].strip().lower().endswith("z")
    assert not [one for one in groups if one.startswith("CUT_INNER")]
    assert not strip.holes


def test_freecad_reads_drawings_and_solids(cut):
    folder, strip = cut
    pytest.importorskip("OCP")
    file = str(folder / "exact" / "bow")
    (folder / "read.py").write_text(IN_FREECAD.format(file=file))
    run("freecadcmd", str(folder / "read.py"), cwd=folder, seconds=300)
    found = json.loads((folder / "exact" / "bow.freecad.json").read_text())
    for kind in ("svg", "dxf"):
        largest = max(found[kind], key=lambda size: size[0])
        np.testing.assert_allclose(largest, outline_size(strip), atol=SIZE_MM)
    assert [closed for closed, _ in found["step"]] == [True, True]
    volume = strip.area * strip.sheet.thickness
    assert [size for _, size in found["step"]] == pytest.approx([volume, volume], rel=1e-4)


def stroke_width(file):
    """The visual box that Inkscape tells includes the stroke, mm."""
    text = file.read_text()
    return float(re.search(r'stroke-width[=:]"?([0-9.]+)', text)[1])


@pytest.mark.parametrize("kind", ["arc", "lines", "old"])
def test_openscad_extrudes_the_dxf(cut, kind):
    folder, strip = cut
    (folder / f"{kind}.scad").write_text(f'$fn = 720; import("{cutting_file(kind)}", layer="CUT_OUTER");')
    run("openscad", "-o", f"{kind}.svg", f"{kind}.scad", cwd=folder)
    root = ElementTree.parse(folder / f"{kind}.svg").getroot()
    (path,) = root.findall("{http://www.w3.org/2000/svg}path")
    loops = [part for part in path.get("d").split("M") if part.strip()]
    assert len(loops) == 1, "one closed loop"
    points = np.array(re.findall(r"(-?[0-9.e+-]+),(-?[0-9.e+-]+)", loops[0]), float)
    np.testing.assert_allclose(
        np.ptp(points, axis=0), outline_size(strip), atol=0.06 if kind == "arc" else 0.03
    )
    x, y = points.T
    area = abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2
    assert area == pytest.approx(strip.outline.area, rel=2e-3)


@pytest.mark.parametrize("kind", ["exact", "arc", "old"])
def test_librecad_prints_the_dxf_at_full_size(cut, kind):
    folder, strip = cut
    printed = librecad_size(folder, cutting_file(kind), (1, 0, 0))
    # LibreCAD rounds the paper to whole points: a plate that ezdxf wrote says by how much it then scales
    document = ezdxf.new(units=4)
    document.modelspace().add_lwpolyline(
        [(0, 0), (300, 0), (300, 40), (0, 40)], close=True, dxfattribs={"color": 1}
    )
    document.saveas(folder / "plate.dxf")
    scale = librecad_size(folder, "plate.dxf", (1, 0, 0)) / (300, 40)
    np.testing.assert_allclose(scale, 1, atol=1e-3)
    np.testing.assert_allclose(printed / scale, outline_size(strip), atol=3 * DOT_MM)


def librecad_size(folder, file, color):
    """Width and height (mm) of the lines of a colour on the paper that LibreCAD prints."""
    target = folder / f"librecad-{file.replace('/', '-')}"
    target.mkdir(exist_ok=True)
    words = ["librecad", "dxf2pdf", "-c", "-s", "1", "-r", "4800", "-t", str(target), file]
    run(*words, cwd=folder, screen=True)
    (pdf,) = target.glob("*.pdf")
    return printed_size(pdf, color)


def test_poppler_measures_the_paper_template(cut):
    folder, strip = cut
    color = (194 / 255, 69 / 255, 45 / 255)
    np.testing.assert_allclose(
        printed_size(folder / "paper" / "bow.pdf", color), outline_size(strip), atol=SIZE_MM
    )


def test_tiles_join_at_their_marks(cut):
    """Neighbouring pages overlap by 10 mm, and together they hold the whole drawing."""
    folder, strip = cut
    tiling = save_template(strip.drawing(), folder / "tiles.pdf", paper="A4", force=True)
    assert len(tiling.names) > 1
    step = np.diff(tiling.origins, axis=0)[0]
    assert step[0] == pytest.approx(tiling.size[0] - 10.0)
    low, high = strip.drawing().bounds
    assert np.all(tiling.origins[0] <= low)
    assert np.all(tiling.origins[-1] + tiling.size >= high)


def printed_size(pdf, color):
    """Width and height (mm) of all lines of a colour (r, g, b) on the first page, as Poppler draws it."""
    svg = pdf.with_suffix(".poppler.svg")
    run("pdftocairo", "-svg", "-f", "1", "-l", "1", "-noshrink", pdf.name, svg.name, cwd=pdf.parent)
    found = []
    pattern = r'stroke:rgb\(([^)]*)\)[^>]* d="([^"]+)"(?: transform="matrix\(([^)]*)\)")?'
    for stroke, d, matrix in re.findall(pattern, svg.read_text()):
        if np.allclose([float(part.rstrip("%")) / 100 for part in stroke.split(",")], color, atol=0.01):
            points = np.array(re.findall(r"(-?[0-9.]+) (-?[0-9.]+)", d), float)
            a, b, c, e, x, y = (float(v) for v in (matrix or "1,0,0,1,0,0").split(","))
            found.append(points @ np.array([[a, b], [c, e]]) + (x, y))
    return np.ptp(np.concatenate(found), axis=0) * MM_PER_PT


def test_layers_stand_in_the_dxf_for_every_reader(cut):
    folder, _ = cut
    for kind in ("exact", "arc", "lines", "old"):
        document = ezdxf.readfile(folder / cutting_file(kind))
        assert {entity.dxf.layer for entity in document.modelspace()} == {"CUT_OUTER", "ENGRAVE", "MARK"}
