"""Results of the finite elements: the file measured.json and the page docs/finite_elements.md."""

import json
import statistics
import textwrap
import time
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from elastica_cad.strip import compensate_widths
from tests.campaign.finite_elements.bent_strip import bend_cut_strip
from tests.campaign.finite_elements.cases import Case

__all__ = ["Row", "keep", "kept", "measured", "written"]

KEPT = Path(__file__).with_name("measured.json")
PAGE = Path(__file__).resolve().parents[3] / "docs" / "finite_elements.md"

HEAD = """# Strips bent by finite elements

Does a strip take the curve for which elastica_cad designed it? On this page, strips are bent by an independent
program. The program gmsh makes a mesh from the cutting file (DXF) of the strip. The program CalculiX bends this
mesh into the drawn curve, and then releases it except for the tabs at its ends. If the design were exact, the
strip would keep the drawn curve. Sheet, cut and clamps are exact, except in *Pockets with clearance*, and in
*Random strips* for plywood, whose stiffness across the grain elastica_cad does not use. After the result, the
page is for readers who know mechanics.

{result}

- *Deviation*: largest distance between the centre line of the released strip and the drawn curve, divided by
  the length of the strip. At 1e-03, a strip of 300 mm is 0.3 mm off its curve. The centre line is the mean over
  each cross-section.
- *Computed*: the deviation that elastica_cad itself computes (`Strip.held_deviation`). After correction, it is
  often much smaller than the deviation, because elastica_cad does not compute the remaining effects.
- *nu*: Poisson ratio of the sheet. If nu is not 0, bending also curls a strip across its width. A wide strip
  can hardly curl, and is therefore stiffer than a beam.
- *Heavy*: the strip is designed and bent with its own weight. Other strips are weightless unless stated.

The elements are bricks of twenty nodes (C3D20R), one through the thickness of each sheet, and the computation
is geometrically nonlinear. The sheets are linearly elastic, and isotropic except for the plywood of the random
strips. `make campaign-elements` repeats the computations and writes this page. The row *elements* of [the long
test runs](trust.md) has the date and commit of the last run.
"""

RESULT = """Result: with widths corrected for all effects, the largest distance between strip and drawn curve is
{corrected} for {count} chosen strips, and {random} for {few} random strips. The default corrects only {changed}
of the {count} strips, and only for curl across their width; the distance for all {count} is then {default}.
Usual errors of sheet, cut and clamps move a strip by another {least:.1f} to {most:.1f} mm per metre, as
computed for the random strips."""

ACCURACY = """These strips have a constant width, and their shape, frequency or sag is known in closed form. An
elastica is the shape of a bent thin strip of constant width. In all rows, nu is 0. Errors of shapes are divided
by the length, and the other errors by the exact value. The columns are for elements of 8 mm and of 4 mm. Their
errors are almost equal, so they are not due to the mesh."""

KINDS = """The widths of a strip are computed in three ways (option `compensate`):

- *Not corrected* (`compensate=False`): the widths are proportional to the bending stiffness that the curve
  needs.
- *By default*: strips without holes and without a second layer are corrected for curl, if nu is known.
  Perforated and laminated strips are not corrected.
- *Corrected* (`compensate=True`): every strip is corrected for all effects that elastica_cad computes, such as
  curl, slots, narrow tabs, steps of width, and inclined ligaments (the material between holes).

Each cell has the median of the deviations, and the worst deviation in brackets. *Laminated* strips have a
second layer glued on. *Steps of width* occur where arcs of different radius meet. *Narrow tabs* are narrower
than the strip. On this page, *plain* strips have none of these, and no holes, slots or weight."""

