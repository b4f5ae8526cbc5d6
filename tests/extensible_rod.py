"""A clamped extensible rod, pushed at a point: spline of its angle, multipliers, and signs of eigenvalues."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import BSpline
from scipy.linalg import eigh, solve

DEGREE, SPANS, POINTS = 5, 24, 8
"""Degree of the angle's spline, spans on each side of the pushed point, Gauss points in a span."""

STILL = 1e-10
"""Largest residual of a solution, relative to the smallest bending stiffness over the length."""

LARGEST_TURN = 0.5
"""Largest change of the angle in one Newton step, rad."""


class NoBalance(Exception):
    """Raised if Newton's method does not converge."""


@dataclass(frozen=True, eq=False)
class ExtensibleRod:
    """A rod of unit length between two clamps.

    The axial strain is <force, tangent> / axial stiffness everywhere. The unknowns are the coefficients of the
    angle and the multipliers: the force at the end (2,) and, if the pushed point is held, the push. A shape is
    stable if the symmetric matrix of Newton's method has as many negative eigenvalues as multipliers.

    Attributes
    ----------
    stiffness, natural, axial : function
        K, kappa_0 and E A over the least bending stiffness, by s in [0, 1].
    angles : (2,) array
        Angles at both clamps.
    end : (2,) array
        Vector from the first clamp to the second.
    at : float
        Position of the push.
    direction : (2,) array
        Unit vector of the push.
    """

    stiffness: object
    natural: object
    axial: object
    angles: np.ndarray
    end: np.ndarray
    at: float
    direction: np.ndarray

    @cached_property
    def knots(self):
        """Knots of the spline. The shear force jumps at the pushed point."""
        inner = np.concatenate(
            [np.linspace(0, self.at, SPANS + 1)[1:], np.linspace(self.at, 1, SPANS + 1)[1:-1]]
        )
        inner = np.sort(np.concatenate([inner, [self.at] * (DEGREE - 2)]))
        return np.concatenate([[0.0] * (DEGREE + 1), inner, [1.0] * (DEGREE + 1)])

    @cached_property
    def quadrature(self):
        """Gauss points and weights."""
        x, w = np.polynomial.legendre.leggauss(POINTS)
        edges = np.unique(self.knots)
        half = np.diff(edges)[:, None] / 2
        return (edges[:-1, None] + half * (1 + x)).ravel(), (half * w).ravel()

    @cached_property
    def rows(self):
        """Basis of the angle and of the curvature at the Gauss points."""
        s, _ = self.quadrature
        basis = BSpline(self.knots, np.eye(self.knots.size - DEGREE - 1), DEGREE)
        return basis(s), basis(s, 1)

    @cached_property
    def given(self):
        """K, kappa_0, E A and effect of the push at the Gauss points; mass matrix of the inner coefficients."""
        s, w = self.quadrature
        B = self.rows[0][:, 1:-1]
        felt = (s < self.at)[:, None] * self.direction
        return self.stiffness(s), self.natural(s), self.axial(s), felt, B.T @ (w[:, None] * B)

    def fitted(self, angle):
        """Return the coefficients that fit an angle, a function of s."""
        s, w = self.quadrature
        B = self.rows[0]
        c = np.empty(B.shape[1])
        c[[0, -1]] = self.angles
        rest = angle(s) - B[:, [0, -1]] @ self.angles
        root = np.sqrt(w)
        c[1:-1] = np.linalg.lstsq(root[:, None] * B[:, 1:-1], root * rest, rcond=None)[0]
        return c

    def _system(self, c, force, target):
        """Return residual and matrix. `force` is (2,) for a free rod and (3,) for a rod held at `target`."""
        B, D = self.rows
        _, w = self.quadrature
        K, natural, axial, felt, _ = self.given
        theta, bend = B @ c, D @ c - natural
        t = np.column_stack([np.cos(theta), np.sin(theta)])
        n = np.column_stack([-t[:, 1], t[:, 0]])
        L = force[:2] + (force[2] * felt if force.size == 3 else 0.0)
        along, across = (L * t).sum(axis=1), (L * n).sum(axis=1)
        stretch = along / axial
        reach = np.column_stack([t, (felt * t).sum(axis=1)])[:, : force.size]
        turned = np.column_stack([n, (felt * n).sum(axis=1)])[:, : force.size]
        # W = K bend^2 / 2 - along - along^2 / (2 axial)
        by_theta = -(1 + stretch) * across
        second = (1 + stretch) * along - across**2 / axial
        mixed = -((1 + stretch)[:, None] * turned + (across / axial)[:, None] * reach)
        right = np.append(self.end, 0.0 if target is None else target)[: force.size]
        residual = np.concatenate([
            (D.T @ (w * K * bend) + B.T @ (w * by_theta))[1:-1],
            -reach.T @ (w * (1 + stretch)) + right,
        ])  # fmt: skip
        corner = (B.T @ (w[:, None] * mixed))[1:-1]
        matrix = np.block([
            [(D.T @ ((w * K)[:, None] * D) + B.T @ ((w * second)[:, None] * B))[1:-1, 1:-1], corner],
            [corner.T, -reach.T @ ((w / axial)[:, None] * reach)],
        ])  # fmt: skip
        return residual, matrix

    def balanced(self, c, force, target, *, drag=0.0):
        """Return coefficients and force of an equilibrium, and the number of directions that lower the energy."""
        from_here, mass = c.copy(), self.given[4]
        for _ in range(40):
            residual, matrix = self._system(c, force, target)
            inner = c.size - 2
            residual[:inner] += drag * mass @ (c - from_here)[1:-1]
            matrix[:inner, :inner] += drag * mass
            if np.abs(residual).max() < STILL * max(1.0, np.abs(force).max()):
                falls = int((np.linalg.eigvalsh(matrix) < 0).sum()) - force.size
                return c, force, falls
            step = solve(matrix, -residual, assume_a="sym")
            largest = np.abs(self.rows[0][:, 1:-1] @ step[:inner]).max()
            step *= min(1.0, LARGEST_TURN / largest)
            c, force = np.concatenate([c[:1], c[1:-1] + step[:inner], c[-1:]]), force + step[inner:]
        raise NoBalance

    def sunk(self, c, force, target):
        """Return the stable shape that a rod reaches in a viscous fluid."""
        drag = 100.0 * float(np.abs(self.stiffness(self.quadrature[0])).max())
        for _ in range(400):
            try:
                there, f, falls = self.balanced(c, force, target, drag=drag)
            except NoBalance:
                falls = 1
            if falls:
                drag *= 4
                continue
            c, force, drag = there, f, drag / 2
            if drag < 1e-3:
                try:
                    c, force, falls = self.balanced(c, force, target)
                except NoBalance:
                    continue
                if falls == 0:
                    return c, force
                c, drag = self._off_the_ridge(c, force, target), 100.0
        raise NoBalance

    def _off_the_ridge(self, c, force, target):
        """Return the coefficients, moved along the direction that lowers the energy most."""
        matrix = self._system(c, force, target)[1]
        inner = c.size - 2
        A, C = matrix[:inner, :inner], matrix[:inner, inner:]
        null = np.linalg.svd(C.T)[2][force.size :].T
        _, vectors = eigh(null.T @ A @ null, null.T @ self.given[4] @ null)
        mode = null @ vectors[:, 0]
        return np.concatenate(
            [c[:1], c[1:-1] + 0.03 * mode / np.abs(self.rows[0][:, 1:-1] @ mode).max(), c[-1:]]
        )

    def rest(self, angle):
        """Return the rest shape near an angle (a function of s), as coefficients and force."""
        c = self.fitted(angle)
        force = np.zeros(2)
        try:
            there, f, falls = self.balanced(c, force, None)
            if falls == 0 and np.abs(self.rows[0] @ (there - c)).max() < 0.3:
                return there, f
        except NoBalance:
            pass
        return self.sunk(c, force, None)

    def position(self, c, force, s):
        """Return the positions (n, 2) of a shape at s."""
        fine = np.linspace(0, 1, 4001)
        theta = BSpline(self.knots, c, DEGREE)(fine)
        t = np.column_stack([np.cos(theta), np.sin(theta)])
        L = force[:2] + (force[2] * (fine < self.at)[:, None] * self.direction if force.size == 3 else 0.0)
        rate = (1 + (L * t).sum(axis=1) / self.axial(fine))[:, None] * t
        place = np.concatenate([[[0, 0]], np.cumsum((rate[1:] + rate[:-1]) / 2, axis=0) * fine[1]])
        return np.column_stack([np.interp(s, fine, column) for column in place.T])

    def reach(self, c, force):
        """Return the displacement of the pushed point along the push."""
        _, w = self.quadrature
        _, _, axial, felt, _ = self.given
        theta = self.rows[0] @ c
        t = np.column_stack([np.cos(theta), np.sin(theta)])
        L = force[:2] + (force[2] * felt if force.size == 3 else 0.0)
        return float(((felt * t).sum(axis=1) * (1 + (L * t).sum(axis=1) / axial)) @ w)

    def pushed(self, angle, far, steps=300):
        """Return travel and push (k,), from the rest shape near an angle until the push falls through zero."""
        c, force = self.rest(angle)
        zero = self.reach(c, force)
        force = np.append(force, 0.0)
        travel, pushes = [0.0], [0.0]
        for u in np.linspace(0, far, steps + 1)[1:]:
            try:
                there, f, falls = self.balanced(c, force, zero + u)
                jumped = falls > 0 or np.abs(self.rows[0] @ (there - c)).max() > 0.15
            except NoBalance:
                jumped = True
            if jumped:
                there, f = self._fallen(c, force, zero + u)
            c, force = there, f
            travel.append(u)
            pushes.append(float(force[2]))
            if pushes[-1] < 0:
                break
        return np.array(travel), np.array(pushes)

    def _fallen(self, c, force, target):
        """Return the shape that a rod reaches after the end of its branch. The fluid slows the first step, too."""
        drag = 1e4 * float(np.abs(self.stiffness(self.quadrature[0])).max())
        there, f, _ = self.balanced(c, force, target, drag=drag)
        return self.sunk(there, f, target)
