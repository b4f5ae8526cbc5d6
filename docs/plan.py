"""Draws the packages from their import statements.

`python docs/plan.py` draws docs/plan.svg (the packages, their modules, the path of a drawn curve) and writes the
list of modules in docs/architecture.md. `python docs/plan.py FOLDER` draws the modules of one folder (for instance
elastica_cad/mechanics) as FOLDER.svg in the current directory, with all arrows in one direction.
"""

import ast
import sys
from functools import cache
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parents[1]
ROOTS = {
    "elastica_cad": ROOT / "elastica_cad",
    "freecad.elastica_wb": ROOT / "freecad_workbench" / "freecad" / "elastica_wb",
}

FLOORS = (
    ("elastica_cad.cli", "command line"),
    ("elastica_cad.web", "the page"),
    ("elastica_cad.kit", "a folder of files for a strip or a model"),
    ("elastica_cad.files", "format by file name"),
    ("elastica_cad.plot", "pictures (matplotlib)"),
    ("elastica_cad.build123d", "objects for build123d"),
    ("elastica_cad.cadquery", "functions for CadQuery"),
    ("elastica_cad.kernel", "OpenCASCADE"),
    ("elastica_cad.design", "design files, reports"),
    ("elastica_cad.model", "several strips"),
    ("elastica_cad.pairs", "two rest shapes"),
    ("elastica_cad.paper", "the paper's own"),
    ("elastica_cad.formats", "files in and out"),
    ("elastica_cad.strip", "flat parts and bodies"),
    ("elastica_cad.form_finding", "curves that can be made"),
    ("elastica_cad.mechanics", "rods"),
    ("elastica_cad.geometry", "curves and paths"),
)
"""From top to bottom: each package imports only from those below it (a contract in pyproject.toml)."""

BESIDE = {"plot", "build123d", "cadquery", "kernel"}
"""Packages that share a line of the drawing with the one before."""

DIVIDED = ("geometry", "mechanics", "form_finding", "strip", "formats", "model", "pairs", "design", "paper")
"""Packages that are drawn with their modules."""

WAY = {
    1: ("cli", "options and file names become one request"),
    2: ("formats.dxf_curves", "the drawing is read: splines stay splines"),
    3: ("strip.strip_spec", "the request, a StripSpec, is made"),
    4: ("mechanics.equilibrium_check", "Theorem 1: can it be bent, and if not, where"),
    5: ("form_finding.nearest_search", "if the curve may change: the nearest within limits"),
    6: ("mechanics.least_ratio", "the stiffness with the least ratio"),
    7: ("mechanics.rod", "the rod: shape, stiffness, moment and force"),
    8: ("strip.drawing", "stiffness is width: outline, marks, kerf"),
    9: ("formats.drawing_files", "DXF and SVG"),
    10: ("kernel", "STEP"),
    11: ("design.reports", "the report"),
    12: ("plot", "the picture"),
}
"""The path of a curve through `elastica strip`: number, place, what happens there."""

BOX = 174, 34
GAP = 8
MOST_IN_LINE = 8
"""Parts beside each other: a screen's width."""
PAPER, INK, FLOOR, ROOM, MARKED = "#ffffff", "#222222", "#f1efe9", "#ffffff", "#c8553d"


def modules() -> dict[str, Path]:
    """Every module's file, by its dotted name; a package stands for its `__init__.py`."""
    found = {}
    for package, folder in ROOTS.items():
        for file in sorted(folder.rglob("*.py")):
            parts = (package, *file.relative_to(folder).with_suffix("").parts)
            found[".".join(parts).removesuffix(".__init__")] = file
    return found


def absolute(node: ast.ImportFrom, name: str, is_package: bool) -> str:
    """What `from X import ...` names as X in the module called `name`, dots resolved."""
    if not node.level:
        return node.module or ""
    parents = name.split(".") if is_package else name.split(".")[:-1]
    kept = parents[: len(parents) - node.level + 1]
    return ".".join([*kept, *([node.module] if node.module else [])])


