"""Writes the reference pages from the code: python docs/generated_pages.py, or `make generate`.

The pages are plain Markdown and are committed; a test compares them with what this writes.
"""

import inspect
import json
import os
import re
from collections.abc import Iterator
from enum import Enum
from functools import cached_property
from operator import attrgetter
from pathlib import Path
from typing import Any, get_args

import click

import elastica_cad as ec
from elastica_cad.cli.commands import elastica
from elastica_cad.design.design_schema import SCHEMA_FILE, design_schema, tables
from elastica_cad.design.tables import CONSTANTS, FUNCTIONS

NAMES = {
    "Curves": (
        "PlaneCurve", "read_curves", "read_model", "write_curves", "four_point_map", "Path", "Profile", "Frame",
    ),
    "Can it be bent?": ("check_equilibrium", "EquilibriumCheck", "NotRealizable", "split"),
    "Rods": (
        "optimal_rod", "mechanics.optimal_rods", "Rod", "bend", "stability", "Stability", "stability_limit",
        "Supports", "End", "Gravity", "Weight", "PointMass", "PointForce", "Rail", "Pin", "Tie",
        "mechanics.RestCurvature", "mechanics.LeavesLaw", "mechanics.RoundLaw", "mechanics.MaterialLaw",
        "mechanics.suggest_support", "mechanics.tolerance_study",
    ),
    "The nearest rod": (
        "nearest_rod", "nearest_rods", "form_finding.stream_nearest_rods", "NearestRod", "Status",
        "Limits", "Keep", "Box", "HalfPlane",
        "form_finding.smooth_curve",
    ),
    "Strips": (
        "StripSpec", "make_strip", "Strip", "Plain", "Perforated", "Laminated", "Tab", "Hole", "Slot",
        "FabricationLimits", "Drawing", "save", "strip.MakingTolerance",
    ),
    "A strip that is moved": ("bend_strip", "strip.Travel", "plot.travel"),
    "A rod with a cord": ("bow", "model.Bow", "plot.bow"),
    "Sheets": ("Sheet", "sheet_names", "load_sheets"),
    "Models": ("Model", "Placed", "save_model", "revolution", "revolve", "meridian", "meridian_through",
               "touching_widths", "model.EndFixture", "model.LeafStack", "model.PlateHoles",
               "model.add_spacers"),
    "Two drawn curves, one strip": (
        "matched_pair", "check_pair", "two_state_rod", "TwoStateRod", "PairLimits", "pairs.FlexureSpec", "Flexure",
    ),
    "The page": ("studio",),
    "Errors": ("ElasticaError", "InputError", "NotConvergedError", "MissingDependencyError"),
}  # fmt: skip
"""Public names in the order in which a curve meets them; a test holds that none is left out."""

NUMBER = {"type": ["number", "string"]}
"""What the schema says of a number, which a formula may stand for."""

WIDTH = 88
"""Columns of a command's help, as on a terminal."""

SHOWN: dict[str, Any] = {
    "max_content_width": WIDTH,
    "terminal_width": WIDTH,
    "help_option_names": ["-h", "--help"],
}
"""How help is shown; click takes the names from the first context in which a command shows its help."""


def pages() -> dict[str, str]:
    """Text of every generated page by its name in docs/reference."""
    return {
        "command_line.md": command_line(),
        "python.md": python(),
        "code_cad.md": code_cad(),
        "sheets.md": sheets(),
        "design_files.md": design_files(),
        SCHEMA_FILE: json.dumps(design_schema(), indent=1) + "\n",
    }


def command_line() -> str:
    """Each command with its own help."""
    context = click.Context(elastica, info_name="elastica", **SHOWN)
    parts = ["# Command line", "",
             "What `elastica --help` and `elastica COMMAND --help` print.", "",
             "Every command takes `--json` ([one record](../json.md) for programs), `-q`, `-v`, and lengths with "
             "their unit (`--max-width 1.5in`, or `--units inch` for all); those that read files take `--watch` "
             "and make everything anew when one is saved.", ""]  # fmt: skip
    parts += [_help(elastica, context)]
    for name in elastica.list_commands(context):
        command = elastica.get_command(context, name)
        inner = click.Context(command, info_name=name, parent=context, **SHOWN)
        parts += [f"## elastica {name}", "", _help(command, inner)]
    return "\n".join(parts)


def _help(command: click.Command, context: click.Context) -> str:
    os.environ.setdefault("COLUMNS", str(WIDTH))
    return f"```\n{command.get_help(context)}\n```\n"


