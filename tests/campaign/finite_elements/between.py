"""Strips with forces between the ends: a slat on a rail with a load, a strip with a tie, an even bow."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import elastica_cad as ec
from tests.campaign.finite_elements.bent_strip import flat_body, in_tabs, middle_line, on_curve
from tests.campaign.finite_elements.bricks import Bricks
from tests.campaign.finite_elements.calculix import Material, displaced, model_cards, run, strict

WITHIN, FORCES_WITHIN = 3e-3, 0.03
"""Required: distance from the drawn curve as a fraction of the length, and relative error of the forces."""

FAR = 1e5
"""Length of the cord, mm, that pulls as a rail pushes: its direction does not change when the strip slides."""

WAVE = ((0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0))

SHALLOW = ((0, 0), (60, 30), (120, 36), (150, 36), (180, 30), (240, 0))

SHEET = ec.Sheet("ply", 0.8, 9000.0, 680.0, max_strain=0.02, poisson_ratio=0.0)


@dataclass(frozen=True)
class BetweenEnds:
    """Result of finite elements for a strip with forces between its ends.

    Attributes
    ----------
    name : str
    nodes : int
        Number of nodes.
    deviation : float
        Largest distance of the middle line from the drawn curve, as a fraction of the length.
    computed, found : float
        Force of the rail or cord, N: of the program, and of the finite elements.
    """

    name: str
    nodes: int
    deviation: float
    computed: float
    found: float

    @property
    def good(self) -> bool:
        """True if shape and force are within the required accuracy."""
        return self.deviation <= WITHIN and abs(self.found / self.computed - 1) <= FORCES_WITHIN


@dataclass(frozen=True, eq=False)
class Setup:
    """Strip in its drawn pose, with stations that are held, loaded or tied.

    Attributes
    ----------
    name : str
    strip : Strip
    curve : PlaneCurve
        Pose, turned so that the held directions of the stations are those of the axes.
    stations : tuple of float
        mm.
    held : dict
        Directions (0, 1, 2) in which the mean of a station's section stays in its pose, by its number.
    pull : float
        Computed force, N, of the cord or rail.
    cord : (int, int)
        Numbers of the stations between which a cord pulls; the anchor comes after the stations.
    load : (int, (float, float)), optional
        Station and force in the plane, N.
    anchor : (float, float), optional
        Fixed end of a cord, mm.
    give : float
        Elongation of the cord under its computed pull, as a fraction of the length of the strip.
    clamped : bool
        True if the tabs are held.
    """

    name: str
    strip: ec.Strip
    curve: ec.PlaneCurve
    stations: tuple[float, ...]
    held: dict[int, tuple[int, ...]]
    pull: float
    cord: tuple[int, int]
    load: tuple[int, tuple[float, float]] | None = None
    anchor: tuple[float, float] | None = None
    give: float = 1e-3
    clamped: bool = True


def between_ends(folder: Path, size: float = 6.0) -> Iterator[BetweenEnds]:
    """A slat on a rail, two shallow arches on a rail, a strip with a tie and an even bow."""
    thin = replace(SHEET, thickness=SHEET.thickness / 2)
    setups = (
        slat_on_a_rail("slat on a rail with a load"),
        slat_on_a_rail("shallow arch on a rail with a load, 0.8 mm thick", SHALLOW, 0.5),
        slat_on_a_rail("shallow arch on a rail with a load, 0.4 mm thick", SHALLOW, 0.5, thin),
        tied_strip(),
        even_bow(),
    )
    for setup in setups:
        yield solved(setup, folder / setup.name.replace(" ", "-"), size)


def slat_on_a_rail(
    name: str, points: Sequence[tuple[float, float]] = WAVE, at: float = 0.56, sheet: ec.Sheet = SHEET
) -> Setup:
    """A clamped slat over a rail at a fraction of its length, with a load of 0.5 N at 0.3 of it."""
    curve = ec.PlaneCurve.spline(points, degree=5)
    stations = at * curve.length, 0.3 * curve.length
    solid = sheet.youngs_modulus * sheet.thickness**3 / 12
    force = 0.5 * (sheet.thickness / SHEET.thickness) ** 3
    rod = ec.optimal_rod(
        curve,
        between=ec.Rail(stations[0]),
        loads=ec.PointForce(stations[1], (0, -force)),
        largest_stiffness=24 * solid,
    )
    strip = ec.Strip(rod, sheet, max_width=rod.bending_stiffness * rod.ratio / solid)
    push = rod.between_forces[0] * rod.bending_stiffness
    far = curve.at([stations[0]]).position[0] + FAR * push / np.hypot(*push)
    return Setup(
        name, strip, rod.curve, stations, {}, float(np.hypot(*push)), (0, 2),
        load=(1, (0.0, -force)), anchor=(float(far[0]), float(far[1])), give=1e-4,
    )  # fmt: skip


def tied_strip() -> Setup:
    """A clamped wave that needs a tie between two places."""
    points = [(0, 0), (60, 60), (120, 70), (180, 10), (240, 5), (300, 50), (360, 0)]
    curve = ec.PlaneCurve.spline(points, degree=5)
    tie = 0.3 * curve.length, 0.8 * curve.length
    rod = ec.optimal_rod(curve, between=ec.Tie(*tie))
    strip = ec.Strip(rod, SHEET, max_width=30.0)
    pull = float(np.hypot(*rod.between_forces[0])) * strip.bending_stiffness
    return Setup("strip with a tie", strip, rod.curve, tie, {}, pull, (0, 1))


def even_bow() -> Setup:
    """A strip of constant width whose cord is 0.8 of its length."""
    arc = ec.PlaneCurve.arc((0, 0), 150, 2.5, 0.6)
    bow = ec.bow(arc, SHEET, max_width=20.0, min_width=20.0, ends=(ec.Tab(0.0), ec.Tab(0.0)))
    turned, _ = _turned(
        bow.strip.rod.curve, -float(np.arctan2(*np.subtract(*bow.strip.rod.position[[-1, 0]])[::-1]))
    )
    L = bow.length
    return Setup(
        "even bow", bow.strip, turned, (0.0, L / 2, L), {0: (0, 1, 2), 1: (1,), 2: (1, 2)}, bow.pull, (0, 2),
        clamped=False,
    )  # fmt: skip


def _turned(curve: ec.PlaneCurve, angle: float) -> tuple[ec.PlaneCurve, np.ndarray]:
    """A curve turned by an angle, rad, and the turn."""
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    full = np.eye(3)
    full[:2, :2] = turn
    return curve.transformed(full), turn


def solved(setup: Setup, folder: Path, size: float) -> BetweenEnds:
    """The strip as cut, put in its pose and let go but for what holds it."""
    strip, curve, length = setup.strip, setup.curve, setup.strip.rod.length
    sheet = strip.sheet
    body = flat_body(strip, folder, size=size, at=setup.stations)
    pose = on_curve(curve, body.nodes)
    clamps = in_tabs(strip, body.nodes) if setup.clamped else np.zeros(len(pose), dtype=bool)
    rows = [_section(body, s) for s in setup.stations]
    n = len(pose)
    # the mean of each section is a node of its own, on which cords, loads and supports act
    means = [weights @ body.nodes[row] for row, weights in rows]
    drawn = [weights @ pose[row] for row, weights in rows]
    if setup.anchor is not None:
        means.append(np.array([setup.anchor[0], 0.0, setup.anchor[1]]))
        drawn.append(means[-1])
    moved = np.vstack([pose - body.nodes, np.subtract(drawn, means)])
    model = model_cards(body, [Material(sheet.youngs_modulus, sheet.poisson_ratio, sheet.density)])
    model += [
        "*NODE, NSET=MEANS",
        *(f"{n + i}, {x:.12g}, {y:.12g}, {z:.12g}" for i, (x, y, z) in enumerate(means, 1)),
    ]
    model += ["*NSET, NSET=EVERY", "ALL, MEANS"]
    for i, (row, weights) in enumerate(rows):
        for j in range(3):
            model += _mean_equation(row, weights, n + i, j)
    model += _cord(setup, drawn, means, n + 1)
    dependent = {(int(row[0]), j) for row, _ in rows for j in range(3)}
    held = setup.held | dict.fromkeys(range(len(rows), len(means)), (0, 1, 2))
    put = [displaced(i, j, moved) for i in range(n) for j in (0, 2) if (i, j) not in dependent]
    put += [displaced(n + i, j, moved) for i in range(len(means)) for j in (0, 2)]
    keep = [displaced(i, 1, moved) for i in np.flatnonzero(clamps)]
    sideways = [displaced(n + i, 1, moved) for i, ways in held.items() if 1 in ways]
    fixed = [displaced(i, j, moved) for i in np.flatnonzero(clamps) for j in range(3)]
    fixed += [displaced(n + i, j, moved) for i, ways in held.items() for j in ways]
    loads = []
    if setup.load is not None:
        i, (x, z) = setup.load
        loads = ["*CLOAD", f"{n + i + 1}, 1, {x:.12g}", f"{n + i + 1}, 3, {z:.12g}"]
    deck = [
        *model,
        "*STEP, NLGEOM", "*STATIC, DIRECT", "1., 1.", *strict(), "*BOUNDARY", *put, *keep, *sideways, *loads,
        "*END STEP",
        "*STEP, NLGEOM, INC=200", "*STATIC", "1., 1., 1e-6", *strict(), "*BOUNDARY, OP=NEW", *fixed, *loads,
        "*NODE PRINT, NSET=EVERY", "U", "*END STEP",
    ]  # fmt: skip
    answer = run(deck, n + len(means), folder)
    strayed = body.nodes + answer.displacement[:n] - pose
    _, off = middle_line(body, strayed, length)
    found = _pull(setup, drawn, means + answer.displacement[n:])
    return BetweenEnds(setup.name, n, float(np.hypot(*off.T).max()) / length, _computed(setup), found)


def _computed(setup: Setup) -> float:
    """Computed force, N. Under a rail, the flat strip is compressed along its length; the rail yields."""
    if setup.anchor is None:
        return setup.pull
    rod = setup.strip.rod_to_bend
    flat = replace(rod, compression=replace(rod.compression, pull=np.zeros(rod.s.size - 1)))
    place = setup.strip.rod.curve.at(np.array(setup.stations[:1])).position[0]
    along = (np.array(setup.anchor) - place) / FAR
    push = setup.pull
    for _ in range(12):
        point = place + along * setup.give * rod.length * (1 - push / setup.pull)
        bent = ec.bend(flat, between=ec.Rail((float(point[0]), float(point[1]))))
        push = float(np.hypot(*bent.between_forces[0])) * setup.strip.bending_stiffness
    return push


def _section(body: Bricks, s: float) -> tuple[np.ndarray, np.ndarray]:
    """Nodes in the middle of the thickness at a station, and their shares of the width."""
    x, y, z = body.nodes.T
    row = np.flatnonzero((abs(x - s) < 1e-6) & (abs(z) < 1e-9))
    row = row[np.argsort(y[row])]
    edges = np.concatenate([y[row][:1], (y[row][1:] + y[row][:-1]) / 2, y[row][-1:]])
    return row, np.diff(edges) / np.ptp(y[row])


def _mean_equation(row: np.ndarray, weights: np.ndarray, mean: int, j: int) -> list[str]:
    """The mean displacement of a section is that of its own node; the first of its nodes depends on the others."""
    terms = [f"{node + 1}, {j + 1}, {w:.15g}" for node, w in zip(row, weights, strict=True)]
    terms.append(f"{mean + 1}, {j + 1}, -1.")
    return ["*EQUATION", str(len(terms)), *terms]


def _cord(setup: Setup, drawn: np.ndarray, flat: np.ndarray, first: int) -> list[str]:
    """A spring that only pulls; under the computed pull it is as long as drawn."""
    give = setup.give * setup.strip.rod.length
    slack = _apart(drawn, setup.cord) - give - _apart(flat, setup.cord)
    i, j = setup.cord
    return [
        "*ELEMENT, TYPE=SPRINGA, ELSET=CORD", f"900001, {first + i}, {first + j}",
        "*SPRING, ELSET=CORD, NONLINEAR",
        f"0., {slack - 1000:.12g}", f"0., {slack:.12g}", f"{100 * setup.pull:.12g}, {slack + 100 * give:.12g}",
    ]  # fmt: skip


def _apart(places: np.ndarray, pair: tuple[int, int]) -> float:
    return float(np.linalg.norm(places[pair[1]] - places[pair[0]]))


def _pull(setup: Setup, drawn: np.ndarray, found: np.ndarray) -> float:
    """Force of the cord, N, from its elongation."""
    give = setup.give * setup.strip.rod.length
    return setup.pull * (1 + (_apart(found, setup.cord) - _apart(drawn, setup.cord)) / give)
