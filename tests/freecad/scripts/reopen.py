"""Files of earlier versions in a FreeCAD with a window: shapes, looks, a recompute of everything."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import answers, run, wait


def work():
    for file in sorted(Path(os.environ["ELASTICA_TEST_FILES"]).glob("*.FCStd")):
        document = App.openDocument(str(file))
        wait(300)
        ours = [obj for obj in document.Objects if getattr(obj, "Proxy", None) is not None]
        before = {obj.Name: obj.Shape.Volume for obj in ours}
        for obj in ours:
            obj.touch()
        document.recompute()
        wait(100)
        answers[file.stem] = {
            obj.Name: {
                "proxy": f"{type(obj.Proxy).__module__}.{type(obj.Proxy).__name__}",
                "view": f"{type(obj.ViewObject.Proxy).__module__}.{type(obj.ViewObject.Proxy).__name__}",
                "icon": Path(obj.ViewObject.Proxy.getIcon()).exists(),
                "state": obj.State,
                "said": obj.getStatusString() if "Invalid" in obj.State else "",
                "volumes": (before[obj.Name], obj.Shape.Volume),
            }
            for obj in ours
        }
        App.closeDocument(document.Name)
        Gui.updateGui()


run(work)
