"""Assembly sheet as PDF: exploded view, order of assembly, positions, and parts."""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, groupby, zip_longest
from os import PathLike
from textwrap import wrap
from typing import Any, NamedTuple
from unicodedata import east_asian_width

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import and_more, counted, is_one_of
from elastica_cad.errors import Force, InputError, Length, Refusal, Wording, note, number_text, sentences
from elastica_cad.geometry.plane_points import angle_of, box_about, boxes_meet, norm
from elastica_cad.mechanics.elements import Pin, PointForce, Rail, Tie
from elastica_cad.mechanics.loads import PointMass
from elastica_cad.model.assembly import (
    AssemblyStep,
    Holder,
    SingleHolder,
    angle_in_space,
    direction_in_space,
    engraved_marks,
    is_unmarked,
    list_assembly_steps,
    side_in_space,
    single_holders,
    unheld_ends,
)
from elastica_cad.model.cut_rows import CutList
from elastica_cad.model.fixtures import EndFixture, place_tabs
from elastica_cad.model.frames import Rib
from elastica_cad.model.model import Model
from elastica_cad.model.plates import BasePlate, Ring, RingOptions
from elastica_cad.model.spacers import Spacer, pairs_of_plates, spacer_name
from elastica_cad.plot.canvas import (
    INK,
    chinese_font,
    draw_arrow,
    empty_figure,
    paint_patches,
    paint_polygons,
    show_box,
    text_in,
    write_pages,
)
from elastica_cad.plot.model_pictures import (
    EDGE_MM,
    assembled_box,
    holder_patches,
    lit,
    look_from,
    rule_strip,
    screen_of,
    size_text,
)
from elastica_cad.strip.holding_template import ARROW_MM, held_elements, held_ends
from elastica_cad.strip.outline import ENDS
from elastica_cad.strip.pieces import EqualStrips
from elastica_cad.strip.strip import Placed
from elastica_cad.translations import LANGUAGES, Language, Translated

A4 = np.array([595.0, 842.0])  # width and height of a page, points
MARGIN, TITLE_POINTS, LEADING = 36.0, 44.0, 12.5  # margin, heights of title and line, points
TEXT_POINTS = 8.5
LETTER_POINTS = 0.57 * TEXT_POINTS  # mean width of a letter, points
LABEL_HIGH, LABEL_PAD = 13.0, 6.0  # height of a label, and space beside its letters, points
LABEL_SPACE = np.array([24.0, 10.0])  # space for labels at the sides, and at the top and bottom, points
LABEL_AT = np.array([0.0, 0.3, 0.6, 1.0])  # places of a label, as fractions of the line from tab to holder
GAP_LETTERS = 2
# directions to the viewer, and to the right and upwards in the picture
TOWARD, SCREEN = look_from(24.0, -60.0), screen_of(24.0, -60.0)
BEHIND = 1.4  # ratio of the distances by which the second and the first plate of a pair are moved away
BLOCK = np.array([0.75, 0.79, 0.85])
PLATE, HOLE, LEAD = "#d9c9a3", "#ffffff", "#c2452d"


class Table(NamedTuple):
    """Heading, column heads and rows of a table. A sentence is a row with a single cell."""

    title: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]


class Line(NamedTuple):
    """Printed line. A cell is its distance from the left margin, in widths of a letter, and its text."""

    cells: Sequence[tuple[int, str]] = ()
    weight: str = "normal"


def save_assembly_sheet(
    model: Model,
    path: str | PathLike[str],
    *,
    holders: Sequence[Holder] = (),
    cut_list: CutList | None = None,
    language: Language = "en",
    force: bool = False,
) -> tuple[AssemblyStep, ...]:
    """Write a PDF for the workshop: exploded view, numbered ends, order of assembly, positions, and parts.

    If the text is short, picture and text share one page of A4.

    Parameters
    ----------
    model : Model
        Model with its strips in the order of assembly.
    path : path-like
    holders : sequence of BasePlate, Ring, Rib, SlottedFrame or EndFixture
        Holders in addition to the plates of the model.
    cut_list : CutList, optional
        Cut list, from which the table of the parts is printed.
    language : "en", "de" or "zh-CN"
        Language of the text. Without a font that has Chinese characters, the text is in English.
    force : bool
        Overwrite a file of that name.

    Returns
    -------
    tuple of AssemblyStep
        A step for each strip, in order.

    Raises
    ------
    InputError
        The file exists.
    MissingDependencyError
        matplotlib is not installed.
    """
    if not is_one_of(language, ("en", *LANGUAGES)):
        raise InputError("The language is {given!r}. Use en, de or zh-CN.", given=language)
    steps, font, hints = list_assembly_steps(model, holders), None, list[str]()
    if language == "zh-CN" and (font := chinese_font()) is None:
        language = "en"
        hints.append(
            "This sheet is in English because no font with Chinese characters was found. Install a font such as "
            "Noto Sans CJK SC."
        )
    words = Translated(language)
    pages = _pages(model, [*model.plates, *holders], steps, cut_list, words, hints)
    title = words.sentence(note("{name}: assembly", name=model.name))
    with text_in(font):
        # strips are painted as pixels, because thousands of vector patches take minutes to open
        write_pages(pages, path, title, what="assembly sheets", force=force, resolution=300)
    return steps


