"""What a cut takes from the stiffness of a bent strip beyond its own width."""

import numpy as np

from elastica_cad._values import require_number
from elastica_cad.errors import InputError


def dead_zone_slope(poisson_ratio: float) -> float:
    """Length, over depth, of the idle triangle on either side of a cut across a bent strip.

    A through crack of length 2 a in a thin plate bent by a skin stress sigma sets free the energy
    pi (1 + nu) / (3 (3 + nu)) sigma^2 a^2 h / E (Sih, Paris and Erdogan, J. Appl. Mech. 29, 1962; Hui and
    Zehnder, Int. J. Fracture 61, 1993). As much is stored in a rhombus with the crack for its diagonal and the
    slope pi (1 + nu) / (3 + nu); a cut from the edge leaves half of it idle.

    Parameters
    ----------
    poisson_ratio : float
        Dimensionless.

    Raises
    ------
    InputError
        A ratio outside 0 to 0.5.

    Examples
    --------
    >>> round(dead_zone_slope(0.3), 3)
    1.238
    """
    nu = require_number(poisson_ratio, "Poisson's ratio")
    if not 0 <= nu <= 0.5:
        raise InputError(f"Poisson's ratio is {poisson_ratio}: it must lie between 0 and 0.5")
    return float(np.pi * (1 + nu) / (3 + nu))
