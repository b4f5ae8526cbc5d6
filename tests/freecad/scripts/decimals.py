"""Numbers typed with a comma and with a point, where numbers are written with a comma."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from inside import ARCH, answers, begun, button, open_panel, panel, run, sketch, typed, window


def work():
    from freecad.elastica_wb.host.fields import value_of

    window()
    document = begun("Decimals")
    open_panel("Elastica_Strip", sketch(document, ARCH, poles=False))
    for words in ("12,5", "12.5"):
        typed("MaxWidth", words)
        answers[words] = [panel().form.MaxWidth.text(), panel().object.MaxWidth.Value]
    button()
    open_panel("Elastica_Bend", document.Strip)
    typed("EndAngle", "0.5")
    answers["angle"] = value_of(panel().form.EndAngle)
    button("Cancel")


run(work)
