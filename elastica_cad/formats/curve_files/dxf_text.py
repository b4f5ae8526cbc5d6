"""What is asked of a DXF file before its entities are expanded: how many there are, and how many digits."""

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from elastica_cad.errors import InputError
from elastica_cad.formats.curve_files.number_gate import MOST_SHAPES, check_count, half_last_place

if TYPE_CHECKING:
    from ezdxf.document import Drawing

DEEPEST_BLOCK = 20  # blocks within blocks: deeper ones are a slip or an attack

ODDITIES = (ValueError, TypeError, LookupError, AttributeError, ArithmeticError, AssertionError)
"""What ezdxf meets in entities that break off or are overwritten in places."""

_PLACES = re.compile(rb"^[ \t]*(?:1[0-8]|2[0-8]|40)[ \t]*\r?\n[ \t]*([-+0-9.eE]+)[ \t]*\r?$", re.MULTILINE)
_SECTION = re.compile(rb"^[ \t]*2[ \t]*\r?\n[ \t]*(BLOCKS|ENTITIES)[ \t]*\r?$", re.MULTILINE)
_MOST_NUMBERS = 20_000  # whose digits are looked at
_COUNTLESS = 10**9  # insertions: counting stops there


def dxf_rounding(path: Path) -> float:
    """Half a unit of the last digit of the coordinates (group codes 10 to 28, 40) of the entities; 0 where none."""
    data = path.read_bytes()
    if data.startswith(b"AutoCAD Binary DXF"):
        return 0.0
    sections = list(_SECTION.finditer(data))
    found: list[str] = []
    for section in reversed(sections):  # the entities before the blocks
        begin, end = section.end(), data.find(b"ENDSEC", section.end())
        for match in _PLACES.finditer(data, begin, len(data) if end < 0 else end):
            found.append(match[1].decode("ascii"))
            if len(found) >= _MOST_NUMBERS:
                break
    return half_last_place(found)


def refuse_many_inserts(document: "Drawing") -> None:
    """Refuse a drawing whose blocks, inserted as often as it says, come to more entities than are read."""
    known: dict[str, int] = {}
    total = _count(document, document.modelspace(), known, 0)
    check_count(
        total,
        MOST_SHAPES,
        "entities, those of its blocks counted",
        "leave out blocks, or explode one of them",
    )


def _count(document: "Drawing", layout: Any, known: dict[str, int], depth: int) -> int:
    """Entities of a layout, blocks expanded; never more than a billion."""
    if depth > DEEPEST_BLOCK:
        raise InputError(f"blocks are nested more than {DEEPEST_BLOCK} deep: explode them before export")
    from ezdxf.lldxf.const import DXFError

    total = 0
    for entity in layout:
        if entity.dxftype() != "INSERT":
            total += 1
            continue
        name = str(entity.dxf.get("name", "")) if entity.dxf.is_supported("name") else ""
        if name not in known:
            block = document.blocks.get(name)
            known[name] = 0 if block is None else _count(document, block, known, depth + 1)
        try:
            times = max(1, int(entity.dxf.get("row_count", 1))) * max(
                1, int(entity.dxf.get("column_count", 1))
            )
        except (*ODDITIES, DXFError):
            times = 1
        total = min(total + times * max(1, known[name]), _COUNTLESS)
    return total
