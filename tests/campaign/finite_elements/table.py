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

HEAD = """# Strips bent by finite elements

`make campaign-elements` writes this page. The program gmsh makes a mesh from the cutting file (DXF) of each
strip, and the program CalculiX bends this mesh in three dimensions. The elements are bricks of twenty nodes
(C3D20R), one brick through the thickness of each sheet, with large displacements. The tabs are held as drawn,
and the rest of the strip is free.

The *deviation* of a strip is the largest distance between its centre line and the drawn curve, divided by its
length. The centre line is the mean over each cross-section. *Computed* is the deviation that the program
reports for the same strip.

Words in the tables:

- *nu*: Poisson ratio of the sheet. If it is not 0, a bent strip curls across its width.
- *Heavy*: the strip is designed and bent with its own weight.
- *Corrected*: the widths are changed so that the strip takes its curve although it curls or has slots,
  narrow tabs or steps.
- *2 x 12* of a perforated strip: 2 columns and 12 rows of holes. *Steps of width*: the width changes abruptly.

The row *elements* of [the long test runs](trust.md) has the date and commit of the last run.
"""

DEFAULT = """The columns differ in the option `compensate`. *Not corrected*: `compensate=False`. *By default*:
widths are corrected for curl across the strip (anticlastic bending) only, if the Poisson ratio of the sheet
is known. *Corrected*: `compensate=True`, for all causes. The accuracy required of corrected strips is a
median of 3e-04 and a worst case of 1e-03."""

DRAWN = """A random generator with the seed 541126 draws the curves, the widths, the places of slots and the
widths of tabs (`drawn_requests.py`). The computation of the stiffness was not adjusted to these
strips, but four uncertainties of the model were set after these results: for slots; for slots that
are closer together than they are deep; for perforated and laminated plywood; and the least
uncertainty of any strip (1e-4 of the length).

Plywood has a Young's modulus of 15 times its shear modulus, and nu = 0.1. In the finite elements alone, its
modulus across the grain is 0.3 of the modulus along the grain. Sheets without grain have nu = 0.3.

*Uncertainty* is the error that the program expects of its own model. *From the sheet* is the reported effect of
a thickness that varies by 1 %, grain off by 2 degrees, clamps off by 0.5 degrees and a kerf off by 0.05 mm. The
finite elements do not include these errors. *Agrees*: the deviations of finite elements and program
differ by at most the uncertainty. The slots in the sheet without grain are 6 mm apart, and the program warns
of this."""

DRAWN_WORDS = {"even": "no grain", "ply": "plywood", "leaves": "glued plies", "tabbed": "narrow tabs",
               "tapered": "tapered in thickness", "made up for": "corrected"}  # fmt: skip
"""Words of the page for the words in the names of the strips."""

TABS = """A random generator with the seed 541127 draws two curves, widths and thicknesses. The tabs at both
ends have 0.2, 0.35 and 0.5 of the width of the strip. The sheets are those of the twelve strips
above. The length over which a clamp prevents curling (`RESTRAINT`) was set after these results, and
nothing else. The sum of computed deviation and uncertainty is at least the deviation of the
finite elements, and at most twice as large."""

SIDEWAYS = """Does a strip of equal width tip out of the plane of its curve? The columns *sideways* and *in its
plane* have its lowest eigenvalues (`*FREQUENCY, PERTURBATION` after the nonlinear step), in units
of E I / (m L^4), with the bending stiffness E I, the mass per length m and the length L. If an
eigenvalue is negative, the strip leaves its shape. *Computed* is the rating by `Strip.sideways`:
*ample* is stable, *undecided* means that the program cannot decide. *Ends pushed together*: both
ends are clamped in one line, and are the closer the larger k is; at k = 0.91 they meet. The strips
are 300 mm long, with nu = 0.3. Plain strips are 0.8 mm thick, laminated strips consist of two
sheets of 0.5 mm."""

TAPERED = """Strips 8 mm wide whose thickness varies. The mesh is made from the side view (DXF), with two
bricks across the width and elements of 8 mm along the strip. Rods are round, with twelve bricks
in a cross-section, and their diameter is the height of the side view. The tabs are held as drawn.
The required deviation is at most 1e-03."""

JOINED = """Strips 20 or 30 mm wide, made of two pieces. The strip is cut through, and a plate of the same sheet, as
wide as the strip, is glued over the joint. The tabs are held as drawn."""

FLEXURES = """Parts cut in the plane of a sheet. Each part is meshed from its DXF file, bent into each of its
states, and then released except for its pads, by which it is clamped. The columns of the states
have the largest distance of the centre line from the drawn curve, divided by the length. The
required distance is at most 3e-03. The clip is pushed at its middle from either state. The largest
push must be within a tenth of the computed push. After the push, the clip is released and moves
slowly, as in a viscous fluid. It must come to rest within 3e-03 of the curve of the other state.
*Rests in the other state*: from the first, from the second. In the run at 8b5ff0f99 the first step of
the push was too large (0.7 mm): elements of the clip were pinched, and the clip did not rest in its
second state. The rows here are newer."""

