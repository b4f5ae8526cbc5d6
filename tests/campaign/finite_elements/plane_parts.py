"""Parts with two states as plane elements: cut files meshed by gmsh, large displacements, strain along the rim."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import gmsh
import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import splu

from elastica_cad.formats.drawing_files import write_drawing
from elastica_cad.pairs.flexure import CentreLine, Flexure
from tests.campaign.finite_elements.flat_mesh import _surface
from tests.campaign.finite_elements.flexures import HELD_MM, _along

__all__ = ["PlanePart", "plane_part"]

SIDE_MM, AROUND = 0.7, 48
"""Largest sides of triangles, and how many of them a full circle has."""

STILL = 1e-9
"""Largest force on a node that is free, over E times the depth and 1 mm."""

POINTS = ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3))
"""Of Hammer's quadrature in a triangle; each weighs a sixth."""

SLOPES = np.array([
    [[4 * (a + b) - 3, 4 * a - 1, 0, 4 - 8 * a - 4 * b, 4 * b, -4 * b],
     [4 * (a + b) - 3, 0, 4 * b - 1, -4 * a, 4 * a, 4 - 4 * a - 8 * b]]
    for a, b in POINTS
])  # fmt: skip
"""Derivatives of the shape functions (points, 2, 6)."""


@dataclass(frozen=True, eq=False)
class PlanePart:
    """Triangles of six nodes, in plane stress, of a material linear in Green's strain.

    Attributes
    ----------
    part : Flexure
    nodes : (n, 2) array
        mm, as cut.
    triangles : (m, 6) int array
    rim : (k, 3) int array
        Sides on the outline: both ends, then the middle.
    """

    part: Flexure
    nodes: np.ndarray
    triangles: np.ndarray
    rim: np.ndarray

    @cached_property
    def _places(self):
        """Along the part and to its left (n,), mm."""
        return _along(self.part, np.column_stack([self.nodes, np.zeros(len(self.nodes))]))

    @cached_property
    def held(self):
        """Numbers of the nodes of the pads."""
        s, _ = self._places
        length, over = self.part.pair.length, [self.part.overhang(at) for at in (0.0, self.part.pair.length)]
        return np.flatnonzero((s < -over[0] - HELD_MM) | (s > length + over[1] + HELD_MM))

    def pose(self, line: CentreLine):
        """All nodes (n, 2) where a bent centre line has them."""
        s, off = self._places
        place, angle = line.at(s)
        return place + off[:, None] * np.column_stack([-np.sin(angle), np.cos(angle)])

    @cached_property
    def _elements(self):
        """Gradients of the shape functions (points, m, 2, 6), areas (points, m), and places in the matrix."""
        J = np.einsum("pij,ejk->peik", SLOPES, self.nodes[self.triangles])
        gradients = np.linalg.solve(J, np.broadcast_to(SLOPES[:, None], (*J.shape[:2], 2, 6)))
        rows = np.stack([2 * self.triangles, 2 * self.triangles + 1], axis=2).reshape(-1, 12)
        return gradients, np.abs(np.linalg.det(J)) / 6, rows

    def _system(self, x):
        """Forces (2 n,) over E times the depth, mm, and their derivatives (2 n, 2 n)."""
        nu = self.part.sheet.poisson_ratio
        law = np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]]) / (1 - nu**2)
        gradients, areas, rows = self._elements
        force, matrix = np.zeros((len(rows), 12)), np.zeros((len(rows), 12, 12))
        for g, area in zip(gradients, areas, strict=True):
            F = np.einsum("ean,enc->eca", g, x[self.triangles])
            strain = (F.transpose(0, 2, 1) @ F - np.eye(2)) / 2
            voigt = np.stack([strain[:, 0, 0], strain[:, 1, 1], 2 * strain[:, 0, 1]], axis=1)
            B = np.empty((len(rows), 3, 12))
            for c in (0, 1):
                B[:, 0, c::2] = F[:, c, 0, None] * g[:, 0]
                B[:, 1, c::2] = F[:, c, 1, None] * g[:, 1]
                B[:, 2, c::2] = F[:, c, 0, None] * g[:, 1] + F[:, c, 1, None] * g[:, 0]
            stress = voigt @ law
            S = np.stack([stress[:, [0, 2]], stress[:, [2, 1]]], axis=1)
            force += area[:, None] * np.einsum("ei,eij->ej", stress, B)
            matrix += area[:, None, None] * (B.transpose(0, 2, 1) @ (law @ B))
            initial = area[:, None, None] * (g.transpose(0, 2, 1) @ S @ g)
            for c in (0, 1):
                matrix[:, c::2, c::2] += initial
        total = np.bincount(rows.ravel(), force.ravel(), minlength=x.size)
        places = (np.repeat(rows, 12, axis=1).ravel(), np.tile(rows, (1, 12)).ravel())
        return total, csr_matrix((matrix.ravel(), places), (x.size, x.size))

    def settled(self, x, fixed):
        """Nodes (n, 2) at rest near given ones, with fixed coordinates (numbers), and the forces (2 n,)."""
        free = np.setdiff1d(np.unique(self._elements[2]), fixed)
        drag = 1e-2
        force, matrix = self._system(x)
        for _ in range(400):
            if np.abs(force[free]).max() < STILL:
                return x, force
            inner = matrix[free][:, free].tocsc()
            inner.setdiag(inner.diagonal() * (1 + drag))
            step = splu(
                inner, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
            ).solve(-force[free])
            there = x.ravel().copy()
            there[free] += step
            there = there.reshape(-1, 2)
            new, slope = self._system(there)
            if np.abs(new[free]).max() < 3 * np.abs(force[free]).max() and np.abs(step).max() < 5:
                x, force, matrix, drag = there, new, slope, drag / 4 if drag > 1e-9 else 0.0
            else:
                drag = max(4 * drag, 1e-6)
        raise RuntimeError("the part finds no rest")

    def rest(self, line: CentreLine):
        """Nodes (n, 2) of the part let go near a state, with its pads held there."""
        return self.settled(self.pose(line), self._coordinates(self.held))[0]

    def _coordinates(self, nodes):
        return np.concatenate([2 * nodes, 2 * nodes + 1])

    def pushed(self, line: CentreLine, shapes, travel):
        """Push (k,), N, and nodes (k, n, 2) of the part pushed from rest near a state by (k,) mm.

        Each shape is sought near a centre line of `shapes`.
        """
        at, way = self.part.pushed
        s, off = self._places
        i = int(np.hypot(s - at, off).argmin())
        c, d = way / np.hypot(*way)
        frame = np.array([[c, d], [-d, c]])
        start = self.rest(line) @ frame.T
        fixed = np.append(self._coordinates(self.held), 2 * i)
        pushes, found = [], []
        for u, shape in zip(travel, shapes, strict=True):
            guess = self.pose(shape) @ frame.T
            guess[self.held] = start[self.held]
            guess[i, 0] = start[i, 0] + u
            x, force = self.settled(guess, fixed)
            pushes.append(force[2 * i] * self.part.sheet.youngs_modulus * self.part.sheet.thickness)
            found.append(x @ frame)
        return np.array(pushes), np.array(found)

    def strain(self, x):
        """Places along the part (k,), mm, and strains along the rim (k,), the larger of two points of each side."""
        s, _ = self._places
        strains = []
        for at in (-(3**-0.5), 3**-0.5):
            slopes = np.array([at - 0.5, at + 0.5, -2 * at])
            before, after = (
                np.hypot(*np.einsum("i,kij->kj", slopes, p[self.rim]).T) for p in (self.nodes, x)
            )
            strains.append(after / before - 1)
        worst = np.where(np.abs(strains[0]) > np.abs(strains[1]), *strains)
        return s[self.rim[:, 2]], worst


