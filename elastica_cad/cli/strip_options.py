"""Options of a strip, and their conversion to a `StripSpec`."""

from collections.abc import Mapping
from itertools import accumulate
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from elastica_cad.cli.element_options import (
    CUTS,
    ELEMENTS,
    LOADS,
    cut_options,
    element_options,
    element_table,
    elements_of,
)
from elastica_cad.cli.options import (
    POINT,
    Chosen,
    given_of,
    join_options,
    option_name,
    option_of,
    output_options,
    refuse_idle,
)
from elastica_cad.cli.requested_curves import (
    END_NAMES,
    Blank,
    number_option,
    read_curves_with_note,
    unit_option,
)
from elastica_cad.cli.settings import GROUPS, CommandKeys, parsed_settings, set_option, twice
from elastica_cad.cli.suggestions import typed_length, typed_line
from elastica_cad.declared import REQUIRED, declared
from elastica_cad.defaults import KERF
from elastica_cad.design.records import CurveReader, Reader, paths_of, put
from elastica_cad.design.strip_table import read_request
from elastica_cad.design.tables import Table, merged
from elastica_cad.errors import Change, InputError, rounded_up
from elastica_cad.form_finding.limits import BOTH_ENDS
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.stability import SAFE_MARGIN
from elastica_cad.strip.strip_spec import StripSpec

if TYPE_CHECKING:
    from elastica_cad.strip.suggestions import Suggestion

CALLED = {
    "style.kind": "style", "style.width": "outer_width", "keep.length": "keep_length", "ends.length": "tab",
}  # fmt: skip
"""Names of options that differ from the last part of their key."""

# keys whose option can only be switched on
FLAGS = ("keep.length", "ignore_limits")


def typed_name(path: str) -> str:
    """Return the option that sets a key. Without an option of its own, a key is set by `--set KEY`.

    Examples
    --------
    >>> typed_name("max_width"), typed_name("limits.curvature"), typed_name("supports")
    ('--max-width', '--set limits.curvature', '--start')
    """
    if name := _OWN_OPTIONS.get(path) or OPTIONS.get(path):
        return option_name(name)
    return f"--set {path}" if path in paths_of(CommandKeys) else ""


CHANGED = {"nearest": "limits", "lap": "shop.lap", "split_corners": "curve.split_corners"}
"""Keys of a design file, by the field of a suggested change, if both have different names."""


def _arguments_of(change: Change) -> tuple[str, ...]:
    """Return the words of the command line that make a suggested change; none if no option does."""
    if change.field == "between":  # the class gives the option (--rail, --pin, --tie)
        record: Any = type(change.value)
        places = [
            getattr(change.value, entry.name) for entry in declared(record) if entry.default is REQUIRED
        ]
        return f"--{record.__name__.lower()}", *map(typed_length, places)
    if change.field == "nearest" and click.get_current_context().info_name != "bow":
        return "--nearest", "--stable"
    path, value = CHANGED.get(change.field, change.field), change.value
    name = typed_name(path)
    if not name:
        return ()
    if name.startswith("--set "):
        return "--set", f"{path}={'true' if value is True else f'{value:g}'}"
    if isinstance(value, str):
        return name, value
    return (name,) if value is True else (name, typed_length(value))


def typed_change(suggestion: "Suggestion", *options: str, instead: str | None = None) -> str:
    """Return the running command with a suggested change.

    Without an option for the change, return an instruction.
    """
    words = _arguments_of(suggestion.change)
    if suggestion.change.field == "size":
        # the key `length` includes the straight ends of the curve
        words = "--set", f"length={rounded_up(suggestion.requests[0].curve.length, 4):g}"
    if "--max-width" not in options:
        options = *options, *_width_of(suggestion)
    return f"`{typed_line(*options, *words, instead=instead)}`" if words else suggestion.title


ACTING = (*map(option_name, (*ELEMENTS, *LOADS, *CUTS)), "between", "loads")
"""Options and keys of rails, pins, ties and loads."""


def _width_of(suggestion: "Suggestion") -> tuple[str, ...]:
    return () if suggestion.width is None else _arguments_of(suggestion.width)


def nearest_curve_line(name: str, suggestion: "Suggestion", *words: str) -> str:
    """Return the command that makes a strip of the curve of the nearest strip NAME, with added options.

    The nearest strip is made by the running command. The files are written into a folder below its folder.
    """
    output: Path = click.get_current_context().params["output"]
    words = *words, *_width_of(suggestion), "-o", str(output / "supported")
    return typed_line(*words, without=CHANGING, curve=output / f"{name}.json")


