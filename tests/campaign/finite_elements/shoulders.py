"""Corners beside a tab: a flat bar with shoulders and fillets, bent as a solid in CalculiX."""

from pathlib import Path

import gmsh
import numpy as np

from tests.campaign.finite_elements.bricks import extrude
from tests.campaign.finite_elements.calculix import Material, displaced, model_cards, run_deck
from tests.campaign.finite_elements.flat_mesh import meshed


def corner_strain(width: float, tab: float, radius: float, material: Material, folder: Path) -> float:
    """Strain where a fillet of this radius, mm, meets the tab, over the tab's mean, of a sheet 1 mm thick.

    On its face, along the grain; half of the bar's upper half, whose ends are turned against each other.
    """
    long, end, high = width, 2.0 * tab, tab / 2 + radius
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Verbosity", 2)
        draw = gmsh.model.occ
        places = [
            (0, high),
            (0, width / 2),
            (-long, width / 2),
            (-long, 0),
            (end, 0),
            (end, tab / 2),
            (radius, tab / 2),
        ]
        points = [draw.addPoint(*at, 0.0) for at in places]
        arc = draw.addCircleArc(points[-1], draw.addPoint(radius, high, 0.0), points[0])
        rim = [*map(draw.addLine, points, points[1:]), arc]
        sheet = draw.addPlaneSurface([draw.addCurveLoop(rim)])
        draw.synchronize()
        flat = meshed([{sheet}] * 2, radius / 4)
    finally:
        gmsh.finalize()
    body = extrude(flat, [0.0, 0.25, 0.5])
    x, y, z = body.nodes.T
    turned = np.column_stack([np.where(x < 0, -z, z), 0 * y, 0 * z])
    far, near, neutral = np.abs(x + long) < 1e-6, np.abs(x - end) < 1e-6, z == 0
    fixed = far | near | neutral, (y < 1e-6) | neutral, far & neutral
    held = [displaced(i, j, turned) for j, there in enumerate(fixed) for i in np.flatnonzero(there)]
    top = [f"{i + 1}," for i in np.flatnonzero(near & (z > 0))]
    body_cards = [*model_cards(body, [material] * 2), "*NSET, NSET=TOP", *top]
    result = ["*NODE PRINT, NSET=ALL", "U", "*NODE PRINT, NSET=TOP, TOTALS=ONLY", "RF", "*END STEP"]
    deck = [*body_cards, "*STEP", "*STATIC", "*BOUNDARY", *held, *result]
    printed = run_deck(deck, folder, len(x))
    fillet = np.flatnonzero((np.abs(np.hypot(x - radius, y - high) - radius) < 1e-6) & (z > 0.4))
    last = fillet[np.argsort(x[fillet])][-2:]
    step, change = np.diff(body.nodes[last], axis=0)[0], np.diff(printed.displacements[0][last], axis=0)[0]
    mean = (
        8 * printed.forces[0, 0] / (tab * material.youngs_modulus)
    )  # linear from 0, over half the tab, 0.5 mm high
    return float(step @ change / (step @ step) / mean)