DRAWN = """A random generator drew the curves, the widths, the places of slots and the widths of tabs of twelve
strips. The stiffness model was not adjusted to them. *Uncertainty* is the largest error that elastica_cad
expects in its computed deviation, with or without correction. The ten strips that can be corrected are bent
without and with correction, the other two once: this gives 22 cases. The uncertainties of slots and of
perforated and laminated plywood were set after these results, so in these 8 cases (4 with slots, 4 of such
plywood) the agreement is no independent proof. No uncertainty is below 1e-4. This floor was also set
afterwards, but the other 14 cases agree without it too.

Plywood has nu = 0.1, and a Young's modulus of 15 times its shear modulus. CalculiX, but not elastica_cad, uses
a modulus across the grain of 0.3 of the modulus along the grain. Sheets without grain have nu = 0.3. The two
slots of *slotted, no grain* are 6 mm apart, which is less than their depth. elastica_cad reports that it does
not compute their combined effect. *Glued plies* are stacks of one to four plies, whose number changes along the
strip. They and strips tapered in thickness cannot be corrected."""

DRAWN_WORDS = {"even": "no grain", "ply": "plywood", "leaves": "glued plies", "tabbed": "narrow tabs",
               "tapered": "tapered in thickness"}  # fmt: skip
"""Words of the page for the words in the names of the strips."""

WORKSHOP = """For comparison, elastica_cad computes the effect of errors in the workshop: a thickness that
varies by 1 %, grain off by 2 degrees, clamps off by 0.5 degrees and a kerf off by 0.05 mm together move these
strips by {least:.1e} to {most:.1e}."""

CORRECTED = ", made up for"
"""End of the name of a random strip with corrected widths."""

TABS = """Strips of two more random curves, cut from the same sheets as the random strips, are bent without
correction. The tabs at both ends have 0.2, 0.35 or 0.5 of the width of the strip. One constant of the model was
set after these results: the length over which a clamp prevents curling."""

SIDEWAYS = """Does a bent strip stay in the plane of its curve, or does it tip over sideways? CalculiX computes
the natural frequencies of the bent strip. The column *sideways* is for its slowest motion out of the plane, the
column *in its plane* for its slowest motion in the plane. The numbers are squares of angular frequencies. A
negative number means that the strip does not swing but moves away: it is unstable. The unit is E I / (m L^4),
with the bending stiffness E I, the mass per length m and the length L; a straight clamped strip has 501.
*Rating* is the result of elastica_cad (`Strip.sideways`).

The strips are 300 mm long and of constant width, with nu = 0.3. Strips without a backing are 0.8 mm thick.
Laminated strips have two layers of 0.5 mm. *Backing 12 mm*: the second layer is 12 mm wide. *10 rows*: ten
holes, one behind another along the strip. In *ends pushed together*, both clamps are on one line. The number
k (elliptic modulus of the elastica) states how near they are: their distance is 0.84 of the length for k = 0.4,
0.47 for 0.7, 0.28 for 0.8, 0.16 for 0.85, 0.09 for 0.88, and 0.03 for 0.9."""

TAPERED = """These strips are 400 mm long and 8 mm wide; their thickness varies instead of their width. The
round rods are also 400 mm long, and their diameter varies. The mesh is made from the side view (DXF)."""

JOINED = """These strips are 300 mm long, 20 or 30 mm wide, and made of two pieces. A plate of the same sheet,
as wide as the strip, is glued over the joint. One constant of the model was fitted to these strips: the length
at each end of the plate that does not stiffen the strip."""

FLEXURES = """These parts are cut in the plane of a sheet and have [two states](explanation/two_states.md). Each
part is meshed from its DXF file, bent into each of its states, and then released except for the pads at its
ends, by which it is clamped. The columns *first state* and *second state* have the deviation, which must be at
most 3e-03. Both clips are pushed at their middle from each state to the other (the stand is not pushed). The
largest force must be within a tenth of the computed force. After the push, the clip is released and moves
slowly, as in a viscous fluid. It must come to rest within 3e-03 of the curve of the other state: the last
column says whether it does, first after the push, then after the push back."""

BETWEEN = """Forces act between the ends of these strips: a slat and two arches are on a rail, one strip has a
tie between two of its places, and a bow of constant width has a string. For CalculiX, a tie or string is a
spring that can only pull. A rail is a spring 100 m long, so that its force keeps its direction while the strip
slides. The force is not prescribed: it follows from the elongation of the spring. With a spring 20 % stiffer,
the force changes by less than 1 % (tie, bow). The limits are 3e-03 for the deviation, and 3 % for the
difference of the forces.

The computed forces of rails include the compression of the strip along its length. The forces that elastica_cad
reports for a strip do not: for the shallow arches they are 5 % (0.8 mm thick) and 1 % (0.4 mm thick) larger
than in the table."""

