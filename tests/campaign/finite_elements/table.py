"""What was measured, kept in a file beside this one, and told as docs/finite_elements.md."""

import json
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from elastica_cad.strip import compensate_widths
from tests.campaign.finite_elements.bent_strip import bend_cut_strip
from tests.campaign.finite_elements.between import FORCES_WITHIN, WITHIN
from tests.campaign.finite_elements.cases import Case

__all__ = ["Row", "keep", "kept", "measured", "written"]

KEPT = Path(__file__).with_name("measured.json")
PAGE = Path(__file__).resolve().parents[3] / "docs" / "finite_elements.md"
ASKED_MEDIAN, ASKED_WORST = 3e-4, 1e-3

HEAD = """# Strips bent by finite elements

`make campaign-elements` writes this page. The cutting files (DXF) of each strip are read, meshed by gmsh and
bent by CalculiX in three dimensions: bricks of twenty nodes (C3D20R), one through the thickness of each sheet,
large displacements. The tabs are held as drawn; all else is free. Numbers are the largest distance of the
middle line (the mean over the section) from the drawn curve, as a share of the length.

The finite elements are of 21 November 2026, but for the strips drawn by a seed, and strips with slots,
narrow tabs or steps whose widths make up for them: these are of 26 November. The column "told" is what the
program reports for the same strip; for other strips made with `compensate=False` or by default it is of 24
November.
"""

DEFAULT = """Stiffness alone: `compensate=False`. By default plain strips of a sheet whose Poisson ratio is known,
as that of all of nu 0.3 here is, are made for anticlastic bending. Made up for: `compensate=True`."""

DRAWN = """The seed 541126 draws the curves, the widths, the places of slots and the widths of tabs
(`drawn_by_seed.py`). The stiffness was fitted to none of them. Four of the shares that are left open were set
after these rows: of slots, of slots nearer to each other than they are deep, of perforated and laminated
plywood, and the least of any strip (1e-4 of the length). Plywood has E / G = 15, nu = 0.1 and, in the
finite elements alone, an E across of 0.3 of that along; even sheets have nu = 0.3. "Left open" is by how much
the model may be wrong, as it says of each strip. "From the sheet" is what a wave of thickness of 1 %, grain
off by 2 degrees, clamps off by 0.5 degrees and a kerf of 0.05 mm add; the finite elements have none of these.
A strip strays as told where the first two figures differ by no more than what is left open. The slots of the
even sheet lie 6 mm apart, which is told too."""

TABS = """The seed 541127 draws two curves, widths and thicknesses; tabs at both ends have 0.2, 0.35 and 0.5 of the
width there. Sheets are those of the twelve strips above. Only the length that a clamp takes away in sheets that
curl across (`RESTRAINT`) was set after these rows. Told and left open together are at least what finite elements
find, and at most twice as much."""

SIDEWAYS = """The lowest eigenvalues (`*FREQUENCY, PERTURBATION` after the nonlinear step) of uniform strips 300 mm
long, nu = 0.3, in units of E I over mass per length and L^4: 0.8 mm thick, laminated of two sheets of 0.5 mm.
Negative: the strip leaves that shape. "Told" is the word of `Strip.sideways`, said of the same rod."""

TAPERED = """Strips 8 mm wide whose thickness carries the stiffness. The side view (DXF) is meshed and made
wide: two bricks across the width, elements of 8 mm along. Rods are round, twelve bricks to a section, as thick
as their side view is high. The tabs are held in the drawn pose; asked are 1e-03 of the length."""

JOINED = """Strips 20 or 30 mm wide of two pieces: the base is cut through, a plate of the same sheet, as wide as
the strip, is glued over the joint. Shares of the length, held by the tabs in the drawn pose."""

FLEXURES = """Cut in the plane of a sheet, meshed from their DXF and put into each state, then let go but for their
pads: the largest distance of the centre line from the drawn curve, as a share of the length; asked are 3e-03.
The clip is pushed at its middle from either state: the largest push, which is to be within a tenth of
what is told. Behind the snap they are let go, as in something viscous (implicit steps along the slope of the
energy), and rest in the other state, as near to its curve as those that were put there."""

