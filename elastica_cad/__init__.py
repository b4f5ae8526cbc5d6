"""Strips that are cut flat and bend into a drawn curve.

"The paper" is C. Hafner and B. Bickel, The Design Space of Plane Elastic Curves, ACM Transactions on Graphics
40(4), 2021, doi:10.1145/3450626.3459800. Docstrings cite its equations and sections.

>>> import elastica_cad as ec
>>> curve = ec.PlaneCurve.ellipse((0, 0), (200, 100), 0.0, 0.0, 3.14159)
>>> rod = ec.optimal_rod(curve)
>>> round(rod.ratio, 3)
1.57
"""

import sys

if (
    sys.argv[:1] == ["-m"]
    and not sys.flags.safe_path
    and {"elastica_cad", "-melastica_cad"} & {*sys.orig_argv}
):
    # remove the working folder, which `python -m` puts first, because its files could replace modules
    del sys.path[0]

from elastica_cad._exports import exports

__version__ = "0.1.0"
__getattr__, __dir__, __all__ = exports(__file__, __name__)
