from elastica_cad.mechanics.sheets import sheet_color as sheet_color
from elastica_cad.model.bows import Bow as Bow
from elastica_cad.model.fixtures import (
    end_fixtures as end_fixtures,
    EndFixture as EndFixture,
    PlacedTab as PlacedTab,
)
from elastica_cad.model.frames import (
    add_feet as add_feet,
    Rib as Rib,
    slotted_frame as slotted_frame,
    SlottedFrame as SlottedFrame,
)
from elastica_cad.model.held_tabs import (
    held_shapes as held_shapes,
    holder_plays as holder_plays,
    tab_seats as tab_seats,
)
from elastica_cad.model.interlocking import interlock as interlock, Joint as Joint, slot_width as slot_width
from elastica_cad.model.batten import LeafStack as LeafStack
from elastica_cad.model.model import Model as Model
from elastica_cad.model.cut_rows import cut_list as cut_list, CutList as CutList, CutListRow as CutListRow
from elastica_cad.model.nesting import nest_pieces as nest_pieces, NestedSheet as NestedSheet
from elastica_cad.model.plate_pairs import plate_pair as plate_pair, ring_pair as ring_pair
from elastica_cad.model.plate_holes import PlateHoles as PlateHoles
from elastica_cad.model.plates import (
    base_plate as base_plate,
    BasePlate as BasePlate,
    PlateOptions as PlateOptions,
    Ring as Ring,
    ring_plate as ring_plate,
    RingOptions as RingOptions,
)
from elastica_cad.model.spacers import add_spacers as add_spacers
from elastica_cad.model.rocking import rocking_tabs as rocking_tabs
from elastica_cad.model.revolution_model import (
    revolution as revolution,
    revolve as revolve,
    touching_widths as touching_widths,
)
