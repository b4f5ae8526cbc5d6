# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Parametric objects.

These modules and classes must not be moved or renamed, because users' files contain their names.
"""
