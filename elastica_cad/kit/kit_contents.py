"""Contents of the kit of a model: parts to cut, nested sheets, holders and notes."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._values import and_more, counted
from elastica_cad.defaults import CLEARANCE
from elastica_cad.design.design_file import merged_error
from elastica_cad.design.kit_spec import HolderKind, KitSpec
from elastica_cad.design.model_report import report_model
from elastica_cad.design.reports import pre_bend_message
from elastica_cad.design.strip_table import StripEntry
from elastica_cad.errors import (
    ElasticaError,
    FieldName,
    InputError,
    Length,
    Listed,
    NotConvergedError,
    note,
    sentences,
)
from elastica_cad.form_finding.limits import FAR_SHARE
from elastica_cad.geometry.path import Path, largest_deviation
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.stability import stability
from elastica_cad.model.assembly import Holder, unheld_ends
from elastica_cad.model.collisions import missing_slots
from elastica_cad.model.cut_rows import CutList, Stock, cut_list
from elastica_cad.model.fixtures import EndFixture, crowded_blocks
from elastica_cad.model.held_tabs import hold_each, holder_plays
from elastica_cad.model.model import LARGEST_CORRECTION, MOST_NARROWER, SMALLER_CORRECTION, Model
from elastica_cad.model.nesting import NestedSheet, Nesting, nest_pieces, saw_rods, widened_by
from elastica_cad.model.plate_pairs import UPRIGHT_COSINE
from elastica_cad.model.plates import BasePlate, numbered, tips_below
from elastica_cad.model.rocking import rocking_tabs
from elastica_cad.strip.clamp_errors import can_snap
from elastica_cad.strip.drawing import CUT_OUTER, Drawing, LayeredPath
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.lettering import numbers_note
from elastica_cad.strip.makeable_strip import Splice, compensate_widths, joined_within, spliced
from elastica_cad.strip.outline import StripEnd
from elastica_cad.strip.pieces import EqualStrips, Piece, count_pieces, strip_pieces
from elastica_cad.strip.strip import Strip, distinct_names
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.summary import instability
from elastica_cad.strip.uncuttable_parts import FabricationLimits, accept_faults, find_strip_faults


@dataclass(frozen=True, eq=False)
class KitContents:
    """A model with the contents of its kit."""

    model: Model
    spec: KitSpec
    pieces: tuple[Piece, ...]
    nests: tuple[NestedSheet, ...]
    holders: tuple[Holder, ...]
    """Holders of the strips: bases, rails, ribs and fixtures."""
    entries: tuple[StripEntry, ...] = ()
    """Entries of the design file from which the strips were made, if there is a design file."""
    held: dict[str, HeldShape] | None = None
    """Shape of each finished strip in its holders, by the name of the strip, if requested."""
    notes: tuple[str, ...] = ()
    """Notes for the user, such as on strips that rock in their holders, or on parts that cannot be cut."""
    deviations: dict[str, float] = field(default_factory=dict)
    """Largest distance, mm, of each part from its drawn curve, by name. Parts with fixed curves are omitted."""

    @cached_property
    def cut_list(self) -> CutList:
        """List of all parts to be cut, cached because the search for equal shapes is slow."""
        listed = cut_list((*self.pieces, *self.blocks))
        sheets = Counter(
            (nest.sheet.full_name, nest.sheet_size) for nest in self.nests if nest.sheet is not None
        )
        bought = (Stock(*kind, count) for kind, count in sheets.items())
        stock = (*bought, *_rods_to_buy(self.pieces, self.spec))
        return replace(listed, stock=stock, price=self.spec.nesting.price)

    @property
    def blocks(self) -> list[EndFixture]:
        """Blocks to be printed."""
        return [holder for holder in self.holders if isinstance(holder, EndFixture)]

    @property
    def names_of_blocks(self) -> list[str]:
        """Names of the blocks to be printed, each once."""
        return [*dict.fromkeys(block.label for block in self.blocks)]

    @cached_property
    def report(self) -> dict[str, Any]:
        """Report as data for JSON, without the list of files."""
        report = report_model(
            self.model,
            cut_list=self.cut_list,
            nests=self.nests,
            files={},
            held=self.held,
            entries=self.entries,
        )
        return report | {"reports": [*report["reports"], *self.notes]}


def require_sizes(entries: Sequence[StripEntry], spec: KitSpec) -> None:
    """Raise InputError, before the strips are made, for strips that cannot be cut from the stock and the sheets.

    Strips on sections are checked later, because a section that is too large is left out.
    """
    refused, blanks, longest = list[ElasticaError](), list[Piece](), max(spec.nesting.sheet_size)
    for entry in (entry for entry in entries if not entry.section):
        try:
            entry.spec.require_size()
            spec.cutting.options(entry.sheet)
            outline = Path.rectangle(*np.maximum(entry.spec.size_above(longest), 1.0))
            drawing = Drawing(entry.label, (LayeredPath(CUT_OUTER, outline),))
            blanks.append(Piece(entry.label, drawing, entry.sheet))
        except InputError as problem:
            refused.append(problem.at(strip=entry.label))
    if refused:
        raise merged_error(refused)
    _nest(blanks, spec.nesting, spec, "")


def kit_contents(
    model: Model, spec: KitSpec | None = None, *, entries: Sequence[StripEntry] = (), effects: bool = False
) -> KitContents:
    """Return the parts to cut, the nested sheets, the holders and the notes of a model.

    Parameters
    ----------
    model : Model
    spec : KitSpec, optional
        Request for additional parts of the kit. By default there are only the nested sheets.
    entries : sequence of StripEntry
        Entries of the design file from which the strips were made, with their drawn curves.
    effects : bool
        If True, compute the shape of every finished strip in its holders, and the deviation from the design.
    """
    spec = spec or KitSpec()
    requests = {entry.label: entry.spec for entry in entries}
    if spec.cutting.service:
        model = _with_each(model, lambda strip: replace(strip, unmarked=True))
    model = _with_each(model, lambda strip: joined_within(strip, _shop_of(strip, spec, requests)))
    deviations = _deviations(model, entries)
    unstable = ((part, instability(part.strip, stability(part.strip.rod))) for part in model.parts)
    # names of the pre-bent parts by their message
    pre_bent = dict[str, list[str]]()
    for part in model.parts:
        pre_bent.setdefault(pre_bend_message(part.strip), []).append(part.name)
    pre_bent.pop("", None)
    messages = [
        *_departure_notes(model, requests, deviations),
        *(warning.at(strip=part.name) for part, warning in unstable if warning is not None),
        *(
            note("{name}{more}: {blank}", name=names[0], more=and_more(names), blank=words)
            for words, names in pre_bent.items()
        ),
        *_strip_faults(model, spec, requests),
        *_tip_notes("rings", model.plates),
    ]
    holders = list[Holder]()
    joined = _spliced(model, spec, requests)
    strips = strip_pieces(model.parts, numbered=_numbers_ends(model, spec))
    # joined strips are replaced by their pieces
    pieces_of = {called: layer for splice in joined.values() for called, layer in splice.layer_pieces.items()}
    pieces = (
        *(
            replace(part, count=piece.count)
            for piece in strips
            for part in pieces_of.get(piece.name, (piece,))
        ),
        *count_pieces(plate.piece for plate in model.plates),
        *spec.extras(model),
    )
    nests = _nest(pieces, spec.nesting, spec, f"{model.name}-nest")
    # plates of holders with equal kind, sheet and nesting share sheets: names of the holders and their pieces
    shared = dict[tuple[str, Sheet | None, Nesting], list[tuple[str, tuple[Piece, ...]]]]()
    for request in spec.holders:
        made, sentence = request.made(model, spec.shop, ignore_limits=spec.ignore_limits)
        new_holders = numbered(model.placed, made, (*model.plates, *holders))
        plates = [holder for holder in new_holders if not isinstance(holder, EndFixture)]
        cut = tuple(
            replace(piece, name=f"{model.name}-{piece.name}")
            for piece in count_pieces(plate.piece for plate in plates)
        )
        shared.setdefault((request.kind, request.sheet, request.nesting), []).append((request.name, cut))
        pieces, holders = (*pieces, *cut), [*holders, *new_holders]
        messages += [sentence] if sentence else []
        messages += _tip_notes(request.kind, plates)
    for (_, _, nesting), parts in shared.items():
        names = "-".join(name for name, _ in parts)
        nests += _nest(
            [piece for _, cut in parts for piece in cut], nesting, spec, f"{model.name}-{names}-nest"
        )
    messages += crowded_blocks([holder for holder in holders if isinstance(holder, EndFixture)], model.placed)
    messages += missing_slots(model.placed, model.joints, brief=True)
    unheld = unheld_ends(model, holders) if model.plates or holders else {}
    if unheld:
        (first, ends), *_ = unheld.items()
        messages.append(note(
            "{name}{more}: nothing holds its {ends}, so the shape of the strip is unknown. Add a holder "
            "(stand, fixtures), or hold this end at its position on the assembly sheet.",
            name=distinct_names(model.placed)[first], more=and_more([*unheld]),
            ends=sentences([END_NAMES[end] for end in ends], " & "),
        ))  # fmt: skip
    held, notes = (
        _shapes_in_holders(model, (*model.plates, *holders), unheld, requests) if effects else (None, ())
    )
    messages += [text for plate in (*model.plates, *holders) for text in getattr(plate, "warnings", ())]
    if spec.reference_bar is not None and spec.cutting.service:
        messages.append(
            note(
                "The files are for a cutting service, so they have no bar of known length, which is only for "
                "checking your own machine."
            )
        )
    if long := [
        piece for piece in pieces if piece.is_rod and piece.size[0] > spec.shop.stock_for(piece.sheet)[0]
    ]:
        messages.append(note(
            "{rods}: longer than the rods that you buy ({length:g}). Join each from the lengths in the cut list "
            "with sleeves, or state the length of your rods in {field}.",
            rods=Listed(piece.name for piece in long), length=Length(spec.shop.stock_for(long[0].sheet)[0]),
            field=FieldName("shop.stock"),
        ))  # fmt: skip
    messages += [*(f"{name}: {splice}" for name, splice in joined.items()), *notes]
    numbers = (
        ()
        if spec.cutting.service
        else numbers_note({piece.name: piece.number or piece.name for piece in pieces})
    )
    kerf = spec.cutting.kerf_note(piece.sheet for piece in pieces)
    messages = [*numbers, *([] if kerf is None else [kerf]), *messages]
    return KitContents(
        model, spec, pieces, nests, tuple(holders), tuple(entries), held, tuple(messages), deviations
    )


def _tip_notes(kind: HolderKind, parts: Sequence[Holder]) -> tuple[str, ...]:
    """Return a note if tabs extend below the lowest plate, except for frames, which stand on ribs."""
    plates = [part for part in parts if isinstance(part, BasePlate)]
    if kind == "frame" or (kind == "stand" and len(plates) < len(parts)):
        return ()
    standing = [plate for plate in plates if kind == "base" or plate.frame.z_axis[2] >= UPRIGHT_COSINE]
    return tips_below(standing) if standing else ()


def _with_each(model: Model, change: Callable[[Strip], Strip]) -> Model:
    """Return the model with every strip changed. Copies of a strip stay copies, and an unchanged model the same."""
    changed = {id(strip): change(strip) for strip in model.strips}
    if all(changed[id(strip)] is strip for strip in model.strips):
        return model
    return model.with_strips([changed[id(strip)] for strip in model.strips])


def _spliced(model: Model, spec: KitSpec, requests: Mapping[str, StripSpec]) -> dict[str, Splice]:
    # the division into pieces of each strip that is longer than its sheet, by the name of the part
    splices = {
        part.name: spliced(part.strip.labelled(part.name), _shop_of(part.strip, spec, requests))
        for part in model.parts
    }
    ends = ("1", "2") if _numbers_ends(model, spec) else ("", "")
    return {name: replace(splice, ends=ends) for name, splice in splices.items() if splice is not None}


def _numbers_ends(model: Model, spec: KitSpec) -> bool:
    # holders, and the templates on paper, name the ends 1 and 2 of a strip
    return bool(spec.holders or model.plates or spec.pages)


def _shop_of(strip: Strip, spec: KitSpec, requests: Mapping[str, StripSpec]) -> FabricationLimits:
    """Return the fabrication limits of a strip. The pieces of a joined strip must fit on a nested sheet."""
    shop = requests[strip.label].shop if strip.label in requests else spec.shop
    if shop.lap is None:
        return shop
    lost = 2 * spec.nesting.margin + widened_by(strip.sheet, spec.cutting.kerf)
    long, short = (side - lost for side in sorted(spec.nesting.sheet_size, reverse=True))
    first, second = shop.stock_for(strip.sheet)
    return replace(shop, stock=(min(first, long), min(second, short)))


def _strip_faults(model: Model, spec: KitSpec, requests: Mapping[str, StripSpec]) -> tuple[str, ...]:
    """Return messages on faults of the parts if their limits are ignored; otherwise, faults are raised."""
    messages: list[str] = []
    # pairs of layers and limits without faults, because equal strips are checked only once
    clear: set[tuple[int, FabricationLimits]] = set()
    for part in model.parts:
        request = requests.get(part.strip.label)
        shop, ignore_limits = (spec.shop, False) if request is None else (request.shop, request.ignore_limits)
        alike = id(part.strip.layers), shop
        if alike in clear:
            continue
        faults = find_strip_faults(part.strip.labelled(part.name), shop)
        messages += accept_faults(faults, ignore_limits or spec.ignore_limits)
        if not faults:
            clear.add(alike)
    reported = {text for strip in model.strips for text in strip.warnings} | {*model.reports}
    return tuple(text for text in dict.fromkeys(messages) if text not in reported)


def _deviations(model: Model, entries: Sequence[StripEntry]) -> dict[str, float]:
    """Return the largest distance, mm, of each part from its drawn curve, for parts whose curve may change."""
    curves = {entry.label: entry.curve for entry in entries if entry.spec.may_change}
    deviations = dict[PlaneCurve, float]()
    for part in model.parts:
        curve = part.strip.rod.curve
        if part.strip.label in curves and curve not in deviations:
            deviations[curve] = largest_deviation(curves[part.strip.label], curve)
    return {part.name: deviations[part.strip.rod.curve] for part in model.parts if part.strip.label in curves}


def far_parts(model: Model, deviations: Mapping[str, float]) -> list[EqualStrips]:
    """Return the parts that deviate from the drawn curve by a large fraction of their length."""
    return [
        part for part in model.parts if deviations.get(part.name, 0.0) > FAR_SHARE * part.strip.rod.length
    ]


def _departure_notes(
    model: Model, requests: Mapping[str, StripSpec], deviations: Mapping[str, float]
) -> list[str]:
    """Return notes on curves that the limits change too much, one for each sheet."""
    far = dict[Sheet, list[EqualStrips]]()
    for part in far_parts(model, deviations):
        far.setdefault(part.strip.sheet, []).append(part)
    messages = list[str]()
    for parts in far.values():
        from elastica_cad.strip.suggestions import thinner_for_all

        worst = max(parts, key=lambda part: deviations[part.name])
        thinner = thinner_for_all([requests[part.strip.label] for part in parts])
        messages.append(
            note(
                "The limits change the curves of {names}: {worst} by up to {far}, {percent:.2g} % of its length. "
                "Relax a limit."
                if thinner is None
                else "The limits change the curves of {names}: {worst} by up to {far}, {percent:.2g} % of its "
                "length. Use stock at most {thickness} thick, or relax a limit.",
                names=Listed(part.name for part in parts), worst=worst.name,
                far=Length(deviations[worst.name]), thickness=Length(thinner or 0.0),
                percent=100 * deviations[worst.name] / worst.strip.rod.length, severity="warning",
            )
        )  # fmt: skip
    return messages


def count_strips(model: Model) -> str:
    """Return a text with the number of strips and the number of their different shapes."""
    count = len(model.placed)
    shapes = {count: "all different", 1: "all the same"}.get(
        model.shape_count, f"{model.shape_count} different"
    )
    return counted(count, "strip") + (f" ({shapes})" if count > 1 else "")


def _rods_to_buy(pieces: Sequence[Piece], spec: KitSpec) -> Iterator[Stock]:
    """Yield the rods of each stock with the lengths to be sawn from each."""
    kinds = dict[Sheet, list[Piece]]()
    for piece in pieces:
        if piece.is_rod:
            kinds.setdefault(piece.sheet, []).append(piece)
    for sheet, sawn in kinds.items():
        length, _ = spec.shop.stock_for(sheet)
        rods = saw_rods(sawn, length, spec.nesting.margin)
        lines = tuple(", ".join(f"{part:.1f} ({name})" for name, part in rod) for rod in rods)
        yield Stock(sheet.full_name, (length,), len(rods), lines)


def _nest(pieces: Sequence[Piece], nesting: Nesting, spec: KitSpec, name: str) -> tuple[NestedSheet, ...]:
    pieces = [piece for piece in pieces if not piece.is_rod]
    options = {key: value for key, value in vars(nesting).items() if key != "price"}
    return nest_pieces(pieces, **options, kerf=spec.cutting.kerf, name=name)


END_NAMES: Mapping[StripEnd, str] = {"start": note("start (1)"), "end": note("end (2)")}
"""Names of the ends, with the numbers that are engraved on strips and slots."""


def _nearer_to_design(name: str, strip: Strip, requests: Mapping[str, StripSpec]) -> Iterator[str]:
    """Yield which changes of the request make the strip deviate less, as tried on this strip alone."""
    request = requests.get(strip.label)
    if request is None or request.section is not None:
        return
    # a change may leave no strip that can be held
    with suppress(ElasticaError):
        if not request.compensate:
            # as `interlock_compensated`: a correction is smaller if a slot would no longer reach the neighbour
            largest, at = LARGEST_CORRECTION, np.array([slot.at for slot in strip.slots])
            corrected = compensate_widths(strip, largest=largest)
            while np.max(strip.width(at) / corrected.width(at)) > MOST_NARROWER:
                largest *= SMALLER_CORRECTION
                corrected = compensate_widths(strip, largest=largest)
            if corrected.held_deviation < 0.7 * strip.held_deviation:
                yield note(
                    "{field} = true reduces the deviation, of {name} to {better:.2g} at best.",
                    field=FieldName("compensate"), name=name, better=Length(corrected.held_deviation),
                )  # fmt: skip
    with suppress(ElasticaError):
        wide = replace(strip, ends=tuple(replace(tab, width=None) for tab in strip.ends))
        if wide.held_deviation < 0.7 * strip.held_deviation:
            yield note(
                "Tabs as wide as the strip ({field}) reduce the deviation, of {name} to {better:.2g} at best.",
                field=FieldName("ends.width"), name=name, better=Length(wide.held_deviation),
            )  # fmt: skip


def _shapes_in_holders(
    model: Model,
    holders: Sequence[Holder],
    unheld: Mapping[int, object],
    requests: Mapping[str, StripSpec],
) -> tuple[dict[str, HeldShape], tuple[str, ...]]:
    """Return the shapes of strips in their holders by name, and notes.

    Strips on rails, pins or ties, strips that can snap, and those in `unheld` have no such shape.
    """
    held_shapes = dict[str, HeldShape]()
    names = distinct_names(model.placed)
    free = [k for k, member in enumerate(model.placed) if not member.strip.rod.acting]
    placed = tuple(model.placed[k] for k in free)
    notes = [*holder_plays(model.placed, holders), *rocking_tabs(placed, holders)]
    if on_elements := [name for k, name in enumerate(names) if k not in free]:
        notes.append(
            note(
                "The shape as made is not computed for strips with rails, pins, ties or point forces: {strips}.",
                strips=Listed(on_elements),
            )
        )
    if snapping := [names[k] for k in free if can_snap(model.placed[k].strip)]:
        notes.append(
            note(
                "The shape as made is not computed for strips that can snap into another shape: {strips}.",
                strips=Listed(snapping),
            )
        )
    for k, shape in zip(free, hold_each(placed, holders), strict=True):
        name = names[k]
        if k in unheld or name in snapping:
            continue
        if isinstance(shape, NotConvergedError):
            notes.append(f"{name}: {shape}")
        else:
            held_shapes[name] = shape
    locked = {names[k]: model.placed[k].strip for joint in model.joints for k in joint.members}
    if deviating := {
        name: shape.deviation
        for name, shape in held_shapes.items()
        if name in locked and shape.deviation > CLEARANCE
    }:
        worst = max(deviating, key=deviating.__getitem__)
        head = note(
            "{worst} deviates from its design by {most:.2g}, more than the clearance of slots ({room:g})."
            if len(deviating) == 1 else
            "{count} strips deviate from their design by {least:.2g} to {most:.2g}, {worst} most, more than the "
            "clearance of slots ({room:g}).",
            count=len(deviating), least=Length(min(deviating.values())), most=Length(deviating[worst]),
            worst=worst, room=Length(CLEARANCE),
        )  # fmt: skip
        notes.append(
            note(
                "{deviating} If their slots do not meet, bend the strips by hand until they do.",
                deviating=sentences([head, *_nearer_to_design(worst, locked[worst], requests)], " "),
            )
        )
    return held_shapes, tuple(notes)
