"""Rods of all stiffness laws, with and without weight, and an independent boundary-value solver to check them."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import solve_bvp

from elastica_cad import (
    Gravity,
    Limits,
    Perforated,
    PlaneCurve,
    Profile,
    Sheet,
    Strip,
    nearest_rod,
    optimal_rod,
)
from elastica_cad.mechanics import LaminatedSection, PlainSection, RoundLaw, ThicknessLaw, optimal_laminate

GLASS = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.012)
RUBBERY = Sheet("rubbery", 2.0, 900.0, density=1150.0, max_strain=0.05, poisson_ratio=0.4)
G = 9.80665e-9  # N/mm3 for 1 kg/m3

LAWS = ("thickness", "rod", "tube", "width", "plate")


@dataclass(frozen=True)
class Design:
    """A rod to check: the name of a law, a curve, and whether the rod carries its weight."""

    law: str
    curve: PlaneCurve
    heavy: bool
    nearest: bool

    @property
    def material(self):
        return RUBBERY if self.heavy else GLASS

    @property
    def section(self):
        sheet = self.material
        if self.law == "thickness":
            return ThicknessLaw(sheet, 1.0, 8.0, width=25.0)
        if self.law in ("rod", "tube"):
            return RoundLaw(sheet, 1.0, 8.0, bore=0.7 if self.law == "tube" else 0.0)
        sheet = sheet if self.law == "plate" else Sheet("even", 2.0, 5000.0, 1200.0, 0.05, poisson_ratio=0.0)
        return PlainSection(sheet, 5.0, 120.0)

    def rod(self):
        gravity = Gravity(1.0) if self.heavy else None
        if self.nearest:
            return nearest_rod(
                self.curve, Limits(margin=2.0), gravity=gravity, section=self.section, samples=801
            ).rod
        return optimal_rod(self.curve, gravity, section=self.section, samples=801)


def designs(count=250):
    """Return arches, leaning arches and waves of 300 to 700 mm, of each law in turn, half of them with weight."""
    rng = np.random.default_rng(19)
    found = []
    for i in range(count):
        size, lean = rng.uniform(300, 700), rng.uniform(-0.15, 0.15)
        if i % 3 == 2:
            points = [(0, 0), (0.2, 0.3), (0.45, 0.35 + lean), (0.7, -0.05), (0.95, 0.05), (1.15, 0.3)]
        else:
            points = [(0, 0), (0.1 + lean, 0.35), (0.5, rng.uniform(0.4, 0.6)), (0.9 + lean, 0.3), (1, 0)]
        curve = PlaneCurve.spline(size * np.array(points), degree=4)
        found.append(Design(LAWS[i % 5], curve, heavy=i % 2 == 1, nearest=i % 3 == 2 or i % 4 == 3))
    return found


def laminates(count=50):
    """Yield arches and waves of 100 to 250 mm in two glued layers, half of them with weight: rod, E I, weight."""
    rng = np.random.default_rng(20)
    for i in range(count):
        size, lean = rng.uniform(100, 250), rng.uniform(-0.05, 0.05)
        points = [(0, 0), (0.15 + lean, 0.3), (0.5, rng.uniform(0.3, 0.45)), (0.85 + lean, 0.3), (1, 0)]
        if i % 3 == 2:  # a single inflection
            points = [(0, 0), (0.17, 0.26), (0.39, 0.3 + lean), (0.61, -0.04), (0.83, 0.04), (1, 0.26)]
        curve = PlaneCurve.spline(size * np.array(points), degree=4)
        thin, thick = rng.uniform(0.15, 0.2), rng.uniform(0.2, 0.3)
        base = Sheet("base", thin, rng.uniform(1500, 3000), density=rng.uniform(600, 1200), max_strain=0.05)
        backing = Sheet(
            "backing", thick, rng.uniform(1500, 3000), density=rng.uniform(600, 1200), max_strain=0.05
        )
        width = Profile.interpolate([0.0, curve.length / 2, curve.length], rng.uniform(20, 24, 3))
        down = (0, -1) if i % 2 else None
        made = optimal_laminate(curve, LaminatedSection(base, backing), width, direction=down, samples=801)
        w1, w2 = made.base_width, made.backing_width
        A1, A2 = base.youngs_modulus * thin * w1, backing.youngs_modulus * thick * w2
        apart = (thin + thick) / 2
        EI = (A1 * thin**2 + A2 * thick**2) / 12 + A1 * A2 / (A1 + A2) * apart**2
        weight = G * (base.density * thin * w1 + backing.density * thick * w2)
        yield made.rod, EI, weight if down else 0.0 * weight


def perforated(count=50):
    """Yield arches and waves of 150 to 400 mm with columns of holes: rod, E I, weight.

    They have one to three columns, and half of them carry weight. The remaining width at a station is measured on
    the loops of the cut file, as the sum of chords across the loops.
    """
    rng = np.random.default_rng(21)
    for i in range(count):
        size, lean = rng.uniform(150, 400), rng.uniform(-0.05, 0.05)
        points = [(0, 0), (0.15 + lean, 0.3), (0.5, rng.uniform(0.3, 0.45)), (0.85 + lean, 0.3), (1, 0)]
        if i % 3 == 2:  # a single inflection
            points = [(0, 0), (0.17, 0.26), (0.39, 0.3 + lean), (0.61, -0.04), (0.83, 0.04), (1, 0.26)]
        curve = PlaneCurve.spline(size * np.array(points), degree=4)
        sheet = Sheet("card", 0.4, rng.uniform(800, 3000), density=rng.uniform(600, 1400), max_strain=0.05)
        gravity = sheet.gravity() if i % 2 else None
        rod = optimal_rod(curve, gravity, samples=801)
        if rod.ratio > 3.5:  # more than holes can remove
            rod = nearest_rod(curve, Limits(ratio=3.5, margin=2.0), gravity=gravity, samples=801).rod
        length, wide = rod.length, rng.uniform(36, 48, 3)
        style = Perforated(
            Profile.interpolate([0.0, length / 2, length], wide),
            columns=1 + i % 3, rows=None if i % 4 else 5, sides="arc" if i % 5 == 4 else "spline",
        )  # fmt: skip
        strip = Strip(rod, sheet, style=style)
        s = np.clip(rod.s, 1e-6, length - 1e-6)  # the section inside the ends counts, not the tab
        left = across(strip.outline, s) - sum(across(hole, s) for hole in strip.holes)
        EI = sheet.youngs_modulus * left * sheet.thickness**3 / 12
        weight = sheet.density * G * sheet.thickness * left
        result = replace(rod, bending_stiffness=strip.bending_stiffness)
        yield result, EI, weight if i % 2 else 0.0 * weight


def across(loop, s):
    """Return the length (n,) of the chords across a closed path at the stations (n,)."""
    points, total = loop.points(1e-4), np.zeros(s.size)
    for (x, y), (x1, y1) in zip(points, np.roll(points, -1, axis=0), strict=True):
        first, last = np.searchsorted(s, sorted((x, x1)))
        met = slice(first, last)
        if last > first:
            total[met] += np.sign(x1 - x) * (y + (y1 - y) / (x1 - x) * (s[met] - x))
    return np.abs(total)


def section_numbers(design, parameter, curvature):
    """Return E I (N mm2) and weight (N/mm) by textbook formulas, from the sizes of the section."""
    sheet, p = design.material, parameter
    E, rho = sheet.youngs_modulus, sheet.density * G
    if design.law == "thickness":
        return E * 25.0 * p**3 / 12, rho * 25.0 * p
    if design.law == "rod":
        return E * np.pi * p**4 / 64, rho * np.pi * p**2 / 4
    if design.law == "tube":
        return E * np.pi * (p**4 - (0.7 * p) ** 4) / 64, rho * np.pi * (p**2 - (0.7 * p) ** 2) / 4
    if design.law == "width":
        return 5000.0 * p * 8.0 / 12, 1200.0 * G * 2.0 * p
    nu, h = sheet.poisson_ratio, sheet.thickness
    x = (3 * (1 - nu**2)) ** 0.25 * p * np.sqrt(np.abs(curvature) / h)
    return E * p * h**3 / 12 * _plate_factor(x, nu), rho * h * p


def _plate_factor(x, nu):
    """Return moment over E I kappa of a strip with curled cross-sections, from the energy of Lamb's strip."""

    def energy(x):
        t = np.maximum(x, 1e-3)
        f = (np.cosh(t) - np.cos(t)) / (np.sinh(t) + np.sin(t))
        return 1 - 2 * nu**2 * f / t

    step = 1e-5 * np.maximum(x, 1e-3)
    return (energy(x) + x * (energy(x + step) - energy(x - step)) / (2 * step) / 4) / (1 - nu**2)


