"""Parts with two states by finite elements: cut files meshed, put into each state and let go, and pushed over."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from elastica_cad import Flexure, PlaneCurve, Rod, read_curves
from elastica_cad.design.pair_table import read_pair
from elastica_cad.formats import write_drawing
from elastica_cad.pairs import FlexureSpec, FlexureTravel
from elastica_cad.pairs.flexure import CentreLine
from tests.campaign.finite_elements.bricks import Bricks, extrude
from tests.campaign.finite_elements.calculix import (
    Material,
    Printed,
    displaced,
    model_cards,
    run_deck,
    strict,
)
from tests.campaign.finite_elements.flat_mesh import mesh_cut_files

EXAMPLES = Path(__file__).parents[3] / "examples" / "two_states"

ASKED = 3e-3
"""Of the length, from the drawn curve."""

FIRST_PUSH, LARGEST_PUSH = 1 / 1000, 1 / 40
"""First and largest step of the pushed point, as fractions of its path.

If the first step is 1/30 (0.7 mm for the clip), Newton's method does not stay near the state and ends with pinched
elements: the force is then 3 % too large, and the clip does not rest in its other state."""

PINCHED = 0.01
"""Largest displacement of the faces of the sheet through its depth, as a fraction of the depth.

It is at most 0.0024 on the paths of the clip. With larger values, elements are pinched or turned inside out."""

CENTRE_MM = 0.2
"""Nodes nearer to the centre line hold it."""

STEPS_IN_HONEY = 12
"""On the way from where a part is let go to where it rests."""

HELD_MM = 1.0
"""Beyond its root a pad is held: what the root itself gives belongs to the part."""


@dataclass(frozen=True)
class FlexedPart:
    """What finite elements say of a part.

    Attributes
    ----------
    name : str
    deviation : (float, float)
        Largest distance of the centre line from the drawn curve, in lengths, of both states.
    told, found : (float, float)
        Largest push there and back, N: what the program tells, and what elements found; (0, 0) if none was asked.
    snapped : (bool, bool)
        Pushed over and let go, does it rest in the other state?
    """

    name: str
    deviation: tuple[float, float]
    told: tuple[float, float] = (0.0, 0.0)
    found: tuple[float, float] = (0.0, 0.0)
    snapped: tuple[bool, bool] = (False, False)

    @property
    def good(self) -> bool:
        """True if states and forces are within their limits and a pushed part rests in the other state."""
        near = max(self.deviation) <= ASKED
        forces = all(abs(f / t - 1) <= 0.1 for t, f in zip(self.told, self.found, strict=True) if t)
        return near and forces and (all(self.snapped) or not any(self.told))


def flexed_parts(
    folder: Path, names: Sequence[str] = ("stand", "clip", "lopsided clip")
) -> Iterator[FlexedPart]:
    """The two examples that are shipped, and a lopsided clip."""
    for name in names:
        if name == "lopsided clip":
            part = FlexureSpec(*(_lopsided(rise) for rise in (30.0, -15.0)), "pom-3").make()
        else:
            part = read_pair(EXAMPLES / f"{name}.toml", read_curves).make()
        yield flexed(name, part, folder / name.replace(" ", "-"), push=name != "stand")


def _lopsided(rise: float) -> PlaneCurve:
    x = 150 * np.array([0, 0.18, 0.37, 0.73, 0.82, 1])
    return PlaneCurve.spline(np.column_stack([x, [0, 0, rise, rise, 0, 0]]), degree=4)


def flexed(name: str, part: Flexure, folder: Path, *, push: bool, size: float = 0.9) -> FlexedPart:
    """The part put into both states and, where asked, pushed from each to the other."""
    folder.mkdir(parents=True, exist_ok=True)
    write_drawing(part.drawing(), folder / "part.dxf", force=True)
    across = float(
        part.centre.at(np.array([part.pushed[0]]))[0][0, 0]
    )  # a line of elements' sides to push at
    body = extrude(
        mesh_cut_files([folder / "part.dxf"], size=size, at=(across,)), [0.0, part.sheet.thickness]
    )
    s, off = _along(part, body.nodes)
    bodies = _Body(part, body, s, off)
    rests = [bodies.let_go(line, folder / f"state{i}") for i, line in enumerate(part.states)]
    rods = part.rods
    deviation = tuple(bodies.astray(rest, rod) for rest, rod in zip(rests, rods, strict=True))
    if not push:
        return FlexedPart(name, deviation)
    ways = [part.travel, part.travel_back]
    pushes = [bodies.pushed(i, rests[i], folder / f"push{i}") for i in (0, 1)]
    back = [bodies.astray(rest, rods[1 - i]) <= ASKED for i, (_, rest) in enumerate(pushes)]
    return FlexedPart(
        name,
        deviation,
        tuple(one.largest_force for one in ways),
        tuple(force for force, _ in pushes),
        tuple(back),
    )


def _along(part: Flexure, nodes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where along the unloaded part nodes (n, 3) lie, mm, and how far to its left."""
    reach = part.pad.length + part.fillet + 5
    s = np.linspace(-reach, part.pair.length + reach, 40001)
    place, angle = part.centre.at(s)
    i = cKDTree(place).query(nodes[:, :2])[1]
    normal = np.column_stack([-np.sin(angle[i]), np.cos(angle[i])])
    tangent = np.column_stack([np.cos(angle[i]), np.sin(angle[i])])
    away = nodes[:, :2] - place[i]
    return s[i] + (away * tangent).sum(axis=1), (away * normal).sum(axis=1)


