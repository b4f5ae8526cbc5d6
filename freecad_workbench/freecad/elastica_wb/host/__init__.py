# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Integration in FreeCAD: Qt, preferences, units, translations, progress, errors."""