def errors(design, seed=0):
    """Compare a design with an independent solver: shape over length, camber place over chord, end force."""
    rod = design.rod()
    section = design.section.bent(rod.curvature)
    parameter = section.parameter(rod.bending_stiffness * rod.stiffness)
    EI, weight = section_numbers(design, parameter, rod.curvature)
    return judged(rod, EI, weight if design.heavy else 0.0 * weight, seed)


def judged(rod, EI, weight, seed=0):
    """Do the same for any rod with E I (N mm2) and weight (N/mm) at its stations."""
    length, scale = rod.length, float(EI.max())
    stiffness, load = (
        lambda s: np.interp(s * length, rod.s, EI) / scale,
        lambda s: np.interp(s * length, rod.s, weight) * length**3 / scale,
    )

    def slopes(s, y):
        _, _, angle, moment, nx, ny = y
        return np.array(
            [np.cos(angle), np.sin(angle), moment / stiffness(s), nx * np.sin(angle) - ny * np.cos(angle),
             0 * nx, load(s)]
        )  # fmt: skip

    ends = np.array([[*rod.position[i] / length, rod.angle[i]] for i in (0, -1)])

    def held(a, b):
        return np.concatenate([a[:3] - ends[0], b[:3] - ends[1]])

    rng = np.random.default_rng(seed)
    bump = np.sin(np.pi * rod.s / length) * rng.uniform(-0.03, 0.03)
    moment = EI / scale * rod.curvature * length * (1 + bump)
    force = -rod.force * rod.bending_stiffness * length**2 / scale * (1 + rng.uniform(-0.1, 0.1))
    guess = np.vstack([rod.position.T / length, rod.angle + bump, moment, force.T])
    found = solve_bvp(slopes, held, rod.s / length, guess, tol=1e-6, max_nodes=60000)
    assert found.success, found.message
    y = found.sol(rod.s / length)
    shape = float(np.hypot(*(y[:2].T - rod.position / length).T).max())
    place = abs(camber_place(y[:2].T) - camber_place(rod.position))
    newtons = np.array([y[4:6, i] for i in (0, -1)]) * scale / length**2
    designed = -rod.force[[0, -1]] * rod.bending_stiffness
    size = np.hypot(*designed.T).max()
    return shape, place, float(np.hypot(*(newtons - designed).T).max() / size)


def camber_place(position):
    """Return the position along the chord where the shape is farthest from it, in chords."""
    chord = position[-1] - position[0]
    along = (position - position[0]) @ chord / (chord @ chord)
    off = np.abs((position - position[0]) @ np.array([-chord[1], chord[0]]))
    k = int(np.clip(off.argmax(), 1, off.size - 2))
    a, b, _ = np.polyfit(along[k - 1 : k + 2] - along[k], off[k - 1 : k + 2], 2)
    return along[k] - b / (2 * a)