@cache
def imported(name: str, file: Path) -> tuple[tuple[str, str], ...]:
    """(module, name) of every import statement of a module: at the top, in functions, for types."""
    found = []
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found += [(alias.name, "") for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            home = absolute(node, name, file.name == "__init__.py")
            found += [(home, alias.name) for alias in node.names]
    return tuple(found)


@cache
def imports() -> dict[str, set[str]]:
    """The modules of this project that each of them imports."""
    known = modules()
    graph = {}
    for name, file in known.items():
        targets = {f"{a}.{b}" if f"{a}.{b}" in known else a for a, b in imported(name, file)}
        graph[name] = (targets & known.keys()) - {name}
    return graph


def circles(graph: dict[str, set[str]]) -> list[tuple[str, ...]]:
    """Groups of nodes that reach each other (strongly connected components of more than one)."""
    reach = {name: set(targets) for name, targets in graph.items()}
    for through in graph:
        for name in graph:
            if through in reach[name]:
                reach[name] |= reach[through]
    on_circles = [name for name in graph if name in reach[name]]
    return sorted(
        {tuple(sorted(b for b in on_circles if b in reach[a] and a in reach[b])) for a in on_circles}
    )


def ranks(graph: dict[str, set[str]]) -> dict[str, int]:
    """How many steps of import lie below each node; on a circle there is no such order."""
    if found := circles(graph):
        raise SystemExit(f"no plan can be drawn: these import each other: {found}")
    order: dict[str, int] = {}
    while len(order) < len(graph):
        ready = [name for name in graph if name not in order and graph[name] <= order.keys()]
        order |= {name: 1 + max((order[target] for target in graph[name]), default=-1) for name in ready}
    return order


def parts_of(floor: str) -> dict[str, set[str]]:
    """The parts of a package (sub-packages and single modules) and those of them that each imports."""
    inside: dict[str, set[str]] = {}
    depth = floor.count(".") + 1
    for name, targets in imports().items():
        if name.startswith(floor + "."):
            room = name.split(".")[depth]
            others = {t.split(".")[depth] for t in targets if t.startswith(floor + ".")}
            inside.setdefault(room, set()).update(others - {room})
    return inside


def box(x: float, y: float, text: str, number: int | None = None, *, wide: float = BOX[0]) -> str:
    """A named box at its upper left corner, with a number where the way passes."""
    marked = f'stroke="{MARKED}" stroke-width="2"' if number else f'stroke="{INK}" stroke-width="0.8"'
    parts = [
        f'<rect x="{x:g}" y="{y:g}" width="{wide:g}" height="{BOX[1]}" rx="4" fill="{ROOM}" {marked}/>',
        f'<text x="{x + wide / 2:g}" y="{y + BOX[1] / 2 + 4:g}" text-anchor="middle">{escape(text)}</text>',
    ]
    if number:
        parts += [
            f'<circle cx="{x + 2:g}" cy="{y + 2:g}" r="9" fill="{MARKED}"/>',
            f'<text x="{x + 2:g}" y="{y + 6:g}" text-anchor="middle" fill="{PAPER}" font-size="11">{number}</text>',
        ]
    return "\n".join(parts)


def page(width: float, height: float, parts: list[str]) -> str:
    """An SVG file of that size."""
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" width="{width:g}" '
        f'height="{height:g}" font-family="sans-serif" font-size="12.5" fill="{INK}">'
    )
    return "\n".join([head, f'<rect width="100%" height="100%" fill="{PAPER}"/>', *parts, "</svg>\n"])


