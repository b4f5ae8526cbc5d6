"""The workbench as a user installs it: where its modules are, what it shows, and a strip."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import ARCH, QtWidgets, action_of, answers, run, sketch, window


def work():
    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    import freecad.elastica_wb as elastica
    from freecad.elastica_wb.host.resources import icon, load_panel

    import elastica_cad

    answers["places"] = [elastica.__file__, elastica_cad.__file__]
    answers["menu"] = action_of("Elastica_Strip").text().replace("&", "")
    answers["icon"] = Path(icon("Elastica_Strip")).is_file()
    answers["boxes"] = len(load_panel("check").findChildren(QtWidgets.QWidget))
    drawn = sketch(App.newDocument("Arch"), ARCH)
    answers["volume"] = elastica.make_strip(drawn, Sheet="birch-plywood-0.8", MaxWidth=20).Shape.Volume


run(work)
