# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Live feedback on an open sketch at every move of the mouse. *Keep it possible* moves poles back."""

import time
from dataclasses import replace
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from freecad.elastica_wb.curves.edge_chains import curves_of_geometry
from freecad.elastica_wb.curves.part_shapes import plane_curve
from freecad.elastica_wb.curves.sketch_curves import (
    AUTOMATIC,
    curve_into,
    drawn_in,
    gap_of,
    is_blank,
    move_poles,
    read_line,
    sketch_curve,
)
from freecad.elastica_wb.features.strip_properties import spec_of
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.objects import sensor
from freecad.elastica_wb.host.progress import begun
from freecad.elastica_wb.host.qt import later
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live import sketches
from freecad.elastica_wb.live.curve_picture import comb_scale, curve_picture, width_lines
from freecad.elastica_wb.live.overlay import Overlay
from freecad.elastica_wb.live.sketch_drag import Dragged
from freecad.elastica_wb.live.verdict_card import VerdictCard
from freecad.elastica_wb.recording import record_call, recorded
from freecad.elastica_wb.solving.strip_cache import (
    AS_DRAWN_MM,
    SEARCHING,
    DraggableCurve,
    default_spec,
    nearest_to_drag,
    solve_strip,
)
from freecad.elastica_wb.solving.verdicts import Answer, Verdict, answer_of, refusal_answer, strip_answer
from freecad.elastica_wb.undo_steps import close_step, open_step
from pivy import coin

from elastica_cad._types import FloatArray
from elastica_cad.errors import Change, Length, note, sentences
from elastica_cad.geometry.plane_curve import DRAWN_POINTS, PlaneCurve
from elastica_cad.mechanics.point_search import move_while_possible
from elastica_cad.mechanics.section_limits import sharp_bend_message, sharpest_bend
from elastica_cad.strip.strip_spec import StripSpec

# delay, ms, of slower results after the last mouse move
REST_MS = 40
NO_POLES = np.zeros((0, 2))
# number of points of a curve that the card tries not to hide
SEEN = 24
# interval, ms, between checks whether the nearest curve was found
PEEK_MS = 60
LEAST_STEP = (
    1e-3  # smallest move of a pole back to a possible curve, as a fraction of the length of the curve
)
# largest number of moves towards the dragged poles, and of bisection steps in a move
MOVES, HALVINGS = (
    3,
    12,
)
SKETCHER = "User parameter:BaseApp/Preferences/Mod/Sketcher/General"
OWN_COMB = "BSplineCombVisible"

_session: "Session | None" = None


