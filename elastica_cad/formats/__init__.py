"""Files in and out: curve readers, drawings, reports."""

from elastica_cad.formats.chains import FIT_TOLERANCE, JOIN_TOLERANCE
from elastica_cad.formats.dxf_curves import read_dxf_curves
from elastica_cad.formats.json_curves import curve_record, curves_json, read_json_curves
from elastica_cad.formats.point_files import read_csv_curves, read_text_curves
from elastica_cad.formats.svg_curves import read_svg_curves

__all__ = [
    "FIT_TOLERANCE",
    "JOIN_TOLERANCE",
    "curve_record",
    "curves_json",
    "read_csv_curves",
    "read_dxf_curves",
    "read_json_curves",
    "read_svg_curves",
    "read_text_curves",
]