POCKETS = """The tabs are in pockets 10 mm deep, with a clearance of 0.15 mm on each face. The walls are rigid
and without friction. The columns have the largest distance between centre line and drawn curve in mm, by finite
elements and as computed by `Strip.held`. The strips of the Pavilion are of card with slots, and have weight. In
[Reproduce the paper](explanation/reproduce_the_paper.md) two plates hold them, with other clearances."""

BANK = """These are the strips of the table *Deviations by kind of strip*. Arch, bow, S, hook and tall ellipse
are shapes of curves. A strip with *2 x 12* holes has 12 rows along its length, each of 2 holes side by side.
Beside each deviation is the computed deviation. Where *by default* is blank, the widths are those of *not
corrected*. A correction makes some deviations slightly larger, because some effects are not computed."""


@dataclass(frozen=True)
class Row:
    """One strip measured; lengths in mm, the rest as shares of the length.

    Attributes
    ----------
    strayed : float
        Largest distance of the middle line from the drawn curve, by finite elements.
    told : float
        The same as our own rod has it (`Strip.held_deviation`).
    stable : bool
        Are all swings about the rest shape stable?
    """

    group: str
    name: str
    length: float
    widest: float
    nodes: int
    strayed: float
    told: float
    stable: bool
    seconds: float


def measured(case: Case, folder: Path, *, compensated: bool | None) -> Row:
    """A strip of the bank cut, bent and compared; its widths make up for what leads it astray, or for nothing.

    None: as it is made by default.
    """
    start = time.perf_counter()
    spec = case.spec.changed(compensate=None if compensated is None else False)
    strip, falls = spec.make(), spec.gravity_in_plane
    if compensated:
        strip = compensate_widths(strip)
    direction = None if falls is None else tuple(falls.direction)
    bent = bend_cut_strip(strip, folder, size=case.size, gravity=direction, modes=1)
    length, seconds = strip.rod.length, time.perf_counter() - start
    return Row(case.group, case.name, length, strip.width.extremes[1], len(bent.body.nodes),
               bent.deviation / length, strip.held_deviation / length, bool(bent.eigenvalues.min() > 0),
               round(seconds, 1))  # fmt: skip


def kept() -> dict[str, list[dict[str, Any]]]:
    """Lists of records by what they answer: "known", "plain widths", "compensated", "sideways", "tapered", ..."""
    return json.loads(KEPT.read_text()) if KEPT.exists() else {}


def keep(part: str, record: Any) -> None:
    """Put one record in the file, in place of an older one of the same name, and write the page anew."""
    everything = kept()
    row = asdict(record)
    rows = [one for one in everything.get(part, []) if _key(one) != _key(row)]
    everything[part] = sorted([*rows, row], key=_key) if part != "known" else [*rows, row]
    KEPT.write_text(json.dumps(everything, indent=1) + "\n")
    PAGE.write_text(written(everything))


def _key(row: dict[str, Any]) -> tuple[str, str, float]:
    return row.get("group", ""), row["name"], row.get("width", 0.0)


