"""The layers of a strip, the lap joint of a closed strip, and the plates over the joints between pieces."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import numbers
from elastica_cad.errors import InputError
from elastica_cad.geometry.path import Line, Path, chords_of_all
from elastica_cad.geometry.path_intersections import trim_off
from elastica_cad.geometry.plane_points import numbers_in_groups
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.cross_sections import LaidLeaves
from elastica_cad.mechanics.laminated_section import stack_stiffness
from elastica_cad.mechanics.rod import Rod, cell_edges
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.drawing import Drawing, cut_paths
from elastica_cad.strip.lettering import Text, fit_label
from elastica_cad.strip.outline import Ends, add_alignment_holes, end_holes, fix_tab_widths, flat_rim
from elastica_cad.strip.slots import (
    Cut,
    Cuts,
    Slot,
    cut_slots,
    label_off_cuts,
    label_on_tabs,
    mating_marks,
    slot_cut,
)
from elastica_cad.strip.styles import Layout

TICK_FRACTION = 0.3
"""Half the length of a mark across the strip, as a fraction of the width. A mark that reached the edge would act
as a notch."""


@dataclass(frozen=True, eq=False)
class Layer:
    """One sheet of a strip as it is cut, in the coordinates of the flat strip.

    Attributes
    ----------
    sheet : Sheet
    outline : Path
        Outline of the sheet: closed and anticlockwise.
    holes : tuple of Path
        Closed inner loops.
    name : str
        Suffix to the name of the strip; empty for the base.
    low : float
        Height of the lower face of the layer above the lower face of the base, mm.
    slots : tuple of Cut
        Slots in this layer as lines that engraved letters avoid.
    """

    sheet: Sheet
    outline: Path
    holes: tuple[Path, ...] = ()
    name: str = ""
    low: float = 0.0
    slots: tuple[Cut, ...] = ()

    def __repr__(self) -> str:
        return f"<Layer {self.name or 'base'!r} of {self.sheet.name}, {len(self.holes)} holes>"

    @property
    def high(self) -> float:
        """Height of the upper face above the lower face of the base, mm."""
        return self.low + self.sheet.thickness

    def called(self, strip: str) -> str:
        """Return the name of the layer in files, from the name of the strip and the suffix of the layer."""
        return f"{strip}-{self.name.replace(' ', '-')}" if self.name else strip

    @cached_property
    def rim(self) -> Cut:
        """Outline as a line that engraved letters avoid."""
        return Cut(self.outline, "outside")

    @cached_property
    def area(self) -> float:
        """Area, mm2."""
        return abs(self.outline.area) - sum(abs(hole.area) for hole in self.holes)

    @property
    def mass(self) -> float:
        """Mass, g."""
        return self.area * self.sheet.thickness * self.sheet.density * 1e-6

    def material(self, s: ArrayLike) -> FloatArray:
        """Return the net width (n,), mm, at stations `s` (n,).

        At a jump of the width, this is the width just beyond the jump.

        Examples
        --------
        >>> sheet, hole = Sheet.named("card-200gsm"), Path.rectangle(10, 4, corner=(5, 3))
        >>> Layer(sheet, Path.rectangle(40, 10), (hole,)).material([2.0, 8.0]).round(6).tolist()
        [10.0, 6.0]
        """
        if (stations := numbers(s, "stations")).ndim > 1:
            raise InputError(f"stations have the shape {stations.shape}: give numbers (n,), in mm")
        stations = np.atleast_1d(stations)
        order = stations.argsort(kind="stable")
        at = stations[order]
        loop, (x, y), (x1, y1) = self._chords
        # stations in the x range of each chord: index of the first station, and number of stations
        first = at.searchsorted(np.minimum(x, x1))
        count = at.searchsorted(np.maximum(x, x1)) - first
        line = np.arange(x.size).repeat(count)
        station = numbers_in_groups(count) + first.repeat(count)
        u = (at[station] - x[line]) / (x1 - x)[line]
        # add y of chords that run to the left, and subtract it for chords to the right: the sum is the width
        crossing = np.sign(x - x1)[line] * (y[line] * (1 - u) + y1[line] * u)
        # the outline counts as positive and holes as negative, whether a loop is clockwise or not
        sign = np.sign(np.bincount(loop[line], crossing, minlength=len(self.holes) + 1))
        sign[1:] *= -1
        net_width = np.empty(at.size)
        net_width[order] = np.bincount(station, sign[loop[line]] * crossing, minlength=at.size)
        return net_width

    @cached_property
    def _chords(self) -> tuple[IntArray, FloatArray, FloatArray]:
        """Return the loop index (m,), start point (2, m) and end point (2, m) of the chords of all cuts.

        Loop 0 is the outline.
        """
        loops = self.outline, *self.holes
        which, points = chords_of_all([line for loop in loops for line in loop.segments], 1e-4)
        same_loop = np.append(which[1:] == which[:-1], False)
        loop = np.arange(len(loops)).repeat([len(line.segments) for line in loops])[which[same_loop]]
        begins, points = loop.searchsorted(np.arange(len(loops))), points[same_loop]
        ends = np.roll(points, -1, axis=0)
        ends[np.append(begins[1:], loop.size) - 1] = points[begins]
        return loop, points.T, ends.T


def cut_layers(
    layout: Layout, ends: Ends, slots: Sequence[Slot], cord_holes: Sequence[Path] = (), *, name: str
) -> tuple[Layer, ...]:
    """Return the layers with tabs, slots and holes for cords, the base layer first."""
    width = layout.width
    if layout.stack is not None:
        return _cut_leaves(layout.stack, width.length, ends)
    ends_held = add_alignment_holes(width, ends, layout.dots) if layout.dots else ends
    holes = (*end_holes(width, ends_held), *layout.hole_paths(ends, slots), *cord_holes)
    outline = cut_slots(flat_rim(width, ends), holes, slots, width, name=name)
    rims = tuple(Cut(slot_cut(slot, width, beyond=slot.width), "inside") for slot in slots)
    base = Layer(layout.sheet, outline, holes, slots=rims)
    if layout.backing is None:
        return (base,)
    drawn = layout.backing.width
    held = fix_tab_widths(width, ends_held)
    # the backing is cut only by slots whose inner end is on it
    inner_ends = [slot.center_line(width)[0][0] for slot in slots]
    reaching = [
        slot
        for slot, (x, y) in zip(slots, inner_ends, strict=True)
        if abs(y) < drawn(np.clip(x, 0.0, drawn.length)) / 2
    ]
    holes = end_holes(drawn, held)
    rim = cut_slots(
        flat_rim(drawn, held), holes, reaching, width, name=f"{name}, backing" if name else "backing"
    )
    return base, Layer(layout.backing.sheet, rim, holes, "backing", layout.sheet.thickness)


def _cut_leaves(section: LaidLeaves, length: float, ends: Ends) -> tuple[Layer, ...]:
    """Return the plies as rectangular layers, the full-length ply first.

    A ply that reaches an end includes its tab.
    """
    h, half = section.sheet.thickness, section.width / 2
    layers: list[Layer] = []
    for leaf, name in zip(section.leaves, section.names, strict=True):
        start = leaf.start - (ends[0].length if leaf.start <= 0 else 0.0)
        end = leaf.end + (ends[1].length if leaf.end >= length else 0.0)
        rim = Path.polygon([(start, -half), (end, -half), (end, half), (start, half)])
        called = f"leaf {name}" if layers else ""
        layers.append(Layer(section.sheet, rim, (), called, (leaf.number - 1) * h))
    return tuple(layers)


def draw_layers(
    layout: Layout,
    layers: Sequence[Layer],
    ends: Ends,
    slots: Sequence[Slot],
    engraved: str,
    name: str,
    *,
    lap: float,
) -> tuple[Drawing, ...]:
    """Return a drawing of each layer with engraved texts, marks, inner cuts and the outer cut.

    A mark at the distance `lap`, mm, from the start shows where the lap joint of a closed strip ends.
    """
    name = name or "strip"
    drawn = []
    for i, layer in enumerate(layers):
        width = layout.width if i == 0 or layout.backing is None else layout.backing.width
        if layout.stack is None:
            marks = _marks_across(layout, width, ends, lap)
            texts = (
                _label_texts(engraved, layout, width, ends, layer, slotted=bool(slots)) if engraved else ()
            )
            if i == 0:
                # a slot is an open line, which is closed beyond the edge
                open_cuts = [rim.line for rim in layer.slots]
                loops = [Path((*cut.segments, Line(cut.end, cut.start)), closed=True) for cut in open_cuts]
                marks += tuple(part for guide in layout.guides for part in trim_off(guide, loops))
                pairs = [*zip(slots, layer.slots, strict=True)]
                texts += mating_marks(pairs, layout.width, layer.holes, marks, texts)
        else:
            # lines at the ends of the plies above, and the name with the range along the stack
            (left, low), (right, high) = layer.outline.bounds.tolist()
            above = [ply for ply in layers if abs(ply.low - layer.high) < layer.sheet.thickness / 2]
            places = [float(x) for ply in above for x in ply.outline.bounds[:, 0] if left < x < right]
            marks = tuple(Path.polyline([(x, low), (x, high)]) for x in places)
            words = f"{layer.called(engraved or name)}: {left:.0f} - {right:.0f}"
            center = ((left + right) / 2, (low + high) / 2)
            texts = (fit_label(words, center, angle=0.0, room=right - left, across=high - low),)
        paths = cut_paths(layer.outline, layer.holes, marks)
        drawn.append(Drawing(name=layer.called(name), paths=paths, texts=texts))
    return tuple(drawn)


def _marks_across(layout: Layout, width: Profile, ends: Ends, lap: float) -> tuple[Path, ...]:
    """Return engraved lines across the strip where tabs begin and where the lap of a closed strip ends.

    A perforated strip needs none.
    """
    if layout.pattern is not None:
        return ()
    starts = ((0.0, ends[0]), (width.length, ends[1]))
    heights = [(x, min(float(width(x)), tab.width or np.inf)) for x, tab in starts if tab.length > 0]
    if lap:
        heights.insert(0, (lap, float(width(lap))))
    return tuple(
        Path.polyline([(x, -TICK_FRACTION * wide), (x, TICK_FRACTION * wide)]) for x, wide in heights
    )


def _label_texts(
    label: str, layout: Layout, width: Profile, ends: Ends, layer: Layer, *, slotted: bool
) -> tuple[Text, ...]:
    """Return the label at a place clear of cuts: on the bent part or, for a perforated strip, on a tab."""
    if layout.pattern is None:
        return label_off_cuts(label, width, Cuts(layer.holes, rim=layer.rim if slotted else None))
    length = width.length
    spans = ((-ends[0].length, 0.0), (length, length + ends[1].length))
    tabs = [
        (*span, tab.width or float(width(end)))
        for span, end, tab in zip(spans, (0.0, length), ends, strict=True)
        if span[0] < span[1]
    ]
    near = [hole for hole in layer.holes if hole.bounds[0, 0] < 0 or hole.bounds[1, 0] > length]
    return (label_on_tabs(label, tabs, Cuts(near, rim=layer.rim)),) if tabs else ()


END_MM = 1e-6
"""Distance from the ends, mm, at which the net width of the ends is measured. At the end itself, a strip without
a tab has no width."""

PLATE_END, PLATE_CUT = 0.25, 0.82
"""Lengths along which a glued plate does not stiffen the strip, as multiples of the plate's thickness.

