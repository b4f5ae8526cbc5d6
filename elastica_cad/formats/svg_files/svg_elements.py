"""Lengths as SVG writes them."""

import re

from elastica_cad.formats.curve_files.number_gate import NUMBER
from elastica_cad.formats.file_access.source_file import MILLIMETRES

LENGTH = re.compile(rf"\s*({NUMBER})\s*(px|pt|pc|mm|cm|in|[qQ])?\s*")
MM = {"pc": 25.4 / 6, "q": 0.25} | {unit: MILLIMETRES[unit] for unit in ("px", "pt", "mm", "cm", "in")}