POCKETS = """Rigid walls 0.15 mm off either face of the tabs, 10 mm deep, without friction; weight included. A tab
touches where the free part ends and at its bottom, on the faces where the walls push. "Told" is what `Strip.held`
says. Strips of the Pavilion are of card, with their slots and weight; six minutes and more of processor each."""


BETWEEN = """Cut files of strips with forces between their ends, put in the drawn pose and let go but for
their clamps. A cord is a spring that only pulls, between the means of two sections. A rail is a cord 100 m
long, which lets the strip slide. The pull follows from the elongation. If the spring is set for a force 20
% too large, the force found changes by less than 1 % (tie, bow). Required are 3e-03 of the length and 3 %
of the force. A shallow arch on a rail is compressed along its length, which the rod neglects. This error of
the rail's force falls with the thickness."""


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
    before, now = (everything.get(part, []) for part in ("plain widths", "compensated"))
    own = {_key(row): row for row in everything.get("by default", [])}
    usual = [own.get(_key(row), row) for row in before]
    lines = [HEAD, "## The harness itself", "", "Where the answer is known in closed form (nu = 0).", ""]
    lines += _table(("question", "error"), everything.get("known", []), _known)
    lines += ["", "## By what leads a strip astray", ""]
    groups = sorted({row["group"] for row in before + now})
    lines += [DEFAULT, ""]
    head = ("strips", "stiffness alone: median", "worst", "by default: median", "worst", "made up for: median",
            "worst")  # fmt: skip
    spreads = (before, usual, now)
    lines += _table(
        head, groups, lambda group: (group, *(cell for rows in spreads for cell in _spread(rows, group)))
    )
    for when, rows in (
        ("as the stiffness alone asks", before),
        ("by default, where that is another", list(own.values())),
        ("with widths that make up for the rest", now),
    ):
        if rows:
            lines += ["", f"## Every strip {when}", "", _summary(rows), ""]
            head = ("strips", "strip", "length, widest (mm)", "strayed", "told", "swings")
            lines += _table(head, rows, _strip)
    if everything.get("drawn"):
        lines += ["", "## Twelve strips drawn by a seed", "", DRAWN, ""]
        head = ("strip", "strayed", "told", "left open", "from the sheet", "strayed as told")
        lines += _table(head, everything["drawn"], _drawn)
    if everything.get("tabs"):
        lines += ["", "## Narrow tabs drawn by a seed", "", TABS, ""]
        head = ("strip", "strayed", "told", "left open", "from the sheet", "strayed as told")
        lines += _table(head, everything["tabs"], _drawn)
    if everything.get("sideways"):
        lines += ["", "## Sideways", "", SIDEWAYS, ""]
        lines += _table(
            ("strip", "width (mm)", "sideways", "told", "in its plane"), everything["sideways"], _swung
        )
    if everything.get("tapered"):
        lines += ["", "## Tapered in thickness or diameter", "", TAPERED, ""]
        head = ("strip", "length (mm)", "thickness, diameter (mm)", "nodes", "strayed")
        lines += _table(head, everything["tapered"], _thinned)
    if everything.get("joined"):
        lines += ["", "## Joined of two pieces by a plate", "", JOINED, ""]
        head = ("strip", "plate (mm)", "strayed", "told", "made up for: strayed", "told")
        lines += _table(head, everything["joined"], _joined)
    if everything.get("flexures"):
        lines += ["", "## Parts with two states", "", FLEXURES, ""]
        head = ("strip", "first state", "second state", "push told (N)", "found", "back told (N)", "found",
                "snapped")  # fmt: skip
        lines += _table(head, everything["flexures"], _flexed)
    if everything.get("between"):
        lines += ["", "## With forces between the ends", "", BETWEEN, ""]
        head = ("strip", "nodes", "distance", "force computed (N)", "force found (N)", "within")
        lines += _table(head, everything["between"], _between)
    if everything.get("pockets"):
        lines += ["", "## In pockets with play", "", POCKETS, ""]
        head = ("strip", "length (mm)", "finite elements (mm)", "told (mm)")
        lines += _table(head, everything["pockets"], _pocketed)
    return "\n".join(lines) + "\n"


