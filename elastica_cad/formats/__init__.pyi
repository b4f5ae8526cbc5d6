from elastica_cad.formats.chains import JOIN_TOLERANCE as JOIN_TOLERANCE
from elastica_cad.formats.curve_writer import write_curves as write_curves
from elastica_cad.formats.drawing_files import (
    DRAWING_SUFFIXES as DRAWING_SUFFIXES,
    encode_svg as encode_svg,
    write_drawing as write_drawing,
)
from elastica_cad.formats.drawing_style import (
    CURVES as CURVES,
    LayerStyle as LayerStyle,
    style_layers as style_layers,
)
from elastica_cad.formats.dxf_drawing import DXF_VERSIONS as DXF_VERSIONS, encode_dxf as encode_dxf
from elastica_cad.formats.json_curves import curve_record as curve_record, curves_json as curves_json
from elastica_cad.formats.mesh_files import read_mesh as read_mesh
from elastica_cad.formats.write_files import (
    check_target as check_target,
    write_atomically as write_atomically,
    write_together as write_together,
)