def _pages(
    model: Model,
    holders: Sequence[Holder],
    steps: Sequence[AssemblyStep],
    cut_list: CutList | None,
    words: Wording,
    hints: Sequence[str],
) -> Iterator[Any]:
    """Yield the pages as figures.

    The tables are below the picture, if it remains large enough; otherwise on further pages.
    """
    pairs = tuple(pairs_of_plates(_plates(holders)))
    view = View.of(model, holders, {id(second) for _, second, _ in pairs})
    first_steps = [*_flat_gluing(model), *_plate_sentences(holders, pairs)]
    rows, plates = [*_step_rows(steps, len(first_steps) + 1)], [*_plate_rows(holders)]

    def numbered(texts: Iterable[str], first: int) -> list[tuple[str]]:
        return [(note("{number}   {text}", number=k, text=text),) for k, text in enumerate(texts, first)]

    tables = [
        Table("Order of assembly", (), numbered(first_steps, 1)),
        Table(
            "" if first_steps else "Order of assembly",
            ("step", "strip", "cut as", "start (1)", "end (2)", "locks into"),
            rows,
        ),
        Table("", (), numbered(_element_steps(model), len(first_steps) + len(rows) + 1)),
        Table("", (), [(text,) for text in _sentences_below_steps(model, holders)]),
        Table(
            "Positions in the blocks (mm)",
            ("strip", "start (1) at (x, y, z)", "angle", "end (2) at (x, y, z)", "angle", "distance"),
            [*_block_rows(model, holders)],
        ),
        Table(
            "Positions of the plates (mm)",
            ("plate", "middle at (x, y, z)", "from the middle above"),
            plates if len(plates) > 1 else [],
        ),
        Table(
            "Force and moment at the ends",
            (
                "strip",
                "force at start (1)",
                "moment at start (1)",
                "force at end (2)",
                "moment at end (2)",
            ),
            [*_load_rows(model)],
        ),
        Table(
            "Rails, pins, ties and loads (the place of a rail is where its bar touches the strip; other places are "
            "on the centre line of the strip)",
            ("strip", "element", "place (x, y, z), mm", "angle", "force on the strip, N", "length, mm"),
            [*_element_rows(model)],
        ),
        Table(
            "Parts",
            ("part", "count", "sheet", "size, mm", "file"),
            [] if cut_list is None else [*_part_rows(cut_list)],
        ),
        Table("", (), [(hint,) for hint in hints]),
    ]
    tables = [_translated(table, words) for table in tables if table.rows]
    # choose the orientation with the larger picture, with the text below the picture if there is space
    layouts = []
    for paper in (A4, A4[::-1]):
        space = paper - [2 * MARGIN, 2 * MARGIN + TITLE_POINTS]
        blocks = [_block(table, int(space[0] / LETTER_POINTS)) for table in tables]
        picture = space - [0.0, LEADING * sum(len(head) + len(body) + 1 for head, body in blocks)]
        # a picture on a page with text may be smaller
        shared = bool(picture[1] > 0 and view.scale(picture) >= 0.55 * view.scale(space))
        layouts.append((shared, view.scale(picture if shared else space), paper, blocks))
    shared, scale, paper, blocks = max(layouts, key=lambda layout: layout[:2])
    lines = int((paper[1] - 2 * MARGIN - TITLE_POINTS) / LEADING)
    texts = [*_paginated(blocks, lines)]
    first, further = (texts[0], texts[1:]) if shared and texts else ([], texts)
    for k, page in enumerate([first, *further]):
        figure = empty_figure(tuple(paper / 72.0))
        x, y = MARGIN / paper[0], 1 - MARGIN / paper[1]
        figure.suptitle(model.name, x=x, y=y, ha="left", fontsize=14, color=INK)
        if further:
            _print(figure, (paper[0] - MARGIN, 0.5 * MARGIN), f"{k + 1} / {len(further) + 1}", ha="right")
        top = paper[1] - MARGIN - TITLE_POINTS
        if k == 0:
            summary = note(
                "{count}; assembled {size} mm (x, y, z)",
                count=counted(len(model.placed), "strip"), size=size_text(view.size),
            )  # fmt: skip
            _print(figure, (MARGIN, top + 12.0), words.sentence(summary))
            picture = np.array([paper[0] - 2 * MARGIN, view.height(scale) if shared else top - MARGIN])
            top -= picture[1]
            view.draw(figure.add_axes(np.array([MARGIN, top, *picture]) / [*paper, *paper]), picture, words)
        for row, line in enumerate(page, 1):
            for start, text in line.cells:
                place = MARGIN + LETTER_POINTS * start, top - LEADING * row
                _print(figure, place, text.replace(PAD, ""), fontweight=line.weight)
        yield figure


