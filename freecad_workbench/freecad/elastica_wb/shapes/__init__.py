# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Kernel-neutral records as shapes of FreeCAD's Part."""