def python() -> str:
    """Every public name with its signature and its docstring."""
    parts = [
        "# Python",
        "",
        "Lengths are mm, angles rad, moduli MPa, densities kg/m3, unless a name says otherwise.",
        "",
    ]
    for title, names in NAMES.items():
        parts += [f"## {title}", ""]
        for name in names:
            thing = attrgetter(name)(ec)
            parts += [f"### {name}", "", *_described(f"ec.{name}", thing)]
            if inspect.isclass(thing):
                for member, value in _members(thing):
                    parts += [f"#### {name}.{member}", "", *_described(member, value)]
    return "\n".join(parts)


def code_cad() -> str:
    """Every public name for build123d and CadQuery. Their common options are listed once."""
    from elastica_cad import build123d, cadquery
    from elastica_cad.kernel.strip_body import BendOptions
    from elastica_cad.kernel.strip_on_path import BlockOptions
    from elastica_cad.kernel.strip_options import StripOptions

    parts = [
        "# build123d and CadQuery",
        "",
        "Lengths are mm, angles degrees. [Strips in build123d and CadQuery](../code_cad.md) explains the use of "
        "these names. The functions and classes for strips take the options at the end of this page as keywords.",
        "",
    ]
    for title, library, shape in (
        ("build123d", build123d, build123d.BentStrip),
        ("CadQuery", cadquery, cadquery.StripSolid),
    ):
        parts += [f"## {title}", ""]
        for name in library.__all__:
            thing = getattr(library, name)
            parts += [f"### {title}: {name}", "", *_described(name, thing)]
            bases = (library.__name__, "elastica_cad.kernel") if thing is shape else ()
            for member, value in _members(thing, bases) if inspect.isclass(thing) else ():
                parts += [f"#### {name}.{member}", "", *_described(member, value)]
    for title, options in (
        ("Options of a strip", StripOptions),
        ("Options of a block", BlockOptions),
        ("Options of bending", BendOptions),
    ):
        parts += [f"## {title}", ""]
        for name, hint in options.__annotations__.items():
            kind, text = get_args(hint)
            parts.append(f"- `{name}`, {_escaped(kind.__forward_arg__)}: {_escaped(text)}")
        parts.append("")
    return "\n".join(parts)


def _members(
    cls: type, packages: tuple[str, ...] = ("elastica_cad.geometry",)
) -> Iterator[tuple[str, object]]:
    """Public methods and properties of a class and of its bases in packages, in the order of the source."""
    for base in cls.__mro__:
        if base is cls or base.__module__.startswith(packages):
            for name, found in vars(base).items():
                value = getattr(found, "__func__", found)  # of a class method or a static method
                described = isinstance(value, (property, cached_property)) or inspect.isfunction(value)
                if described and not name.startswith("_") and inspect.getdoc(value):
                    yield name, value


def _described(name: str, thing: object) -> list[str]:
    """Signature and docstring of a function, class or property as Markdown."""
    lines = []
    if inspect.isfunction(thing) or (inspect.isclass(thing) and not issubclass(thing, (Enum, Exception))):
        signature = inspect.signature(thing)
        asked = [
            one.replace(annotation=one.empty)
            for one in signature.parameters.values()
            if one.name not in ("self", "cls") and str(one.default) != "..."  # an option that is listed once
        ]
        signature = signature.replace(parameters=asked, return_annotation=signature.empty)
        # a default without a text of its own would be shown with its address
        call = re.sub(r"<[\w.]*?(\w+) object at 0x\w+>", r"\1()", f"{name}{signature}")
        lines += ["```python", call, "```", ""]
    return [*lines, *_markdown((inspect.getdoc(thing) or "").partition("\nOptions\n")[0])]


SECTION = re.compile(
    r"^(Parameters|Attributes|Returns|Yields|Raises|Warns|References|Notes|Examples)\n-+\n", re.MULTILINE
)


def _markdown(docstring: str) -> list[str]:
    """A docstring in numpy's form as Markdown: entries become list items, examples a code block."""
    text, *sections = SECTION.split(docstring)
    lines = [_escaped(text.strip()), ""]
    for title, body in zip(sections[::2], sections[1::2], strict=True):
        lines += [f"**{title}**", ""]
        if title == "Examples":
            lines += ["```pycon", body.strip(), "```"]
        elif title in ("References", "Notes"):
            lines += [_escaped(body.strip())]
        else:
            for head, words in re.findall(r"^(\S.*)\n((?:(?: .*)?\n)*)", body.rstrip() + "\n", re.MULTILINE):
                name, _, kind = head.partition(" : ")
                said = _escaped(" ".join(words.split()))
                lines += [f"- `{name}`{f', {_escaped(kind)}' if kind else ''}{f': {said}' if said else ''}"]
        lines.append("")
    return lines