def _print(figure: Any, place: tuple[float, float], text: str, **style: Any) -> None:
    """Print text at a place, points from the lower left corner of the page."""
    x, y = place / (72.0 * figure.get_size_inches())
    figure.text(x, y, text, fontsize=TEXT_POINTS, color=INK, **style)


def _plate_sentences(
    holders: Sequence[Holder], pairs: Sequence[tuple[BasePlate, BasePlate, float]]
) -> Iterator[str]:
    """Yield how to join pairs of plates by spacers, and frames by ribs."""
    singles, stacked = [*single_holders(holders)], set[int]()
    spacers = Counter(holder.name for holder in singles if isinstance(holder, Spacer))
    for first, second, gap in pairs:
        name = spacer_name(first)
        if name in spacers:
            stacked |= {id(first), id(second)}
            yield note(
                "Glue the tongues of {count} x {spacer} into the slots of {second}, then of {first}. The "
                "spacers keep these plates {gap:.3g} apart.",
                count=spacers[name], spacer=name, second=second.name, first=first.name, gap=Length(gap),
            )  # fmt: skip
        else:
            yield note(
                "Put spacers {gap:.3g} high between {second} and {first}. These spacers are not in the kit.",
                second=second.name, gap=Length(gap), first=first.name,
            )  # fmt: skip
    # slots without a tab are for tongues: of spacers in stacked plates, of ribs in rails
    rails = [
        plate.name
        for plate in _plates(singles)
        if id(plate) not in stacked and any(slot.tab is None for slot in plate.slots)
    ]
    if rails:
        ribs = [holder.name for holder in singles if type(holder) is Rib]
        yield note("Push the tongues of {ribs} into {rails}.", ribs=_range(ribs), rails=_joined(rails))


def _plates(holders: Sequence[Holder]) -> list[BasePlate]:
    return [holder for holder in single_holders(holders) if isinstance(holder, BasePlate)]


def _joined(names: Sequence[str]) -> str:
    if len(names) == 1:
        return names[0]
    return note("{some} and {last}", some=sentences(names[:-1], ", "), last=names[-1])


def _step_rows(steps: Sequence[AssemblyStep], number: int) -> Iterator[tuple[str, ...]]:
    """Yield a row for each run of equal steps, numbered from `number`."""
    count = Counter(step.part for step in steps)

    def alike(step: AssemblyStep) -> tuple[Any, ...]:
        part = step.part if count[step.part] > 1 else ""
        return step.holders, step.motions, step.locks_into, part

    for k, ((places, motions, locks, part), run) in enumerate(groupby(steps, alike), number):
        first, *following = run
        strips = _range([first.strip, *(step.strip for step in following)])
        if part and following:
            strips = note("strips {first} to {last}", first=first.number, last=following[-1].number)
        ends = (
            sentences([_joined(names), motion], ", ") for names, motion in zip(places, motions, strict=True)
        )
        yield str(k), strips, part, *ends, ", ".join(locks)


ELEMENT_STEPS: Mapping[str, Mapping[type, str]] = {
    "Mount the {elements} at the places in the table below.": {Rail: "rails", Pin: "pins"},
    "Tie the {elements} between the places in the table below.": {Tie: "cords"},
    "Last, add the {elements} at the places in the table below.": {PointMass: "masses", PointForce: "forces"},
}


