"""Strips that bend as plates, solved by scipy with independent moments: shape, forces, margin, load limit."""

from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_bvp, solve_ivp
from scipy.optimize import brentq, root

EXACT = {"rtol": 1e-8, "atol": 1e-9}


def ashwell(width, kappa, thickness, nu):
    """Return M / (E I kappa), differentiated from the energy per length of Lamb's solution: D w kappa^2 g / 2."""
    x = (3 * (1 - nu**2)) ** 0.25 * np.sqrt(np.maximum(np.abs(kappa) / thickness, 1e-12)) * width

    def kept(x):
        y = np.minimum(x, 40.0)  # cosh over sinh is 1 beyond
        return (np.cosh(y) - np.cos(y)) / (np.sinh(y) + np.sin(y)) / x

    d = 1e-4 * x
    slope = (8 * (kept(x + d) - kept(x - d)) - (kept(x + 2 * d) - kept(x - 2 * d))) / (12 * d)
    return (1 - 2 * nu**2 * (kept(x) + x * slope / 4)) / (1 - nu**2)


def bend_by(straight, factor):
    """Return the curvature where kappa factor(kappa) is the moment over E I, by fixed-point iteration."""
    kappa = straight
    for _ in range(8):
        kappa = straight / factor(kappa)
    return kappa


class Bent(NamedTuple):
    """A bent shape at its nodes: places (n, 2), mm, angle, curvature, moment (N mm), internal force (n, 2), N."""

    position: np.ndarray
    angle: np.ndarray
    curvature: np.ndarray
    moment: np.ndarray
    force: np.ndarray