`PLATE_END` is for each end of the plate, fitted to the strips of `docs/finite_elements.md`. `PLATE_CUT` is
for the joint, which is an edge crack through half of the total thickness. In bending, such a crack acts like
an added length of 5.7 total thicknesses (Tada, Paris and Irwin 1973)."""


def lap_joint(rod: Rod, width: FloatArray, length: float, lap_width: float) -> tuple[FloatArray, FloatArray]:
    """Return the effect of the lap joint at the start of a closed rod.

    Strip (width w) and tab (width v) are bent from the rest curvature kappa_0 to the drawn curvature kappa,
    and are glued there. The moment of both is proportional to w + v, but the design needs a moment
    proportional to w. So the joint bends less than the drawn curve. The glued section has two equally thick
    layers. Its stiffness is c times that of the strip, where c w = w + v + 12 w v / (w + v). Its rest
    curvature is kappa - (w + v) / (c w) (kappa - kappa_0).

    Parameters
    ----------
    rod : Rod
        The design.
    width : (n,) array
        Width of the material at the nodes, mm.
    length, lap_width : float
        Length and width of the tab, mm.

    Returns
    -------
    (n,) array
        Factors on the stiffness at the nodes of the rod.
    (n,) array
        Rest curvature at the nodes, 1/mm.
    """
    edges = cell_edges(rod.s)
    covered = ((length - edges[:-1]) / np.diff(edges)).clip(0.0, 1.0)
    both = width + lap_width
    stiffer = (both + 12 * width * lap_width / both) / width
    natural = rod.natural_curvature
    lapped = rod.curvature - both / width / stiffer * (rod.curvature - natural)
    return 1 / (covered / stiffer + 1 - covered), natural + covered * (lapped - natural)


@dataclass(frozen=True)
class LapPlates:
    """Solid plates of the same sheet, as wide as the strip, glued on one side over the joints of its pieces.

    Attributes
    ----------
    joints : tuple of float
        Arc lengths, mm, at which the strip is cut into pieces; for a laminate, the joints of its base.
    lap : float
        Length of the plates, mm. Half of each plate is on either piece.
    backing_joints : tuple of float
        Arc lengths, mm, at which the backing of a laminate is cut into pieces.
    """

    joints: tuple[float, ...]
    lap: float
    backing_joints: tuple[float, ...] = ()

    def clear_holes(self, holes: Sequence[Path]) -> tuple[Path, ...]:
        """Return the holes that no plate covers. Holes under a plate are not cut."""
        half = self.lap / 2
        spans = [(hole, hole.bounds[:, 0]) for hole in holes]
        return tuple(
            hole
            for hole, (low, high) in spans
            if not any(low < at + half and high > at - half for at in self.joints)
        )

    def stiffening(self, s: FloatArray, layout: Layout, layers: Sequence[Layer]) -> FloatArray:
        """Return the factors (n,) of the plates on the stiffness of the strip at the nodes s (n,), mm.

        Strip and plate bend as one section, except near the ends of the plate and at the joint.
        """
        base, *more = layers
        at = s.clip(END_MM, layout.width.length - END_MM)
        # widths of the outline, of the base as cut, and (`net_width`) of the base without holes under the plates
        wide, cut = layout.width(at), base.material(at)
        net_width = np.minimum(replace(base, holes=self.clear_holes(base.holes)).material(at), wide)
        glued = [(layer.sheet, np.minimum(layer.material(at), cut)) for layer in more]
        designed = stack_stiffness([(base.sheet, cut), *glued])
        compliance = np.zeros(s.size)
        on_base = self._covered(s, self.joints, base.sheet.thickness)
        on_backing = self._covered(s, self.backing_joints, layers[-1].sheet.thickness)
        # fraction of the strip around each node, and its stack of sheets and widths: without plates, with a plate
        # on the base (plates have no holes), and with a plate on the backing
        for share, stack in (
            (1 - on_base - on_backing, [(base.sheet, net_width), *glued]),
            (on_base, [(base.sheet, wide), (base.sheet, net_width), *glued]),
            (on_backing, [(base.sheet, net_width), *glued, *glued]),
        ):
            compliance += share * designed / stack_stiffness(stack)
        return 1 / compliance

    def _covered(self, s: FloatArray, joints: Sequence[float], thickness: float) -> FloatArray:
        """Return the fraction (n,) of the strip around each node that a plate stiffens."""
        ends = cell_edges(s)
        near = PLATE_CUT / 2 * thickness
        far = max(near, self.lap / 2 - PLATE_END * thickness)
        under = np.zeros(s.size)
        for at in joints:
            for low, high in ((at - far, at - near), (at + near, at + far)):
                under += np.diff(ends.clip(low, high))
        return under / np.diff(ends)
