# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What a panel shows in the view before it is in the document."""
