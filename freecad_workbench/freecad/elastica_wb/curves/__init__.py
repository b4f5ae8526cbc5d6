# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Curves that strips follow: drawn curves, sections of bodies, and curves changed by handles."""
