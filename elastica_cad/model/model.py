"""Models: strips in space, their copies, the simplest holder for all tabs, and the pieces to be cut."""

from collections.abc import Callable, Container, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, Any

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._notebook import html_table
from elastica_cad._types import ArrayLike, Takes, Triple, required
from elastica_cad._values import counted, direction, is_whole, several, three
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import InputError, Length, note, quoted, refuse_options_unlike
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.sheets import Sheet, require_name
from elastica_cad.model.cut_rows import CutList, cut_list
from elastica_cad.model.fixtures import EndFixture, end_fixtures
from elastica_cad.model.frames import Rib, SlottedFrame, slotted_frame
from elastica_cad.model.held_tabs import held_shapes
from elastica_cad.model.interlocking import Joint, interlock
from elastica_cad.model.nesting import NestedSheet, nest_pieces
from elastica_cad.model.plate_pairs import end_plates, facing_plates
from elastica_cad.model.plates import BasePlate, Ring, RingOptions, base_plate, numbered
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.makeable_strip import compensate_widths
from elastica_cad.strip.pieces import (
    EqualStrips,
    Piece,
    count_pieces,
    cut_key,
    group_equal_strips,
    strip_pieces,
)
from elastica_cad.strip.strip import Placed, Strip, distinct_names, require_placed, strip_names
from elastica_cad.strip.uncuttable_parts import FabricationLimits


@dataclass(frozen=True, eq=False)
class Stand:
    """Holders of the strips.

    Attributes
    ----------
    holders : tuple of BasePlate, Rib or EndFixture
    sentence : str
        Sentence with the kind of holders, and the reason if plates cannot hold all tabs.
    """

    holders: tuple[BasePlate | Rib | EndFixture, ...]
    sentence: str


def stand(
    placed: Sequence[Placed],
    sheet: Sheet | str,
    *,
    name: str | None = None,
    shop: FabricationLimits | None = None,
    ignore_limits: bool = False,
) -> Stand:
    """Make the simplest holder for the tabs of all strips.

    The first possible holder in this order is used: one plate, two plates joined by the strips, a slotted
    frame, a printed block for every end.

    Parameters
    ----------
    placed : sequence of Placed
        Strips with tabs.
    sheet : Sheet or its name
        Sheet of plates and frames.
    name : str, optional
        Name of a plate or a pair of plates. Rails, ribs and blocks are named by their kind.
    shop : FabricationLimits, optional
        Limits of the workshop. Plates beyond these limits are rejected.
    ignore_limits : bool
        Accept plates beyond these limits.

    Returns
    -------
    Stand
        The holders, and a sentence that states their kind.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 60, 3.1, 0.04), "birch-plywood-0.8", max_width=20)
    >>> arches = [Placed(arch, (0, y, 0), (1, 0, 0), (0, 0, 1)) for y in (0, 40, 80)]
    >>> print(stand(arches, Sheet.named("mdf-3")).sentence)
    stands on one plate
    """
    sheet = Sheet.of(sheet)
    options = RingOptions(name=name or "ring", shop=shop, ignore_limits=ignore_limits)
    one_plate = replace(options, name=name or "base")
    ways: tuple[tuple[str, Callable[[], tuple[BasePlate | Rib, ...]]], ...] = (
        ("stands on one plate", partial(end_plates, placed, sheet, together=True, **vars(one_plate))),
        ("held by two plates", partial(_stable_facing_plates, placed, sheet, options)),
        (
            "held by a slotted frame",
            lambda: slotted_frame(placed, sheet, shop=shop, ignore_limits=ignore_limits).parts,
        ),
    )
    problem = ""
    for sentence, make in ways:
        try:
            return Stand(make(), sentence)
        except InputError as error:
            problem = str(error)
    blocks = end_fixtures(placed)
    if not blocks:
        raise InputError(
            "strips without tabs cannot be held: add tabs to their ends ({problem})", problem=problem
        )
    return Stand(
        blocks,
        note(
            "printed blocks hold all ends, because plates cannot hold all tabs: {problem}",
            problem=problem,
        ),
    )


def _stable_facing_plates(
    placed: Sequence[Placed], sheet: Sheet, options: RingOptions
) -> tuple[BasePlate, ...]:
    """Return the plates that face the ends of strips, or refuse slots in one row, on which a plate would tip."""
    plates = facing_plates(placed, sheet, options)
    for plate in plates:
        centers = np.array([slot.corners.mean(axis=0) for slot in plate.slots])
        # the singular values are the spreads along the principal directions
        spreads = np.linalg.svd(centers - centers.mean(axis=0), compute_uv=False)
        if len(plate.slots) < 3 or spreads[1] < 0.2 * spreads[0]:
            raise InputError(
                "{name}: the slots are in one row, so the plate would tip. Move one strip out of the row",
                name=plate.name,
            )
    return plates