def _element_steps(model: Model) -> Iterator[str]:
    kinds = {type(held.action.element) for strip in model.strips for held in held_elements(strip)}
    for text, plurals in ELEMENT_STEPS.items():
        nouns = [note(plural) for kind, plural in plurals.items() if kind in kinds]
        if nouns:
            yield note(text, elements=_joined(nouns))


def _range(names: Sequence[str]) -> str:
    return note("{some} to {last}", some=names[0], last=names[-1]) if len(names) > 2 else _joined(names)


def _flat_gluing(model: Model) -> Iterator[str]:
    layered = [part for part in model.parts if len(part.strip.layers) > 1]
    joined = [part for part in model.parts if part.strip.plates is not None]
    for text, parts in (
        (
            "Glue the layers of {strips} onto each other, flat. Let the glue dry before you bend the strips.",
            layered,
        ),
        (
            "Put the pieces of {strips} end to end, flat, and glue their plates (lap) over the joints. Let the "
            "glue dry before you bend the strips."
            if is_unmarked(model)
            else "Put the pieces of {strips} end to end, flat, and glue their plates (lap) over the joints, "
            "between the marks. Let the glue dry before you bend the strips.",
            [part for part in joined if part not in layered],
        ),
        (
            "The layers of {strips} are made of pieces. Put the pieces end to end, flat, and glue their plates "
            "(lap) over the joints, on the outer face of each layer.",
            [part for part in joined if part in layered],
        ),
    ):
        if parts:
            yield note(text, strips=_joined([part.name for part in parts]))


def _sentences_below_steps(model: Model, holders: Sequence[Holder]) -> Iterator[str]:
    """Yield what the table of steps does not state: glue joints, engraved marks, and the distance of plates."""
    plates = _plates(holders)
    closed = [part.name for part in model.parts if part.strip.is_closed]
    if closed:
        yield note(
            "Bend {strips} along the curve, and glue the tab at the end (2) to the inside of the start (1). "
            "Hold this joint bent along the curve until the glue is dry.",
            strips=_joined(closed),
        )
    seats = [plate.name for plate in plates if isinstance(plate, Ring) and plate.seats]
    if seats:
        yield note(
            "Glue or bolt each tab to its place on {rings}."
            if is_unmarked(model)
            else "Glue or bolt each tab to its engraved outline on {rings}.",
            rings=_joined(seats),
        )
    if any(plate.glued for plate in plates):
        yield note(
            "Glue each foot into the corner between its plate and the tab in its name, such as tab A:1 for "
            "foot-A-1a."
        )
    if _states_angles(model, holders):
        yield note(
            "Angles are measured from the line between the ends of the strip, seen from start (1) to end (2)."
        )
    yield from engraved_marks(model, holders) if holders else ()
    # keep one plate of a pair, the plate next to the strips
    sides = {tuple(np.sign(plate.frame.z_axis).tolist()): plate for plate in reversed(plates)}
    if len(sides) == 2:
        near_plate, opposite = reversed(sides.values())
        # the plates face each other
        if near_plate.frame.z_axis @ opposite.frame.z_axis < -1 + 1e-6:
            distance = abs(float((near_plate.frame.origin - opposite.frame.origin) @ near_plate.frame.z_axis))
            yield note(
                "The inner faces of {first} and {second} are {distance:.1f} apart.",
                first=near_plate.name, second=opposite.name, distance=Length(distance),
            )  # fmt: skip


def _states_angles(model: Model, holders: Sequence[Holder]) -> bool:
    supports = [member.strip.rod.supports.ends for member in model.placed]
    by_hand = (
        supports[i][ENDS.index(end)] for i, ends in unheld_ends(model, holders).items() for end in ends
    )
    return (
        any(isinstance(holder, EndFixture) for holder in holders)
        or any(support.angle for support in by_hand)
        or any(held_elements(part.strip) for part in model.parts)
    )


def _block_rows(model: Model, holders: Sequence[Holder]) -> Iterator[tuple[str, ...]]:
    """Yield positions and angles of both ends, and their distance, mm, for each strip that printed blocks hold."""
    blocks = {holder.tab.key for holder in holders if isinstance(holder, EndFixture)}
    for i, member in enumerate(model.placed):
        tabs = place_tabs([member])
        if blocks.isdisjoint(tab.key for tab in tabs):
            continue
        cells = []
        for tab, end in zip(tabs, held_ends(member.strip), strict=True):
            cells += [_point(tab.frame.origin), angle_in_space(member, end.tilt)]
        apart = tabs[1].frame.origin - tabs[0].frame.origin
        yield model.single_name_of(i), *cells, f"{np.linalg.norm(apart):.1f}"


