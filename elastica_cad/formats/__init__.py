"""Files in and out: curve readers, drawings, reports."""

from elastica_cad.formats.chains import FIT_TOLERANCE, JOIN_TOLERANCE
from elastica_cad.formats.curve_files import write_curves
from elastica_cad.formats.cutting import DRAWING_SUFFIXES, write_drawing
from elastica_cad.formats.design import Design, read_design
from elastica_cad.formats.dxf import DXF_VERSIONS, dxf_bytes, write_dxf
from elastica_cad.formats.dxf_curves import read_dxf_curves
from elastica_cad.formats.json_curves import curve_record, curves_json, read_json_curves, write_json_curves
from elastica_cad.formats.layers import LayerStyle, layer_styles
from elastica_cad.formats.meshes import read_mesh
from elastica_cad.formats.model_report import MODEL_SCHEMA, model_report
from elastica_cad.formats.output import checked_target, write_atomically
from elastica_cad.formats.point_files import read_csv_curves, read_text_curves
from elastica_cad.formats.report import REPORT_SCHEMA, check_report, strip_report
from elastica_cad.formats.shaping import CURVES
from elastica_cad.formats.svg import svg_bytes, write_svg
from elastica_cad.formats.svg_curves import read_svg_curves
from elastica_cad.formats.together import files_together

__all__ = [
    "CURVES",
    "DRAWING_SUFFIXES",
    "DXF_VERSIONS",
    "FIT_TOLERANCE",
    "JOIN_TOLERANCE",
    "MODEL_SCHEMA",
    "REPORT_SCHEMA",
    "Design",
    "LayerStyle",
    "check_report",
    "checked_target",
    "curve_record",
    "curves_json",
    "dxf_bytes",
    "files_together",
    "layer_styles",
    "model_report",
    "read_csv_curves",
    "read_design",
    "read_dxf_curves",
    "read_json_curves",
    "read_mesh",
    "read_svg_curves",
    "read_text_curves",
    "strip_report",
    "svg_bytes",
    "write_atomically",
    "write_curves",
    "write_drawing",
    "write_dxf",
    "write_json_curves",
    "write_svg",
]
