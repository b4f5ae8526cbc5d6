"""What an element of SVG is called, what it links to, and lengths as SVG writes them."""

import re
from xml.etree import ElementTree

from elastica_cad.formats.curve_files.number_gate import NUMBER
from elastica_cad.formats.file_access.source_file import MILLIMETRES

LENGTH = re.compile(rf"\s*({NUMBER})\s*(px|pt|pc|mm|cm|in|[qQ])?\s*")
MM = {"pc": 25.4 / 6, "q": 0.25} | {unit: MILLIMETRES[unit] for unit in ("px", "pt", "mm", "cm", "in")}
_LINKS = ("href", "{http://www.w3.org/1999/xlink}href")


def tag(element: ElementTree.Element) -> str:
    """Its name without that of its namespace."""
    return str(element.tag).rpartition("}")[2]


def linked_id(element: ElementTree.Element) -> str:
    """The id in this file that it refers to; "" without one."""
    link = next((text for name in _LINKS if (text := element.get(name))), "")
    return link[1:] if link.startswith("#") else ""


def unlink(element: ElementTree.Element) -> None:
    """Take the link off a clone."""
    for name in _LINKS:
        element.attrib.pop(name, None)
