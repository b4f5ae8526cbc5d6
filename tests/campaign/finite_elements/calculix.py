"""CalculiX (ccx, from Debian): a body led to a pose, let go but for its ends, and asked how it rests and swings."""

import re
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.campaign.finite_elements.bricks import Bricks

__all__ = [
    "Answer",
    "Material",
    "Printed",
    "displaced",
    "model_cards",
    "run",
    "run_deck",
    "solve",
    "strict",
    "weight_cards",
]

GRAVITY_MM_S2 = 9806.65

RESIDUAL = 1e-7
"""Of the forces, as a share of their mean: CalculiX asks for 5e-3, which is too coarse for a slender strip."""


@dataclass(frozen=True)
class Material:
    """E along the strip in MPa, nu, density in kg/m3; of plywood also G in the plane and E across, MPa."""

    youngs_modulus: float
    poisson_ratio: float
    density: float
    shear_modulus: float | None = None
    across: float | None = None

    @property
    def cards(self) -> list[str]:
        """Its lines in the deck; t, mm, s. Along x, across y and through z; through it nothing couples."""
        E, nu, G = self.youngs_modulus, self.poisson_ratio, self.shear_modulus
        density = ["*DENSITY", f"{self.density * 1e-12:.12g}"]
        if G is None:
            return ["*ELASTIC", f"{E:.12g}, {nu:.12g}", *density]
        across = self.across or E
        figures = (E, across, across, nu, 0.0, 0.0, G, G, G)
        first = ", ".join(f"{one:.12g}" for one in figures[:8])
        return ["*ELASTIC, TYPE=ENGINEERING CONSTANTS", f"{first},", f"{figures[8]:.12g}, 293.", *density]


@dataclass(frozen=True, eq=False)
class Answer:
    """Displacements (n, 3), mm, of all nodes at rest; eigenvalues (k,), 1/s2, and modes (k, n, 3) where asked."""

    displacement: np.ndarray
    eigenvalues: np.ndarray
    modes: np.ndarray


def solve(
    body: Bricks,
    materials: Sequence[Material],
    pose: np.ndarray,
    held: np.ndarray,
    folder: Path,
    *,
    gravity: Sequence[float] | None = None,
    modes: int = 0,
) -> Answer:
    """The rest shape of a flat body near a pose.

    In the first step every node is put where the pose has it and only slides across; in the second all but the
    held ones are let go. So no path can snap on the way: what moves is what the pose lacks in balance.

    Parameters
    ----------
    materials : sequence of Material
        Of the layers.
    pose : (n, 3) array
        Positions of the nodes, mm.
    held : (n,) bool array
        Nodes that stay in their pose.
    gravity : (gx, gy, gz), optional
        Direction in which things fall.
    modes : int
        How many swings about the rest shape are asked for.
    """
    deck = [
        *model_cards(body, materials),
        *_put(body, pose, held, gravity),
        *_let_go(body, pose, held, gravity),
    ]
    if modes:
        deck += ["*STEP, PERTURBATION", "*FREQUENCY", str(modes), "*END STEP"]
    return run(deck, len(body.nodes), folder)


@dataclass(frozen=True, eq=False)
class Printed:
    """What a deck of several steps prints: displacements (k, n, 3), mm, and total forces of a set (m, 3), N."""

    displacements: np.ndarray
    forces: np.ndarray


def run_deck(deck: Sequence[str], folder: Path, count: int) -> Printed:
    """What ccx prints of a deck whose first `count` nodes are the body's."""
    text = _said(deck, folder)
    rows = re.findall(r"total force[^\n]*\n\s*\n\s*(\S+)\s+(\S+)\s+(\S+)", text)
    return Printed(_displacements(text, count), np.array(rows, dtype=float).reshape(-1, 3))


def run(deck: Sequence[str], count: int, folder: Path) -> Answer:
    """What ccx answers to a deck whose first `count` nodes are the body's."""
    text = _said(deck, folder)
    moved = _displacements(text, count)
    return Answer(moved[0], _eigenvalues(text), moved[1:])


