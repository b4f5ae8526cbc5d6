"""A FreeCAD without the workbench opens a file with strips and shows their shapes."""

import json
import os
import traceback
from pathlib import Path

import FreeCAD as App

OUT = Path(os.environ["ELASTICA_TEST_OUT"])
answers = {}
try:
    document = App.openDocument(os.environ["ELASTICA_TEST_FILE"])
    answers["volumes"] = {name: document.getObject(name).Shape.Volume for name in ("Strip", "Flat")}
    try:
        import freecad.elastica_wb
    except ImportError:
        answers["workbench"] = False
    else:
        answers["workbench"] = freecad.elastica_wb.__file__
    document.saveAs(str(OUT / "again.FCStd"))
except BaseException:
    answers["error"] = traceback.format_exc()
(OUT / "answers.json").write_text(json.dumps(answers))
os._exit(0)
