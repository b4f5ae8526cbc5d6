# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Task panels; their widgets are .ui files named as the modules."""
