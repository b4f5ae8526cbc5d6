# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How the workbench sits in FreeCAD: Qt, preferences, units, words, progress, refusals."""