MOST_STRIPS = 100_000


def mirror(
    placed: Sequence[Placed],
    point: Annotated[ArrayLike, Option("Point on the plane.", "mm", written=Triple)] = (0.0, 0.0, 0.0),
    normal: Annotated[ArrayLike, Option("Normal of the plane.", written=Triple)] = (1.0, 0.0, 0.0),
    *,
    keep: Annotated[bool, Option("Keep the original strips too.")] = True,
) -> tuple[Placed, ...]:
    """Return the mirror images of strips in the plane through `point` perpendicular to `normal`.

    With `keep`, the originals come first.
    """
    n, p = direction(normal, "the normal of a mirror"), three(point, "the point of a mirror")
    turn = np.eye(3) - 2 * np.outer(n, n)
    images = tuple(strip.moved(turn, 2 * (p @ n) * n) for strip in placed)
    return (*placed, *images) if keep else images


def rotate(
    placed: Sequence[Placed],
    count: Annotated[int, Option("Number of copies, including the original.", least=1, most=1000)],
    *,
    axis: Annotated[ArrayLike, Option("Direction of the axis.", written=Triple)] = (0.0, 0.0, 1.0),
    point: Annotated[ArrayLike, Option("Point on the axis.", "mm", written=Triple)] = (0.0, 0.0, 0.0),
    step: Annotated[
        float | None, Option("Angle between adjacent copies; by default they fill the full turn.", "rad")
    ] = None,
) -> tuple[Placed, ...]:
    """Return `count` copies of the strips about an axis, `step` rad apart.

    By default, the copies are distributed over a full turn.
    """
    _require_count(count, len(placed))
    require_declared(rotate, {"step": step}, "rotation")
    k, p = direction(axis, "the axis of a rotation"), three(point, "the point of a rotation")
    angle = 2 * np.pi / count if step is None else float(step)
    # cross @ v is k x v, and `turn` is the formula of Rodrigues
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    copies = list(placed)
    for i in range(1, count):
        turn = np.eye(3) + np.sin(i * angle) * cross + (1 - np.cos(i * angle)) * cross @ cross
        copies += [strip.moved(turn, p - turn @ p) for strip in placed]
    return tuple(copies)


def repeat(
    placed: Sequence[Placed],
    count: Annotated[int, Option("Number of copies, including the original.", least=1, most=1000)],
    step: Annotated[ArrayLike, Option("Displacement from each copy to the next.", "mm", written=Triple)],
) -> tuple[Placed, ...]:
    """Return `count` copies of the strips, `step` (3,) mm apart. The first copy is the original."""
    _require_count(count, len(placed))
    d = three(step, "the step of a pattern")
    return tuple(strip.moved(np.eye(3), i * d) for i in range(count) for strip in placed)


def _require_count(count: int, of: int) -> None:
    require_declared(repeat, {"count": count}, "pattern")
    if count * of > MOST_STRIPS:
        raise InputError(
            f"{of} strips repeated {quoted(count)} times are too many: make at most {MOST_STRIPS} strips"
        )


