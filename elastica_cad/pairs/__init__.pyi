from elastica_cad.pairs.flexure import Flexure as Flexure, FlexureTravel as FlexureTravel, Pad as Pad
from elastica_cad.pairs.flexure_spec import FlexureSpec as FlexureSpec
from elastica_cad.pairs.matching import matched_pair as matched_pair, MatchedPair as MatchedPair
from elastica_cad.pairs.pair_check import check_pair as check_pair
from elastica_cad.pairs.two_state_rods import (
    PairLimits as PairLimits,
    two_state_rod as two_state_rod,
    TwoStateRod as TwoStateRod,
)
