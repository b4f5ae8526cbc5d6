"""build123d, CadQuery and their bindings, imported on first use: an environment may have one library only."""

from importlib import import_module
from typing import Any


class Library:
    """A module that is imported when a name of it is needed."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        return getattr(import_module(self._name), attribute)


bd, bd_strips = Library("build123d"), Library("elastica_cad.build123d")
cq, cq_strips = Library("cadquery"), Library("elastica_cad.cadquery")