def packages() -> str:
    """All packages, their parts in the order of their imports, and the way of a curve in numbers."""
    numbers = {room: number for number, (room, _) in WAY.items()}
    left, top, y = 190, 20, 20.0
    parts, widest = [], 0.0
    line: list[tuple[str, str]] = []
    lines = []
    for floor, idea in FLOORS:
        if floor.rpartition(".")[2] in BESIDE and line:
            line.append((floor, idea))
        else:
            line = [(floor, idea)]
            lines.append(line)
    for line in lines:
        x, tallest = 12.0, 0
        for floor, idea in line:
            short = floor.rpartition(".")[2]
            inside = ranks(parts_of(floor)) if short in DIVIDED else {}
            names = sorted(inside, key=lambda name: (inside[name], name))
            rows = -(-len(names) // MOST_IN_LINE) or 1
            size = left - 30 + min(len(names), MOST_IN_LINE) * (BOX[0] + GAP) if names else left + 60
            height = rows * (BOX[1] + GAP) + 10
            tallest = max(tallest, height)
            parts.append(
                f'<rect x="{x:g}" y="{y:g}" width="{size:g}" height="{height}" rx="6" fill="{FLOOR}"/>'
            )
            if short in numbers:
                parts.append(box(x + 8, y + 9, short, numbers[short], wide=size - 16))
            else:
                parts.append(
                    f'<text x="{x + 10:g}" y="{y + 23:g}" font-weight="bold">{short}</text>'
                    f'<text x="{x + 10:g}" y="{y + 39:g}" font-size="10">{escape(idea)}</text>'
                )
            for i, name in enumerate(names):
                row, column = divmod(i, MOST_IN_LINE)
                at = x + left - 24 + column * (BOX[0] + GAP), y + 9 + row * (BOX[1] + GAP)
                parts.append(box(*at, name, numbers.get(f"{short}.{name}")))
            x += size + GAP
        widest = max(widest, x)
        y += tallest + GAP
    for number, (room, text) in WAY.items():
        column, row = divmod(number - 1, 6)
        parts.append(
            f'<text x="{14 + 560 * column}" y="{y + 20 + 18 * row:g}">{number}. {room}: {escape(text)}</text>'
        )
    return page(widest + 4, y + top + 6 * 18, parts)


def title(file: Path) -> str:
    """The first paragraph of a module, or the first comment of a script of the page."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".js":
        return text.partition("\n")[0].removeprefix("// ")
    paragraph = (ast.get_docstring(ast.parse(text)) or "").partition("\n\n")[0]
    return " ".join(paragraph.split()).replace("|", "\\|")


def reading_order() -> str:
    """The modules of every package, in the order of their imports, with the first paragraph of each."""
    files = modules()
    core, workbench = ROOTS.values()
    tables = {"top of elastica_cad": [file for file in sorted(core.glob("*.py")) if file.stem[:2] != "__"]}
    for floor, _ in reversed(FLOORS):
        inside = ranks(parts_of(floor))
        names = sorted(inside, key=lambda name: (inside[name], name))
        tables[floor.partition(".")[2]] = [files[f"{floor}.{name}"] for name in names]
    tables["web/page"] = sorted((core / "web" / "page").glob("*.js"))
    for folder in sorted({file.parent for file in workbench.rglob("*.py")}):
        inside = [file for file in sorted(folder.glob("*.py")) if file.stem != "__init__"]
        tables[f"elastica_wb/{folder.relative_to(workbench)}".removesuffix("/.")] = inside
    lines = []
    for name, found in tables.items():
        if found:
            lines += [f"\n### {name}\n\n| module | what it holds |", "| --- | --- |"]
            lines += [
                f"| `{file.parent.name if file.stem == '__init__' else file.stem}` | {title(file)} |"
                for file in found
            ]
    return "\n".join(lines) + "\n"


def with_reading_order(page: str) -> str:
    """The page with the list of modules between its two marks made anew."""
    begin, end = "<!-- modules: made by docs/plan.py -->\n", "<!-- end of modules -->"
    before, _, rest = page.partition(begin)
    return before + begin + reading_order() + "\n" + end + rest.partition(end)[2]


def folder_plan(folder: str) -> str:
    """The modules of one folder; every arrow leads from an importing module to one at its left."""
    prefix = folder.strip("/").replace("freecad_workbench/freecad/", "freecad.").replace("/", ".")
    names = {name for name in modules() if name.rpartition(".")[0] == prefix}
    graph = {name: targets & names for name, targets in imports().items() if name in names}
    rank = ranks(graph)
    columns: dict[int, list[str]] = {}
    for name in sorted(names):
        columns.setdefault(rank[name], []).append(name)
    wide = 8.0 * max(len(name.rpartition(".")[2]) for name in names) + 20
    place = {
        name: (20 + column * (wide + 60), 20 + i * (BOX[1] + 26))
        for column, members in columns.items()
        for i, name in enumerate(members)
    }
    half = BOX[1] / 2
    ends = [(place[a], place[b]) for a, targets in graph.items() for b in sorted(targets)]
    arrows = [
        f'<path d="M {a[0]:g} {a[1] + half:g} L {b[0] + wide:g} {b[1] + half:g}" stroke="{INK}" '
        'stroke-width="0.9" fill="none" marker-end="url(#to)"/>'
        for a, b in ends
    ]
    head = (
        '<marker id="to" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        f'<path d="M 0 0 L 8 4 L 0 8 z" fill="{INK}"/></marker>'
    )
    boxes = [box(*place[name], name.rpartition(".")[2], wide=wide) for name in sorted(names)]
    width = max(x for x, _ in place.values()) + wide + 20
    height = max(y for _, y in place.values()) + BOX[1] + 20
    return page(width, height, [head, *arrows, *boxes])


def main(arguments: list[str]) -> None:
    """Draw all packages, or the folders named."""
    for folder in arguments:
        target = Path(folder.strip("/").replace("/", "-") + ".svg")
        target.write_text(folder_plan(folder), encoding="utf-8")
        print(target)
    if not arguments:
        target = ROOT / "docs" / "plan.svg"
        target.write_text(packages(), encoding="utf-8")
        architecture = ROOT / "docs" / "architecture.md"
        architecture.write_text(
            with_reading_order(architecture.read_text(encoding="utf-8")), encoding="utf-8"
        )
        print(target, architecture, sep="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
