"""mechanics"""

from elastica_cad.mechanics.gravity import Gravity
from elastica_cad.mechanics.sheet import Sheet, load_sheets, sheet_names

__all__ = ["Gravity", "Sheet", "load_sheets", "sheet_names"]