class Session:
    """Controller of the overlay of a sketch while the sketch is edited."""

    def __init__(self, sketch: Any, view: Any, layout: Any = None) -> None:
        self.sketch = sketch
        self.overlay = Overlay(view, sketch.getGlobalPlacement())
        self.card = VerdictCard(view, self.use_nearest, self._enlarge, layout)
        self._placement = sketch.getGlobalPlacement()
        self.times: list[float] = []
        self.moves = 0
        self.sentence = ""
        self.near: DraggableCurve | None = None
        self._times = 1.0
        self._placed, self._cost = NO_POLES, ""
        self._scale: float | None = None
        self._asks: dict[tuple[str, ...], StripSpec] = {}
        self._curve: Any = None
        self._geometry: list[Any] | None = None
        self._sensor: Any = None
        self._node: Any = None
        self._dragged: Dragged | None = None
        self._soon = later(self._follow, 0)
        self._rest = later(self._finish, REST_MS)
        self._asked: Any = None
        self._answer = later(self._look, PEEK_MS)
        self._possible: tuple[PlaneCurve, Any] | None = None
        # FreeCAD's own curvature comb is switched off while the overlay is displayed
        self._sketcher = App.ParamGet(SKETCHER)
        self._own_comb = self._sketcher.GetBool(OWN_COMB, True)
        self._sketcher.SetBool(OWN_COMB, False)
        self.card.keep.setChecked(getattr(sketch, sketches.KEEP, False))
        self.card.keep.clicked.connect(self._keep)
        self.refresh()

    def refresh(self) -> None:
        """Update the overlay from the sketch as it is stored in the document."""
        self._soon.stop()
        self._scale, self._asks = None, {}
        if self.card.keep.isChecked() and self._stop_at_border():
            return  # the changed sketch causes another refresh
        self._attach()
        self._dragged = Dragged(self.sketch, self._points()) if self._node is not None else None
        self._show(None)

    def close(self) -> None:
        """Remove the overlay at the end of the edit."""
        for timer in (self._soon, self._rest, self._answer):
            timer.stop()
        if self._sensor is not None:
            self._sensor.detach()
        self.overlay.remove()
        self.card.remove()
        self._sketcher.SetBool(OWN_COMB, self._own_comb)

    def use_nearest(self) -> None:
        """Replace the refused curve by the nearest possible curve, in one undo step."""
        if self.near is None:
            return
        self._cost = self.near.cost
        self._placed = self.near.curve.control_points
        self._draw(self.near.curve, self.card.button.text())

    def _enlarge(self) -> None:
        larger = self._curve.transformed(np.diag([self._times, self._times, 1.0]))
        self._draw(larger, self.card.larger.text())

    def _draw(self, curve: PlaneCurve, step: str) -> None:
        """Replace the curve of the sketch in one undo step."""
        document = self.sketch.Document
        open_step(document, " ".join(step.split()))
        recorded(curve_into, self.sketch, curve)
        # solve in the same undo step, because solving moves points
        record_call(self.sketch, "solve")
        close_step(document)
        self.refresh()

    def _keep(self, on: bool) -> None:
        sketches.remember(self.sketch, on, sketches.KEEP)
        self._possible = None
        self.refresh()

    def _stop_at_border(self) -> bool:
        """Move a dragged curve back to its last possible shape. Return True if the sketch changed.

        The sketcher itself moves the poles until the mouse is released. Then this method replaces the undo
        step of the drag.
        """
        try:
            self._curve = curve = sketch_curve(self.sketch, None, gap_of(*sketches.followers(self.sketch)))
            spec = self._spec(curve).changed(limits=None, keep=None)
        except FAILURES:
            return False

        def possible(poles: FloatArray) -> FloatArray | None:
            answer = answer_of(spec.changed(curve=curve.with_control_points(poles)))
            return poles if answer.verdict is Verdict.CAN else None

        driving = [c for c in self.sketch.Constraints if c.Driving and c.Type not in AUTOMATIC]
        # what a drag does not change
        drawing = curve.control_points.shape, [(c.Type, c.Value) for c in driving]
        if possible(curve.control_points) is not None:
            self._possible = curve, drawing
            return False
        document = self.sketch.Document
        if self._possible is None or document.RedoCount or self._possible[1] != drawing:
            return False
        start = poles = self._possible[0].control_points
        geometry = drawn_in(self.sketch, None)
        # restore the initial position of curves other than a single spline
        is_spline = len(geometry) == 1 and hasattr(geometry[0], "getPoles")
        for _ in range(MOVES if is_spline else 0):
            step = LEAST_STEP * curve.length
            nearer = move_while_possible(poles, curve.control_points, possible, step, HALVINGS)
            poles = poles if nearer is None else nearer
        record_call(document, "undo")
        if poles is not start:
            open_step(document, translate("Elastica", "Keep it possible"))
            recorded(move_poles, self.sketch, curve.with_control_points(poles))
            record_call(self.sketch, "solve")
            solved = sketch_curve(self.sketch).control_points
            close_step(document, abort=possible(solved) is None)
        return True

    def _attach(self) -> None:
        """Find the Coin node of the drawn points, which some FreeCAD releases replace for new geometry."""
        if self._sensor is not None:
            self._sensor.detach()
        self._sensor = self._node = None
        root = coin.SoNode.getByName("Sketch_EditRoot")
        if root is None:
            return
        search = coin.SoSearchAction()
        search.setName("PointsCoordinate0")
        search.setSearchingAll(True)
        search.apply(root)
        if search.getPath() is None:
            return
        self._node = search.getPath().getTail()
        self._sensor = sensor(coin.SoFieldSensor, self._moved)
        self._sensor.attach(self._node.point)

    def _points(self) -> list[Any]:
        field = self._node.point
        return [field[i].getValue() for i in range(field.getNum())]

    def _moved(self) -> None:
        self.moves += 1
        if not self._soon.isActive():
            self._soon.start()

    def _follow(self) -> None:
        if self._dragged is not None and self._dragged.usable:
            points = self._points()
            try:
                self._show(self._dragged.geometry(points))
            # the sketch has lost points, so wait until the mouse is released
            except IndexError:
                self._dragged = None

    def _show(self, geometry: list[Any] | None) -> None:
        # CPU time of this thread, independent of other processes
        began = time.thread_time()
        self._rest.stop()
        self._answer.stop()
        self.near = None
        self.card.offer("")
        self.card.offer("", button=self.card.larger)
        self.overlay.show_nearest()
        self._geometry = geometry
        gap = gap_of(*sketches.followers(self.sketch))
        try:
            self._curve = sketch_curve(self.sketch, geometry, gap)
            spec = self._spec(self._curve)
            if self._scale is None:
                self._scale = comb_scale(self._curve)
            picture = curve_picture(self._curve, spec, self._scale)
        except FAILURES as error:
            self._curve = None
            self.overlay.clear()
            answer = refusal_answer(explained(error))
            if is_blank(self.sketch):
                answer = Answer(Verdict.NOTHING, translate("Elastica", "no curve yet"), answer.sentence)
            elif len(chains := curves_of_geometry(drawn := drawn_in(self.sketch, geometry))) > 1:
                answer = self._show_several(chains, drawn, gap)
            self._show_answer(answer)
            return
        self.overlay.show(picture)
        if picture.realizable is False:
            self.overlay.show_width(())
        self._show_answer(picture.answer)
        self.times.append(time.thread_time() - began)
        self._rest.start()

    def _show_several(self, chains: list[tuple[str, ...]], drawn: list[Any], gap: float) -> Answer:
        pictures, titles, answers = [], [], []
        for number, names in enumerate(chains, 1):
            try:
                curve, _ = plane_curve([drawn[int(name[len("Edge") :]) - 1] for name in names], gap=gap)
                if self._scale is None:
                    self._scale = comb_scale(curve)
                pictures.append(curve_picture(curve, self._spec(curve, names), self._scale))
            except FAILURES as error:
                answers.append(refusal_answer(explained(error)))
                continue
            answers.append(pictures[-1].answer)
            x, y = curve.sample(3).position[1].tolist()
            titles.append(((x, y), note("{number}: {words}", number=number, words=answers[-1].words)))
        self.overlay.show(*pictures, titles=titles)
        worst = max((answer.verdict for answer in answers), key=list(Verdict).index)
        lines = [
            note("{number}: {words}", number=number, words=answer.sentence)
            for number, answer in enumerate(answers, 1)
        ]
        count = sum(answer.verdict is Verdict.CAN for answer in answers)
        words = note("strips can be bent into {count} of {total} curves", count=count, total=len(answers))
        return Answer(worst, words, sentences(lines, "\n"))

    def _finish(self) -> None:
        if self._curve is None:
            return
        places = np.concatenate([self._curve.control_points, self._curve.sample(SEEN).position])
        self.card.keep_off([self._placement.multVec(App.Vector(x, y, 0)) for x, y in places.tolist()])
        spec = self._spec(self._curve)
        try:
            strip = solve_strip(spec.changed(curve=self._curve, limits=None, keep=None))
        except FAILURES as error:
            self.overlay.show_width(())
            self._show_read(refusal_answer(explained(error)))
            sharp = sharp_bend_message(spec.material, *sharpest_bend(self._curve, spec.natural_curvature))
            if sharp is not None:
                self._times = sharp.values["times"]
                words = worded(note("Draw the curve {scale:g} times as large.", scale=self._times))
                self.card.offer(words, button=self.card.larger)
            if preferences.get("LiveNearest"):
                self._request()
            return
        self.overlay.show_width(width_lines(strip))
        answer = strip_answer(strip)
        self._show_read(answer)
        if answer.verdict is not Verdict.CAN and answer.curve_helps and preferences.get("LiveNearest"):
            self._request()

    def _request(self) -> None:
        """Start the search for the nearest curve in another thread. Results for earlier curves are ignored.

        The search ignores rails, pins, ties and point forces, so it is not started with these.
        """
        spec = self._spec(self._curve)
        if spec.between or spec.rod_spec.point_forces:
            return
        if self._asked is None or self._asked.done():
            self._asked_for = self._curve
            near = spec.with_change(Change("nearest", True)) or spec
            self._asked = begun(nearest_to_drag, near.changed(curve=self._curve).rod_spec)
        self.card.offer(translate("Elastica", SEARCHING), usable=False)
        self._answer.start()

    def _look(self) -> None:
        if not self._asked.done():
            self._answer.start()
            return
        if self._asked_for is not self._curve:
            self._finish()
            return
        self.card.offer("")
        if self._asked.exception() is not None:
            return
        found = self._asked.result()
        if found.near.met and found.deviation < AS_DRAWN_MM:
            return  # the curve is not why the strip cannot be made
        message = note(found.near.status.value)
        if found.near.met:
            self.near = found
            self.overlay.show_nearest(found.curve.sample(DRAWN_POINTS).position)
            message = note(
                "The nearest possible curve is {far} from the drawn curve.", far=Length(found.deviation)
            )
            self.card.offer(translate("Elastica", "Use the nearest curve"))
        self._show_answer(
            replace(self.card.answer, sentence=sentences([message, self.card.answer.sentence], "\n"))
        )

    def _spec(self, curve: PlaneCurve, edges: tuple[str, ...] = ()) -> StripSpec:
        if edges not in self._asks:
            self._asks[edges] = request_along(self.sketch, curve, edges)
        return self._asks[edges]

    def _show_read(self, answer: Answer) -> None:
        read = read_line((self.sketch, ()), self._geometry)
        self._show_answer(replace(answer, sentence=sentences([answer.sentence, read], "\n")))

    def _show_answer(self, answer: Answer) -> None:
        poles = NO_POLES if self._curve is None else self._curve.control_points
        cost = self._cost if poles.shape == self._placed.shape and np.allclose(poles, self._placed) else ""
        self.sentence = worded(sentences([answer.sentence, cost], "\n"))
        self.card.show(answer, self.sentence, self.overlay.shown())
        if self._geometry is None:  # during a drag, the pole may still return to a possible position
            why = ""
            if self._curve is None:
                why = translate("Elastica", "First draw a single curve.")
            elif answer.verdict is not Verdict.CAN and answer.curve_helps:
                why = translate("Elastica", "First use the nearest curve.")
            elif answer.verdict is not Verdict.CAN:
                why = translate("Elastica", "First make the strip possible.")
            self.card.allow_keep(why)


def request_along(sketch: Any, curve: PlaneCurve, edges: tuple[str, ...] = ()) -> StripSpec:
    """Return the request of a strip that follows a sketch or its edges, or by default one for the curve."""
    spec = default_spec(curve)
    for strip in sketches.followers(sketch):
        if not edges or {*edges} & {*strip.Curve[1]}:
            spec = spec_of(strip)
    return spec


def session() -> Session | None:
    """Return the running session, or None."""
    return _session


def start(sketch: Any, layout: Any = None) -> Session | None:
    """Show the overlay of a sketch, which need not be open.

    The verdict is shown in the layout, or by default below the messages of the sketcher.
    """
    global _session  # noqa: PLW0603 - a view shows only one overlay
    stop()
    view = Gui.getDocument(sketch.Document.Name).activeView()
    if view is None or not hasattr(view, "getSceneGraph"):
        return None
    _session = Session(sketch, view, layout)
    _notify_listeners(True)
    return _session


def stop() -> None:
    """Remove the overlay."""
    global _session  # noqa: PLW0603
    if _session is not None:
        _session.close()
        _session = None
        _notify_listeners(False)


def _notify_listeners(on: bool) -> None:
    for listener in sketches.listeners:
        listener(on)