def _plate_rows(holders: Sequence[Holder]) -> Iterator[tuple[str, ...]]:
    """Yield a row for each plate and rib, with its middle and the distance from the previous middle."""
    middles = list[FloatArray]()
    for holder in single_holders(holders):
        # leave out blocks, which have their own table, rings and glued parts, which the text of the page describes,
        # and spacers, which fit into slots
        if isinstance(holder, EndFixture | Spacer) or (
            isinstance(holder, BasePlate) and (holder.glued or isinstance(holder.options, RingOptions))
        ):
            continue
        solid = holder.solid
        middles.append(solid.frame.point([*solid.outline.bounds.mean(axis=0), solid.thickness / 2]))
        apart = f"{np.linalg.norm(middles[-1] - middles[-2]):.1f}" if middles[1:] else ""
        yield holder.name, _point(middles[-1]), apart


def _point(position: FloatArray) -> str:
    return f"({', '.join(f'{x:z.1f}' for x in position)})"


def _element_rows(model: Model) -> Iterator[tuple[str, ...]]:
    """Yield a row for each rail, pin, tie and load."""
    for i, member in enumerate(model.placed):
        for element in held_elements(member.strip):
            contact = element.contact
            points = member.frame.point(element.position if contact is None else contact[None])
            first, *others = map(_point, points)
            at = note("{some} to {last}", some=first, last=others[-1]) if others else first
            noun = note("{name} {noun}", name=element.name, noun=element.noun)
            angle, length, force = "", "", number_text(element.force, ".2g")
            if element.is_between_bars:
                at = note("{place} (middle between two bars)", place=at)
            if contact is not None:
                outward = member.frame.direction(element.outward[0])
                at = note("{text} (bar {side})", text=at, side=side_in_space(outward))
            if others:
                length = f"{np.linalg.norm(points[-1] - points[0]):.1f}"
            else:
                angle = angle_in_space(member, element.tilt)
                push = direction_in_space(member.frame.direction(element.action.force[0]))
                force = note("{force} {direction}", force=force, direction=push) if element.force else force
            yield model.single_name_of(i), noun, at, angle, force, length


def _load_rows(model: Model) -> Iterator[tuple[str, ...]]:
    def cells(part: EqualStrips) -> tuple[str, ...]:
        # force, N, and moment, N mm, at the start and at the end
        return tuple(f"{size:.2g}" for end in part.strip.reactions().sizes for size in end)

    for texts, parts in groupby((part for part in model.parts if not part.strip.is_closed), cells):
        yield _range([part.name for part in parts]), *texts


def _part_rows(cut_list: CutList) -> Iterator[tuple[str, ...]]:
    """Yield a row for each shape, because parts of equal shape differ only in their engraving."""
    flat, solid = "{0.length:.1f} x {0.width:.1f}", "{0.length:.1f} x {0.width:.1f} x {0.thickness:.1f}"
    for cut_rows, size in ((cut_list.rows, flat), (cut_list.printed, solid)):
        shapes: dict[str, list[int]] = {}
        for k, row in enumerate(cut_rows):
            shapes.setdefault(row.like or (row.part if size is flat else size.format(row)), []).append(k)
        for places in shapes.values():
            rows = [cut_rows[k] for k in places]
            names = [row.called for row in rows]
            # names of rows one after another are shortened to "A1 to A5"
            in_order = places[-1] - places[0] < len(places) and not any(row.number for row in rows)
            name = _range(names) if in_order else _joined(names)
            count = sum(row.count for row in rows)
            sheet = note("{sheet}", sheet=rows[0].sheet)
            file = note("{file}{others}", file=rows[0].file, others=and_more(rows))
            yield name, str(count), sheet, size.format(rows[0]), file


def _translated(table: Table, words: Wording) -> Table:
    """Return the table in another language. Names and numbers, which are plain texts, are unchanged."""
    rows = [
        [words.sentence(cell) if isinstance(cell, Refusal) else cell for cell in row] for row in table.rows
    ]
    title, *head = (
        words.template(f"sheet|{text}").removeprefix("sheet|") for text in (table.title, *table.head)
    )
    return Table(title, head, rows)


