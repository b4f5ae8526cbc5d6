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

KINDS = {bool: "Bool", float: "Float", str: "String"}
"""Ends of the names of FreeCAD's methods for preferences, by type."""

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
    return getattr(group, f"Get{KINDS[type(default)]}")(name, default)


def put(name: str, value: Any) -> None:
    """Change the value of a preference."""
    kind, group = type(DEFAULTS[name]), App.ParamGet(PATH)
    if name in CHOICES:
        group.SetInt(name, CHOICES[name].index(value))
    else:
        getattr(group, f"Set{KINDS[kind]}")(name, kind(value))
