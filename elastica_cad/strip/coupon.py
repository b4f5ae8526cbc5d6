"""The bend coupon: a test strip with an engraved scale, to measure the stiffness of a sheet from its droop."""

import numpy as np

from elastica_cad._values import require_positive, require_record
from elastica_cad.errors import BareLength, InputError, Length
from elastica_cad.geometry.path import Path
from elastica_cad.mechanics.sheets import Sheet, require_flat, require_name
from elastica_cad.strip.drawing import CUT_OUTER, ENGRAVE, Drawing, LayeredPath
from elastica_cad.strip.lettering import Text, centred_text, engraved_names, text_width

TICK_MM, LONG_TICK_MM = 10.0, 50.0
"""Spacing of ticks and of long ticks on the scale, mm."""

MOST_OVERHANG_MM = 10_000.0

NARROWEST_MM = 8.0

EDGE_MM = 0.5
"""Distance of engraving from the edge, mm. A tick at the edge would act as a notch."""


def coupon_overhang(sheet: Sheet, *, max_overhang: float = 400.0) -> float:
    """Return the free length of the coupon, mm, at which its tip sags by about half that length.

    At this length, reading errors have the least effect. The length is rounded down to whole centimetres and
    is at most `max_overhang`, mm.

    Examples
    --------
    >>> coupon_overhang(Sheet.named("card-200gsm"))
    160.0
    """
    sheet = Sheet.of(sheet)
    require_positive(max_overhang, "max_overhang")
    # if w L^3 / (E I) is 5, where w is the weight per length, the tip of a clamped level strip sags by half its
    # length L, and the sag is most sensitive to E
    best = 5.0 ** (1 / 3) * sheet.elasto_gravity_length
    return float(max(TICK_MM, TICK_MM * np.floor(min(best, max_overhang) / TICK_MM)))


def coupon_drawing(
    sheet: Sheet,
    *,
    overhang: float | None = None,
    width: float = 20.0,
    clamp: float = 40.0,
    label: str | None = None,
) -> Drawing:
    """Return a rectangular test strip with an engraved scale.

    Cut the strip along the grain, clamp it level at a tick, and measure the sag of its tip. A second coupon
    can be the ruler. Long ticks are labelled with their free length. The tick of the longest overhang is at x
    = 0.

    Parameters
    ----------
    sheet : Sheet
        Sheet of the coupon; its estimated stiffness determines the overhang.
    overhang : float, optional
        Longest free length, mm; by default `coupon_overhang`.
    width, clamp : float
        Width of the strip and length of the part to be clamped, mm.
    label : str, optional
        Text engraved in the clamped part; by default the name of the sheet. An empty string engraves no text.

    Examples
    --------
    >>> drawing = coupon_drawing(Sheet.named("card-200gsm"))
    >>> drawing.paths[-1].path.bounds.tolist()
    [[-40.0, -10.0], [160.0, 10.0]]
    """
    require_record(sheet, Sheet, "the sheet", "a Sheet")
    require_flat(sheet)
    free = coupon_overhang(sheet) if overhang is None else overhang
    for value, name in ((free, "overhang"), (width, "width"), (clamp, "clamp")):
        require_positive(value, f"coupon {name}")
    if free < 2 * TICK_MM:
        raise InputError(
            "a coupon with an overhang of {free:g} is too short for its engraved scale: use {tick_mm:g} or more",
            free=Length(free),
            tick_mm=Length(2 * TICK_MM),
        )
    if free > MOST_OVERHANG_MM:
        raise InputError(
            "a coupon with an overhang of {free:g} is longer than any board: use {most_overhang_mm:g} or less",
            free=Length(free),
            most_overhang_mm=Length(MOST_OVERHANG_MM),
        )
    if width < NARROWEST_MM:
        raise InputError(
            "a coupon {width:g} wide is too narrow for its engraving: use {least} or more",
            width=Length(width),
            least=Length(NARROWEST_MM),
        )
    if width > free:
        raise InputError(
            (
                "a coupon {width:g} wide with an overhang of {free:g} bends as a plate: make it narrower than its "
                "overhang"
            ),
            width=Length(width),
            free=Length(free),
        )
    scale, figures = _scale_ticks_and_labels(free, width)
    name = sheet.name if label is None else require_name(label, "the label")
    label_text = centred_text(
        engraved_names([name])[name], (-clamp / 2, 0.0), min(4.0, 0.3 * width), 0.85 * clamp
    )
    texts = (*figures, label_text) if name else figures
    outline = Path.rectangle(clamp + free, width, corner=(-clamp, -width / 2))
    return Drawing(name=f"coupon-{sheet.name}", paths=(*scale, LayeredPath(CUT_OUTER, outline)), texts=texts)


def reference_bar(length: float = 100.0, *, width: float = 10.0) -> Drawing:
    """Return a bar with its length engraved, to measure the machine's scale and kerf after cutting.

    Parameters
    ----------
    length, width : float
        Size of the bar, mm.

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
            "a reference bar of {length:g} by {width:g} is too short for its numbers: make the bar longer",
            length=BareLength(length),
            width=Length(width),
        )
    start = (length - text_width(figure, height)) / 2
    text = Text((start, (width - height) / 2), figure, height, 0.0, ENGRAVE)
    return Drawing("reference-bar", (LayeredPath(CUT_OUTER, Path.rectangle(length, width)),), (text,))


def _scale_ticks_and_labels(free: float, width: float) -> tuple[tuple[LayeredPath, ...], tuple[Text, ...]]:
    """Return the ticks of the scale, and numbers at long ticks: the distance, mm, from the tip at x = `free`."""
    edge = -width / 2 + EDGE_MM
    short, long = 0.12 * width, 0.24 * width
    height = min(3.0, 0.2 * width)
    paths, texts = [], []
    below = TICK_MM * np.arange(np.ceil(free / TICK_MM) - 1, 0.0, -1.0)
    for left in [free, *below.tolist()]:
        x = free - left
        major = left == free or left % LONG_TICK_MM == 0
        top = -edge if x == 0.0 else edge + (long if major else short)
        paths.append(LayeredPath(ENGRAVE, Path.polyline([(x, edge), (x, top)])))
        if major:
            figure = f"{left:g}"
            start = min(x + 1.0, free - text_width(figure, height) - EDGE_MM)
            # write the longest length at the other edge, where it does not overlap the next number
            y = -edge - height if x == 0.0 else edge + long + 1.0
            texts.append(Text((start, y), figure, height, 0.0, ENGRAVE))
    return tuple(paths), tuple(texts)