def _block(table: Table, most: int) -> tuple[list[Line], list[Line]]:
    """Return the heading and the rows of a table as lines of at most `most` letters.

    Empty columns are left out. The widest columns are wrapped.
    """
    used = [k for k in range(len(table.rows[0])) if any(row[k] for row in table.rows)]
    # a wide character takes the place of two letters
    rows = [[_padded(row[k]) for k in used] for row in (table.head, *table.rows) if row]
    widths = [max(map(len, column)) + GAP_LETTERS for column in zip(*rows, strict=True)]
    while sum(widths) > most:
        widths[np.argmax(widths)] -= 1
    starts = [0, *accumulate(widths[:-1])]
    lines = []
    for row in rows:
        cells = [wrap(cell, width - GAP_LETTERS) for cell, width in zip(row, widths, strict=True)]
        wrapped = zip_longest(*cells, fillvalue="")
        lines.append([Line([*zip(starts, texts, strict=True)]) for texts in wrapped])
    heads = [Line([(0, text)], "bold") for text in wrap(_padded(table.title), most)]
    if table.head:
        heads += [Line(line.cells, "bold") for line in lines.pop(0)]
    return heads, [line for row in lines for line in row]


PAD = "\u2060"  # invisible character that follows each wide character while lines are wrapped


def _padded(text: str) -> str:
    return "".join(letter + PAD * (east_asian_width(letter) in "FW") for letter in text)


def _paginated(blocks: Sequence[tuple[list[Line], list[Line]]], most: int) -> Iterator[list[Line]]:
    """Yield the lines of each page, at most `most`. A continued table repeats its heading."""
    page: list[Line] = []
    for head, body in blocks:
        start = 0
        while start < len(body):
            free = most - len(page) - len(head)
            # at the foot of a page, a table has at least three lines
            if free < min(3, len(body) - start):
                yield page
                page = []
                continue
            page += [*head, *body[start : start + free], Line()]
            start += free
    if page:
        yield page


class Label(NamedTuple):
    """Text of the picture, drawn at the first of `positions` (k, 3) where it covers no other text.

    For each position, `sides` gives the side on which the text is: (1, 0) to the right, (0, 1) above.
    """

    text: str
    positions: FloatArray
    sides: Sequence[tuple[float, float]] = ((0.0, 0.0),) * len(LABEL_AT)


