"""What mutations grow from: public drawings, files of our own in every format, and designs."""

import io
import re
from functools import cache
from pathlib import Path

DATA = Path(__file__).resolve().parents[2] / "data"
TEMPLATES = Path(__file__).resolve().parents[3] / "elastica_cad" / "cli" / "templates"

SHARES = {
    "svg": 30, "dxf": 22, "csv": 12, "json": 11, "txt": 10, "toml": 8, "obj": 3, "stl": 1, "ply": 1, "step": 2,
}  # fmt: skip
"""How many of a hundred cases are of each format."""


@cache
def originals(kind: str) -> tuple[bytes, ...]:
    """Sound files of a format."""
    made = {"dxf": _dxf, "svg": _svg, "json": _json, "csv": _csv, "txt": _txt, "toml": _toml, "step": _step}
    own = made[kind]() if kind in made else _mesh(kind)
    public = (path.read_bytes() for path in sorted((DATA / "public").rglob(f"*.{kind}")))
    return (*own, *(data for data in public if len(data) < 200_000))


def _dxf() -> list[bytes]:
    import ezdxf

    found = []
    for version in ("R12", "R2000", "R2010"):
        document = ezdxf.new(version, units=0 if version == "R12" else 4)
        space = document.modelspace()
        space.add_polyline2d([(0, 0, 0.3), (40, 10, 0), (60, 30, -0.5)], format="xyb")
        space.add_arc((0, 0), 50, 10, 170)
        space.add_circle((70, 0), 5)
        space.add_text("A")
        document.blocks.new("B").add_line((0, 0), (5, 9))
        document.blocks.new("C").add_blockref("B", (1, 1))
        array = {"xscale": 2.0, "row_count": 2, "row_spacing": 20}
        space.add_blockref("C", (10, 10), dxfattribs=array)
        if version != "R12":
            space.add_open_spline([(0, 0), (40, 80), (90, 90), (130, 20), (190, 0)], degree=3)
            space.add_rational_spline([(0, 0), (40, 80), (90, 90), (130, 20)], [1, 2, 1, 1], degree=3)
            space.add_ellipse((5, 5), (30, 0), 0.5, 0, 2)
            space.add_lwpolyline([(0, 0, 0.3), (40, 10, 0), (60, 30, -0.5)], format="xyb")
        stream = io.StringIO()
        document.write(stream)
        text = stream.getvalue()
        found.append(text.encode())
        if version == "R12":  # once more without its tables, so that mutations meet the drawing
            headless = text[text.index("  0\nSECTION\n  2\nBLOCKS") :]
            found.append(b"0\nSECTION\n2\nHEADER\n0\nENDSEC\n" + headless.encode())
    return found


def _svg() -> list[bytes]:
    head = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
    return [
        (head + 'width="200mm" height="100mm" viewBox="0 0 200 100"><style>.a{fill:none}</style>'
         '<g transform="translate(10,5) rotate(20)"><path id="a" class="a" d="M 10 20 C 30 80 60 -10 90 40 '
         's 20 30 40 -5"/><circle cx="50" cy="50" r="20"/></g><use href="#a" x="5"/>'
         '<polyline points="0,0 10,30 50,40"/></svg>').encode(),
        (head + '><defs><g id="d"><path d="M0 0q10 20 30 0t40 0H5V9z"/></g></defs><use xlink:href="#d" '
         'transform="matrix(1 .2 -.3 1 5 6) skewX(10)"/><rect x="1" y="2" width="9" height="8" rx="2"/>'
         '<ellipse cx="5" cy="9" rx="20" ry="9"/><path d="M10,10A30 20 15 1 0 60-40a5 5 0 00 8 8L90 90"/>'
         "</svg>").encode(),
    ]  # fmt: skip


def _json() -> list[bytes]:
    from elastica_cad import PlaneCurve
    from elastica_cad.formats import curves_json

    arc, line = PlaneCurve.arc((0, 0), 50, 0, 2), PlaneCurve.line((0, 0), (30, 5))
    wave = PlaneCurve.spline([(0, 0), (40, 60), (90, -60), (130, 0)], degree=3)
    return [curves_json([arc, line]).encode(), curves_json([wave]).encode()]


def _csv() -> list[bytes]:
    rows = [f"{x},{0.02 * x * (90 - x):.3f}" for x in range(0, 91, 5)]
    more = [f"{x};{0.02 * x * (90 - x):.3f}".replace(".", ",") for x in range(0, 91, 5)]
    return ["\n".join(["x,y", *rows, "", *rows]).encode(), "\n".join(more).encode()]


def _txt() -> list[bytes]:
    return [b"3 5\n0 0\n10.5 20.5\n30 40\n60.5 30\n90 0\n", b"4 6\n0 0\n40 60\n90 60\n130 0\n160 -9\n200 0\n"]


def _toml() -> list[bytes]:
    designs = [path.read_bytes() for path in sorted(TEMPLATES.glob("*.toml"))]
    own = (
        b'schema = 1\nsheet = "birch-plywood-0.8"\nmax_width = 20\n[let]\nr = 50\n[[strips]]\ncount = 3\n'
        b'label = "A{i}"\norigin = [0, "9 * i", 0]\n[strips.curve]\nfit = [[0, 0], [30, 40], [60, "r"], [90, 0]]\n'
    )
    return [own, *designs]


def _step() -> list[bytes]:
    try:
        from build123d import Edge, export_step
    except ImportError:  # without a kernel no STEP is read either
        return [b"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"]
    from tempfile import TemporaryDirectory

    with TemporaryDirectory() as folder:
        file = Path(folder, "a.step")
        export_step(Edge.make_spline([(0, 0), (30, 40), (60, 10), (90, 50)]), str(file))
        return [re.sub(rb"'\d{4}-\d\d-\d\dT[\d:]+'", b"'2000-01-01T00:00:00'", file.read_bytes())]


def _mesh(kind: str) -> list[bytes]:
    import trimesh

    shape = trimesh.creation.icosphere(subdivisions=1, radius=40.0)
    found = [shape.export(file_type=kind)]
    if kind == "stl":
        found.append(shape.export(file_type="stl_ascii"))
    return [one.encode() if isinstance(one, str) else one for one in found]
