"""Access to LAPACK in scipy without importing its package.

`scipy.linalg` imports more than 200 modules in 0.2 seconds. LAPACK is one compiled file that loads in milliseconds.
"""

from functools import cache
from importlib import import_module
from importlib.machinery import PathFinder
from importlib.util import find_spec, module_from_spec
from pathlib import Path
from typing import Any

from numpy.linalg import LinAlgError

from elastica_cad._types import FloatArray
from elastica_cad.errors import missing_library


@cache
def lapack() -> Any:
    """Return the double precision functions of `scipy.linalg.lapack`: dgtsv, dpbsv and so on."""
    return _compiled_module("linalg", "_flapack", "dgtsv") or import_module("scipy.linalg.lapack")


def svd(matrix: FloatArray, *, full_matrices: bool = True) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the result of `numpy.linalg.svd`. For a matrix with a few rows, it takes a third of the time.

    Examples
    --------
    >>> import numpy as np
    >>> svd(np.diag([2.0, 3.0]))[1].tolist()
    [3.0, 2.0]
    """
    u, sigma, vt, info = lapack().dgesdd(matrix, full_matrices=full_matrices)
    if info != 0:
        raise LinAlgError(
            "the singular values of a matrix do not converge: check that its numbers are finite and not "
            "too large"
        )
    return u, sigma, vt


def _compiled_module(package: str, name: str, needed: str) -> Any | None:
    """Import a compiled module of scipy without its package. Return None if scipy has another layout.

    The module is not added to `sys.modules`, because scipy loads its own copy later.
    """
    # `find_spec` avoids the slow import of scipy
    scipy = find_spec("scipy")
    if scipy is None:
        raise missing_library("elastica_cad computes with scipy", "scipy")
    places = scipy.submodule_search_locations or ()
    spec = PathFinder.find_spec(f"scipy.{package}.{name}", [str(Path(path) / package) for path in places])
    if spec is None or spec.loader is None:
        return None
    try:
        module = module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError:
        return None
    return module if hasattr(module, needed) else None