def _summary(rows: list[dict[str, Any]]) -> str:
    shares = [row["strayed"] for row in rows]
    return (
        f"{len(rows)} strips: median {statistics.median(shares):.1e}, worst {max(shares):.1e} (asked are "
        f'{ASKED_MEDIAN:.0e} and {ASKED_WORST:.0e}). "Told" is what our own rod says of the same strip.'
    )


def _spread(rows: list[dict[str, Any]], group: str) -> tuple[str, str]:
    shares = [row["strayed"] for row in rows if row["group"] == group]
    return (f"{statistics.median(shares):.1e}", f"{max(shares):.1e}") if shares else ("", "")


def _known(row: dict[str, Any]) -> tuple[str, ...]:
    return row["name"], f"{row['error']:.1e}"


def _strip(row: dict[str, Any]) -> tuple[str, ...]:
    return (row["group"], row["name"], f"{row['length']:.0f}, {row['widest']:.0f}", f"{row['strayed']:.1e}",
            f"{row['told']:.1e}", "stable" if row["stable"] else "unstable")  # fmt: skip


def _drawn(row: dict[str, Any]) -> tuple[str, ...]:
    shares = (f"{row[name]:.1e}" for name in ("strayed", "told", "open", "sheet"))
    within = abs(row["strayed"] - row["told"]) <= row["open"]
    return row["name"], *shares, "yes" if within else "no"


def _swung(row: dict[str, Any]) -> tuple[str, ...]:
    return row["name"], f"{row['width']:g}", f"{row['sideways']:.0f}", row["told"], f"{row['in_plane']:.0f}"


def _thinned(row: dict[str, Any]) -> tuple[str, ...]:
    least, most = row["thickness"]
    return (
        row["name"],
        f"{row['length']:.0f}",
        f"{least:.2f} to {most:.2f}",
        str(row["nodes"]),
        f"{row['strayed']:.1e}",
    )


def _joined(row: dict[str, Any]) -> tuple[str, ...]:
    shares = (row[name] for name in ("strayed", "told", "made_up", "told_made_up"))
    return row["name"], f"{row['lap']:g}", *(f"{share:.1e}" for share in shares)


def _flexed(row: dict[str, Any]) -> tuple[str, ...]:
    pushes = [
        f"{force:.3g}" if force else ""
        for both in zip(row["told"], row["found"], strict=True)
        for force in both
    ]
    snapped = ["yes" if one else "no" for one in row["snapped"]] if any(row["told"]) else []
    return row["name"], *(f"{share:.1e}" for share in row["deviation"]), *pushes, ", ".join(snapped)


def _between(row: dict[str, Any]) -> tuple[str, ...]:
    error = abs(row["found"] / row["computed"] - 1)
    within = row["deviation"] <= WITHIN and error <= FORCES_WITHIN
    forces = (f"{row[name]:.4g}" for name in ("computed", "found"))
    return row["name"], str(row["nodes"]), f"{row['deviation']:.1e}", *forces, "yes" if within else "no"


def _pocketed(row: dict[str, Any]) -> tuple[str, ...]:
    return row["name"], f"{row['length']:.0f}", f"{row['strayed']:.2f}", f"{row['told']:.2f}"


def _table(head: Sequence[str], rows: Sequence[Any], cells: Callable[[Any], Sequence[str]]) -> list[str]:
    numbers = ["---" if i == 0 or name == "strip" else "---:" for i, name in enumerate(head)]
    return [f"| {' | '.join(row)} |" for row in (head, numbers, *map(cells, rows))]
