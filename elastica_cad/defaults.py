"""Default values and usual limits of strips, holders, cutting files and commands. Lengths in mm."""

SHEET = "birch-plywood-0.8"
"""Sheet of a new strip in FreeCAD and in the notebook."""

MAX_WIDTH = 30.0
"""Largest width of a new strip in FreeCAD and in the notebook."""

UNKNOWN_WIDTH = 40.0
"""Widest place of a strip whose width is unknown, where a drawn curve is judged."""

RATIO = 3.5
"""Largest stiffness ratio, widest to narrowest place, where a curve may be changed to meet it."""

CUTTABLE_RATIO = 9.5
"""Stiffness ratio of a strip 30 mm wide that can just be cut at its narrowest place."""

UNLIMITED_RATIO = 1000.0
"""Stiffness ratio where no limit is given: 0.1 mm beside 100 mm, which no machine cuts."""

TAB_LENGTH = 10.0
"""Length of a tab."""

RING_TAB_LENGTH = 8.0
"""Length of a tab that is held by a ring: through 3 mm, with room for glue."""

KERF = 0.0
"""Kerf that cutting files are corrected for: none, as many cutting services correct for their own."""

LASER_KERF = 0.2
"""Width of a laser's cut, for a part with two rest shapes of a sheet without a kerf of its own."""

CLEARANCE = 0.1
"""Added to the thickness of a sheet in the slot that takes it."""

PLAY = 0.3
"""Clearance beside a tab in its slot on either side; it is small, since tabs may be close to each other."""

BORDER = 8.0
"""Width of material beside slots and seats of a plate."""

BASE_PLAY, BASE_BORDER = 0.5, 12.0
"""The same of a base plate."""

POCKET_CLEARANCE = 0.15
"""Clearance around a tab in its printed pocket."""

NOT_REALIZABLE, BAD_INPUT, INTERRUPTED, OUTPUT_CLOSED = 1, 2, 130, 141
"""Exit codes of commands; the last two as shells have them: 128 and the number of the signal."""