def _escaped(text: str) -> str:
    """Signs that Markdown would read, outside of backticks."""
    return "".join(
        part if part.startswith("`") else re.sub(r"([*<])", r"\\\1", part)
        for part in re.split(r"(`[^`]*`)", text)
    )


def sheets() -> str:
    """The library of sheets with its sources."""
    parts = [
        "# Sheets",
        "",
        "Every sheet that commands and scripts know by name. Stiffness and largest strain vary from batch to "
        "batch: [a coupon](../how_to/own_material.md) tells those of yours.",
        "",
        "| name | thickness, mm | E, MPa | density, kg/m3 | largest strain | source |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for name in ec.sheet_names():
        sheet = ec.Sheet.named(name)
        source = " ".join(str(sheet.source).split()).replace("|", "/")
        parts.append(
            f"| `{name}` | {sheet.thickness:g} | {sheet.youngs_modulus:g} | {sheet.density:g} | "
            f"{100 * sheet.max_strain:.2g} % | {source} |"
        )
    return "\n".join([*parts, ""])


def design_files() -> str:
    """Every key of a design file, and the commented files that `elastica new` writes."""
    folder = Path(ec.__file__).parent / "cli" / "templates"
    parts = [
        "# Design files",
        "",
        "A design file is TOML; `elastica model FILE.toml` makes it. Lengths are mm, angles rad; a number may be a "
        'formula in quotes, such as `"30 * degrees"`. A key that nobody knows is refused with the nearest one '
        "that is known. [Design files in an editor](../how_to/design_files.md) says how an editor completes and "
        "checks keys.",
        "",
        "## Templates",
        "",
        "`elastica new KIND` writes these.",
        "",
    ]
    for path in sorted(folder.glob("*.toml")):
        parts += [f"### {path.stem}", "", f"```toml\n{path.read_text(encoding='utf-8')}```", ""]
    parts += ["## Keys", "", "The file itself is the table *design*.", ""]
    for name, keys in tables().items():
        parts += [f"### table {name}", "", "| key | value | says |", "| --- | --- | --- |"]
        parts += [
            f"| `{key}` | {_linked(_in_words(value))} | {text} |" for key, (value, text) in keys.items()
        ]
        parts.append("")
    parts += ["## Names in formulae", "", "Constants: " + ", ".join(f"`{name}`" for name in CONSTANTS) + ".",
              "Functions: " + ", ".join(f"`{name}`" for name in FUNCTIONS) + ".", ""]  # fmt: skip
    return "\n".join(parts)


def _linked(words: str) -> str:
    """Names of tables lead to them."""
    names = sorted(tables(), key=len, reverse=True)
    return re.sub(
        rf"table ({'|'.join(names)})(?=,|$)",
        lambda found: f"[{found[0]}](#table-{found[1].replace(' ', '-')})",
        words,
    )


def _in_words(fragment: dict) -> str:
    """What a reader of the manual is told of a value."""
    if "anyOf" in fragment:
        return ", or ".join(_in_words(one) for one in fragment["anyOf"])
    if "$ref" in fragment:
        return "table " + fragment["$ref"].removeprefix("#/definitions/")
    if "enum" in fragment:
        return " or ".join(f'"{word}"' for word in fragment["enum"])
    if fragment.get("type") == "array":
        count, inner = fragment.get("maxItems"), fragment["items"]
        if inner == NUMBER:
            return f"{'' if count is None else f'{count} '}numbers in brackets"
        return f"list of{'' if count is None else f' {count}'}: {_in_words(inner)}"
    plain = (
        (NUMBER, "number"),
        ({"type": ["integer", "string"]}, "whole number"),
        ({"type": "boolean"}, "true or false"),
        ({"type": "string"}, "text"),
    )
    return next((words for one, words in plain if one == fragment), "table of names and numbers")


def main() -> None:
    """Write all pages."""
    folder = Path(__file__).with_name("reference")
    folder.mkdir(exist_ok=True)
    for name, text in pages().items():
        (folder / name).write_text(text, encoding="utf-8")
        print(folder / name)


if __name__ == "__main__":
    main()
