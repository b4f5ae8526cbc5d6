"""Our files opened by programs nobody here wrote: their size to 0.01 mm, their layers, their closed loops.

`tests/setup.sh` installs Inkscape, LibreCAD, OpenSCAD, Poppler and FreeCAD from Debian.
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
LAYERS = {"CUT_OUTER", "CUT_INNER", "ENGRAVE", "MARK"}
PAPER_MM = (3302, 635)  # whole points, to which LibreCAD rounds paper; large, as it prints in dots of 0.02 mm
ENLARGED = 10
MM_PER_PX, MM_PER_PT = 25.4 / 96, 25.4 / 72


def run(*words, cwd, screen=False, seconds=120):
    words = (["xvfb-run", "-a", *words]) if screen else list(words)
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False, timeout=seconds)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


FINE = ("--set", "cut.tolerance=0.002")

IN_FREECAD = """
import json
import FreeCAD, Import, Part, importSVG
def wires_of(edges):
    return [Part.Wire(group) for group in Part.sortEdges(edges)]
def loops(wires):
    points = [wire.discretize(40000) for wire in wires if wire.isClosed()]
    return [(max(p.x for p in line) - min(p.x for p in line), max(p.y for p in line) - min(p.y for p in line))
            for line in points]
found = {{}}
for kind, read in (("svg", importSVG.insert), ("dxf", Import.readDXF)):
    document = FreeCAD.newDocument()
    read({file!r} + "." + kind, document.Name)
    found[kind] = loops(wires_of([edge for one in document.Objects for edge in one.Shape.Edges]))
FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft").SetBool("groupLayers", True)
document = FreeCAD.newDocument()
Import.readDXF({file!r} + ".dxf", document.Name)
found["layers"] = {{one.Label: [wire.isClosed() for wire in wires_of(one.Shape.Edges)] for one in document.Objects}}
solids = Part.Shape()
solids.read({file!r} + ".step")
found["step"] = [(one.isClosed() and one.isValid(), one.Volume) for one in solids.Solids]
open({file!r} + ".freecad.json", "w").write(json.dumps(found))
"""


OPTIONS = {
    "exact": [], "arc": ["--set", "cut.curves=arc"],
    "bezier": ["--set", "cut.curves=bezier"], "lines": ["--set", "cut.curves=polyline", *FINE],
    "old": ["--set", "cut.version=R12", *FINE], "paper": ["--set", "files.paper=A3"],
}  # fmt: skip
"""How the command writes one strip: exact, as arcs, Bezier curves or lines, for old machines, on paper."""

VARIANT = pytest.mark.campaign
"""One file each way is opened in the everyday suite, the other variants in `make campaign-programs`."""


@pytest.fixture(scope="module")
def cut(tmp_path_factory):
    """The folder with the drawn curve, and the strip itself; `written` adds files."""
    folder = tmp_path_factory.mktemp("cut")
    curve = ec.PlaneCurve.spline([(0, 0), (40, 80), (110, 100), (190, 50), (240, 0)], degree=4)
    ec.formats.write_curves([curve], folder / "bow.dxf")
    sheet = ec.Sheet.named("birch-plywood-0.8")
    (drawn,) = ec.read_curves(folder / "bow.dxf")
    ends = ec.Tab(12.0, holes=(ec.Hole(6.0, 3.0),)), ec.Tab(10.0)
    return folder, ec.Strip(ec.optimal_rod(drawn), sheet, max_width=30.0, label="BOW", ends=ends)


def written(folder, kind):
    """The files of the strip as the command writes them, made once for each kind."""
    if not (folder / kind).exists():
        options = ["--sheet", "birch-plywood-0.8", "--max-width", "30", "--label", "BOW"]
        tabs = "ends = [{ length = 12, holes = [{at = 6, diameter = 3}] }, {}]"
        options += ["--set", tabs, *OPTIONS[kind], "-o", kind]
        options += [] if kind == "exact" else ["--no-step", "--no-pictures"]
        run(sys.executable, "-m", "elastica_cad", "strip", "bow.dxf", *options, cwd=folder)
    return folder / kind


def cutting_file(folder, kind):
    name = "bow-mm.dxf" if kind == "old" else "bow.dxf"  # R12 holds no unit
    return (written(folder, kind) / name).relative_to(folder).as_posix()


def outline_size(strip):
    low, high = strip.outline.bounds
    return high - low


def test_inkscape_measures_the_svg(cut):
    folder, strip = cut
    written(folder, "exact")
    text = run("inkscape", "--query-all", "exact/bow.svg", cwd=folder)
    rows = {row.split(",")[0]: np.array(row.split(",")[1:], float) for row in text.splitlines() if "," in row}
    assert set(rows) >= LAYERS
    stroke = stroke_width(folder / "exact" / "bow.svg")
    measured = rows["CUT_OUTER"][2:] * MM_PER_PX - stroke
    np.testing.assert_allclose(measured, outline_size(strip), atol=SIZE_MM)


@VARIANT
def test_inkscape_draws_closed_loops_on_the_layers(cut):
    folder, _ = cut
    written(folder, "exact")
    words = ("exact/bow.svg", "--export-plain-svg", "--export-filename=plain.svg")
    run("inkscape", *words, cwd=folder)
    root = ElementTree.parse(folder / "plain.svg").getroot()
    groups = {group.get("id"): group for group in root.iter("{http://www.w3.org/2000/svg}g")}
    for layer in ("CUT_OUTER", "CUT_INNER"):
        loops = [path.get("d") for path in groups[layer].iter("{http://www.w3.org/2000/svg}path")]
        assert len(loops) == 1
        assert loops[0].strip().lower().endswith("z")


def test_freecad_reads_drawings_and_solids(cut):
    folder, strip = cut
    file = str(written(folder, "exact") / "bow")
    (folder / "read.py").write_text(IN_FREECAD.format(file=file))
    run("freecadcmd", "-u", str(folder / "user.cfg"), str(folder / "read.py"), cwd=folder, seconds=300)
    found = json.loads((folder / "exact" / "bow.freecad.json").read_text())
    for kind in ("svg", "dxf"):
        largest = max(found[kind], key=lambda size: size[0])
        np.testing.assert_allclose(largest, outline_size(strip), atol=SIZE_MM)
    layers = found["layers"]
    assert set(layers) == LAYERS
    assert layers["CUT_OUTER"] == layers["CUT_INNER"] == [True]
    assert [closed for closed, _ in found["step"]] == [True, True]
    volume = strip.area * strip.sheet.thickness
    assert [size for _, size in found["step"]] == pytest.approx([volume, volume], rel=1e-4)


def stroke_width(file):
    """The visual box that Inkscape tells includes the stroke, mm."""
    text = file.read_text()
    return float(re.search(r'stroke-width[=:]"?([0-9.]+)', text)[1])


def test_openscad_extrudes_the_dxf(cut):
    (folder, strip), kind = cut, "lines"
    # $fn: pieces of a whole turn, also of arcs of 10 m radius
    (folder / f"{kind}.scad").write_text(
        f'$fn = 20000; import("{cutting_file(folder, kind)}", layer="CUT_OUTER");'
    )
    run("openscad", "-o", f"{kind}.svg", f"{kind}.scad", cwd=folder)
    root = ElementTree.parse(folder / f"{kind}.svg").getroot()
    (path,) = root.findall("{http://www.w3.org/2000/svg}path")
    loops = [part for part in path.get("d").split("M") if part.strip()]
    assert len(loops) == 1, "one closed loop"
    points = np.array(re.findall(r"(-?[0-9.e+-]+),(-?[0-9.e+-]+)", loops[0]), float) * (1, -1)
    np.testing.assert_allclose(np.ptp(points, axis=0), outline_size(strip), atol=SIZE_MM)
    with_middles = np.concatenate([points, (points + np.roll(points, -1, axis=0)) / 2])
    assert distances(with_middles, strip.outline.points(1e-3)).max() < SIZE_MM


def distances(points, corners):
    """How far points (n, 2) lie from a closed polyline, mm."""
    side = np.roll(corners, -1, axis=0) - corners
    from_corner = points[:, None] - corners
    share = np.clip(np.sum(from_corner * side, axis=-1) / np.sum(side**2, axis=-1), 0, 1)
    return np.linalg.norm(from_corner - share[..., None] * side, axis=-1).min(axis=1)


@pytest.mark.parametrize(
    "kind", ["exact", *(pytest.param(one, marks=VARIANT) for one in ("arc", "bezier", "lines", "old"))]
)
def test_librecad_prints_each_layer_at_full_size_in_closed_loops(cut, kind):
    folder, strip = cut
    printed = {layer: librecad_lines(folder, cutting_file(folder, kind), layer) for layer in LAYERS}
    for layer, size in {"CUT_OUTER": outline_size(strip), "CUT_INNER": (3, 3)}.items():
        np.testing.assert_allclose(np.ptp(np.concatenate(printed[layer]), axis=0), size, atol=SIZE_MM)
        assert [is_closed(chain) for chain in joined(printed[layer])] == [True]
    assert len(printed["ENGRAVE"]) > 3
    assert [is_closed(chain) for chain in joined(printed["MARK"])] == [False, False]  # where both tabs begin


def librecad_lines(folder, file, layer):
    """The lines (n, 2), mm, that LibreCAD prints of one layer, while all others are frozen."""
    target = folder / f"librecad-{file.replace('/', '-')}-{layer}"
    target.mkdir()
    text, paper = (folder / file).read_text(), f"$PLIMMAX\n 10\n{PAPER_MM[0]}\n 20\n{PAPER_MM[1]}"
    if "$PLIMMAX" not in text:  # R12 is written without a size of the paper
        text = text.replace("  9\n$EXTMIN", f"  9\n{paper}\n  9\n$EXTMIN")
    text, papers = re.subn(r"\$PLIMMAX\s+10\s+\S+\s+20\s+\S+", paper, text)
    table = r"(\n  0\nLAYER\n(?:(?!  0\n).*\n.*\n)*?  2\n(.*)\n 70\n)0\n"
    text, layers = re.subn(table, lambda found: f"{found[1]}{int(found[2] != layer)}\n", text)
    assert papers == 1
    assert layers >= len(LAYERS)
    (target / "one.dxf").write_text(text)
    words = ("librecad", "dxf2pdf", "-c", "-s", str(ENLARGED), "-t", str(target), str(target / "one.dxf"))
    run(*words, cwd=folder, screen=True)
    return [line / ENLARGED for line in printed_lines(target / "one.pdf")]


def is_closed(chain):
    return len(chain) > 2 and np.linalg.norm(chain[0] - chain[-1]) < SIZE_MM


def joined(lines):
    """Lines that meet end to end as chains."""
    lines, chains = list(lines), []
    while lines:
        chain, found = lines.pop(), True
        while found and not is_closed(chain):
            turned = ((i, line[::step]) for i, line in enumerate(lines) for step in (1, -1))
            found = next((one for one in turned if np.linalg.norm(one[1][0] - chain[-1]) < SIZE_MM), None)
            if found:
                chain = np.concatenate([chain, found[1][1:]])
                del lines[found[0]]
        chains.append(chain)
    return chains


def test_poppler_measures_the_paper_template(cut):
    folder, strip = cut
    color = (194 / 255, 69 / 255, 45 / 255)
    lines = np.concatenate(printed_lines(written(folder, "paper") / "bow.pdf", color))
    np.testing.assert_allclose(np.ptp(lines, axis=0), outline_size(strip), atol=SIZE_MM)


@VARIANT
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


def printed_lines(pdf, color=None):
    """The lines (n, 2), mm, of a colour (r, g, b), or of all, on the first page, as Poppler draws it."""
    svg = pdf.with_suffix(".poppler.svg")
    run("pdftocairo", "-svg", "-f", "1", "-l", "1", "-noshrink", pdf.name, svg.name, cwd=pdf.parent)
    found = []
    pattern = r'stroke:rgb\(([^)]*)\)[^>]* d="([^"]+)"(?: transform="matrix\(([^)]*)\)")?'
    for stroke, d, matrix in re.findall(pattern, svg.read_text()):
        if color is None or np.allclose(
            [float(part.rstrip("%")) / 100 for part in stroke.split(",")], color, atol=0.01
        ):
            points = np.array(re.findall(r"(-?[0-9.]+) (-?[0-9.]+)", d), float)
            a, b, c, e, x, y = (float(v) for v in (matrix or "1,0,0,1,0,0").split(","))
            found.append((points @ np.array([[a, b], [c, e]]) + (x, y)) * MM_PER_PT)
    return found


@VARIANT
def test_layers_stand_in_the_dxf_for_every_reader(cut):
    folder, _ = cut
    for kind in ("exact", "arc", "lines", "old"):
        document = ezdxf.readfile(folder / cutting_file(folder, kind))
        assert {entity.dxf.layer for entity in document.modelspace()} == LAYERS
