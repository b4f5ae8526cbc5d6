# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Preferences of the user and their default values."""

from typing import Any

import FreeCAD as App

from elastica_cad.defaults import CLEARANCE, KERF, MAX_WIDTH, SHEET, TAB_LENGTH

PATH = "User parameter:BaseApp/Preferences/Mod/Elastica"

DEFAULTS: dict[str, Any] = {
    "DefaultSheet": SHEET,
    "MaxWidth": MAX_WIDTH,
    "TabLength": TAB_LENGTH,
    "Kerf": KERF,
    "Clearance": CLEARANCE,
    "DxfVersion": "R2010",
    "Curves": "spline",
    "Tolerance": 0.02,
    "LiveMode": True,
    "LiveNearest": True,
    "ExportFolder": "",
}
"""Default of every preference. Its type is the type of the preference."""

CHOICES = {
    "DxfVersion": ("R2010", "R12", "R2000", "R2004", "R2007", "R2013", "R2018"),
    "Curves": ("spline", "arc", "polyline"),
}
"""Choices in the order of the preferences page. FreeCAD stores the index of the choice."""


def get(name: str) -> Any:
    """Return the value of a preference."""
    default, group = DEFAULTS[name], App.ParamGet(PATH)
    if name in CHOICES:
        number = group.GetInt(name, CHOICES[name].index(default))
        return CHOICES[name][number] if 0 <= number < len(CHOICES[name]) else default
    if isinstance(default, bool):
        return group.GetBool(name, default)
    return group.GetFloat(name, default) if isinstance(default, float) else group.GetString(name, default)


def put(name: str, value: Any) -> None:
    """Change the value of a preference."""
    group = App.ParamGet(PATH)
    if name in CHOICES:
        group.SetInt(name, CHOICES[name].index(value))
    elif isinstance(DEFAULTS[name], bool):
        group.SetBool(name, bool(value))
    elif isinstance(DEFAULTS[name], float):
        group.SetFloat(name, float(value))
    else:
        group.SetString(name, str(value))
