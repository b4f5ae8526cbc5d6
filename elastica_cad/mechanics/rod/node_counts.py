"""How many nodes a discrete rod has unless the user says otherwise: its error falls with the square."""

from elastica_cad.geometry.curves.plane_curve import SURVEY_POINTS

# A rod that is shown, cut and tested: a strip of 300 mm has a node every half millimetre, and the discrete shape is
# off the continuous one by less than a laser's kerf (paper, section 7.1, has some hundreds).
DEFAULT_SAMPLES = SURVEY_POINTS

# A rod that is searched for: hundreds are solved on the way, whose error, nine times as large, is still far below
# what limits allow; `editable_curve` extrapolates it away.
SEARCH_SAMPLES = 201
