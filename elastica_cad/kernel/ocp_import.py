"""Import of OCP, the Python binding of OpenCASCADE that build123d and CadQuery install.

Releases 7.x and 8.x of OCP are supported.
"""

from functools import lru_cache
from importlib import import_module
from types import SimpleNamespace
from typing import Any, TypeAlias

from elastica_cad._process import interrupts_held
from elastica_cad.errors import MissingDependencyError, how_to_install, installed_version, note

Shape: TypeAlias = Any
"""TopoDS_Shape, or an object of build123d or CadQuery that wraps a TopoDS_Shape."""


def bare(shape: Any) -> Any:
    """Return the OpenCASCADE shape in a wrapper, or an empty tuple if the wrapper is empty.

    Other objects are returned unchanged.
    """
    try:
        inside = getattr(shape, "wrapped", shape)
    except AssertionError:  # error of build123d for an empty shape
        return ()
    return () if inside is None and shape is not None else inside


MODULES = (
    "APIHeaderSection", "BinTools", "Bnd", "BOPAlgo", "BRep", "BRepAdaptor", "BRepAlgoAPI", "BRepBndLib",
    "BRepBuilderAPI", "BRepMesh", "BRepPrimAPI", "BRepTools", "GeomAbs", "GeomConvert", "Geom", "IFSelect",
    "Interface", "Message", "Quantity", "RWGltf", "RWMesh", "STEPCAFControl", "STEPControl", "ShapeBuild",
    "ShapeFix", "ShapeUpgrade", "TCollection", "TDataStd", "TDocStd", "TopAbs", "TopExp", "TopLoc", "TopoDS",
    "XCAFDoc", "gp",
)  # fmt: skip
REMARKS = {
    "7": ("TColStd", "TColStd_IndexedDataMapOfStringString"),
    "8": ("collections", "IndexedDataMap_TCollection_AsciiString_TCollection_AsciiString"),
}
"""Module and name of the OCP class for comments in written files, for each major version of OCP."""


@lru_cache(maxsize=1)
@interrupts_held()
def kernel() -> SimpleNamespace:
    """Import OCP and return its classes by name. The class in `REMARKS` has the name `Remarks`.

    Raises
    ------
    MissingDependencyError
        OCP is not installed, or its release is not supported.
    """
    try:
        import OCP
    except ModuleNotFoundError as error:
        raise MissingDependencyError(
            f"solids and STEP need OpenCASCADE: {how_to_install('build123d')} (or cadquery)"
        ) from error
    except ImportError as error:
        raise _loading_error(error) from error
    version = str(getattr(OCP, "__version__", "?"))
    release = version.split(".", maxsplit=1)[0]
    if release not in REMARKS:
        raise MissingDependencyError(
            f"OCP {version} is installed, but elastica_cad works with 7.x and 8.x. Install a release of "
            "build123d or cadquery that brings one of these."
        )
    names: dict[str, Any] = {}
    try:
        for module in MODULES:
            names |= {k: v for k, v in vars(import_module(f"OCP.{module}")).items() if not k.startswith("_")}
        module, name = REMARKS[release]
        names["Remarks"] = getattr(import_module(f"OCP.{module}"), name)
    except (ImportError, AttributeError) as error:
        raise _loading_error(error) from error
    for kind in ("Vertex", "Edge", "Wire", "Face", "Shell", "Solid"):
        names[f"as_{kind.lower()}"] = getattr(names["TopoDS"], f"{kind}_s", None) or getattr(
            names["TopoDS"], kind
        )
    return SimpleNamespace(**names)


def kernel_trouble() -> str:
    """Return why bodies cannot be made and what to install, or "" if OpenCASCADE works."""
    try:
        kernel()
    except MissingDependencyError as error:
        return str(error)
    return ""


def library_trouble(library: str, error: ImportError) -> str:
    """Return what to install if a library that uses OpenCASCADE cannot be imported."""
    if error.name == library:
        return how_to_install(library)
    return kernel_trouble() or note(
        "the library cannot be loaded ({error}); install the package that this error names", error=error
    )


def _loading_error(error: Exception) -> MissingDependencyError:
    """Return the error for an OCP that is installed but fails to load.

    Usually two packages have overwritten each other.
    """
    reason = note("OpenCASCADE (OCP) is installed but cannot be loaded ({error})", error=error)
    brought = {
        name: version
        for name in ("cadquery-ocp", "cadquery-ocp-novtk")
        if (version := installed_version(name)) is not None
    }
    if len({version.split(".", maxsplit=1)[0] for version in brought.values()}) > 1:
        both = " and ".join(f"{name} {version}" for name, version in brought.items())
        return MissingDependencyError(
            f"{reason}: {both} overwrite each other in the same environment. Make separate "
            "environments for build123d and CadQuery, or install build123d==0.12.* with "
            "cadquery==2.8.*."
        )
    return MissingDependencyError(
        f"{reason}. Install the named package, or another release of build123d or cadquery."
    )
