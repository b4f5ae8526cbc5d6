# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Previews in the 3D view, before objects are added to the document."""
