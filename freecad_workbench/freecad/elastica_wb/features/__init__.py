# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Parametric objects. Users' files name these modules and classes: they are never moved or renamed."""
