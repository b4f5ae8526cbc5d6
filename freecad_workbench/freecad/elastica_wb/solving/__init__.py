# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""From a request to a strip and its shapes, each solved once."""