def written(everything: dict[str, list[dict[str, Any]]]) -> str:
    """The page."""
    before = everything.get("plain widths", [])
    own, now = (
        {_key(row): row for row in everything.get(part, [])} for part in ("by default", "compensated")
    )
    spreads = (before, [own.get(_key(row), row) for row in before], [*now.values()])
    random = [row for row in everything.get("drawn", []) if row["name"].endswith(CORRECTED)]
    default, corrected = map(_per_metre, spreads[1:])
    effects = [1000 * row["sheet"] for row in everything.get("drawn", [])] or [0.0]
    result = RESULT.format(count=len(before), changed=len(own), corrected=corrected, default=default,
                           least=min(effects), most=max(effects),
                           few=len(random), random=_per_metre(random))  # fmt: skip
    lines = [
        HEAD.format(result=textwrap.fill(result, 112)),
        "## Accuracy of the finite elements",
        "",
        ACCURACY,
        "",
    ]
    lines += _table(("case", "error, 8 mm", "error, 4 mm"), _known(everything.get("known", [])))
    lines += ["", "## Deviations by kind of strip", "", KINDS, ""]
    kinds = [
        [name, *(_deviations([row for row in rows if row["group"] == name]) for rows in spreads)]
        for name in sorted({row["group"] for row in before})
    ]
    total = [f"all {len(before)} strips", *map(_deviations, spreads)]
    lines += _table(("strips", "not corrected", "by default", "corrected"), [*kinds, total])
    unstable = [
        f"{row['group']}, {row['name']}"
        for row in (*before, *own.values(), *now.values())
        if not row["stable"]
    ]
    lines += ["", f"In CalculiX, {'; '.join(unstable) or 'none'} of these strips is unstable."]
    if everything.get("drawn"):
        effects = [row["sheet"] for row in everything["drawn"]]
        workshop = WORKSHOP.format(least=min(effects), most=max(effects))
        lines += ["", "## Random strips", "", DRAWN, "", workshop, "", _judged(everything["drawn"]), ""]
        head = ("strip", "not corrected", "computed", "corrected", "computed", "uncertainty")
        lines += _table(head, _drawn(everything["drawn"]))
    if everything.get("tabs"):
        lines += ["", "## Random strips with narrow tabs", "", TABS, "", _judged(everything["tabs"]), ""]
        lines += _table(
            ("strip", "deviation", "computed", "uncertainty"),
            [[_words(row["name"]), *_shares(row, "strayed", "told", "open")] for row in everything["tabs"]],
        )
    if everything.get("sideways"):
        lines += ["", "## Stability sideways", "", SIDEWAYS, "", _rated(everything["sideways"]), ""]
        lines += _table(
            ("strip", "width (mm)", "sideways", "rating", "in its plane"), map(_swung, everything["sideways"])
        )
    if everything.get("tapered"):
        lines += ["", "## Tapered in thickness or diameter", "", TAPERED, ""]
        lines += _table(
            ("strip", "thickness or diameter (mm)", "deviation"), map(_thinned, everything["tapered"])
        )
    if everything.get("joined"):
        lines += ["", "## Two pieces joined by a plate", "", JOINED, ""]
        lines += _table(
            ("strip", "length of the plate (mm)", "not corrected", "computed", "corrected", "computed"),
            [
                [row["name"], f"{row['lap']:g}", *_shares(row, "strayed", "told", "made_up", "told_made_up")]
                for row in everything["joined"]
            ],
        )
    if everything.get("flexures"):
        lines += ["", "## Parts with two states", "", FLEXURES, ""]
        head = ("strip", "first state", "second state", "push, computed (N)", "by finite elements (N)",
                "push back, computed (N)", "by finite elements (N)", "rests in the other state")  # fmt: skip
        lines += _table(head, map(_flexed, everything["flexures"]))
    if everything.get("between"):
        lines += ["", "## Forces between the ends", "", BETWEEN, ""]
        head = ("strip", "deviation", "force computed (N)", "force by finite elements (N)")
        lines += _table(head, map(_between, everything["between"]))
    if everything.get("pockets"):
        lines += ["", "## Pockets with clearance", "", POCKETS, ""]
        head = ("strip", "length (mm)", "finite elements (mm)", "computed (mm)")
        lines += _table(head, map(_pocketed, everything["pockets"]))
    lines += ["", "## All strips by kind", "", BANK, ""]
    head = ("strips", "strip", "length, largest width (mm)", "not corrected", "computed", "by default", "computed",
            "corrected", "computed")  # fmt: skip
    lines += _table(head, [_ways(row, own.get(_key(row)), now.get(_key(row))) for row in before])
    return "\n".join(lines) + "\n"


def _deviations(rows: list[dict[str, Any]]) -> str:
    """Median and worst deviation."""
    shares = [row["strayed"] for row in rows]
    return f"{statistics.median(shares):.1e} ({max(shares):.1e})" if shares else ""


