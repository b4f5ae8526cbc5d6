"""Signatures as `help` and notebooks display them."""

import inspect
import pydoc

import elastica_cad as ec

FOREIGN = ("elastica_cad.", "typing.", "numpy.", "Annotated", "Option(")


def test_signatures_have_plain_types():
    values = [getattr(ec, name) for name in ec.__all__]
    texts = [str(inspect.signature(value)) for value in values if "__signature__" in dir(value)]
    assert len(texts) > 50
    assert not [text for text in texts if any(word in text for word in FOREIGN)]


def test_help_shows_them():
    shown = pydoc.render_doc(ec.Limits, renderer=pydoc.plaintext)
    assert "Limits(ratio: float | None = None, margin: float | None = None" in shown
    assert "spline(control_points: ArrayLike, degree: int = 4) -> Self" in pydoc.render_doc(
        ec.PlaneCurve, renderer=pydoc.plaintext
    )


def test_a_derived_record_has_its_own_signature():
    class Wider(ec.Tab):
        def __init__(self, by: float):
            super().__init__(width=by)

    assert str(inspect.signature(Wider)) == "(by: float)"
