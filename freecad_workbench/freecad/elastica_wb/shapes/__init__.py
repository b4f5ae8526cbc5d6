# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Kernel-neutral records converted to shapes of FreeCAD's Part workbench."""
