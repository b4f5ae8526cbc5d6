"""The same bytes for the same STEP file, whatever order a kernel's hash tables had, and each point once."""

import re
from collections.abc import Mapping
from itertools import count

_OCCURRENCE = re.compile(rb"NEXT_ASSEMBLY_USAGE_OCCURRENCE\('\d+'(.*?\);)", re.DOTALL)
_STYLES = re.compile(
    rb"#\d+ = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION\(.*(?=ENDSEC;)", re.DOTALL
)
_ENTITY = re.compile(rb"#(\d+) = (.*?);\n", re.DOTALL)
_REFERENCE = re.compile(rb"#(\d+)")
_FOLD = re.compile(rb"\n\s*")
_GEOMETRY = (
    (b"CARTESIAN_POINT(", b"DIRECTION(", b"( GEOMETRIC_REPRESENTATION_CONTEXT(2)"),
    (b"VECTOR(", b"AXIS2_PLACEMENT_3D("),
    (
        b"LINE(", b"CIRCLE(", b"B_SPLINE_CURVE_WITH_KNOTS(", b"PLANE(", b"CYLINDRICAL_SURFACE(",
        b"CONICAL_SURFACE(", b"SPHERICAL_SURFACE(", b"TOROIDAL_SURFACE(", b"B_SPLINE_SURFACE_WITH_KNOTS(",
    ),
)  # fmt: skip
"""What is said once; each kind refers to those of the rows before its own alone."""


def canonical_step(content: bytes) -> bytes:
    """A STEP file with occurrences counted from 1 and colours in the order of the parts.

    OpenCASCADE counts occurrences on through the life of a process, and writes the colours, which end the
    file, in the order of addresses in memory.
    """
    numbers = count(1)
    counted = _OCCURRENCE.sub(
        lambda found: b"NEXT_ASSEMBLY_USAGE_OCCURRENCE('%d'%s" % (next(numbers), _FOLD.sub(b"", found[1])),
        content,
    )
    return _STYLES.sub(lambda found: _sorted_styles(found[0]), counted)


def _sorted_styles(styles: bytes) -> bytes:
    """The entities again, root after root and each followed by what it refers to."""
    entities = {int(number): _FOLD.sub(b"", text) for number, text in _ENTITY.findall(styles)}
    references = {n: [int(r) for r in _REFERENCE.findall(text)] for n, text in entities.items()}
    used = {r for found in references.values() for r in found}
    roots = [n for n in entities if n not in used]
    roots.sort(key=lambda n: [r for r in references[n] if r not in entities])
    order: dict[int, int] = {}
    waiting = roots[::-1]
    first = min(entities)
    while waiting:
        number = waiting.pop()
        if number in entities and number not in order:
            order[number] = first + len(order)
            waiting += references[number][::-1]
    return b"".join(b"#%d = %s;\n" % (new, _renamed(entities[old], order)) for old, new in order.items())


def with_shared_geometry(content: bytes) -> bytes:
    """A STEP file that says each point, direction, curve and surface once, however many faces refer to it.

    OpenCASCADE writes them anew for every face and edge: a third of a file without splines, and half of one with
    thousands of holes, whose edges stand on the walls' own points and in two faces' parameters.
    """
    start = content.index(b"DATA;") + len(b"DATA;")
    end = content.rindex(b"ENDSEC;")
    entities = {int(number): _FOLD.sub(b"", text) for number, text in _ENTITY.findall(content[start:end])}
    again: dict[int, int] = {}
    for kinds in _GEOMETRY:
        first: dict[bytes, int] = {}
        alike = [(number, text) for number, text in entities.items() if text.startswith(kinds)]
        for number, text in alike:
            entities[number] = _renamed(text, again)
            same = first.setdefault(entities[number], number)
            if same != number:
                again[number] = same
    kept = [number for number in entities if number not in again]
    order = {number: new for new, number in enumerate(kept, start=1)}
    order |= {number: order[same] for number, same in again.items()}
    lines = (b"#%d = %s;\n" % (order[n], _renamed(entities[n], order)) for n in kept)
    return b"".join([content[:start], b"\n", *lines, content[end:]])


def _renamed(text: bytes, names: Mapping[int, int]) -> bytes:
    """An entity that refers to others by other numbers."""
    return _REFERENCE.sub(lambda found: b"#%d" % names.get(int(found[1]), int(found[1])), text)