def typed_in_two_steps(name: str, suggestion: "Suggestion") -> str:
    """Return the commands that make the strip NAME of the nearest curve, and that then support it."""
    first = typed_line(*_width_of(suggestion), without=(*ACTING, "--save-design"))
    return f"`{first}`, and then `{nearest_curve_line(name, suggestion)}`"


def _names_of_common_keys() -> dict[str, str]:
    """Return the names of the options for common keys, by the path of each key."""
    keys, names = paths_of(CommandKeys), {}
    for path in keys:
        # the key itself, and the keys of the tables that contain it
        levels = accumulate(path.split("."), "{}.{}".format)
        if path not in (*_OWN_OPTIONS, "cut") and all(keys[level].option.common for level in levels):
            names[path] = CALLED.get(path, path.rpartition(".")[2])
    return names


_OWN_OPTIONS = {
    "style": "style", "limits": "nearest", "limits.strain": "keep_strain", "keep": "keep_ends",
    "keep.ends": "keep_ends", "keep.tangents": "keep_tangents", "supports": "start", "ends": "tab",
    "gravity": "gravity", "between": "rail",
    "natural_curvature": "natural_curvature", "split": "split",
}  # fmt: skip
"""Options written by hand, by the path of the key that they set. These keys have no generated option."""

OPTIONS = _names_of_common_keys()
"""Names of the options generated from declarations, by the path of the key that they set."""

CHANGING = (
    "--nearest", "--stable", "--keep-strain", "--keep-tangents", "--keep-ends", "--curve", "--all", "--layer",
    "--unit", "--save-design", "limits", "keep", "curve",
    *(option_name(name) for path, name in OPTIONS.items() if path.startswith(("limits.", "keep."))),
)  # fmt: skip
"""Options and keys that select or change a drawn curve, and that save its design."""

DEFAULTS = {
    "label": "the file's name", "ends.length": "10, 0 at a free end", "style.kind": "plain",
    "cut.kerf": f"{KERF:g}",
}  # fmt: skip
"""Descriptions of defaults in help."""


_HAND_MADE: dict[str, tuple[Any, ...]] = {
    "curve": (
        unit_option,
        number_option,
        click.option("--all", "every", is_flag=True, help="Make a separate strip of every curve of the file."),
        click.option("--split", is_flag=False, flag_value="fewest", metavar="[N]",
                     callback=lambda _, __, text: int(text) if text and text.isdecimal() else text,
                     help="Split the curve into N strips that meet at clamps; without N, into the fewest."),
        click.option("--natural-curvature", type=Blank(), metavar="1/MM|KEYS|FILE",
                     help="Curvature of the strip before bending; variable as 'stations = [0, 300], "
                          "curvatures = [0, 0.01]', or a drawing of the pre-bent strip  [default: 0]"),
    ),
    "ends": (
        *(
            click.option(f"--{end}", type=click.Choice(END_NAMES),
                         help=f"Support of the {end} of the curve  [default: clamped]")
            for end in ("start", "end")
        ),
        element_options(ELEMENTS),
        cut_options(),
    ),
    "limits": (
        click.option("--nearest", is_flag=True, help="Change the curve as little as a strip requires."),
        click.option("--stable", is_flag=True,
                     help="As --nearest, and the strip does not snap into another shape (a margin of "
                          f"{SAFE_MARGIN:g})."),
        click.option("--keep-strain", is_flag=True, help="Keep the strain within the limit of the sheet."),
        click.option("--keep-tangents", is_flag=True, help="Keep the tangents of both ends."),
        click.option("--keep-ends", type=click.Choice(list(BOTH_ENDS)),
                     help="Ends that stay in place when the curve changes  [default: both]"),
    ),
    "weight": (
        click.option("--gravity", is_flag=True, help="Include the weight of the strip, as every load does."),
        click.option("--down", type=POINT, metavar="X Y",
                     help="Direction of gravity in the drawing  [default: 0 -1]"),
        element_options(LOADS),
    ),
    "files": (
        click.option("--step/--no-step", default=True,
                     help="Write NAME.step: the flat and the bent strip (needs build123d or CadQuery)."),
        click.option("--pictures/--no-pictures", default=True, help="Draw NAME.png (needs matplotlib)."),
        click.option("--save-design", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
                     help="Write the request as a design file for `elastica model`."),
        output_options,
    ),
}  # fmt: skip


