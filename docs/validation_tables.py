"""Writes explanation/validation.md, published numbers and ours: python docs/validation_tables.py."""

import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from elastica_cad.form_finding.limits import Limits  # noqa: E402  # the checkout's
from elastica_cad.form_finding.meridians import meridian  # noqa: E402
from elastica_cad.form_finding.nearest_search import nearest_rod  # noqa: E402
from elastica_cad.mechanics.discrete_rod import DiscreteRod  # noqa: E402
from elastica_cad.mechanics.least_ratio import optimal_rod  # noqa: E402
from elastica_cad.mechanics.stability import stability_determinant  # noqa: E402
from tests.validation import test_cantilever_tables as cantilevers  # noqa: E402
from tests.validation import test_elastica_tables as elasticas  # noqa: E402
from tests.validation import test_nearest_published as nearest  # noqa: E402
from tests.validation import test_optimal_ratios as ratios  # noqa: E402
from tests.validation import test_sideways as sideways  # noqa: E402

PAGE = ROOT / "docs" / "explanation" / "validation.md"
DATA = ROOT / "tests" / "data"

HEAD = """# Validation: published numbers and ours

Each table compares one source with the results of this program. `docs/validation_tables.py` writes the columns
*ours*, and a test runs it again. The tests in `tests/validation` compare more numbers, to tighter bounds.
[Strips bent by finite elements](../finite_elements.md) have a page of their own.
"""


def page() -> str:
    """The whole page."""
    return "\n".join([HEAD, *elastica(), *cantilever(), *lateral(), *paper(), *pot(), *revolution(), *code()])


def _table(title: str, source: str, test: str, columns: list[str], rows: list[list[str]]) -> Iterator[str]:
    yield f"## {title}\n\n{source} Tested by `tests/validation/{test}.py`.\n"
    yield f"| {' | '.join(columns)} |\n|{' --- |' * len(columns)}"
    yield from (f"| {' | '.join(row)} |" for row in rows)
    yield ""


def elastica() -> Iterator[str]:
    """The uniform strip between pinned and between clamped ends."""
    rows = []
    for one in elasticas.TABLE:
        for end in ("pinned", "clamped"):
            pressure, rise, _ = elasticas.pushed(one.alpha, end)
            numbers = (one.pressure, pressure, one.rise, rise)
            rows.append([f"{one.alpha:g} deg", end, *(f"{number:.5f}" for number in numbers)])
    yield from _table(
        "A uniform strip pushed together",
        "Timoshenko and Gere, *Theory of Elastic Stability*, section 2.7. The force is divided by the Euler force, "
        "and the rise by the length. *Angle* is the steepest angle of the strip.",
        "test_elastica_tables",
        ["angle", "ends", "force", "ours", "rise", "ours"],
        rows,
    )


def cantilever() -> Iterator[str]:
    """A load at the tip."""
    rows = []
    for one in cantilevers.MATTIASSON:
        drop, shortening, angle = cantilevers.under_tip_load(one.load)
        rows.append([f"{one.load:g}", f"{one.drop:.6f}", f"{drop:.6f}", f"{one.shortening:.6f}",
                     f"{shortening:.6f}", f"{one.angle:.6f}", f"{angle:.6f}"])  # fmt: skip
    yield from _table(
        "A cantilever with a load at its tip",
        "K. Mattiasson, *Int. J. Numer. Meth. Eng.* 17 (1981) 145-153. The load is P L² / E I, "
        "with the force P, the length L and the bending stiffness E I. "
        "Drop and shortening of the tip are divided by the length. The angle of the tip is in rad.",
        "test_cantilever_tables",
        ["load", "drop", "ours", "shortening", "ours", "angle", "ours"],
        rows,
    )


def lateral() -> Iterator[str]:
    """Leaving the plane."""
    rows = [
        [case, f"{value:.3f}", f"{sideways.critical_load(case):.3f}"]
        for case, (value, _) in sideways.LATERAL.items()
    ]
    yield from _table(
        "Strips that tip out of their plane",
        "The strip has length 1. The table contains the critical value of the load that its row names (moment, "
        "force or weight per length), divided by "
        "the square root of edgewise bending stiffness times torsional stiffness. Ours is the load at which the "
        "computed stability margin against tipping sideways is 0. The bent shape is computed at 601 points along "
        "the strip, and the margin at 201 points.",
        "test_sideways",
        ["source", "published", "ours"],
        rows,
    )


