"""The bend coupon: a strip to cut, hang over an edge and measure, with its scale engraved."""

import numpy as np

from elastica_cad._values import require_positive, require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.segments import Line
from elastica_cad.mechanics.sheets import Sheet, require_printable
from elastica_cad.refusals import Length
from elastica_cad.strip.drawing import CUT_OUTER, ENGRAVE, Drawing, LayeredPath
from elastica_cad.strip.lettering import Text, centred_text, text_width

BEST_LOAD = 5.0
"""Load w L^3 / EI for which a clamped strip drops by half its length; its droop then depends most on E."""

TICK_MM, LONG_TICK_MM = 10.0, 50.0
"""Steps of the scale, mm."""

MOST_OVERHANG_MM = 10_000.0
"""Longest scale, mm."""

EDGE_MM = 0.5
"""Distance of engraving from the edge, mm, so that a tick is not a notch."""


def coupon_overhang(sheet: Sheet, *, max_overhang: float = 400.0) -> float:
    """Return the free length, mm, whose end drops by about half the length, rounded down to whole centimetres.

    At this length reading errors have the least effect. The length is limited to `max_overhang`, mm.

    Examples
    --------
    >>> coupon_overhang(Sheet.named("card-200gsm"))
    160.0
    """
    sheet = Sheet.of(sheet)
    require_positive(max_overhang, "max_overhang")
    best = BEST_LOAD ** (1 / 3) * sheet.elasto_gravity_length
    return float(max(TICK_MM, TICK_MM * np.floor(min(best, max_overhang) / TICK_MM)))


def coupon_drawing(
    sheet: Sheet,
    *,
    overhang: float | None = None,
    width: float = 20.0,
    clamp: float = 40.0,
    label: str | None = None,
) -> Drawing:
    """Return a rectangular test strip along the grain, whose droop is read when it is clamped level at a tick.

    x = 0 is the tick of the whole overhang; every tick is engraved with its free length. A second coupon serves as
    the rule for reading the droop.

    Parameters
    ----------
    sheet : Sheet
        Sheet of the coupon; its estimated stiffness determines the overhang.
    overhang : float, optional
        Longest free length, mm; by default `coupon_overhang`.
    width, clamp : float
        Width of the strip and length of the part to be clamped, mm.
    label : str, optional
        Text engraved in the clamped part; by default the sheet's name, empty for none.

    Raises
    ------
    InputError
        Sizes that are not positive, an overhang of less than two ticks or beyond 10 m, or a strip too narrow for
        its engraving.

    Examples
    --------
    >>> drawing = coupon_drawing(Sheet.named("card-200gsm"))
    >>> drawing.paths[-1].path.bounds.tolist()
    [[-40.0, -10.0], [160.0, 10.0]]
    """
    require_record(sheet, Sheet, "the sheet", "a Sheet")
    free = coupon_overhang(sheet) if overhang is None else overhang
    for value, name in ((free, "overhang"), (width, "width"), (clamp, "clamp")):
        require_positive(value, f"coupon {name}")
    if free < 2 * TICK_MM:
        raise InputError(
            "a coupon of {free:g} overhang is too short for its scale: use {tick_mm:g} or more",
            free=Length(free),
            tick_mm=Length(2 * TICK_MM),
        )
    if free > MOST_OVERHANG_MM:
        raise InputError(
            "a coupon of {free:g} overhang is longer than any board: use {most_overhang_mm:g} or less",
            free=Length(free),
            most_overhang_mm=Length(MOST_OVERHANG_MM),
        )
    if width < 8.0:
        raise InputError(
            "a coupon of {width:g} width is too narrow for its engraving: use 8 mm or more",
            width=Length(width),
        )
    if width > free:
        raise InputError(
            (
                "a coupon of {width:g} width and {free:g} overhang bends as a plate: make it narrower than its "
                "overhang"
            ),
            width=Length(width),
            free=Length(free),
        )
    scale, figures = _scale(free, width)
    name = sheet.name if label is None else require_printable(label, "the label")
    label_text = centred_text(name, (-clamp / 2, 0.0), min(4.0, 0.3 * width), 0.85 * clamp)
    texts = (*figures, label_text) if name else figures
    outline = Path.rectangle(clamp + free, width, corner=(-clamp, -width / 2))
    return Drawing(name=f"coupon-{sheet.name}", paths=(*scale, LayeredPath(CUT_OUTER, outline)), texts=texts)


def reference_bar(length: float = 100.0, *, width: float = 10.0) -> Drawing:
    """Return a bar with its length engraved, to measure the machine's scale and kerf after cutting.

    Parameters
    ----------
    length, width : float
        mm.

    Raises
    ------
    InputError
        Sizes that are not positive, or a bar too small for its figures.

    Examples
    --------
    >>> reference_bar(100).bounds.tolist()
    [[0.0, 0.0], [100.0, 10.0]]
    """
    for value, name in ((length, "length"), (width, "width")):
        require_positive(value, f"reference bar {name}")
    figure, height = f"{length:g} mm", 0.4 * width
    if text_width(figure, height) > 0.9 * length:
        raise InputError(
            "a reference bar of {length:g} by {width:g} is too short for its figures: make it longer",
            length=length,
            width=Length(width),
        )
    start = (length - text_width(figure, height)) / 2
    text = Text((start, (width - height) / 2), figure, height, 0.0, ENGRAVE)
    return Drawing("reference-bar", (LayeredPath(CUT_OUTER, Path.rectangle(length, width)),), (text,))


def _scale(free: float, width: float) -> tuple[tuple[LayeredPath, ...], tuple[Text, ...]]:
    """Return ticks from the lower edge, and the free length at each long tick."""
    edge = -width / 2 + EDGE_MM
    short, long = 0.12 * width, 0.24 * width
    height = min(3.0, 0.2 * width)
    paths, texts = [], []
    for left in _marks(free):
        x = free - left
        major = left == free or left % LONG_TICK_MM == 0
        if x == 0.0:
            tick = Line((x, edge), (x, -edge))
        else:
            tick = Line((x, edge), (x, edge + (long if major else short)))
        paths.append(LayeredPath(ENGRAVE, Path((tick,), closed=False)))
        if major:
            figure = f"{left:g}"
            start = min(x + 1.0, free - text_width(figure, height) - EDGE_MM)
            # write the whole length at the upper edge, so that it is clear of the next number, which may be close
            y = -edge - height if x == 0.0 else edge + long + 1.0
            texts.append(Text((start, y), figure, height, 0.0, ENGRAVE))
    return tuple(paths), tuple(texts)


def _marks(free: float) -> list[float]:
    """Return the free lengths with a tick: the whole length, then every full 10 mm below it."""
    below = TICK_MM * np.arange(np.ceil(free / TICK_MM) - 1, 0.0, -1.0)
    return [free, *below.tolist()]
