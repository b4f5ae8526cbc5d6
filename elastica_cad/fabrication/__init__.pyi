from elastica_cad.fabrication.compensation import compensate_widths as compensate_widths
from elastica_cad.fabrication.drawings.cutting import (
    HoldingTabs as HoldingTabs,
    add_holding_tabs as add_holding_tabs,
)
from elastica_cad.fabrication.drawings.drawing import (
    CUT_INNER as CUT_INNER,
    CUT_OUTER as CUT_OUTER,
    Drawing as Drawing,
    ENGRAVE as ENGRAVE,
    LAYERS as LAYERS,
    LayeredPath as LayeredPath,
    MARK as MARK,
)
from elastica_cad.fabrication.drawings.cutting import compensate_kerf as compensate_kerf
from elastica_cad.fabrication.drawings.lettering import (
    Text as Text,
    text_strokes as text_strokes,
    text_width as text_width,
)
from elastica_cad.fabrication.model.material_colors import sheet_color as sheet_color
from elastica_cad.fabrication.holders.plates import BasePlate as BasePlate, base_plate as base_plate
from elastica_cad.fabrication.holders.end_fixtures import (
    EndFixture as EndFixture,
    end_fixtures as end_fixtures,
)
from elastica_cad.fabrication.holders.slotted_frame import add_feet as add_feet
from elastica_cad.fabrication.holders.placed_tab import PlacedTab as PlacedTab
from elastica_cad.fabrication.holders.plate_pairs import plate_pair as plate_pair, ring_pair as ring_pair
from elastica_cad.fabrication.holders.plates import Ring as Ring, ring_plate as ring_plate
from elastica_cad.fabrication.holders.held_tabs import (
    holder_plays as holder_plays,
    rocking_tabs as rocking_tabs,
)
from elastica_cad.fabrication.holders.slotted_frame import (
    Rib as Rib,
    SlottedFrame as SlottedFrame,
    slotted_frame as slotted_frame,
)
from elastica_cad.fabrication.holders.held_tabs import held_shapes as held_shapes, tab_seats as tab_seats
from elastica_cad.fabrication.measuring import Measuring as Measuring
from elastica_cad.fabrication.holding.expected_error import (
    MakingTolerance as MakingTolerance,
)
from elastica_cad.fabrication.holding.held_shape import HeldShape as HeldShape
from elastica_cad.fabrication.holding.held_shape import Reactions as Reactions
from elastica_cad.fabrication.holding.tab_seat import EndPose as EndPose, TabSeat as TabSeat
from elastica_cad.fabrication.interlocking.interlock import (
    Joint as Joint,
    interlock as interlock,
    slot_width as slot_width,
)
from elastica_cad.fabrication.flexure import Flexure as Flexure, FlexureTravel as FlexureTravel, Pad as Pad
from elastica_cad.fabrication.flexure_spec import FlexureSpec as FlexureSpec
from elastica_cad.fabrication.makeability.fabrication_limits import FabricationLimits as FabricationLimits
from elastica_cad.fabrication.model.revolution_model import revolution as revolution, revolve as revolve
from elastica_cad.fabrication.model.strip_model import Model as Model
from elastica_cad.fabrication.model.touching_widths import touching_widths as touching_widths
from elastica_cad.fabrication.leaf_stack import LeafStack as LeafStack
from elastica_cad.fabrication.placed_strip import Placed as Placed
from elastica_cad.fabrication.sheets.coupon import (
    coupon_drawing as coupon_drawing,
    coupon_overhang as coupon_overhang,
    reference_bar as reference_bar,
)
from elastica_cad.fabrication.sheets.cut_list import (
    CutList as CutList,
    CutListRow as CutListRow,
    cut_list as cut_list,
)
from elastica_cad.fabrication.sheets.pieces import EqualStrips as EqualStrips
from elastica_cad.fabrication.sheets.nesting import NestedSheet as NestedSheet, nest_pieces as nest_pieces
from elastica_cad.fabrication.sheets.pieces import Piece as Piece
from elastica_cad.fabrication.slots.slot import Slot as Slot
from elastica_cad.fabrication.solids.strip_solids import PrismSolid as PrismSolid
from elastica_cad.fabrication.solids.strip_solids import BentSolid as BentSolid, FlatSolid as FlatSolid
from elastica_cad.fabrication.strip.lamination import Laminated as Laminated
from elastica_cad.fabrication.strip.perforation import Perforated as Perforated
from elastica_cad.fabrication.strip.strip_layers import Layer as Layer
from elastica_cad.fabrication.strip.strip_record import Strip as Strip
from elastica_cad.fabrication.strip_spec import StripSpec as StripSpec, make_strip as make_strip
from elastica_cad.fabrication.strip.styles import Plain as Plain
from elastica_cad.fabrication.strip.outline import Hole as Hole, TSlot as TSlot, Tab as Tab
from elastica_cad.fabrication.travel import Travel as Travel, bend_strip as bend_strip
from elastica_cad.geometry.frame import Frame as Frame