def paper() -> Iterator[str]:
    """Least ratios of the Pavilion."""
    rows = []
    for strip, (light, heavy) in ratios.PAVILION.items():
        curve = ratios.pavilion(strip)
        ours = optimal_rod(curve).ratio, optimal_rod(curve, ratios.CARD).ratio
        rows.append([f"strip {strip}", f"{light:.4f}", f"{ours[0]:.4f}", f"{heavy:.4f}", f"{ours[1]:.4f}"])
    yield from _table(
        "Pavilion of Hafner and Bickel: least stiffness ratio",
        "Hafner and Bickel 2021, section 9.1. The stiffness ratio is the largest stiffness of a strip divided by "
        "its smallest. The published ratios are results of their linear program. We ran it with so many "
        "points along the curve that more points do not change the ratios. The strips are computed without and "
        "with their weight.",
        "test_optimal_ratios",
        ["curve", "without weight", "ours", "with weight", "ours"],
        rows,
    )


def pot() -> Iterator[str]:
    """How far strips leave the drawn curves of the Flower Pot."""
    curves, published, _ = nearest.read_flower_pot(DATA)
    found = [nearest_rod(curve, Limits(ratio=2.5)) for curve in curves]
    ours = [nearest.hausdorff(c, near.rod.position) for c, near in zip(curves, found, strict=True)]
    rows = [
        [f"{i}", f"{100 * theirs:.1f}", f"{100 * own:.1f}"]
        for i, (theirs, own) in enumerate(zip(published, ours, strict=True), start=1)
    ]
    rows.append(["mean", f"{100 * published.mean():.1f}", f"{100 * np.mean(ours):.1f}"])
    yield from _table(
        "Flower Pot of Hafner and Bickel: distance from the drawn curves",
        "Hafner and Bickel 2021, section 9.2, results of their published code. The numbers are the largest "
        "distance of a strip from its drawn curve, in percent of the diagonal of the curve's bounding box. All our "
        "strips have a stiffness ratio of at most 2.5.",
        "test_nearest_published",
        ["curve", "theirs", "ours"],
        rows,
    )


def revolution() -> Iterator[str]:
    """Ends of the published meridians."""
    rows = []
    for i, one in enumerate(json.loads((DATA / "reference" / "revolution.json").read_text())["examples"]):
        line = meridian(
            one["a"], np.array(one["b"]), np.array(one["gamma0"]), one["alpha0"], one["total_length"]
        )
        end = line.curve.evaluate(line.curve.domain[1])
        off = np.hypot(*(end - one["gamma_end"])) / one["ds"]
        rows.append([f"{i + 1}", f"({one['gamma_end'][0]:.3f}, {one['gamma_end'][1]:.3f})",
                     f"({end[0]:.3f}, {end[1]:.3f})", f"{off:.1f}"])  # fmt: skip
    yield from _table(
        "Surfaces of revolution of Hafner and Bickel: ends of the meridians",
        "Hafner and Bickel 2021, section 9.4. Their published code integrates the meridian step by step with a "
        "method of first order. Therefore the error of its end (x, y) is up to ten times the length of a step. "
        "With "
        "shorter steps, their end approaches ours. The last column is the distance between both ends, divided by "
        "the length of a step of their code.",
        "test_revolution",
        ["surface", "theirs", "ours", "distance (steps)"],
        rows,
    )


def code() -> Iterator[str]:
    """Stability of one equilibrium of the authors' code."""
    data = json.loads((DATA / "reference" / "adjoint_check.json").read_text())
    arrays = {name: np.array(value) if isinstance(value, list) else value for name, value in data.items()}
    rod = DiscreteRod(arrays["K"], arrays["segment_angles"], arrays["lambda"], arrays["segment_lengths"])
    (place,) = stability_determinant(rod).sign_changes
    yield from _table(
        "Where a strip loses stability",
        "The published code of Hafner and Bickel computed one shape in equilibrium. A piece of the strip "
        "from its start is stable if it ends before the conjugate point. The table contains the arc length of the "
        "conjugate point, in the unit of length of their data.",
        "test_stability_reference",
        ["result", "theirs", "ours"],
        [["conjugate point", f"{data['sigma']:.8f}", f"{place:.8f}"]],
    )


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
    print(PAGE)
