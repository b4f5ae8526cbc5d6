# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Curves that strips follow: drawn in sketches, cut out of bodies, pulled by handles."""