def _curvature(line: CentreLine, s: np.ndarray, step: float = 1e-3) -> np.ndarray:
    """Curvature of a centre line, 1/mm, by central differences of its angle over 2 `step`, mm."""
    return (line.at(s + step)[1] - line.at(s - step)[1]) / (2 * step)


@dataclass(frozen=True, eq=False)
class _Body:
    part: Flexure
    body: Bricks
    s: np.ndarray
    off: np.ndarray

    @property
    def held(self) -> np.ndarray:
        """Nodes of the pads."""
        low, high = (
            -self.part.overhang(0.0),
            self.part.pair.length + self.part.overhang(self.part.pair.length),
        )
        return (self.s < low - HELD_MM) | (self.s > high + HELD_MM)

    @property
    def _turned(self) -> np.ndarray:
        """Nodes that are pushed, whose directions are along and across the push."""
        first = int(np.hypot(self.s - self.part.pushed[0], 3 * self.off).argmin())
        return np.hypot(*(self.body.nodes[:, :2] - self.body.nodes[first, :2]).T) < 1e-6

    @property
    def middle(self) -> np.ndarray:
        """Nodes of the plane half way through the depth, which the part does not leave."""
        return np.abs(self.body.nodes[:, 2] - self.part.sheet.thickness / 2) < 1e-9

    def pose(self, line: CentreLine) -> np.ndarray:
        """All nodes (n, 3) where a bent centre line has them, each section strained across as by bending.

        At y to the left of it the strain along is -(kappa - kappa0) y, and that across is -nu times as large. With
        sections of the unloaded shape, Newton's method needs up to six times as many steps, and may end in pinched
        elements.
        """
        place, angle = line.at(self.s)
        bent = _curvature(line, self.s) - _curvature(self.part.centre, self.s)
        bent[self.held] = 0.0
        off = self.off + self.part.sheet.poisson_ratio * bent * self.off**2 / 2
        normal = np.column_stack([-np.sin(angle), np.cos(angle)])
        return np.column_stack([place + off[:, None] * normal, self.body.nodes[:, 2]])

    def _cards(self) -> list[str]:
        sheet = self.part.sheet
        return model_cards(self.body, [Material(sheet.youngs_modulus, sheet.poisson_ratio, sheet.density)])

    def _put(self, line: CentreLine) -> list[str]:
        """The step that puts every node in its place in the plane."""
        moved = self.pose(line) - self.body.nodes
        cards = [displaced(i, j, moved) for i in range(len(moved)) for j in (0, 1)]
        return [
            "*STEP, NLGEOM",
            "*STATIC, DIRECT",
            "1., 1.",
            *strict(),
            "*BOUNDARY",
            *cards,
            *self._flat(),
            "*END STEP",
        ]

    def _flat(self) -> list[str]:
        return [f"{i + 1}, 3, 3, 0." for i in np.flatnonzero(self.middle | self.held)]

    def _kept(self, line: CentreLine) -> list[str]:
        moved = self.pose(line) - self.body.nodes
        return [displaced(i, j, moved) for i in np.flatnonzero(self.held) for j in (0, 1)]

    def _loose(self, line: CentreLine) -> list[str]:
        """The step in which only the pads are held."""
        return ["*STEP, NLGEOM, INC=300", "*STATIC", "1., 1., 1e-6", *strict(), "*BOUNDARY, OP=NEW",
                *self._kept(line), *self._flat()]  # fmt: skip

    def _free(self, line: CentreLine) -> list[str]:
        """The same; before it one that holds the centre line too.

        There sections come to what is left of their stress, so that the last step has little to do.
        """
        moved = self.pose(line) - self.body.nodes
        centre = np.flatnonzero((np.abs(self.off) < CENTRE_MM) & ~self.held & ~self._turned)
        begin = ["*STEP, NLGEOM, INC=300", "*STATIC", "1., 1., 1e-6", *strict(), "*BOUNDARY, OP=NEW"]
        kept = [*self._kept(line), *self._flat()]
        led = [displaced(i, j, moved) for i in centre for j in (0, 1)]
        return [*begin, *kept, *led, "*END STEP", *self._loose(line)]

    def let_go(self, line: CentreLine, folder: Path) -> np.ndarray:
        """Nodes (n, 3) at rest near a state."""
        deck = [
            *self._cards(),
            *self._put(line),
            *self._free(line),
            "*NODE PRINT, NSET=ALL",
            "U",
            "*END STEP",
        ]
        return self.body.nodes + self._run(deck, folder).displacements[-1]

    def _run(self, deck: Sequence[str], folder: Path) -> Printed:
        """Run a deck and require elements that are not pinched."""
        answer = run_deck(deck, folder, len(self.body.nodes))
        lifted = float(np.abs(answer.displacements[:, :, 2]).max())
        if lifted > PINCHED * self.part.sheet.thickness:
            raise RuntimeError(
                f"ccx in {folder}: the faces of the sheet moved by {lifted:.2g} mm. Use smaller steps."
            )
        return answer

    def astray(self, nodes: np.ndarray, rod: Rod) -> float:
        """Largest distance of the centre line from a state's curve, in lengths."""
        near = self.middle & (self.s > 0) & (self.s < rod.length) & (np.abs(self.off) < 0.6 * self._thick)
        centre = PlaneCurve.at(rod.curve, np.clip(self.s[near], 0, rod.curve.length))
        normal = np.column_stack([-np.sin(centre.angle), np.cos(centre.angle)])
        missed = nodes[near, :2] - centre.position - self.off[near, None] * normal
        return float(np.hypot(*missed.T).max()) / rod.length

    @property
    def _thick(self) -> np.ndarray:
        return self.part.thickness_range[1]

    def pushed(self, start: int, rest: np.ndarray, folder: Path) -> tuple[float, np.ndarray]:
        """The largest push, N, from one state over to the other, and the nodes when it is let go there."""
        line, part = self.part.states[start], self.part
        _, way = part.pushed
        way = way if start == 0 else -way
        far = float(np.hypot(*way))
        away = way / far
        plane = self._turned
        nodes = np.flatnonzero(plane)
        travel = part.travel if start == 0 else part.travel_back
        # the first peak, then over to where it goes on by itself
        over = 1.15 * (travel.snap or far)
        set_cards = ["*NSET, NSET=PUSHED", ", ".join(str(i + 1) for i in nodes),
                     "*TRANSFORM, NSET=PUSHED, TYPE=R",
                     f"{away[0]:.12g}, {away[1]:.12g}, 0., {-away[1]:.12g}, {away[0]:.12g}, 0."]  # fmt: skip
        turned = np.array([away, [-away[1], away[0]]])
        moved = self.pose(line) - self.body.nodes
        put = []
        for i in range(len(moved)):
            own = turned @ moved[i, :2] if plane[i] else moved[i, :2]
            put += [f"{i + 1}, {j + 1}, {j + 1}, {own[j]:.12g}" for j in (0, 1)]
        begin = [
            "*STEP, NLGEOM",
            "*STATIC, DIRECT",
            "1., 1.",
            *strict(),
            "*BOUNDARY",
            *put,
            *self._flat(),
            "*END STEP",
        ]
        free = [*self._free(line), "*END STEP"]
        zero = float((rest - self.body.nodes)[nodes[0], :2] @ away)
        hold = ["*STEP, NLGEOM, INC=1000", "*STATIC", f"{FIRST_PUSH:g}, 1., 1e-7, {LARGEST_PUSH:g}", *strict(),
                "*BOUNDARY, OP=NEW", *self._kept(line), *self._flat(),
                *(f"{i + 1}, 1, 1, {zero + over:.12g}" for i in nodes),
                "*NODE PRINT, NSET=PUSHED, TOTALS=ONLY, GLOBAL=YES", "RF", "*END STEP"]  # fmt: skip
        result = ["*NODE PRINT, NSET=ALL, GLOBAL=YES", "U", "*END STEP"]
        answer = self._run([*self._cards(), *set_cards, *begin, *free, *hold[:-1], *result], folder)
        forces = answer.forces[:, :2] @ away
        return float(forces.max()), self._sunk(answer.displacements[-1], line, travel, folder)

    def _sunk(self, moved: np.ndarray, line: CentreLine, travel: FlexureTravel, folder: Path) -> np.ndarray:
        """The nodes when the part, moved so, is let go in something as viscous as honey.

        In every step springs pull the centre line back to where it was before: the implicit Euler method for
        motion along the slope of the energy, which ends in the valley that it begins in. The last has none.
        """
        centre = np.flatnonzero((np.abs(self.off) < CENTRE_MM) & ~self.held)
        stiffness = 12 * travel.largest_force / (travel.snap or travel.travel[-1]) / centre.size
        springs = []
        for j in (1, 2):
            ids = j * len(self.body.nodes) + np.arange(centre.size)
            springs += [f"*ELEMENT, TYPE=SPRING1, ELSET=HONEY{j}",
                        *(f"{k}, {i + 1}" for k, i in zip(ids, centre, strict=True)),
                        f"*SPRING, ELSET=HONEY{j}", f"{j}", f"{stiffness:.12g}"]  # fmt: skip
        result = ["*NODE PRINT, NSET=ALL", "U", "*END STEP"]
        for step in range(STEPS_IN_HONEY + 1):
            last = step == STEPS_IN_HONEY
            pulls = [] if last else [
                "*CLOAD", *(f"{i + 1}, {j + 1}, {stiffness * moved[i, j]:.12g}" for i in centre for j in (0, 1))
            ]  # fmt: skip
            placed = [displaced(i, j, moved) for i in range(len(moved)) for j in (0, 1)]
            deck = [*self._cards(), *([] if last else springs),
                    "*STEP, NLGEOM", "*STATIC, DIRECT", "1., 1.", *strict(), "*BOUNDARY", *placed, *self._flat(),
                    *pulls, "*END STEP", *self._loose(line), *pulls, *result]  # fmt: skip
            moved = self._run(deck, folder / f"honey{step}").displacements[-1]
        return self.body.nodes + moved
