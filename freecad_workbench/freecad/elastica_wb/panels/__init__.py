# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Task panels. Their .ui files have the names of the modules."""
