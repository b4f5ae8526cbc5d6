from elastica_cad.formats.curve_files.chains import (
    JOIN_TOLERANCE as JOIN_TOLERANCE,
)
from elastica_cad.formats.curve_files.json_curves import (
    curve_record as curve_record,
    curves_json as curves_json,
)
from elastica_cad.formats.curve_files.write_curves import write_curves as write_curves
from elastica_cad.formats.design_files.design_file import Design as Design, read_design as read_design
from elastica_cad.formats.design_files.kit_spec import Cutting as Cutting
from elastica_cad.formats.drawing_files.drawing_style import CURVES as CURVES
from elastica_cad.formats.drawing_files.dxf_drawing import encode_dxf as encode_dxf
from elastica_cad.formats.drawing_files.dxf_drawing import DXF_VERSIONS as DXF_VERSIONS
from elastica_cad.formats.drawing_files.drawing_style import (
    LayerStyle as LayerStyle,
    style_layers as style_layers,
)
from elastica_cad.formats.drawing_files.svg_drawing import encode_svg as encode_svg
from elastica_cad.formats.drawing_files.write_drawing import (
    DRAWING_SUFFIXES as DRAWING_SUFFIXES,
    write_drawing as write_drawing,
)
from elastica_cad.formats.file_access.write_files import (
    check_target as check_target,
    write_atomically as write_atomically,
)
from elastica_cad.formats.file_access.write_files import write_together as write_together
from elastica_cad.formats.reports.check_report import report_check as report_check
from elastica_cad.formats.reports.model_report import (
    MODEL_SCHEMA as MODEL_SCHEMA,
    report_model as report_model,
)
from elastica_cad.formats.reports.strip_report import (
    REPORT_SCHEMA as REPORT_SCHEMA,
    report_strip as report_strip,
)
from elastica_cad.formats.surface_files.mesh_files import read_mesh as read_mesh
from elastica_cad.geometry.curve_editing.polylines import FIT_TOLERANCE as FIT_TOLERANCE
