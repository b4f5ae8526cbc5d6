"""Default values and usual limits of strips, holders, cutting files and commands. Lengths are in mm."""

SHEET = "birch-plywood-0.8"
"""Sheet of a new strip in FreeCAD and in the notebook."""

MAX_WIDTH = 30.0
"""Largest width of a new strip in FreeCAD and in the notebook."""

UNKNOWN_WIDTH = 40.0
"""Largest width that is assumed for a strip of unknown width."""

RATIO = 3.5
"""Largest stiffness ratio (largest over least stiffness of the strip) if the curve may be changed."""

UNLIMITED_RATIO = 1000.0
"""Largest stiffness ratio if no limit is given. The widths of such a strip, for example 0.1 and 100 mm,
cannot be made."""

TAB_LENGTH = 10.0

RING_TAB_LENGTH = 8.0
"""Length of a tab in a ring: 3 mm for the ring, and the rest for glue."""

KERF = 0.0
"""Kerf for which cutting files are corrected. It is 0, because many cutting services correct their kerf."""

STROKE = 0.1
"""Width of the lines of an SVG file."""

LASER_KERF = 0.2
"""Kerf for a two-state part of a sheet with unknown kerf."""

CLEARANCE = 0.1
"""Width of a slot minus the thickness of the sheet in it."""

PLAY = 0.3
"""Clearance on each side of a tab in its slot. It is small, because tabs may be close to each other."""

BORDER = 8.0
"""Width of material beside the slots of a plate, and beside the outlines of a ring to which tabs are glued."""

BASE_PLAY, BASE_BORDER = 0.5, 12.0
"""Clearance on each side of a tab in a base plate, and width of material beside its slots."""

POCKET_CLEARANCE = 0.15
"""Clearance around a tab in its printed pocket."""

NOT_REALIZABLE, BAD_INPUT, INTERRUPTED, OUTPUT_CLOSED = 1, 2, 130, 141
"""Exit codes of commands. The last two codes are 128 plus the number of the signal, as in shells."""
