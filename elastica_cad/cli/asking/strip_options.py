"""Options that ask for one strip, and the request that they make together."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, cast

import click

from elastica_cad.cli.asking.options import (
    LENGTH,
    POINT,
    SPACE_POINT,
    asked_sheet,
    given_of,
    join_options,
    option_name,
    sheet_options,
    smooth_option,
)
from elastica_cad.cli.asking.support_options import support_options
from elastica_cad.cli.running.suggestions import option_of
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.lettering import engravable
from elastica_cad.fabrication.makeability.shop import Shop
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.outline import Tab
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.styles import Plain, Style
from elastica_cad.fabrication.strip_checks import AskedGravity
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.formats.design_files.one_line import parse_line
from elastica_cad.formats.design_files.rod_records import read_keep_out, read_loads, read_stiffness_bounds
from elastica_cad.formats.design_files.strip_records import LAW_LINE, read_law, read_slot, read_tab
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.forming.limits import BOTH_ENDS, Keep, Limits
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.stability.stability_verdict import SAFE_MARGIN

TAB_LENGTH_MM = 10.0
"""Enough to hold a strip of some centimetres by."""

PAIR, TRIPLE = (float, float), (float, float, float)

PERFORATED = ("columns", "rows", "hole_ratio", "least_ligament", "least_hole", "corner_radius", "sides")
LAMINATED = ("least_backing", "dots")
"""Sizes of the styles: fields of their records, and options of the same name."""

SAME_NAME = ("max_width", "min_width", "natural_curvature", "samples", "joint", "slots", "smooth", "compensate",
             "creep", "ignore_limits")  # fmt: skip
"""Fields of `StripSpec` that options of the same name give."""


class _Keys(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """A record written as in a design file: "at = 40, width = 1.2".

    Parameters
    ----------
    read : callable
        Makes the record of a table.
    inside : str
        Key of the table that is typed, where the reader looks for one.
    """

    name = "keys"

    def __init__(self, read: Callable[[Table], object], inside: str = "") -> None:
        self.read, self.inside = read, inside

    def convert(self, value: Any, param: click.Parameter | None, _: click.Context | None) -> object:
        """The record; a refusal names the option."""
        line = f"{self.inside} = {{{value}}}" if self.inside else value
        return parse_line(line, "" if param is None else param.opts[0], self.read)


_WIDTHS = (
    sheet_options(required=True),
    click.option("--max-width", type=LENGTH, metavar="MM", help="Width of the widest place."),
    click.option("--min-width", type=LENGTH, metavar="MM", help="Width of the narrowest place (or its limit)."),
)  # fmt: skip

_STYLE = (
    click.option("--compensate/--no-compensate", default=None,
                 help="Make up in the widths for slots, narrow tabs, leaning ligaments, anticlastic bending; or "
                      "for nothing. Without either: for anticlastic bending, where the sheet's nu is known."),
    click.option("--creep", type=float, default=0.0, metavar="PHI",
                 help="Creep factor in the long run: tells sag and forces. Plywood indoors: 0.8 (Eurocode 5)."),
    click.option("--law", metavar="KEYS",
                 help="Stiffness from thickness or diameter: 'kind = \"thickness\", limits = [3, 8], width = 20', "
                      "'kind = \"rod\", limits = [3, 8]', or 'tube' with 'bore = 0.7'; with --nearest 'kind = "
                      "\"leaves\", leaves = 4, width = 20', glued of the sheet."),
    click.option("--style", type=click.Choice(["plain", "perforated", "laminated"]), default="plain",
                 show_default=True, help="How stiffness becomes material."),
    click.option("--outer-width", type=LENGTH, metavar="MM", help="Width of a perforated or laminated strip."),
    click.option("--columns", type=click.IntRange(1), metavar="N", help="Perforated: holes side by side."),
    click.option("--rows", type=click.IntRange(1), metavar="N", help="Perforated: rows of holes."),
    click.option("--hole-ratio", type=float, metavar="SHARE", help="Perforated: most that holes take."),
    click.option("--least-ligament", type=LENGTH, metavar="MM", help="Perforated: narrowest ligament."),
    click.option("--least-hole", type=LENGTH, metavar="MM", help="Perforated: narrowest hole."),
    click.option("--corner-radius", type=LENGTH, metavar="MM", help="Perforated: rounding of holes."),
    click.option("--sides", type=click.Choice(["spline", "arc"]), help="Perforated: what holes are made of."),
    click.option("--backing", metavar="NAME", help="Laminated: the sheet that is glued on."),
    click.option("--least-backing", type=LENGTH, metavar="MM", help="Laminated: narrowest backing."),
    click.option("--dots", type=LENGTH, metavar="MM", help="Laminated: holes that align the layers; 0: none."),
)  # fmt: skip

_WEIGHT = (
    click.option("--gravity", is_flag=True, help="Let the strip carry its own weight."),
    click.option("--down", type=PAIR, metavar="X Y",
                 help="The direction in which things fall, in the drawing  [default: 0 -1]"),
    click.option("--down-in-space", type=TRIPLE, metavar="X Y Z",
                 help="The same in space, with --y-axis for a drawing that is not upright there."),
    click.option("--gravity-length", type=LENGTH, metavar="MM",
                 help="Elasto-gravity length, instead of the sheet's."),
    click.option("--origin", type=SPACE_POINT, metavar="X Y Z", help="Where the drawing's origin lies in space."),
    click.option("--x-axis", type=TRIPLE, metavar="X Y Z", help="The drawing's x in space  [default: 1 0 0]"),
    click.option("--y-axis", type=TRIPLE, metavar="X Y Z", help="The drawing's y in space  [default: 0 0 1]"),
    click.option("--hang", "hung", type=(LENGTH, float), multiple=True, metavar="MM GRAMS",
                 help="A mass at this place along the strip, with --gravity; repeatable."),
    click.option("--loads", type=_Keys(read_loads, inside="loads"), metavar="KEYS",
                 help="All weight in newtons: 'alpha = 0.001, masses = [...]'."),
)  # fmt: skip

_NEAREST = (
    smooth_option,
    click.option("--nearest", is_flag=True, help="Change the curve, as little as it takes."),
    click.option("--ratio", type=float, metavar="R", help="Largest stiffness ratio (widest to narrowest)."),
    click.option("--stable", is_flag=True, help=f"Make sure that it stays put (a margin of {SAFE_MARGIN:g})."),
    click.option("--margin", type=float, metavar="MU", help="Least stability margin, instead of --stable's."),
    click.option("--keep-strain", is_flag=True, help="Keep within the strain that the sheet bears."),
    click.option("--max-strain", type=float, metavar="SHARE", help="Keep within this strain: 0.01 is 1 %."),
    click.option("--max-curvature", type=float, metavar="1/MM", help="Keep within this curvature."),
    click.option("--length-range", type=POINT, metavar="MM MM", help="Least and largest length."),
    click.option("--width-range", type=POINT, metavar="MM MM", help="Bound the ratio by two widths."),
    click.option("--keep-out", type=_Keys(read_keep_out), multiple=True, metavar="KEYS",
                 help="'point = [x, y], normal = [x, y]', or 'lower = [x, y], upper = [x, y]'; repeatable."),
    click.option("--stiffness-bounds", type=_Keys(read_stiffness_bounds), metavar="KEYS",
                 help="'lower = 1.5, upper = [2, 3, 2]', along the strip."),
    click.option("--keep-ends", type=click.Choice(list(BOTH_ENDS)), help="Which ends stay  [default: both]"),
    click.option("--keep-tangents", is_flag=True, help="When the curve changes, keep its end tangents."),
    click.option("--keep-tangent", type=click.Choice(["start", "end"]), help="Keep the tangent of one end."),
    click.option("--keep-length", is_flag=True, help="When the curve changes, keep its length."),
    click.option("--keep-symmetry", type=click.Choice(["mirror", "turn"]), help="Keep its symmetry."),
    click.option("--keep-point", "keep_points", type=LENGTH, multiple=True, metavar="MM",
                 help="Still pass through this place along the curve; repeatable."),
    click.option("--keep-line", is_flag=True, help="Keep inflections on the drawn curve's inflection line."),
    click.option("--inflection-line", type=(*POINT, *POINT), metavar="X Y X Y",
                 help="Keep inflections on the line through two points."),
)  # fmt: skip

_PATTERN = (
    click.option("--tab", type=LENGTH, metavar="MM",
                 help=f"Length of tabs without sizes of their own [default: {TAB_LENGTH_MM:g}]."),
    click.option("--tab-radius", type=LENGTH, metavar="MM", help="Rounding of their corners [default: 0]."),
    click.option("--start-tab", type=_Keys(read_tab), metavar="KEYS",
                 help="The first tab: 'length = 12, holes = [{at = 6, diameter = 3}]'."),
    click.option("--end-tab", type=_Keys(read_tab), metavar="KEYS", help="The last tab, in the same way."),
    click.option("--joint", type=LENGTH, metavar="MM",
                 help="Where a closed strip is joined, along the drawn curve [default: where it is bent least]."),
    click.option("--slot", "slots", type=_Keys(read_slot), multiple=True, metavar="KEYS",
                 help="A slot: 'at = 40, width = 1.2, side = \"lower\"'; repeatable."),
    click.option("--label", help="Text engraved on the strip [default: the file's name]."),
    click.option("--samples", type=int, help="Number of samples along the curve [default: chosen]."),
    click.option("--least-width", type=LENGTH, metavar="MM",
                 help="Narrowest strip, tab or tongue that the workshop can make [default: the sheet's]."),
    click.option("--stock", type=POINT, metavar="MM MM", help="Sides of the largest sheet [default: 3050 1525]."),
    click.option("--lap", type=LENGTH, metavar="MM",
                 help="Cut a strip longer than the stock in pieces, joined by plates of this length."),
    click.option("--ignore-limits", is_flag=True, help="Write a strip that cannot be cut or handled, and say so."),
)  # fmt: skip


strip_options = join_options(*_WIDTHS, *_STYLE, support_options, *_WEIGHT, *_NEAREST, *_PATTERN)
"""All that can be asked of one strip, but for its curve."""


def spec_from_options(curve: PlaneCurve, name: str, chosen: Mapping[str, Any]) -> StripSpec:
    """The strip that the options ask for, labelled with its `name` unless they say how.

    Raises
    ------
    InputError
        Options that exclude each other, or what `StripSpec` refuses, with the options to look at.
    """
    sheet = asked_sheet(chosen)
    backing = None if chosen["backing"] is None else Sheet.named(chosen["backing"])
    law = None
    if chosen["law"] is not None:
        law = parse_line(chosen["law"], "--law", partial(read_law, sheet=sheet), example=LAW_LINE)
    label = engravable(name) if chosen["label"] is None else chosen["label"]
    limits, keep = _limits(chosen, sheet), _keep(chosen)
    if limits is None and keep is not None:
        raise InputError(
            "--keep-tangents, --keep-length and other --keep options are for a curve that may change: add --nearest"
        )
    try:
        return StripSpec(
            curve,
            sheet,
            style=_style(chosen, backing),
            limits=limits,
            keep=keep if limits is None else keep or Keep(),
            gravity=_gravity(chosen),
            loads=_loads(chosen),
            supports=Supports(chosen["start"], chosen["end"]),
            ends=_ends(chosen),
            label=label,
            shop=_shop(chosen),
            frame=_frame(chosen),
            law=law,
            **{name: chosen[name] for name in SAME_NAME},
        )
    except InputError as problem:
        named = problem.refusal.where.get("field", ())
        fields = (named,) if isinstance(named, str) else named
        problem.at(option=", ".join(filter(None, map(option_of, fields))))
        raise


def _shop(chosen: Mapping[str, Any]) -> Shop:
    """Limits of the workshop; ligaments are as fine as the style is told to make them."""
    return Shop(**given_of(chosen, ("least_width", "stock", "lap", "least_ligament")))


def _style(chosen: Mapping[str, Any], backing: Sheet | None) -> Style:
    """The style with the sizes that are given; sizes of another style are refused."""
    kind = chosen["style"]
    sizes = {"perforated": PERFORATED, "laminated": ("backing", *LAMINATED)}
    for other, names in sizes.items():
        if other != kind and (idle := [*given_of(chosen, names)]):
            raise InputError(
                "{option_name} is of a {other} strip: add --style {other}",
                option_name=option_name(idle[0]),
                other=other,
            )
    if kind == "plain":
        if chosen["outer_width"] is not None:
            raise InputError("--outer-width is of a perforated or laminated strip: add --style")
        return Plain()
    if chosen["outer_width"] is None:
        raise InputError("a {kind_} strip has a width of its own: give --outer-width MM", kind_=kind)
    given = given_of(chosen, sizes[kind])
    if kind == "perforated":
        return Perforated(width=chosen["outer_width"], **given)
    if backing is None:
        raise InputError("a laminated strip is two sheets: name the one that is glued on with --backing NAME")
    return Laminated(width=chosen["outer_width"], **(given | {"backing": backing}))


def _frame(chosen: Mapping[str, Any]) -> Frame | None:
    """The plane of the drawing, upright in space unless told, where anything says where it is."""
    if all(chosen[name] is None for name in ("origin", "x_axis", "y_axis", "down_in_space")):
        return None
    return Frame(
        chosen["origin"] or (0.0, 0.0, 0.0),
        chosen["x_axis"] or (1.0, 0.0, 0.0),
        chosen["y_axis"] or (0.0, 0.0, 1.0),
    )


def _gravity(chosen: Mapping[str, Any]) -> AskedGravity:
    down, in_space, length = chosen["down"], chosen["down_in_space"], chosen["gravity_length"]
    if not chosen["gravity"]:
        refuse_idle_weight(chosen, ("down", "down_in_space", "gravity_length"))
        return None
    if down is not None and in_space is not None:
        raise InputError("--down and --down-in-space say the same in two ways: leave one of them out")
    if length is not None:
        if in_space is not None:
            raise InputError("--gravity-length falls in the drawing: use --down instead of --down-in-space")
        return Gravity(length, down or (0.0, -1.0))
    return in_space or down or True


def refuse_idle_weight(chosen: Mapping[str, Any], names: Sequence[str]) -> None:
    """Refuse options of a weight that is not asked for."""
    if idle := [*given_of(chosen, names)]:
        raise InputError(
            "{option_name} says how weight pulls, which is left out: add --gravity",
            option_name=option_name(idle[0]),
        )


def _loads(chosen: Mapping[str, Any]) -> tuple[PointMass, ...] | Weight:
    hung = tuple(PointMass(at, grams) for at, grams in chosen["hung"])
    if chosen["loads"] is None:
        return hung
    if hung:
        raise InputError("--hang and --loads exclude each other: name the masses in --loads too")
    return cast("tuple[PointMass, ...] | Weight", chosen["loads"])


def _limits(chosen: Mapping[str, Any], sheet: Sheet) -> Limits | None:
    """The limits; none that are asked for, with --nearest alone; None where the curve may not change."""
    _refuse_both(chosen, "keep_strain", "max_strain", "a largest strain")
    margin = chosen["margin"]
    if margin is None and chosen["stable"]:
        margin = SAFE_MARGIN
    strain = chosen["max_strain"]
    asked: dict[str, Any] = {
        "ratio": chosen["ratio"],
        "margin": margin,
        "curvature": chosen["max_curvature"],
        "sheet": sheet if chosen["keep_strain"] or strain is not None else None,
        "strain": strain,
        "width": chosen["width_range"],
        "length": chosen["length_range"],
        "keep_out": chosen["keep_out"] or None,
        "stiffness_bounds": chosen["stiffness_bounds"],
    }
    given = {name: value for name, value in asked.items() if value is not None}
    return Limits(**given) if given or chosen["nearest"] else None


def _keep(chosen: Mapping[str, Any]) -> Keep | None:
    _refuse_both(chosen, "keep_tangents", "keep_tangent", "which tangents stay")
    _refuse_both(chosen, "keep_line", "inflection_line", "on which line inflections stay")
    tangent, line = chosen["keep_tangent"], chosen["inflection_line"]
    asked: dict[str, Any] = {
        "ends": None if chosen["keep_ends"] is None else BOTH_ENDS[chosen["keep_ends"]],
        "tangents": True if chosen["keep_tangents"] else None if tangent is None else BOTH_ENDS[tangent],
        "length": chosen["keep_length"] or None,
        "symmetry": chosen["keep_symmetry"],
        "points": chosen["keep_points"] or None,
        "line": (line[:2], line[2:]) if line is not None else chosen["keep_line"] or None,
    }
    given = {name: value for name, value in asked.items() if value is not None}
    return Keep(**given) if given else None


def _refuse_both(chosen: Mapping[str, Any], flag: str, other: str, what: str) -> None:
    """Refuse a flag beside the option that says the same otherwise."""
    if chosen[flag] and chosen[other] is not None:
        options = " and ".join(map(option_name, (flag, other)))
        raise InputError("{options} both say {what}: leave one of them out", options=options, what=what)


def _ends(chosen: Mapping[str, Any]) -> tuple[Tab, Tab]:
    own = chosen["start_tab"], chosen["end_tab"]
    sizes = given_of(chosen, ("tab", "tab_radius"))
    if all(own) and sizes:
        raise InputError(
            "{option_name} is of tabs without sizes of their own, and both tabs have theirs: leave it out",
            option_name=option_name(next(iter(sizes))),
        )
    usual = Tab(sizes.get("tab", TAB_LENGTH_MM), corner_radius=sizes.get("tab_radius", 0.0))
    return own[0] or usual, own[1] or usual
