"""The same bytes for the same STEP file, whatever order a kernel's hash tables had."""

import re
from itertools import count

_OCCURRENCE = re.compile(rb"NEXT_ASSEMBLY_USAGE_OCCURRENCE\('\d+'(.*?\);)", re.DOTALL)
_STYLES = re.compile(
    rb"#\d+ = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION\(.*(?=ENDSEC;)", re.DOTALL
)
_ENTITY = re.compile(rb"#(\d+) = (.*?);\n", re.DOTALL)
_REFERENCE = re.compile(rb"#(\d+)")
_FOLD = re.compile(rb"\n\s*")


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
    return b"".join(
        b"#%d = %s;\n"
        % (new, _REFERENCE.sub(lambda found: b"#%d" % order.get(int(found[1]), int(found[1])), entities[old]))
        for old, new in order.items()
    )