def _options_of(group: str) -> list[Any]:
    """Return the decorators that add the options of a group."""
    keys = paths_of(CommandKeys)
    generated = [
        option_of(
            keys[path], name, default=DEFAULTS.get(path, ""), switch=path in FLAGS, required=path == "sheet"
        )
        for path, name in OPTIONS.items()
        if keys[path.partition(".")[0]].option.group == group
    ]
    return [*generated, *_HAND_MADE.get(group, ())]


def strip_options(function: Any) -> Any:
    """Add the options of common keys, and `--set` for all other keys, to a command."""
    options = [option for group in GROUPS for option in _options_of(group)]
    return join_options(*options, set_option(CommandKeys))(function)


def grouped(parameters: list[click.Parameter]) -> dict[str, list[click.Parameter]]:
    """Return the options by their group in help. Options that every command has are in the last group."""
    of = dict[str, str]()
    for group in GROUPS:
        # click stores the options of a decorated function in its `__click_params__`
        probe: Any = join_options(*_options_of(group))(lambda: None)
        of |= {str(option.name): group for option in probe.__click_params__}
    groups: dict[str, list[click.Parameter]] = {group: [] for group in (*GROUPS, "all else")}
    for parameter in parameters:
        groups[of.get(str(parameter.name), "all else")].append(parameter)
    return groups


def table_of(chosen: Chosen) -> dict[str, Any]:
    """Return the options as the table of a design file."""
    table: dict[str, Any] = {}
    for path, name in OPTIONS.items():
        if chosen[name] is not None:
            put(table, path, chosen[name])
    if chosen["stable"] and chosen["margin"] is None:
        put(table, "limits.margin", SAFE_MARGIN)
    if chosen["nearest"]:
        table.setdefault("limits", {})
    if chosen["keep_strain"]:
        put(table, "limits.strain", True)
    if chosen["keep_tangents"]:
        put(table, "keep.tangents", True)
    if chosen["keep_ends"] is not None:
        ends = BOTH_ENDS[chosen["keep_ends"]]
        put(table, "keep.ends", ends if isinstance(ends, bool) else list(ends))
    refuse_idle({"down": ("gravity", *LOADS)} | dict.fromkeys(CUTS, ("pin", "tie")))
    gravity = True if chosen["down"] is None else list(chosen["down"])
    if chosen["gravity"]:
        table["gravity"] = gravity
    if chosen["start"] or chosen["end"]:
        table["supports"] = [chosen["start"] or "clamped", chosen["end"] or "clamped"]
    table |= given_of(chosen, ["natural_curvature", "split"]) | element_table(chosen)
    table = with_settings(table, parsed_settings(chosen["settings"], CommandKeys))
    if elements_of(chosen, LOADS):
        table.setdefault("gravity", gravity)
    if "keep" in table and "limits" not in table:
        raise InputError("The keys of `keep` apply only if the curve may change. Add --nearest.")
    return table


def with_settings(table: Mapping[str, Any], settings: Mapping[str, Any]) -> dict[str, Any]:
    """Merge the table of options with the table of `--set`. Raise InputError for a key in both tables."""
    for path in twice(table, settings):
        raise InputError(
            "{option} and --set {path} set the same value. Leave out one of them.",
            option=typed_name(path) or option_name(path),
            path=path,
        )
    return merged(table, settings)


def spec_from_options(
    curve: PlaneCurve, label: str, table: Mapping[str, Any], read_curves: CurveReader = read_curves_with_note
) -> StripSpec:
    """Return the `StripSpec` that the table of the options defines. Errors name the options.

    The keys `curve`, `cut` and `files` of the table are not fields of a strip: the command reads the curve and
    writes the files.
    """
    keys = {
        "label": label,
        **{k: value for k, value in table.items() if k not in ("curve", "cut", "files")},
    }
    try:
        return read_request(Table(keys, "", {}), Reader(read_curves=read_curves), curve)
    except InputError as problem:
        field_names = problem.refusal.where.get("field", ())
        fields = (field_names,) if isinstance(field_names, str) else field_names
        problem.at(option=", ".join(filter(None, map(typed_name, fields))))
        raise