class OwnStrip(NamedTuple):
    """A strip clamped at both ends.

    Attributes
    ----------
    stiffness : callable
        E I of the flat strip by arc length, N mm2.
    factor : callable
        Factor on this E I, by arc length and curvature.
    load : callable, optional
        Weight by arc length, N/mm, downwards.
    """

    stiffness: object
    factor: object
    load: object = None

    @classmethod
    def cut(cls, width, sheet, *, heavy=False, softer=1.0):
        """Make a strip of a single sheet with `width`, a function of s, and the moment of `ashwell`."""
        E, h, nu = sheet.youngs_modulus / softer, sheet.thickness, sheet.poisson_ratio
        return cls(
            lambda s: E * h**3 / 12 * width(s),
            lambda s, kappa: ashwell(width(s), kappa, h, nu),
            (lambda s: sheet.density * 1e-9 * 9.80665 * h * width(s)) if heavy else None,
        )

    def curvature(self, s, moment):
        """Return kappa for moments, N mm."""
        return bend_by(moment / self.stiffness(s), lambda kappa: self.factor(s, kappa))

    def tangent(self, s, kappa):
        """Return dM/dkappa, N mm2."""
        d = 1e-5 * np.maximum(np.abs(kappa), 1e-4)
        high, low = ((kappa + e) * self.factor(s, kappa + e) for e in (d, -d))
        return self.stiffness(s) * (high - low) / (2 * d)

    def bent(self, rod, *, end=None):
        """Return the shape at the rod's nodes, by default between the ends of the rod, which is the guess."""
        size = float(self.stiffness(rod.s).mean())

        def along(s, state):  # forces and moments over `size`
            _, _, angle, moment, pull, push = state
            weight = np.zeros_like(s) if self.load is None else self.load(s) / size
            cos, sin = np.cos(angle), np.sin(angle)
            return np.array(
                [cos, sin, self.curvature(s, moment * size), sin * pull - cos * push, 0 * s, weight]
            )

        first, last = ([*rod.position[k], rod.angle[k]] for k in (0, -1))
        last[:2] = last[:2] if end is None else end
        moments = self.stiffness(rod.s) * self.factor(rod.s, rod.curvature) * rod.curvature / size
        B = float(self.stiffness(rod.s)[0]) / float(rod.stiffness[0]) / size
        solved = solve_bvp(
            along, lambda a, b: np.array([*(a[:3] - first), *(b[:3] - last)]), rod.s,
            np.vstack([rod.position.T, rod.angle, moments, -B * rod.force.T]), tol=1e-7, max_nodes=20000,
        )  # fmt: skip
        assert solved.success, solved.message
        found = solved.sol(rod.s)
        moment = found[3] * size
        return Bent(found[:2].T, found[2], self.curvature(rod.s, moment), moment, size * found[4:].T)

    def margin(self, s, bent, B):
        """Return the margin of a shape at the nodes s (n,): the lowest mu L^2 with a mode. B is E I where K is 1.

        (K_t h')' + (<lambda, T> + mu) h = <nu, N> along the strip. h vanishes at both ends and does not move them.
        """

        def at_the_end(mu):
            return self._determinant(s, bent, B, mu, s[-1:])[0]

        mus = np.arange(-100.0, 300.0, 10.0)
        signs = np.array([at_the_end(mu) for mu in mus])
        k = int(np.flatnonzero(signs[:-1] * signs[1:] < 0)[0])
        return brentq(at_the_end, mus[k], mus[k + 1], rtol=1e-7)

    def conjugate_point(self, s, bent, B):
        """Return the first place, mm, at which a clamp would give the shape a mode without stiffness."""
        place, value = s, self._determinant(s, bent, B, 0.0, s)
        away = place > 0.2 * s[-1]  # there is a zero of high order at the start
        k = int(np.flatnonzero(value[away][:-1] * value[away][1:] < 0)[0])
        (a, b), (u, v) = place[away][k : k + 2], value[away][k : k + 2]
        return a + (b - a) * u / (u - v)

    def _determinant(self, s, bent, B, mu, at):
        """Return the determinant of the fields and their displacement of the end, at places (m,), mm."""
        length, soft = s[-1], self.tangent(s, bent.curvature) / B

        def along(x, y):
            here = [np.interp(x, s, values) for values in (soft, bent.angle, *bent.force.T)]
            cos, sin = np.cos(here[1]), np.sin(here[1])
            pull = -(here[2] * cos + here[3] * sin) / B
            h, slope = y[:3], y[3:6]
            forced = np.array([0.0, -sin, cos]) / length**2
            return [*(slope / here[0]), *(forced - (pull + mu / length**2) * h), *(-sin * h), *(cos * h)]

        begin = [0, 0, 0, 1, 0, 0, *np.zeros(6)]
        run = solve_ivp(along, (0, length), begin, rtol=1e-7, atol=1e-9, t_eval=at)
        return np.array([np.linalg.det([y[:3], y[6:9], y[9:]]) for y in run.y.T])

    def limit(self, rod, near, options, parameter):
        """Return the parameter at which the second variation becomes singular: a system solved by Newton's method.

        Parameters
        ----------
        rod : Rod
            A rod with the strip's clamps.
        near : Bent
            A shape near the solution.
        asked : callable
            Function of the parameter: factor on the load, and position of the end, mm.
        parameter : float
            Parameter of `near`.
        """
        size, length = float(self.stiffness(rod.s).mean()), rod.length
        first, turn = [*rod.position[0], rod.angle[0]], float(rod.angle[-1])

        def shot(unknown):
            load, end = options(unknown[3])

            def along(s, y):
                _, _, angle, moment, pull, push = y[:6]
                cos, sin = np.cos(angle), np.sin(angle)
                weight = 0.0 if self.load is None else load * self.load(s) / size
                kappa = self.curvature(s, moment * size)
                soft = self.tangent(s, kappa) / size
                h, slope = y[6:9], y[9:12]
                forced = np.array([0.0, -sin, cos]) / length**2
                return [
                    cos, sin, kappa, sin * pull - cos * push, 0.0, weight,
                    *(slope / soft), *(forced + (pull * cos + push * sin) * h), *(-sin * h), *(cos * h),
                ]  # fmt: skip

            begin = [*first, *(np.array(unknown[:3]) / [length, length**2, length**2])]
            y = solve_ivp(along, (0, length), [*begin, 0, 0, 0, 1, 0, 0, *np.zeros(6)], **EXACT).y[:, -1]
            det = np.linalg.det([y[6:9] / length, y[12:15] / length**2, y[15:] / length**2])
            return [*((y[:2] - end) / length), y[2] - turn, det]

        scaled = [near.moment[0] * length / size, *(near.force[0] * length**2 / size), parameter]
        found = root(shot, scaled, tol=1e-7, options={"eps": 1e-6})
        assert found.success, found.message
        return found.x[3]
