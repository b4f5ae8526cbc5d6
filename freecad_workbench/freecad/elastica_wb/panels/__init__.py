# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Task panels. If a panel has a .ui file, the file has the name of the panel's module."""