def _said(deck: Sequence[str], folder: Path) -> str:
    """The file that ccx prints into."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "strip.inp").write_text("\n".join(deck) + "\n")
    done = subprocess.run(["ccx", "strip"], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode or "*ERROR" in done.stdout:
        raise RuntimeError(f"ccx in {folder}: {done.stdout[-1500:]}")
    return (folder / "strip.dat").read_text()


def model_cards(body: Bricks, materials: Sequence[Material]) -> list[str]:
    """Nodes, elements, materials."""
    deck = [
        "*NODE, NSET=ALL",
        *(f"{i}, {x:.12g}, {y:.12g}, {z:.12g}" for i, (x, y, z) in enumerate(body.nodes, 1)),
    ]
    for layer, material in enumerate(materials):
        deck.append(f"*ELEMENT, TYPE=C3D20R, ELSET=LAYER{layer}")
        for i in np.flatnonzero(body.layer == layer):
            row = [int(i) + 1, *(body.bricks[i] + 1)]
            deck += [", ".join(map(str, row[:11])) + ",", ", ".join(map(str, row[11:]))]
        deck += ["*ELSET, ELSET=ALL", f"LAYER{layer}", f"*MATERIAL, NAME=M{layer}", *material.cards]
        deck.append(f"*SOLID SECTION, ELSET=LAYER{layer}, MATERIAL=M{layer}")
    return deck


def _put(body: Bricks, pose: np.ndarray, held: np.ndarray, gravity: Sequence[float] | None) -> list[str]:
    """The step that puts every node in its pose, free to slide across unless held."""
    moved = pose - body.nodes
    placed = [displaced(i, j, moved) for i in range(len(moved)) for j in (0, 2)]
    kept = [displaced(i, 1, moved) for i in np.flatnonzero(held)]
    begin = ["*STEP, NLGEOM", "*STATIC, DIRECT", "1., 1.", *strict()]
    return [*begin, "*BOUNDARY", *placed, *kept, *weight_cards(gravity), "*END STEP"]


def _let_go(body: Bricks, pose: np.ndarray, held: np.ndarray, gravity: Sequence[float] | None) -> list[str]:
    """The step that keeps the held nodes only."""
    fixed = [displaced(i, j, pose - body.nodes) for i in np.flatnonzero(held) for j in range(3)]
    begin = ["*STEP, NLGEOM, INC=200", "*STATIC", "1., 1., 1e-6", *strict()]
    result = ["*NODE PRINT, NSET=ALL", "U", "*NODE FILE", "U", "*END STEP"]
    return [*begin, "*BOUNDARY, OP=NEW", *fixed, *weight_cards(gravity), *result]


def displaced(node: int, direction: int, moved: np.ndarray) -> str:
    """A boundary condition; nodes and directions counted from 0."""
    return f"{node + 1}, {direction + 1}, {direction + 1}, {moved[node, direction]:.12g}"


def weight_cards(gravity: Sequence[float] | None) -> list[str]:
    """Weight of the body, falling along a direction; none without one."""
    if gravity is None:
        return []
    x, y, z = np.asarray(gravity, dtype=float) / np.linalg.norm(gravity)
    return ["*DLOAD, OP=NEW", f"ALL, GRAV, {GRAVITY_MM_S2}, {x:.12g}, {y:.12g}, {z:.12g}"]


def strict() -> list[str]:
    """Small residuals, and patience: a strip let go oscillates before it converges."""
    return ["*CONTROLS, PARAMETERS=FIELD", f"{RESIDUAL:g}, 1e-4, , , {RESIDUAL:g}",
            "*CONTROLS, PARAMETERS=TIME INCREMENTATION", "30, 40, 9, 60, 30, 4, , 30"]  # fmt: skip


def _displacements(text: str, count: int) -> np.ndarray:
    """Those printed (k, n, 3): at rest, then of each mode."""
    found = []
    for block in text.split("displacements")[1:]:
        rows = np.array([line.split() for line in block.splitlines()[2 : count + 2]], dtype=float)
        found.append(rows[np.argsort(rows[:, 0]), 1:])
    return np.array(found)


def _eigenvalues(text: str) -> np.ndarray:
    """In the order of the modes; negative where the strip leaves its rest shape."""
    if "E I G E N V A L U E   O U T P U T" not in text:
        return np.empty(0)
    block = text.split("E I G E N V A L U E   O U T P U T")[1].split("P A R T", maxsplit=1)[0]
    rows = re.findall(r"^\s+\d+\s+(\S+)\s+\S+\s+\S+\s+\S+\s*$", block, flags=re.MULTILINE)
    return np.array(rows, dtype=float)
