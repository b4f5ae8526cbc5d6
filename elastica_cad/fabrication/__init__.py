"""What is cut and printed: drawings, lettering, kerf, strips."""

from elastica_cad.fabrication.base import BasePlate, base_plate
from elastica_cad.fabrication.boundary import Frame
from elastica_cad.fabrication.colors import sheet_color
from elastica_cad.fabrication.coupon import coupon_drawing, coupon_overhang, reference_bar
from elastica_cad.fabrication.cutlist import CutList, CutListRow, cut_list
from elastica_cad.fabrication.drawing import CUT_INNER, CUT_OUTER, ENGRAVE, LAYERS, MARK, Drawing, LayeredPath
from elastica_cad.fabrication.ends import Hole, Tab, TSlot
from elastica_cad.fabrication.fixtures import EndFixture, end_fixtures
from elastica_cad.fabrication.frames import Rib, SlottedFrame, slotted_frame
from elastica_cad.fabrication.held import HeldTab
from elastica_cad.fabrication.holding import HoldingTabs, with_holding_tabs
from elastica_cad.fabrication.interlock import Joint, slot_width
from elastica_cad.fabrication.kerf import with_kerf
from elastica_cad.fabrication.lamination import Laminated
from elastica_cad.fabrication.lettering import Text, text_strokes, text_width
from elastica_cad.fabrication.model import Model, Part, Placed
from elastica_cad.fabrication.nesting import NestedSheet, nested
from elastica_cad.fabrication.perforation import Perforated
from elastica_cad.fabrication.pieces import Piece
from elastica_cad.fabrication.prisms import PrismSolid
from elastica_cad.fabrication.revolution import revolution, revolved
from elastica_cad.fabrication.rings import Ring, ring_plate
from elastica_cad.fabrication.slot_effects import SlotEffect
from elastica_cad.fabrication.slots import Slot
from elastica_cad.fabrication.solids import BentSolid, FlatSolid
from elastica_cad.fabrication.strip import Layer, Reactions, Strip
from elastica_cad.fabrication.styles import Plain
from elastica_cad.fabrication.touching import touching

__all__ = [
    "CUT_INNER",
    "CUT_OUTER",
    "ENGRAVE",
    "LAYERS",
    "MARK",
    "BasePlate",
    "BentSolid",
    "CutList",
    "CutListRow",
    "Drawing",
    "EndFixture",
    "FlatSolid",
    "Frame",
    "HeldTab",
    "HoldingTabs",
    "Hole",
    "Joint",
    "Laminated",
    "Layer",
    "LayeredPath",
    "Model",
    "NestedSheet",
    "Part",
    "Perforated",
    "Piece",
    "Placed",
    "Plain",
    "PrismSolid",
    "Reactions",
    "Rib",
    "Ring",
    "Slot",
    "SlotEffect",
    "SlottedFrame",
    "Strip",
    "TSlot",
    "Tab",
    "Text",
    "base_plate",
    "coupon_drawing",
    "coupon_overhang",
    "cut_list",
    "end_fixtures",
    "nested",
    "reference_bar",
    "revolution",
    "revolved",
    "ring_plate",
    "sheet_color",
    "slot_width",
    "slotted_frame",
    "text_strokes",
    "text_width",
    "touching",
    "with_holding_tabs",
    "with_kerf",
]
