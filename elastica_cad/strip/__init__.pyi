from elastica_cad.strip.coupon import (
    coupon_drawing as coupon_drawing,
    coupon_overhang as coupon_overhang,
    reference_bar as reference_bar,
)
from elastica_cad.strip.drawing import (
    add_holding_tabs as add_holding_tabs,
    compensate_kerf as compensate_kerf,
    CUT_INNER as CUT_INNER,
    CUT_OUTER as CUT_OUTER,
    Drawing as Drawing,
    ENGRAVE as ENGRAVE,
    HoldingTabs as HoldingTabs,
    LayeredPath as LayeredPath,
    LAYERS as LAYERS,
    MARK as MARK,
)
from elastica_cad.strip.held_shape import (
    HeldShape as HeldShape,
    MakingTolerance as MakingTolerance,
    Reactions as Reactions,
)
from elastica_cad.strip.lamination import Laminated as Laminated
from elastica_cad.strip.layers import Layer as Layer
from elastica_cad.strip.lettering import Text as Text, text_strokes as text_strokes, text_width as text_width
from elastica_cad.strip.makeable_strip import compensate_widths as compensate_widths
from elastica_cad.strip.measuring import Measuring as Measuring
from elastica_cad.strip.outline import Hole as Hole, Tab as Tab, TSlot as TSlot
from elastica_cad.strip.perforation import Perforated as Perforated
from elastica_cad.strip.pieces import EqualStrips as EqualStrips, Piece as Piece
from elastica_cad.strip.slots import Slot as Slot
from elastica_cad.strip.solids import BentSolid as BentSolid, FlatSolid as FlatSolid, PrismSolid as PrismSolid
from elastica_cad.strip.strip import Placed as Placed, Strip as Strip
from elastica_cad.strip.strip_spec import make_strip as make_strip, StripSpec as StripSpec
from elastica_cad.strip.styles import Plain as Plain
from elastica_cad.strip.tab_seats import EndPose as EndPose, TabSeat as TabSeat
from elastica_cad.strip.travel import bend_strip as bend_strip, Travel as Travel
from elastica_cad.strip.uncuttable_parts import FabricationLimits as FabricationLimits
