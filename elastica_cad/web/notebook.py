"""The studio in a notebook. The page is the same, but the kernel of the notebook answers its requests."""

import json
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from elastica_cad._exports import installed_modules
from elastica_cad.defaults import MAX_WIDTH, SHEET
from elastica_cad.errors import missing_library
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import require_curve
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.web.answers import requested_spec
from elastica_cad.web.saved_design import curve_table
from elastica_cad.web.vocabulary import page_words
from elastica_cad.web.worker import reply

if TYPE_CHECKING:
    from anywidget import AnyWidget

MODULES = (
    "channel.js", "colors.js", "design.js", "drawing.js", "flat.js", "forms.js", "vendor/three.module.min.js",
    "space.js", "starts.js", "studio.js",
)  # fmt: skip
"""Script files of the page. A file comes after the files that it imports."""


@installed_modules()
def studio(curve: PlaneCurve | None = None, **keys: Any) -> "AnyWidget":
    """Return the studio as a widget of a notebook, to draw a curve for later cells.

    The widget requires anywidget.

    Parameters
    ----------
    curve : PlaneCurve, optional
        Initial curve; by default the drawing is empty.
    **keys
        Keys of a strip, as in a design file: `sheet="pom-1"`, `max_width=20`, `limits={"ratio": 3}`. Lengths
        are in mm.

    Returns
    -------
    AnyWidget
        Widget. Its `value` is the drawn curve (PlaneCurve) and the request (StripSpec); its `design` has the
        tables of a design file.

    Raises
    ------
    MissingDependencyError
        anywidget is not installed.

    Examples
    --------
    >>> drawn = studio(PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]), max_width=30)
    >>> curve, spec = drawn.value
    >>> round(curve.length, 1), spec.max_width
    (202.2, 30.0)
    """
    if curve is not None:
        require_curve(curve)
    table: dict[str, Any] = {"spline": [], "degree": 4} if curve is None else curve_table(curve)
    design = {"schema": 1, "name": "strip", "sheet": SHEET, "max_width": MAX_WIDTH, **keys}
    widget: AnyWidget = _widget()(
        design=design | {"strips": [{"label": "A1", "curve": table}]}, hello=page_words() | {"starts": {}}
    )
    return widget


@cache
def _widget() -> type["AnyWidget"]:
    """Return the class of the widget, which needs packages that are imported on first use."""
    try:
        from anywidget import AnyWidget
        from traitlets import Dict
    except ImportError:
        raise missing_library("the studio in a notebook needs anywidget", "anywidget") from None
    page = files("elastica_cad.web").joinpath("page")
    texts = {f"./{name}": page.joinpath(name).read_text(encoding="utf-8") for name in MODULES}

    class Studio(AnyWidget):
        _esm = (
            f"const MODULES = {json.dumps(texts)};\n{page.joinpath('widget.js').read_text(encoding='utf-8')}"
        )
        _css = page.joinpath("studio.css").read_text(encoding="utf-8")
        design = Dict().tag(sync=True)
        hello = Dict().tag(sync=True)

        def __init__(self, **values: Any) -> None:
            super().__init__(**values)
            self.on_msg(self._answer)

        @installed_modules()
        def _answer(self, _: Any, question: Mapping[str, Any], __: Any) -> None:
            kind, content = reply(json.dumps(question).encode())
            head, _, file = content.partition(b"\n") if kind == b"file" else (content, b"", b"")
            self.send(json.loads(head), [file] if kind == b"file" else None)

        @property
        def value(self) -> tuple[PlaneCurve, StripSpec]:
            spec = requested_spec(self.design)
            return spec.curve, spec

    return Studio
