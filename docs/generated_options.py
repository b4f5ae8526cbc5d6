"""Writes the typed keywords of the CAD libraries from the declarations: python docs/generated_options.py.

Type checkers and editors read them before anything runs, so they are committed; a test compares.
"""

import inspect
import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from elastica_cad.declared import declared
from elastica_cad.design.records import help_with_unit
from elastica_cad.model.fixtures import EndFixture
from elastica_cad.strip.strip_spec import StripSpec

FILE = Path(__file__).resolve().parents[1] / "elastica_cad" / "kernel" / "strip_options.py"

OWN = ("curve", "sheet", "max_width")
"""Fields that every function has as arguments of its own."""

HEAD = '''"""Typed options for the CAD libraries, generated from the fields of `StripSpec` by `make generate`."""

{imports}

class StripOptions(TypedDict, total=False):
    """Options of every function in addition to path, sheet and max_width: see `StripSpec`.

    `gravity` may also be a vector of the CAD library, which is a direction in space.
    """

    plane: Annotated[
        "Any", "Plane of the curve, with z towards the strip's upper edge: a plane of the library, or a `Frame`."
    ]
    color: Annotated[
        "Any", "Screen colour of the body: a colour of the library, or red, green and blue from 0 to 1."
    ]
{strip}

class FixtureSizes(TypedDict, total=False):
    """Sizes of an end fixture: see `model.EndFixture`."""

{fixture}'''


class _Source:
    """Types as they are written, and the modules that they come from."""

    def __init__(self) -> None:
        self.modules: dict[str, set[str]] = {}

    def of(self, hint: Any) -> str:
        """The text of a type."""
        origin, inner = get_origin(hint), get_args(hint)
        if origin is Annotated:
            return self.of(inner[0])
        if origin in (Union, UnionType):
            return " | ".join(dict.fromkeys(self.of(one) for one in inner))
        if origin is Literal:
            self.modules.setdefault("typing", set()).add("Literal")
            return f"Literal[{', '.join(map(repr, inner))}]"
        if origin is tuple and (inner[-1] is ... or all(map(inspect.isclass, inner))):
            return self._row(inner)
        if origin is not None:
            named = self._named(Callable if "Callable" in str(origin) else origin)
            return f"{named}[{', '.join(self.of(one) for one in inner if one is not ...)}]"
        return "None" if hint in (None, NoneType) else self._named(hint)

    def _row(self, inner: tuple[Any, ...]) -> str:
        """A tuple: of records any sequence is taken, or one alone."""
        if inner[0] in (float, int, bool):
            return f"tuple[{', '.join('...' if one is ... else self.of(one) for one in inner)}]"
        self.modules.setdefault("collections.abc", set()).add("Sequence")
        return f"{self.of(inner[0])} | Sequence[{self.of(inner[0])}]"

    def _named(self, kind: Any) -> str:
        if kind.__module__ != "builtins":
            self.modules.setdefault(kind.__module__, set()).add(kind.__name__)
        return str(kind.__name__)


def text() -> str:
    """The module's text, formatted."""
    source = _Source()
    rows = {}
    for record, left_out in ((StripSpec, OWN), (EndFixture, ())):
        hints = get_type_hints(record, include_extras=True)
        rows[record] = ""
        for one in declared(record):
            if one.name in left_out:
                continue
            kind = source.of(hints[one.name])
            if one.name == "gravity":
                kind = kind.replace("None", "Point | None")
            help = json.dumps(help_with_unit(one.help, one.option.unit), ensure_ascii=False)
            rows[record] += f'    {one.name}: Annotated["{kind}", {help}]\n'
    standard = {
        "typing": {"TYPE_CHECKING", "Annotated", "Any", "TypedDict", *source.modules.pop("typing", ())}
    }
    checked = "".join(
        f"    from {module} import {', '.join(sorted(names))}\n"
        for module, names in sorted((source.modules | {"elastica_cad.kernel.strip_body": {"Point"}}).items())
    )
    imports = f"from typing import {', '.join(sorted(standard['typing']))}\n\nif TYPE_CHECKING:\n{checked}"
    written = HEAD.format(imports=imports, strip=rows[StripSpec], fixture=rows[EndFixture])
    return _formatted(written)


def _formatted(source: str) -> str:
    ruff = Path(sys.executable).with_name("ruff")
    for command in (("check", "--select", "I", "--fix", "-q"), ("format", "-q")):
        done = subprocess.run(
            [ruff, *command, "--stdin-filename", FILE, "-"],
            input=source,
            text=True,
            capture_output=True,
            check=True,
        )
        source = done.stdout
    return source


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")
    print(FILE)