def plane_part(part: Flexure, folder: Path, side: float = SIDE_MM) -> PlanePart:
    """The triangles of the part's cut file, which is written into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    write_drawing(part.drawing(), folder / "part.dxf", force=True)
    gmsh.initialize(interruptible=False)
    try:
        options = {"General.Verbosity": 2, "Mesh.MeshSizeMax": side, "Mesh.MeshSizeFromCurvature": AROUND,
                   "Mesh.Algorithm": 6, "Mesh.ElementOrder": 2}  # fmt: skip
        for name, value in options.items():
            gmsh.option.setNumber(name, value)
        sheet = _surface(folder / "part.dxf")
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(2)
        tags, points, _ = gmsh.model.mesh.getNodes()
        place = np.full(int(tags.max()) + 1, -1)
        place[tags.astype(int)] = np.arange(tags.size)

        def elements(dim: int, tag: int, count: int):
            return place[gmsh.model.mesh.getElements(dim, tag)[2][0].astype(int).reshape(-1, count)]

        rims = [elements(1, abs(tag), 3) for _, tag in gmsh.model.getBoundary([(2, sheet)], oriented=False)]
        triangles = elements(2, sheet, 6)
    finally:
        gmsh.finalize()
    used, rows = np.unique(triangles, return_inverse=True)
    number = np.full(tags.size, -1)
    number[used] = np.arange(used.size)
    return PlanePart(part, points.reshape(-1, 3)[used, :2], rows.reshape(-1, 6), number[np.concatenate(rims)])
