from elastica_cad.plot.canvas import save_figure as save_figure
from elastica_cad.plot.strip_pictures import (
    drawing as drawing,
    rod as rod,
    strip as strip,
    strip_sheet as strip_sheet,
)
from elastica_cad.plot.bow_picture import bow as bow
from elastica_cad.plot.check_picture import check as check
from elastica_cad.plot.model_pictures import bodies as bodies, model as model
from elastica_cad.plot.strip_pictures import travel as travel
from elastica_cad.plot.assembly_sheet import save_assembly_sheet as save_assembly_sheet
from elastica_cad.plot.template_pages import save_template as save_template