@dataclass(frozen=True, eq=False)
class Model:
    """Strips in space.

    Parameters
    ----------
    placed : sequence of Placed
        Strips in the order of assembly.
    name : str
        Name for titles and files.
    reports : tuple of str
        Messages about the design, one sentence each.
    joints : tuple of Joint
        Joints cut by `interlock`.
    plates : tuple of Ring or Rib
        Rings, caps and spacers of a surface of revolution, at their positions.
    """

    placed: Takes[tuple[Placed, ...], Placed | Sequence[Placed]] = required()  # noqa: RUF009
    name: str = "model"
    reports: tuple[str, ...] = ()
    joints: tuple[Joint, ...] = ()
    plates: tuple[Ring | Rib, ...] = ()

    def __post_init__(self) -> None:
        placed = require_placed(self.placed)
        vars(self).update(
            placed=placed,
            plates=numbered(placed, several("plates", self.plates, BasePlate | Rib, "Ring or Rib")),
            reports=several("reports", self.reports, str, "text"),
            name=require_name(self.name, "the model's name"),
        )
        if not self.placed:
            raise InputError(f"the model {self.name!r} has no strips: add at least one strip")

    @property
    def strips(self) -> tuple[Strip, ...]:
        """Strips in the order of assembly, including equal strips."""
        return tuple(placed.strip for placed in self.placed)

    def name_of(self, index: int) -> str:
        """Return the name of strip `index` in messages: its label, or its index counted from 1."""
        return self._names[0][self._place(index)]

    def single_name_of(self, index: int) -> str:
        """Return the name of strip `index`, with its index counted from 1 if other strips have the same label."""
        return self._names[1][self._place(index)]

    @cached_property
    def _names(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        # names of all strips, and these names with numbers that make them unique
        return strip_names(self.placed), distinct_names(self.placed)

    def _place(self, index: int) -> int:
        if not is_whole(index) or not -len(self.placed) <= index < len(self.placed):
            raise InputError(
                f"the model has no strip {index!r}: give a number from 0 to {len(self.placed) - 1}"
            )
        return index

    def __repr__(self) -> str:
        strips, joints = counted(len(self.placed), "strip"), counted(len(self.joints), "joint")
        return f"<Model {self.name!r}, {strips}, {joints}>"

    def _repr_html_(self) -> str:
        rows = [
            {
                "part": part.name, "cut": part.count, "sheet": part.strip.sheet.name,
                "length, mm": f"{part.strip.rod.length:.1f}", "ratio": f"{part.strip.rod.ratio:.3g}",
                "strain": f"{part.strip.max_strain:.2%}",
            }
            for part in self.parts
        ]  # fmt: skip
        return html_table(repr(self), rows)

    @cached_property
    def parts(self) -> tuple[EqualStrips, ...]:
        """Strips to be cut. Equal strips are listed once, with their count; see `group_equal_strips`."""
        return group_equal_strips(self.placed)

    @cached_property
    def shape_count(self) -> int:
        """Number of different shapes of strips, without regard to engraving."""
        return len({part.shape for part in self.parts})

    def with_strips(self, strips: Sequence[Strip]) -> "Model":
        """Return the model with other strips at the same positions."""
        new = several("strips", strips, Strip, "Strip")
        if len(new) != len(self.placed):
            raise InputError(
                f"the model has {len(self.placed)} strips, not {len(new)}: give a Strip record for each"
            )
        pairs = zip(self.placed, new, strict=True)
        return replace(self, placed=tuple(placed.with_strip(strip) for placed, strip in pairs))

    def interlock(self, **options: Any) -> "Model":
        """Return the model with slots where bent strips cross, cut half way into each strip.

        Options and errors are the same as for `model.interlock`: clearance, fit, relief, pairs, above.
        """
        refuse_options_unlike(options, interlock, "interlock")
        locked = interlock(self.placed, **options)
        return replace(
            self,
            placed=locked.placed,
            joints=(*self.joints, *locked.joints),
            reports=(*self.reports, *locked.reports),
        )

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """Pieces to be cut: the strips in `parts`, with a piece for each layer of a laminate, then the plates."""
        return (*strip_pieces(self.parts), *count_pieces(plate.piece for plate in self.plates))

    def fixtures(self, *, floor: Frame | None = None, **sizes: Any) -> tuple[EndFixture, ...]:
        """Return printed blocks for both ends of every strip. `sizes` are fields of `EndFixture`."""
        return end_fixtures(self.placed, floor=floor, **sizes)

    def base_plate(self, sheet: Sheet | str, **options: Any) -> BasePlate:
        """Return one slotted plate for all tabs. The options are `frame` and the fields of `PlateOptions`."""
        return base_plate(self.placed, sheet, **options)

    def slotted_frame(self, sheet: Sheet | str, **options: Any) -> SlottedFrame:
        """Return rails for the tabs of both ends, joined by ribs. See `model.slotted_frame` for the options."""
        refuse_options_unlike(options, slotted_frame, "a slotted frame")
        return slotted_frame(self.placed, sheet, **options)

    def nest(self, *, others: Iterable[Piece] = (), **options: Any) -> tuple[NestedSheet, ...]:
        """Return drawings of all sheets to be cut, with the model's pieces and other pieces.

        The options are those of `model.nest_pieces`: sheet_size, margin, kerf, name.
        """
        refuse_options_unlike(options, nest_pieces, "a nest")
        more = several("other pieces", others, Piece, "Piece")
        return nest_pieces((*self.pieces, *more), **{"name": f"{self.name}-nest", **options})

    def cut_list(self, others: Iterable[Piece | EndFixture] = ()) -> CutList:
        """Return the cut list of all pieces, and of other pieces and printed blocks.

        Equal pieces are listed once, with their count.
        """
        return cut_list((*self.pieces, *several("other pieces", others, Piece | EndFixture, "Piece")))

    def held(self, *holders: object) -> tuple[HeldShape, ...]:
        """Return the shape of each strip as cut, in the model's rings and in `holders`; see `Strip.held`."""
        return held_shapes(self.placed, (*self.plates, *holders))

    def mirrored(
        self, point: ArrayLike = (0.0, 0.0, 0.0), normal: ArrayLike = (1.0, 0.0, 0.0), *, keep: bool = True
    ) -> "Model":
        """Return the mirror image in the plane through `point` perpendicular to `normal`.

        With `keep`, the originals come first.
        """
        return self._arranged(mirror(self.placed, point, normal, keep=keep))

    def rotated(self, count: int, **options: Any) -> "Model":
        """Return `count` copies of the strips about an axis. The first copy is the original.

        Options: axis (3,), point (3,) and step, rad. By default the copies fill one full turn about z.
        """
        refuse_options_unlike(options, rotate, "a rotated model")
        return self._arranged(rotate(self.placed, count, **options))

    def repeated(self, count: int, step: ArrayLike) -> "Model":
        """Return `count` copies of the strips, `step` (3,) mm apart. The first copy is the original."""
        return self._arranged(repeat(self.placed, count, step))

    def _arranged(self, placed: tuple[Placed, ...]) -> "Model":
        if self.plates:
            raise InputError(
                f"the model {self.name!r} has {self.plates[0].name}, which fits only the strips where they "
                "are: leave out this plate"
            )
        return replace(self, placed=placed)


ROUNDS, MOST_ROUNDS = 2, 10
"""Number of rounds after the last round that lost a joint, and largest number of rounds."""

LARGEST_CORRECTION, SMALLER_CORRECTION = 0.15, 0.7
"""Largest change of the logarithm of a strip's width, and the factor that reduces it where joints are lost."""

MOST_NARROWER = 1.1
"""Largest ratio of the widths before and after a correction, at a slot that still reaches its neighbour."""


def interlock_compensated(model: Model, which: Container[str], **options: Any) -> Model:
    """Return the interlocked model, with widths that compensate the slots.

    A strip that becomes too narrow to reach its neighbours is widened by a constant factor. The factor does
    not change the shape of the strip, and is reported. If a large factor would be necessary, the slots are
    only partly compensated. `held_deviation` is the remaining error of a strip.

    Parameters
    ----------
    model : Model
        Model before interlocking.
    which : container of str
        Labels of the strips whose widths may change.
    **options
        Options of `Model.interlock`, whose errors are passed on.
    """
    first = locked = model.interlock(**options)
    # `wider` is the factor of each strip's width
    wider, rounds = [1.0] * len(model.strips), ROUNDS
    largest = [LARGEST_CORRECTION] * len(model.strips)
    for _ in range(MOST_ROUNDS):
        # cut the slots again, because old slots may not reach the new edges
        known: dict[Any, Strip] = {}
        strips = list(model.strips)
        for k, (drawn, cut) in enumerate(zip(model.strips, locked.strips, strict=True)):
            if drawn.label not in which:
                continue
            alike = cut_key(cut), largest[k]
            if alike not in known:
                known[alike] = compensate_widths(cut, largest=largest[k])
            strips[k] = _widened(replace(drawn, correction=known[alike].correction), wider[k])
        locked = model.with_strips(strips).interlock(**options)
        ratios = _width_ratios_at_lost_joints(first, model, locked)
        rounds = ROUNDS if ratios else rounds - 1
        if not rounds:
            break
        for k, narrower in ratios.items():
            # a much wider strip would have wider shoulders beside its tabs
            if narrower > MOST_NARROWER:
                largest[k] *= SMALLER_CORRECTION
            else:
                wider[k] *= narrower
    messages = tuple(
        note(
            ("{strip} is at most {width:.4g} wide instead of {asked:.4g}, so that its slots still lock into "
             "the neighbouring strips"),
            strip=model.name_of(k), width=Length(strip.max_width), asked=Length(drawn.max_width),
        )
        for k, (drawn, strip) in enumerate(zip(model.strips, locked.strips, strict=True))
        if strip.max_width is not None and drawn.max_width is not None and strip.max_width > drawn.max_width
    )  # fmt: skip
    return replace(locked, reports=(*locked.reports, *messages))


def _widened(strip: Strip, scale: float) -> Strip:
    # loads or a section fix the stiffness in N mm2, so the strip keeps its width
    if scale == 1 or strip.max_width is None or strip.rod.bending_stiffness is not None:
        return strip
    return replace(strip, max_width=scale * strip.max_width)


def _width_ratios_at_lost_joints(first: Model, before: Model, after: Model) -> dict[int, float]:
    """Return how much narrower (a factor of at least 1) each strip became at a joint of `first` that it lost.

    If two strips have several joints, each remaining joint is matched with the nearest previous joint.
    """
    lost = list(first.joints)
    for joint in after.joints:
        same = [previous for previous in lost if previous.members == joint.members]
        if same:
            lost.remove(min(same, key=lambda previous: abs(previous.slots[0].at - joint.slots[0].at)))
    ratios: dict[int, float] = {}
    for joint in lost:
        for k, slot in zip(joint.members, joint.slots, strict=True):
            narrower = float(before.strips[k].width(slot.at) / after.strips[k].width(slot.at))
            ratios[k] = max(1.0, narrower, ratios.get(k, 1.0))
    return ratios
