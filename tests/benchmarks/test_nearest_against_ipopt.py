"""The nearest rod, and the same rod found by a general solver of nonlinear programs on the same discretisation.

IPOPT, through casadi, is given the rod as one would write it down: the angles of the edges, the coefficients of the
stiffness, the force and the moment are unknowns, the balance of every node (Eq. 3) is a condition, and all
derivatives are exact. Ours marches the balance and leaves the angles out.
"""

import json
import time
from statistics import median

import casadi
import numpy as np
import pytest

from elastica_cad import Limits, PlaneCurve, nearest_rod
from elastica_cad.form_finding.rod_map import StiffnessBasis

RATIO, NODES, COEFFICIENTS = 2.5, 201, 20
QUIET = {"ipopt.print_level": 0, "print_time": 0, "ipopt.sb": "yes", "ipopt.tol": 1e-10}


def test_sixteen_light_curves_against_ipopt(benchmark, reference_data):
    data = json.loads((reference_data / "reference" / "flower_pot.json").read_text())
    points = [np.array(one["cp_initial"]) * 1000 * data["scale_m_per_unit"] for one in data["curves"]]
    curves = [PlaneCurve(np.arange(-4.0, len(p) + 1), p, 4) for p in points]

    def ours(curve):
        return nearest_rod(curve, Limits(ratio=RATIO), samples=NODES, coefficients=COEFFICIENTS)

    ours(curves[0])
    taken = []
    for curve in curves:
        start = time.process_time()
        near = ours(curve)
        between = time.process_time()
        theirs, seconds = by_ipopt(curve)
        assert near.met
        assert near.mean_deviation == pytest.approx(theirs, rel=1e-3)
        taken.append((between - start, seconds))
    benchmark.pedantic(lambda: [ours(curve) for curve in curves], rounds=3)
    benchmark.extra_info["ratio"] = median(a / b for a, b in taken)
    benchmark.extra_info["one"] = median(a for a, _ in taken)
    assert benchmark.extra_info["ratio"] < 1


def by_ipopt(curve):
    """The least mean distance, mm, of a rod between the curve's ends, and the seconds that the solver took."""
    unknown, far, kept, start, low, high = program(curve)
    solver = casadi.nlpsol("rod", "ipopt", {"x": unknown, "f": far, "g": kept}, QUIET)
    began = time.process_time()
    found = solver(x0=start, lbx=low, ubx=high, lbg=0, ubg=0)
    seconds = time.process_time() - began
    assert solver.stats()["success"]
    return float(found["f"]) ** 0.5 * curve.length, seconds


def program(curve):
    """Unknowns, the mean square distance, what must vanish, a start and bounds; lengths in those of the curve."""
    drawn = curve.sample(NODES).position / curve.length
    drawn = drawn - drawn[0]
    coefficients, angle, force = (
        casadi.SX.sym(*one) for one in (("c", COEFFICIENTS), ("a", NODES - 1), ("F", 2))
    )
    edge, moment = casadi.SX.sym("h"), casadi.SX.sym("M")
    x, y = (casadi.vertcat(0, casadi.cumsum(edge * part(angle))) for part in (casadi.cos, casadi.sin))
    stiffness = casadi.mtimes(
        casadi.DM(StiffnessBasis(COEFFICIENTS).at(np.linspace(0, 1, NODES))), coefficients
    )
    bend = (angle[1:] - angle[:-1]) / edge
    balance = stiffness[1:-1] * bend - (moment + force[0] * y - force[1] * x)[1:-1]
    weight = np.full(NODES, 1 / (NODES - 1))
    weight[[0, -1]] /= 2
    far = casadi.dot(casadi.DM(weight), (x - casadi.DM(drawn[:, 0])) ** 2 + (y - casadi.DM(drawn[:, 1])) ** 2)
    kept = casadi.vertcat(balance, x[-1] - drawn[-1, 0], y[-1] - drawn[-1, 1])
    unknown = casadi.vertcat(coefficients, angle, edge, moment, force)
    along = np.unwrap(np.arctan2(*np.diff(drawn, axis=0).T[::-1]))
    free, even = np.full(3, np.inf), 1 / (NODES - 1)
    start = np.concatenate([np.full(COEFFICIENTS, (1 + RATIO) / 2), along, [even, 0, 0, 0]])
    low = np.concatenate([np.ones(COEFFICIENTS), np.full(NODES - 1, -np.inf), [even / 5], -free])
    high = np.concatenate([np.full(COEFFICIENTS, RATIO), np.full(NODES - 1, np.inf), [5 * even], free])
    return unknown, far, kept, start, low, high
