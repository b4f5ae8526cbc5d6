# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Names of properties, derived from the keys of a design file."""

NAMES = {
    "style.width": "OuterWidth", "style.corner_radius": "HoleRadius", "style.sides": "HoleSides",
    "seam_position": "Joint", "ignore_limits": "Anyway", "label": "EngravedText", "limits": "Follow",
    "limits.keep_out": "KeepOut", "limits.stiffness_bounds": "StiffnessBounds",
}  # fmt: skip
"""Properties whose names do not follow from their keys. Users' files contain these names."""


def name_of(path: str) -> str:
    """Return the property of a key, such as MaxWidth, RatioLimit or KeepLength."""
    if path in NAMES:
        return NAMES[path]
    table, _, key = path.rpartition(".")
    name = key.title().replace("_", "")
    if table == "limits":
        return f"{name}Limit"
    return f"Keep{name}" if table == "keep" else name