POCKETS = """Rigid walls 0.15 mm off both faces of the tabs hold the strips. The walls are 10 mm deep and
without friction, and the weight of the strips is included. Each tab touches the walls at two
places: where the free part of the strip ends, and at its tip. *Computed* is the result of
`Strip.held`. Strips of the Pavilion are of card, with their slots. Each of them takes at least
six minutes of processor time."""


BETWEEN = """The cutting files of strips with forces between their ends are bent into the drawn shape, and then
released except for their clamps. In the finite elements a cord is a spring that only pulls, from
the middle of one cross-section to the middle of another. A rail is a cord 100 m long: the strip can
slide, and the force keeps its direction. The force follows from the elongation of the spring. If the
spring is made for a force 20 % too large, the force changes by less than 1 % (tie, bow). The deviation
may be at most 3e-03 of the length, and the error of the force at most 3 % (column *within*).

The forces also compress the strips along their length. The force computed here for a strip on a
rail includes this compression. The design of a strip neglects it. For the shallow arch, the designed
rail force is therefore larger than that of the finite elements: by 4.5 % for a sheet of 0.8 mm, and
by 1.2 % for one of 0.4 mm."""


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
    lines = [
        HEAD,
        "## Accuracy of the finite elements",
        "",
        "Errors in cases with a closed form, for nu = 0.",
        "",
    ]
    lines += _table(("question", "error"), everything.get("known", []), _known)
    lines += ["", "## Deviations by the kind of strip", ""]
    groups = sorted({row["group"] for row in before + now})
    lines += [DEFAULT, ""]
    head = ("strips", "not corrected: median", "worst", "by default: median", "worst", "corrected: median",
            "worst")  # fmt: skip
    spreads = (before, usual, now)
    lines += _table(
        head, groups, lambda group: (group, *(cell for rows in spreads for cell in _spread(rows, group)))
    )
    for when, rows in (
        ("with widths that are not corrected", before),
        ("by default, where this differs", list(own.values())),
        ("with corrected widths", now),
    ):
        if rows:
            lines += ["", f"## Every strip {when}", "", _summary(rows), ""]
            head = ("strips", "strip", "length, widest (mm)", "deviation", "computed", "stability")
            lines += _table(head, rows, _strip)
    if everything.get("drawn"):
        lines += ["", "## Twelve strips drawn by a seed", "", DRAWN, ""]
        head = ("strip", "deviation", "computed", "uncertainty", "from the sheet", "agrees")
        lines += _table(head, everything["drawn"], _drawn)
    if everything.get("tabs"):
        lines += ["", "## Narrow tabs drawn by a seed", "", TABS, ""]
        head = ("strip", "deviation", "computed", "uncertainty", "from the sheet", "agrees")
        lines += _table(head, everything["tabs"], _drawn)
    if everything.get("sideways"):
        lines += ["", "## Stability sideways", "", SIDEWAYS, ""]
        lines += _table(
            ("strip", "width (mm)", "sideways", "computed", "in its plane"), everything["sideways"], _swung
        )
    if everything.get("tapered"):
        lines += ["", "## Tapered in thickness or diameter", "", TAPERED, ""]
        head = ("strip", "length (mm)", "thickness, diameter (mm)", "nodes", "deviation")
        lines += _table(head, everything["tapered"], _thinned)
    if everything.get("joined"):
        lines += ["", "## Joined of two pieces by a plate", "", JOINED, ""]
        head = ("strip", "plate (mm)", "deviation", "computed", "corrected: deviation", "computed")
        lines += _table(head, everything["joined"], _joined)
    if everything.get("flexures"):
        lines += ["", "## Parts with two states", "", FLEXURES, ""]
        head = ("strip", "first state", "second state", "push computed (N)", "found", "back computed (N)", "found",
                "rests in the other state")  # fmt: skip
        lines += _table(head, everything["flexures"], _flexed)
    if everything.get("between"):
        lines += ["", "## With forces between the ends", "", BETWEEN, ""]
        head = ("strip", "nodes", "deviation", "force computed (N)", "force found (N)", "within")
        lines += _table(head, everything["between"], _between)
    if everything.get("pockets"):
        lines += ["", "## In pockets with clearance", "", POCKETS, ""]
        head = ("strip", "length (mm)", "finite elements (mm)", "computed (mm)")
        lines += _table(head, everything["pockets"], _pocketed)
    return "\n".join(lines) + "\n"


def _summary(rows: list[dict[str, Any]]) -> str:
    shares = [row["strayed"] for row in rows]
    return f"{len(rows)} strips: median {statistics.median(shares):.1e}, worst {max(shares):.1e}."


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
    name = ", ".join(DRAWN_WORDS.get(word, word) for word in row["name"].split(", "))
    return name, *shares, "yes" if within else "no"


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
