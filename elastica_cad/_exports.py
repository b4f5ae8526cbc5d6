"""Lazy exports of packages: the names are listed in `__init__.pyi` and imported on first use."""

import ast
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any


@contextmanager
def installed_modules() -> Iterator[None]:
    """Prevent imports from the working folder during a `with` block.

    In notebooks, `sys.path` contains this folder as "".
    """
    paths = sys.path.copy()
    sys.path[:] = filter(None, paths)
    try:
        yield
    finally:
        sys.path[:] = paths


def exports(file: str, package: str) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return `__getattr__`, `__dir__` and `__all__` of a package, read from the stub beside its
    `__init__.py`.

    Type checkers read the same stub. `import elastica_cad` does not load numpy. Using a name loads only the
    module that defines it.
    """
    homes: dict[str, str] = {}
    for node in ast.parse(Path(file).with_suffix(".pyi").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            homes.update({alias.name: node.module for alias in node.names})
    names = sorted(homes)

    def get(name: str) -> Any:
        """Return the module or the object with a listed name, imported on first use."""
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        home = homes[name]
        with installed_modules():
            if home == package:
                return import_module(f"{home}.{name}")
            from elastica_cad._signatures import simplify_signature

            value = getattr(import_module(home), name)
            simplify_signature(value)
        return value

    return get, lambda: names, names