def _per_metre(rows: list[dict[str, Any]]) -> str:
    """Median and worst deviation of a strip of one metre, in words."""
    mm = [1000 * row["strayed"] for row in rows]
    return (
        f"{statistics.median(mm):.2g} mm per metre of length (median; worst {max(mm):.2g} mm)" if mm else ""
    )


def _known(rows: list[dict[str, Any]]) -> list[list[str]]:
    errors: dict[str, list[str]] = {}
    for row in rows:
        errors.setdefault(row["name"].split(", elements of")[0], []).append(f"{row['error']:.1e}")
    return [[name, *both] for name, both in errors.items()]


def _shares(row: dict[str, Any] | None, *names: str) -> list[str]:
    return ["" if row is None else f"{row[name]:.1e}" for name in names]


def _ways(before: dict[str, Any], own: dict[str, Any] | None, now: dict[str, Any] | None) -> list[str]:
    numbers = [cell for row in (before, own, now) for cell in _shares(row, "strayed", "told")]
    return [before["group"], before["name"], f"{before['length']:.0f}, {before['widest']:.0f}", *numbers]


def _words(name: str) -> str:
    return ", ".join(DRAWN_WORDS.get(word, word) for word in name.split(", "))


def _drawn(rows: list[dict[str, Any]]) -> list[list[str]]:
    corrected = {row["name"].removesuffix(CORRECTED): row for row in rows if row["name"].endswith(CORRECTED)}
    lines = []
    for row in rows:
        if not row["name"].endswith(CORRECTED):
            after = _shares(corrected.get(row["name"]), "strayed", "told")
            lines.append(
                [_words(row["name"]), *_shares(row, "strayed", "told"), *after, *_shares(row, "open")]
            )
    return lines


def _judged(rows: list[dict[str, Any]]) -> str:
    near = sum(abs(row["strayed"] - row["told"]) <= row["open"] for row in rows)
    return (
        f"Deviation and computed deviation differ by at most the uncertainty in {near} of {len(rows)} cases."
    )


RATINGS = {"ample": "stable", "low": "close to tipping"}
"""Ratings that differ from the word of `Sideways`."""


def _rated(rows: list[dict[str, Any]]) -> str:
    rated = [row for row in rows if row["told"] != "undecided"]
    right = sum((row["sideways"] > 0) == (row["told"] != "unstable") for row in rated)
    return (
        f"The rating agrees with CalculiX for {right} of {len(rated)} strips. The other {len(rows) - len(rated)} "
        "strips are *undecided*,\nbecause they are too wide for their bend to be computed as rods."
    )


def _swung(row: dict[str, Any]) -> list[str]:
    rating = RATINGS.get(row["told"], row["told"])
    return [row["name"], f"{row['width']:g}", f"{row['sideways']:.0f}", rating, f"{row['in_plane']:.0f}"]


def _thinned(row: dict[str, Any]) -> list[str]:
    least, most = row["thickness"]
    return [row["name"], f"{least:.2f} to {most:.2f}", *_shares(row, "strayed")]


def _flexed(row: dict[str, Any]) -> tuple[str, ...]:
    pushes = [
        f"{force:.3g}" if force else ""
        for both in zip(row["told"], row["found"], strict=True)
        for force in both
    ]
    snapped = ["yes" if one else "no" for one in row["snapped"]] if any(row["told"]) else []
    return row["name"], *(f"{share:.1e}" for share in row["deviation"]), *pushes, ", ".join(snapped)


def _between(row: dict[str, Any]) -> list[str]:
    name = row["name"].replace("even bow", "bow with its string")
    return [name, *_shares(row, "deviation"), *(f"{row[name]:.4g}" for name in ("computed", "found"))]


def _pocketed(row: dict[str, Any]) -> list[str]:
    return [row["name"], f"{row['length']:.0f}", f"{row['strayed']:.2f}", f"{row['told']:.2f}"]


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    numbers = ["---" if i == 0 or name in ("strip", "rating") else "---:" for i, name in enumerate(head)]
    return [f"| {' | '.join(row)} |" for row in (head, numbers, *rows)]