@dataclass(frozen=True, eq=False)
class View:
    """Exploded view: strips and holders are moved apart, and lines lead from tabs to their holders.

    Attributes
    ----------
    patches, colors : (n, 4, 3) and (n, 3) arrays
        Surfaces of strips and blocks.
    outlines : sequence of (loop (m, 3), point for depth sorting (3,), colour)
        Outlines and holes of plates.
    leads : sequence of (2, 3) arrays
        Lines from tabs to their holders.
    elements : sequence of (points (k, 3), tip (3,) or None)
        Points of rails, pins, ties and loads. Loads also have the tip of an arrow.
    labels : sequence of Label
        Texts, the most important first.
    dimensions : sequence of (line (2, 3), text)
        Overall width (along x) and height of the assembled model, on edges of the box around the picture.
    size : (3,) array
        Size of the assembled model with the thickness of its sheets, mm.
    """

    patches: FloatArray
    colors: FloatArray
    outlines: Sequence[tuple[FloatArray, FloatArray, str]]
    leads: Sequence[FloatArray]
    elements: Sequence[tuple[FloatArray, FloatArray | None]]
    labels: Sequence[Label]
    dimensions: Sequence[tuple[FloatArray, str]]
    size: FloatArray

    @classmethod
    def of(cls, model: Model, holders: Sequence[Holder], second_plates: Collection[int]) -> "View":
        """Return the exploded view of a model. `second_plates` has the ids of the second plates of pairs."""
        bent = np.concatenate([member.frame.point(member.strip.rod.position) for member in model.placed])
        middle, extent = bent.mean(axis=0), float(np.ptp(bent, axis=0).max())
        painted, assembled_strips, outlines = [], [], list[tuple[FloatArray, FloatArray, str]]()
        # displacements (3,), mm, of the strips by the keys of their tabs
        moved, outs = list[Placed](), dict[object, FloatArray]()
        for member in model.placed:
            # each strip is moved outwards by a quarter of its distance from the middle
            out = 0.25 * (member.frame.point(member.strip.rod.position).mean(axis=0) - middle)
            moved.append(replace(member, origin=member.origin + out))
            outs |= {tab.key: out for tab in place_tabs([member])}
            painted.append(rule_strip(moved[-1]))
            assembled_strips.append((member.strip, painted[-1][0] - out))
        # one label for each name of a plate, and the places (3,) to which lines lead, by the keys of the tabs
        names, targets = dict[str, Label](), dict[object, FloatArray]()
        for holder in single_holders(holders):
            # plates and blocks are moved away from the strips
            shift = _shift_away(holder, 0.3 * extent * (BEHIND if id(holder) in second_plates else 1.0))
            if isinstance(holder, EndFixture):
                shift = shift + outs.get(holder.tab.key, 0.0)
                for patches, _ in holder_patches([holder], 0.02 * extent):
                    painted.append((patches + shift, lit(patches) * BLOCK))
                targets[holder.tab.key] = holder.tab.frame.origin + shift
                continue
            loops = [*_loops(holder, shift)]
            outlines += loops
            # beside the rightmost, leftmost, highest or lowest point of the outline in the picture
            first_loop = loops[0][0]
            across, up = (first_loop @ SCREEN).T
            sides = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))
            places = first_loop[[across.argmax(), across.argmin(), up.argmax(), up.argmin()]]
            names.setdefault(holder.name, Label(holder.name, places, sides))
            for slot in () if isinstance(holder, Rib) else holder.slots:
                if slot.tab is not None:
                    targets[slot.tab.key] = holder.frame.point(slot.corners.mean(axis=0)) + shift
        # the start and the end of strip i have the indices 2 i and 2 i + 1
        ends, tabs = place_tabs(moved), place_tabs(model.placed)
        leads = {
            k: np.array([end.tip, targets[tab.key]])
            for k, (end, tab) in enumerate(zip(ends, tabs, strict=True))
            if tab.key in targets
        }
        elements, labels = list[tuple[FloatArray, FloatArray | None]](), [*names.values()]
        for member in moved:
            for placed in held_elements(member.strip):
                points, tip, text = member.frame.point(placed.position), None, placed.name
                if placed.is_load:
                    tip = points[0] + ARROW_MM * member.frame.direction(placed.outward[0])
                    text = f"{text}, {Force(placed.force):.2g}"
                elements.append((points, tip))
                at = points[0] if tip is None else tip
                labels.append(Label(text, np.array([at, at]), ((1.0, 0.0), (-1.0, 0.0))))
        for part in model.parts:
            for k in range(len(ENDS)):
                # of equal strips, label the end nearest to the viewer
                nearest = max((2 * i + k for i in part.members), key=lambda at: float(ends[at].tip @ TOWARD))
                line = leads.get(nearest, np.array([ends[nearest].tip, ends[nearest].frame.origin]))
                times = f"{part.count} x " if part.count > 1 else ""
                labels.append(
                    Label(f"{times}{part.name}:{k + 1}", line[0] + LABEL_AT[:, None] * (line[1] - line[0]))
                )
        patches, colors = map(np.concatenate, zip(*painted, strict=True))
        assembled = assembled_box(assembled_strips, holders)
        shown_box = box_about(np.concatenate([patches.reshape(-1, 3), *(loop for loop, _, _ in outlines)]))
        size, corner = np.ptp(assembled, axis=0), shown_box[0]
        dimensions = list[tuple[FloatArray, str]]()
        for axis, text in ((0, "width {size:.0f}"), (2, "height {size:.0f}")):
            line = np.array([corner, corner])
            line[:, axis] = assembled[:, axis]
            dimensions.append((line, note(text, size=Length(size[axis]))))
        return cls(patches, colors, outlines, [*leads.values()], elements, labels, dimensions, size)

    @cached_property
    def _box(self) -> FloatArray:
        """Lower left and upper right corner of the picture, mm in the plane of the screen."""
        tips = [tip for _, tip in self.elements if tip is not None]
        loops = [
            self.patches.reshape(-1, 3),
            *(loop for loop, _, _ in self.outlines),
            np.reshape(tips, (-1, 3)),
            *(line for line, _ in self.dimensions),
        ]
        return box_about(np.concatenate(loops) @ SCREEN)

    def scale(self, size: FloatArray) -> float:
        """Return the scale, points per mm, at which the picture fills `size` (2,), points."""
        return float(((size - 2 * LABEL_SPACE) / np.maximum(np.ptp(self._box, axis=0), EDGE_MM)).min())

    def height(self, scale: float) -> float:
        """Return the height of the picture with its labels, points."""
        return float(scale * np.ptp(self._box, axis=0)[1] + 2 * LABEL_SPACE[1])

    def draw(self, axes: Any, size: FloatArray, words: Wording) -> None:
        """Draw the picture on axes of a size (2,), points."""
        to_points = self.scale(size) * SCREEN
        middle = self._box.mean(axis=0) * self.scale(size)
        axes.set_axis_off()
        inside = np.array([middle - size / 2, middle + size / 2])
        show_box(axes, *inside)
        depths = [*(self.patches.mean(axis=1) @ TOWARD), *(depth @ TOWARD for _, depth, _ in self.outlines)]
        # paint from far to near, and draw runs of patches at once, which is much faster
        order = np.argsort(depths, kind="stable")
        for run in np.split(order, np.flatnonzero(np.diff(order >= len(self.patches))) + 1):
            if run[0] < len(self.patches):
                paint_patches(axes, self.patches[run] @ to_points, self.colors[run], rasterized=True)
                continue
            loops, _, fills = zip(*(self.outlines[k - len(self.patches)] for k in run), strict=True)
            paint_polygons(
                axes, [loop @ to_points for loop in loops],
                facecolors=fills, edgecolors=INK, linewidths=0.4, rasterized=True,
            )  # fmt: skip
        for line in self.leads:
            axes.plot(*(line @ to_points).T, color=LEAD, linewidth=0.5, linestyle=":")
        for points, tip in self.elements:
            axes.plot(*(points @ to_points).T, color=LEAD, marker="o", markersize=3, linewidth=0.8)
            if tip is not None:
                draw_arrow(axes, tip @ to_points, points[0] @ to_points, LEAD, 0.8, "->")
        occupied = np.array(
            [_draw_dimension(axes, line @ to_points, words.sentence(text)) for line, text in self.dimensions]
        )
        for label in self.labels:
            half = _half_size(label.text)
            for at, side in zip(label.positions @ to_points, label.sides, strict=True):
                # a label is 3 points away from its position
                center = at + np.multiply(side, half + 3.0)
                box = np.array([center - half, center + half])
                if (
                    not boxes_meet(box, occupied).any()
                    and (box[0] >= inside[0]).all()
                    and (box[1] <= inside[1]).all()
                ):
                    occupied = np.concatenate([occupied, box[None]])
                    frame = {"boxstyle": "round,pad=0.15", "fc": "white", "ec": LEAD, "lw": 0.4}
                    axes.text(*center, label.text, fontsize=TEXT_POINTS, color=INK, ha="center", va="center",
                              bbox=frame)  # fmt: skip
                    break


