"""Bound on computations that no option requests: trials of changes, and the effect of a weight left out."""

from elastica_cad.errors import Refusal, note
from elastica_cad.geometry.plane_curve import PlaneCurve

MOST_PIECES = 2000
"""Largest number of polynomial pieces of a curve for which anything is computed without a request.

Each trial of a change bends a strip again, in a time and a memory that grow with the number of pieces."""

MOST_CORNERS = 100
"""Largest number of corners of a curve for which the nearest curve is tried without a request."""

MOST_INFLECTIONS = 500
"""Largest number of inflections of a curve for which a rail, pin or tie is sought without a request."""

MOST_STEPS = 300
"""Largest total number of steps of the searches for a nearest curve after one refusal."""


def not_tried(curve: PlaneCurve) -> Refusal | None:
    """Return why nothing is computed for a curve without a request, or None for a curve of usual size."""
    pieces = len(curve.bezier_table[1])
    if pieces <= MOST_PIECES:
        return None
    return note(
        "Not tried, because the curve has {pieces} pieces, more than {most}. Draw the curve with fewer points.",
        pieces=pieces, most=MOST_PIECES,
    )  # fmt: skip
