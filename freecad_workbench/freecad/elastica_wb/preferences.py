"""The user's preferences, with the values that hold until he changes them."""

from typing import Any

import FreeCAD as App

__all__ = ["DEFAULTS", "PATH", "default_sheet", "get", "put"]

PATH = "User parameter:BaseApp/Preferences/Mod/Elastica"

DEFAULTS: dict[str, Any] = {
    "DefaultSheet": "birch-plywood-0.8",
    "MaxWidth": 30.0,
    "TabLength": 10.0,
    "Kerf": 0.0,
    "Clearance": 0.1,
    "DxfVersion": "R2010",
    "Curves": "spline",
    "Tolerance": 0.02,
    "LiveMode": True,
    "LiveNearest": True,
}
"""Name of every preference and what holds until it is changed; the type is the default's."""


def get(name: str) -> Any:
    """The value of a preference."""
    default, group = DEFAULTS[name], App.ParamGet(PATH)
    if isinstance(default, bool):
        return group.GetBool(name, default)
    return group.GetFloat(name, default) if isinstance(default, float) else group.GetString(name, default)


def put(name: str, value: Any) -> None:
    """Change a preference."""
    group = App.ParamGet(PATH)
    if isinstance(DEFAULTS[name], bool):
        group.SetBool(name, bool(value))
    elif isinstance(DEFAULTS[name], float):
        group.SetFloat(name, float(value))
    else:
        group.SetString(name, str(value))


def default_sheet() -> str:
    """The sheet that new strips are made of; a known one even when the preference names none."""
    from freecad.elastica_wb.library import sheet_list

    name = get("DefaultSheet")
    return name if name in sheet_list() else DEFAULTS["DefaultSheet"]
