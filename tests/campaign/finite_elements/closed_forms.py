"""What the harness must answer where the answer is known in closed form: shapes, a sag, a swing; and refinement."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.special import ellipeinc, ellipj

from elastica_cad import PlaneCurve, Rod, Sheet, Strip
from tests.campaign.finite_elements.bent_strip import bend_cut_strip

__all__ = ["Known", "arc", "elastica", "known_answers", "uniform_strip"]

LENGTH, WIDTH, THICKNESS = 300.0, 20.0, 0.8
GRAVITY_MM_S2 = 9806.65


@dataclass(frozen=True)
class Known:
    """One question: what is known, what was found; `error` is a share of the length, or of the answer."""

    name: str
    error: float

    def __str__(self) -> str:
        return f"| {self.name} | {self.error:.1e} |"


def known_answers(folder: Path, sizes: tuple[float, ...] = (8.0, 4.0)) -> Iterator[Known]:
    """All of them, with nu = 0, for which the rod is exact."""
    for size in sizes:
        for name, curve in {
            "arc of 120 degrees": arc(120.0),
            "elastica without inflection": elastica(0.8, -1.2, 1.6),
            "elastica with one inflection": elastica(0.7, -0.5, 3.2),
        }.items():
            bent = bend_cut_strip(uniform_strip(), folder, size=size, curve=curve)
            yield Known(f"{name}, elements of {size:g} mm", bent.deviation / LENGTH)
        strip, straight = uniform_strip(), PlaneCurve.spline([(0, 0), (LENGTH / 2, 0), (LENGTH, 0)], degree=2)
        E, rho, h = strip.sheet.youngs_modulus, strip.sheet.density * 1e-12, THICKNESS
        swings = bend_cut_strip(strip, folder, size=size, curve=straight, modes=2).eigenvalues
        exact = 22.373285**2 * E * h**2 / (12 * rho * LENGTH**4)  # clamped at both ends
        yield Known(
            f"square of the lowest natural frequency between clamps, elements of {size:g} mm",
            abs(swings[0] / exact - 1),
        )
        light = uniform_strip(density=5.0)
        sag = bend_cut_strip(light, folder, size=size, curve=straight, gravity=(0.0, -1.0)).deviation
        exact = 12 * light.sheet.density * 1e-12 * GRAVITY_MM_S2 * LENGTH**4 / (384 * E * h**2)
        yield Known(f"sag of {exact:.2g} mm between clamps, elements of {size:g} mm", abs(sag / exact - 1))


def uniform_strip(*, width: float = WIDTH, density: float = 700.0, poisson_ratio: float = 0.0) -> Strip:
    """A rectangle."""
    sheet = Sheet("known", THICKNESS, 9000.0, density, max_strain=0.02, poisson_ratio=poisson_ratio)
    return Strip(Rod.straight(LENGTH, 1.0), sheet, max_width=width)


def arc(degrees: float) -> PlaneCurve:
    """The shape of a uniform strip under moments at its ends."""
    angle = np.radians(degrees) * np.linspace(0.0, 1.0, 400)
    return _fitted(LENGTH / np.radians(degrees) * np.column_stack([np.sin(angle), 1 - np.cos(angle)]))


def elastica(k: float, first: float, last: float) -> PlaneCurve:
    """A piece of Euler's elastica of modulus k, in elliptic functions (Love, art. 263), as long as the strip."""
    u = np.linspace(first, last, 400)
    _, cn, _, amplitude = ellipj(u, k**2)
    rows = np.column_stack([2 * ellipeinc(amplitude, k**2) - u, -2 * k * cn])
    return _fitted(LENGTH / (last - first) * rows)


def _fitted(rows: np.ndarray) -> PlaneCurve:
    return PlaneCurve.fit(rows, degree=5, tolerance=1e-4)
