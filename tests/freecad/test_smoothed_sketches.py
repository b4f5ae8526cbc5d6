"""Strips of sketched cubics, which are smoothed: faces, dimensions and volumes while poles of the sketch move."""

from functools import cache
from pathlib import Path
from typing import Any

import FreeCAD as App
import numpy as np
import Part
import pytest
import TechDraw  # noqa: F401 - pages need it loaded
from freecad.elastica_wb.features import flat, strip

from elastica_cad import PlaneCurve, check_equilibrium, optimal_rod
from tests.freecad.features import change, new

MOVES, WIDTH_MM = 5, 40.0


@cache
def cubics(number: int) -> list[np.ndarray]:
    """Poles of cubics as FreeCAD draws them, which strips can take wherever a pole was moved by 2 mm."""
    rng = np.random.default_rng(7)
    found: list[np.ndarray] = []
    while len(found) < number:
        n, span, kind = 4 + len(found) % 5, rng.uniform(300, 600), rng.integers(2)
        t = np.linspace(0, 1, n)
        wave = np.sin((1 + kind) * np.pi * t) + rng.uniform(-0.1, 0.1, n)
        shown = [np.column_stack([span * t, span * rng.uniform(0.15, 0.35) * wave]).round(2)]
        for pole in rng.integers(n, size=MOVES):
            shown.append(shown[-1] + np.eye(n)[:, [pole]] * rng.uniform(-2, 2, 2).round(2))
        if all(is_bendable(poles) for poles in shown):
            found.append(np.array(shown))
    return found


def is_bendable(poles: np.ndarray) -> bool:
    curve = PlaneCurve(uniform_knots(len(poles)), poles, 3)
    return check_equilibrium(curve).realizable and optimal_rod(curve).ratio < 6


def uniform_knots(poles: int) -> np.ndarray:
    return np.concatenate([np.zeros(3), np.arange(poles - 2.0), np.full(3, poles - 3.0)])


def overall_dimension(document: Any, part: Any) -> Any:
    """Put the part on a page, with the distance of its ends by their edges.

    FreeCAD 1.1 also counts the centres of edges that are nearly arcs as vertices, so numbers of vertices change.
    """
    page = document.addObject("TechDraw::DrawPage", "Page")
    page.Template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    templates = Path(App.getResourceDir()) / "Mod/TechDraw/Templates"
    page.Template.Template = str(next(templates.rglob("A3_*.svg")))
    view = document.addObject("TechDraw::DrawViewPart", "View")
    page.addView(view)
    view.Source, view.Direction, view.XDirection = [part], App.Vector(0, 0, 1), App.Vector(1, 0, 0)
    view.ScaleType, view.Scale = "Custom", 1.0
    document.recompute()
    x = [edge.CenterOfMass.x for edge in Part.makeCompound(view.getVisibleEdges()).Edges]
    dimension = document.addObject("TechDraw::DrawViewDimension", "Overall")
    dimension.Type = "DistanceX"
    dimension.References2D = [(view, f"Edge{k}") for k in (int(np.argmin(x)), int(np.argmax(x)))]
    page.addView(dimension)
    document.recompute()
    return dimension


def places(shape: Any) -> list[str]:
    """Kinds of the faces, in their order."""
    return [type(face.Surface).__name__ for face in shape.Faces]


def follow(document: Any, drawn: Any, move_pole: Any, moves: np.ndarray, **options: Any) -> None:
    sketch = drawn(moves[0], 3)
    made = new(strip.create, document, sketch)
    change(made, MaxWidth=WIDTH_MM, **options)
    part = new(flat.create, document, made)
    dimension = overall_dimension(document, part)
    kinds = places(part.Shape), places(made.Shape)
    for poles in moves[1:]:
        for number, pole in enumerate(poles):
            move_pole(sketch, number, pole)
        document.recompute()
        assert made.State == ["Up-to-date"], made.Reasons
        assert (places(part.Shape), places(made.Shape)) == kinds
        core = strip.strip_of(made)
        assert not any("have a corner" in reason for reason in made.Reasons)
        assert dimension.getRawValue() == pytest.approx(np.ptp(core.outline.bounds[:, 0]), abs=1e-4)
        for body in (part, made):
            assert body.Shape.isValid()
            # OpenCASCADE integrates the short spans of level ends roughly
            assert body.Shape.Volume == pytest.approx(core.area * core.sheet.thickness, rel=1e-4)
        top = max(part.Shape.Faces, key=lambda face: face.CenterOfMass.z)
        larger, smaller = top.makeOffset2D(0.1), top.makeOffset2D(-0.1)
        assert smaller.Area < top.Area < larger.Area


@pytest.mark.parametrize(("number", "smooth"), [(2, 0.0), (1, 0.5), (2, 2.0)])
def test_faces_dimensions_and_volumes_while_poles_move(document, drawn, move_pole, number, smooth):
    follow(document, drawn, move_pole, cubics(3)[number][:4], Smooth=smooth)


@pytest.mark.campaign
@pytest.mark.parametrize("number", range(30))
def test_thirty_sketches(document, drawn, move_pole, number):
    follow(document, drawn, move_pole, cubics(30)[number])
