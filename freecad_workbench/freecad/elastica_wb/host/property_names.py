# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The names of properties: each follows from the key of a design file."""

NAMES = {
    "style.width": "OuterWidth", "style.corner_radius": "HoleRadius", "style.sides": "HoleSides",
    "seam_position": "Joint", "ignore_limits": "Anyway", "label": "EngravedText", "limits": "Follow",
    "limits.keep_out": "KeepOut", "limits.stiffness_bounds": "StiffnessBounds",
}  # fmt: skip
"""Properties that are not called as their keys: users' files have these names."""


def name_of(path: str) -> str:
    """Return the property that holds a key: MaxWidth, RatioLimit, KeepLength."""
    if path in NAMES:
        return NAMES[path]
    table, _, key = path.rpartition(".")
    name = key.title().replace("_", "")
    if table == "limits":
        return f"{name}Limit"
    return f"Keep{name}" if table == "keep" else name
