# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Integration in FreeCAD: Qt, preferences, units, words, progress, errors."""
