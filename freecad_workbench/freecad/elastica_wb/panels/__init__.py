# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Task panels. The .ui file of a panel has the name of its module."""