def _draw_dimension(axes: Any, line: FloatArray, text: str) -> FloatArray:
    """Draw a dimension line (2, 2) with its text, and return the box (2, 2) around the text, in points."""
    center, way = line.mean(axis=0), line[1] - line[0]
    draw_arrow(axes, line[0], line[1], INK, 0.6, "<|-|>")
    turned = abs(way[1]) > abs(way[0])
    # a line that is too short for its text and two arrow heads has the text beside it
    if norm(way) < 2 * LABEL_HIGH + len(text) * LETTER_POINTS:
        center = center - LABEL_HIGH * np.array([turned, not turned])
    axes.text(*center, text, fontsize=TEXT_POINTS, color=INK, ha="center", va="center",
              rotation=np.degrees(angle_of(way)),
              bbox={"boxstyle": "square,pad=0.1", "fc": "white", "ec": "none"})  # fmt: skip
    half = _half_size(text)[::-1] if turned else _half_size(text)
    return np.array([center - half, center + half])


def _half_size(text: str) -> FloatArray:
    # half the width and half the height (2,) of a label, points
    return np.array([len(text) * LETTER_POINTS + LABEL_PAD, LABEL_HIGH]) / 2


def _loops(plate: BasePlate | Rib, shift: FloatArray) -> Iterator[tuple[FloatArray, FloatArray, str]]:
    """Yield the upper outline and holes of a moved plate, each with a point that sorts by depth, and its colour."""
    solid = plate.solid
    for k, path in enumerate((solid.outline, *solid.holes)):
        loop = solid.frame.shifted(z=solid.thickness).point(path.points(EDGE_MM)) + shift
        if k == 0:
            middle = loop.mean(axis=0)
        # holes are painted after the plate
        yield loop, middle + 1e-6 * k * TOWARD, HOLE if k else PLATE


def _shift_away(holder: SingleHolder, distance: float) -> FloatArray:
    """Return the displacement (3,) of a holder from the strips in the exploded view."""
    if isinstance(holder, EndFixture):
        return 0.5 * distance * holder.tab.frame.x_axis
    if isinstance(holder, Spacer):
        return -(1 + BEHIND) / 2 * distance * holder.frame.y_axis
    if isinstance(holder, Rib):
        return np.array([0.0, 0.0, -1.6 * distance])
    return -distance * holder.frame.z_axis
