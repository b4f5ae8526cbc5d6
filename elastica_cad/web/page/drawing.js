// The drawing: a curve with control points to move, and what the server found about it. All of it is SVG in pixels.
import { COLORS, stepOf } from "./colors.js";

const SVG = "http://www.w3.org/2000/svg";
const LAYERS = ["grid", "axis", "comb", "line", "drawn", "strip", "ghost", "polygon", "marks", "elements", "points"];
const COMB_SHARE = 0.12; // of the drawing's size: the longest tooth
const HIT = 12; // px about a control point
const BAR = 6; // px: radius of a rail and length of half an arrow's head
const ARROW = 44; // px

export function element(name, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export class Drawing {
  constructor(svg, t, on) {
    Object.assign(this, { svg, t, on, points: [], answer: null, ghost: null, mode: "move", snap: 0, axis: false, fitted: true });
    this.view = { scale: 1, x: 0, y: 0 }; // px per mm, and where the origin lies
    this.layers = Object.fromEntries(LAYERS.map((name) => [name, element("g", { class: name })]));
    svg.append(...Object.values(this.layers));
    this.fingers = new Map();
    svg.addEventListener("pointerdown", (event) => this.pressed(event));
    svg.addEventListener("pointermove", (event) => this.moved(event));
    for (const name of ["pointerup", "pointercancel"]) svg.addEventListener(name, (event) => this.released(event));
    svg.addEventListener("wheel", (event) => this.wheeled(event), { passive: false });
    svg.addEventListener("dblclick", (event) => { if (this.mode === "move") this.on.add(this.place(event)); });
    svg.addEventListener("keydown", (event) => this.typed(event));
    new ResizeObserver(() => this.resized()).observe(svg);
  }

  get size() { return [this.svg.clientWidth || 600, this.svg.clientHeight || 400]; }

  toScreen([x, y]) { return [this.view.x + x * this.view.scale, this.view.y - y * this.view.scale]; }

  toPlane(x, y) { return [(x - this.view.x) / this.view.scale, (this.view.y - y) / this.view.scale]; }

  // Where an event points to, mm; on the grid where that is on.
  place(event, snap = this.snap) {
    const box = this.svg.getBoundingClientRect();
    const digits = snap || 10 ** Math.floor(Math.log10(0.5 / this.view.scale)); // no finer than half a pixel
    return this.toPlane(event.clientX - box.left, event.clientY - box.top).map((v) => rounded(v, digits));
  }

  resized() {
    if (this.fitted) this.fit();
    else this.paint();
  }

  fit() {
    const [width, height] = this.size;
    const all = [...this.points, ...(this.isOld ? [] : this.answer?.position ?? []), ...(this.ghost ?? [])];
    if (this.axis && all.length) all.push([0, all[0][1]]);
    const [x0, x1] = range(all.map((p) => p[0])), [y0, y1] = range(all.map((p) => p[1]));
    const scale = all.length > 1 ? 0.75 * Math.min(width / Math.max(x1 - x0, 1), height / Math.max(y1 - y0, 1)) : 1.5;
    const middle = all.length > 1 ? [(x0 + x1) / 2, (y0 + y1) / 2] : [width / 3.5, height / 4];
    this.view = { scale, x: width / 2 - middle[0] * scale, y: height / 2 + middle[1] * scale };
    this.fitted = true;
    this.paint();
  }

  zoom(factor, at = this.size.map((v) => v / 2)) {
    const { view } = this, scale = Math.min(Math.max(view.scale * factor, 0.01), 200);
    const grown = scale / view.scale;
    this.view = { scale, x: at[0] - (at[0] - view.x) * grown, y: at[1] - (at[1] - view.y) * grown };
    this.fitted = false;
    this.paint();
  }

  wheeled(event) {
    event.preventDefault();
    const box = this.svg.getBoundingClientRect();
    this.zoom(Math.exp(-event.deltaY / 400), [event.clientX - box.left, event.clientY - box.top]);
  }

  pressed(event) {
    if (event.button > 0) return;
    this.svg.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    this.fitted = false;
    const hit = this.hit(event, this.points), held = this.held(event);
    if (this.fingers.size > 1) { // two fingers zoom: the first set no point
      if (this.appended) this.on.undo();
      this.grabbed = this.tapped = null;
      this.appended = false;
    } else if (!["move", "draw"].includes(this.mode)) this.put(event);
    else if (hit >= 0) {
      this.grabbed = hit;
      this.on.grab(hit);
      this.focus(hit);
    } else if (this.mode === "draw" && event.pointerType === "touch") {
      this.tapped = [event.clientX, event.clientY]; // a point is set when the finger is lifted, unless it moves the view
    } else if (this.mode === "draw") {
      this.appended = this.on.append(this.place(event));
      this.grabbed = this.appended ? this.points.length - 1 : null; // null while it is checked
    } else if (held) {
      this.on.grab();
      this.sliding = held;
    }
    event.preventDefault();
  }

  // Sets an element of the chosen kind on the curve; a tie from where the pointer is pressed to where it is released.
  put(event) {
    const place = this.along(event);
    if (!place) return;
    this.from ??= [];
    this.from.push(place);
    if (this.mode !== "tie" || this.from.length > 1) {
      this.on.put(this.mode, this.from);
      this.from = null;
      this.filled = true;
    }
  }

  // The element under the pointer and which of its places.
  held(event) {
    const places = (this.answer?.elements ?? []).flatMap((element) => element.places.map((at, end) => ({ element, end, at })));
    return places[this.hit(event, places.map(({ at }) => at))];
  }

  // The nearest place of the drawn curve: its point, and how far along it is, mm.
  along(event) {
    const { points = [], length } = this.answer?.path ?? {}, [x, y] = this.place(event, 0);
    const ways = points.slice(1).map((point, k) => Math.hypot(point[0] - points[k][0], point[1] - points[k][1]));
    const whole = ways.reduce((sum, way) => sum + way, 0);
    let best = null, before = 0;
    ways.forEach((way, k) => {
      const [[ax, ay], [bx, by]] = [points[k], points[k + 1]];
      const part = Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / (way * way || 1), 0), 1);
      const point = [ax + part * (bx - ax), ay + part * (by - ay)], off = Math.hypot(x - point[0], y - point[1]);
      if (!best || off < best.off) best = { off, point, s: ((before + part * way) / whole) * length };
      before += way;
    });
    if (!best) return null;
    const end = [[0, points[0]], [length, points.at(-1)]].find(([s]) => Math.abs(s - best.s) * this.view.scale < HIT);
    if (end) return { s: end[0], point: end[1] };
    return { s: rounded(best.s, this.snap || 0.1), point: best.point.map((v) => rounded(v, 0.01)) };
  }

  hit(event, points) {
    const box = this.svg.getBoundingClientRect(), at = [event.clientX - box.left, event.clientY - box.top];
    const far = points.map((point) => Math.hypot(...this.toScreen(point).map((v, i) => v - at[i])));
    const least = Math.min(...far);
    return least <= (event.pointerType === "touch" ? 2 : 1) * HIT ? far.indexOf(least) : -1;
  }

  moved(event) {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY], others = [...this.fingers].filter(([id]) => id !== event.pointerId);
    this.fingers.set(event.pointerId, now);
    if (this.tapped && Math.hypot(now[0] - this.tapped[0], now[1] - this.tapped[1]) < HIT) return;
    this.tapped = null;
    if (others.length) {
      const box = this.svg.getBoundingClientRect(), other = others[0][1];
      const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
      this.zoom(apart(now) / Math.max(apart(before), 1), [other[0] - box.left, other[1] - box.top]);
    } else if (this.grabbed != null) {
      this.on.move(this.grabbed, this.place(event));
    } else if (this.sliding) {
      const place = this.along(event);
      if (place) this.on.slide(this.sliding, place);
    } else if (this.from) {
      this.layers.ghost.replaceChildren(drawn(this.path([this.from[0].point, this.place(event, 0)])));
    } else if (["move", "draw"].includes(this.mode)) {
      this.view.x += now[0] - before[0];
      this.view.y += now[1] - before[1];
      this.paint();
    }
  }

  released(event) {
    this.fingers.delete(event.pointerId);
    const place = this.from && this.along(event);
    if (place && Math.abs(place.s - this.from[0].s) * this.view.scale > HIT) this.put(event);
    if (this.tapped && event.type === "pointerup") this.on.append(this.place(event));
    const changed = this.grabbed != null || this.sliding || this.filled || this.tapped;
    this.grabbed = this.sliding = this.tapped = null;
    this.appended = this.filled = false;
    if (changed) this.on.release();
  }

  typed(event) {
    const k = this.points.length ? [...this.layers.points.children].indexOf(document.activeElement) : -1;
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key === "+" || event.key === "-") this.zoom(event.key === "+" ? 1.25 : 0.8);
    else if (event.key === "0") this.fit();
    else if (ways[event.key] && k >= 0) {
      const step = (this.snap || 1) * (event.shiftKey ? 10 : 1);
      const point = this.points[k].map((v, i) => rounded(v + step * ways[event.key][i], 0.001));
      this.on.grab(k);
      this.on.move(k, point);
    } else if ((event.key === "Delete" || event.key === "Backspace") && k >= 0) this.on.remove(k);
    else if (event.key === "Insert") {
      const next = this.points[k + 1] ?? this.points[k - 1];
      if (k >= 0 && next) this.on.add(this.points[k].map((v, i) => (v + next[i]) / 2));
    } else return;
    event.preventDefault();
  }

  focus(k) { this.layers.points.children[k]?.focus(); }

  // What is given changes; the rest of the picture stays.
  show(given) {
    const before = this.points, size = this.size, wasInside = this.isInside();
    const isOutside = (point) => this.toScreen(point).some((v, i) => v < 0 || v > size[i]), isNew = (point, k) => `${point}` !== `${before[k]}`;
    Object.assign(this, given);
    const isSet = this.mode === "draw" && this.setPoints !== this.points.length; // a view that moves while points are set would misplace them
    if ("answer" in given) this.setPoints = this.points.length;
    const isOther = given.points?.length > 1 && before.length && given.points.every(isNew); // as after Undo of an enlargement
    const isNews = this.isOld && "answer" in given;
    this.isOld = isOther || (this.isOld && !isNews); // the answer is about other points
    if (!this.fingers.size && !isSet && (isOther || isNews || given.points?.some((point, k) => isNew(point, k) && isOutside(point)) || (wasInside && !this.isInside()))) return this.fit();
    if (given.points) this.paintPoints();
    if ("answer" in given || "ghost" in given) this.paintAnswer();
  }

  isInside() {
    const size = this.size;
    return [...this.points, ...(this.answer?.position ?? [])].every((point) => this.toScreen(point).every((v, i) => v >= 0 && v <= size[i]));
  }

  path(points, closed = false) {
    const scaled = points.map((point) => this.toScreen(point).map((v) => v.toFixed(1)).join(","));
    return points.length ? `M${scaled.join("L")}${closed ? "Z" : ""}` : "";
  }

  paint() {
    this.layers.grid.replaceChildren(...this.grid());
    this.layers.axis.replaceChildren(...(this.axis ? [drawn(this.line([[0, 0], [0, 1]]))] : []));
    this.paintAnswer();
    this.paintPoints();
  }

  paintAnswer() {
    const { layers, answer } = this;
    layers.ghost.replaceChildren(...(this.ghost ? [drawn(this.path(this.ghost))] : []));
    layers.drawn.replaceChildren(...(answer?.drawn ? [drawn(this.path(answer.drawn))] : []));
    layers.strip.replaceChildren(...(answer?.position ? this.strained(answer) : []));
    layers.comb.replaceChildren(...(answer?.curvature && !answer.moved ? [drawn(this.comb(answer))] : []));
    layers.line.replaceChildren(...(answer?.theorem?.line ? [drawn(this.line(answer.theorem.line))] : []),
      ...(answer?.thrust ?? []).map((side) => drawn(this.path(side))));
    layers.elements.replaceChildren(...(answer?.elements ?? []).map((element) => this.glyph(element)));
    layers.marks.replaceChildren(...(answer ? this.marks(answer) : []));
  }

  // Control points stay the same elements while they are moved: the focus stays where it is.
  paintPoints() {
    this.layers.polygon.replaceChildren(drawn(this.path(this.points)));
    const shown = this.points, group = this.layers.points, r = shown.length > 30 ? 3.5 : 6;
    while (group.children.length > shown.length) group.lastChild.remove();
    shown.forEach((point, k) => {
      const made = group.children[k] ?? element("circle", { tabindex: 0, role: "button" });
      const [x, y] = this.toScreen(point);
      made.setAttribute("r", r);
      made.setAttribute("cx", x.toFixed(1));
      made.setAttribute("cy", y.toFixed(1));
      made.setAttribute("aria-label", `${this.t("Control point")} ${k + 1}: ${point.map((v) => +v.toFixed(2)).join(", ")} mm`);
      if (!made.parentNode) {
        made.addEventListener("focus", () => this.on.select(k));
        group.append(made);
      }
    });
  }

  grid() {
    const [width, height] = this.size, { view } = this;
    const step = this.snap && this.snap * view.scale >= 8 ? this.snap : 10 ** Math.ceil(Math.log10(8 / view.scale));
    const [x0, y1] = this.toPlane(0, 0), [x1, y0] = this.toPlane(width, height);
    const lines = (from, to, draw) => {
      let fine = "", coarse = "";
      for (let k = Math.ceil(from / step); k * step <= to; k++) k % 10 ? (fine += draw(k * step)) : (coarse += draw(k * step));
      return [fine, coarse];
    };
    const across = lines(x0, x1, (x) => `M${this.toScreen([x, 0])[0].toFixed(1)},0V${height}`);
    const up = lines(y0, y1, (y) => `M0,${this.toScreen([0, y])[1].toFixed(1)}H${width}`);
    const told = element("text", { x: 8, y: height - 8 }, `${this.t("grid")} ${this.on.number(+step.toPrecision(3))} mm`);
    return [element("path", { d: across[0] + up[0] }), element("path", { d: across[1] + up[1], class: "coarse" }), told];
  }

  strained({ position, shares: free }) {
    const runs = COLORS.map(() => "");
    const at = position.map((point) => this.toScreen(point).map((v) => v.toFixed(1)).join(","));
    let last = -1;
    const shares = [free[0], ...free, free.at(-1)]; // tabs are not bent
    for (let k = 0; k + 1 < at.length; k++) {
      const step = stepOf(Math.max(shares[k], shares[k + 1] ?? 0));
      runs[step] += step === last ? `L${at[k + 1]}` : `M${at[k]}L${at[k + 1]}`;
      last = step;
    }
    return runs.map((d, k) => element("path", { d, stroke: COLORS[k] }));
  }

  comb({ position, curvature }) {
    const free = position.slice(1, -1), most = Math.max(...curvature.map(Math.abs), 1e-9);
    const [x0, x1] = range(free.map((p) => p[0])), [y0, y1] = range(free.map((p) => p[1]));
    const scale = (COMB_SHARE * Math.hypot(x1 - x0, y1 - y0)) / most;
    const tips = free.map(([x, y], k) => {
      const [a, b] = [free[Math.max(k - 1, 0)], free[Math.min(k + 1, free.length - 1)]];
      const [dx, dy] = [b[0] - a[0], b[1] - a[1]], size = Math.hypot(dx, dy) || 1, far = -scale * curvature[k];
      return [x - (dy / size) * far, y + (dx / size) * far];
    });
    return this.path(tips) + tips.map((tip, k) => (k % 4 ? "" : this.path([free[k], tip]))).join("");
  }

  // No longer than the view: dashes that nobody sees take a renderer long.
  line([[x, y], [dx, dy]]) {
    const [width, height] = this.size, [cx, cy] = this.toPlane(width / 2, height / 2);
    const at = (cx - x) * dx + (cy - y) * dy, far = (width + height) / 2 / this.view.scale;
    return this.path([at - far, at + far].map((t) => [x + t * dx, y + t * dy]));
  }

  // A rail is a bar on the side from which it pushes, a pin a ring, a tie a cord, a force an arrow, a mass a weight.
  glyph({ noun, places, force, mass, slot }) {
    const at = places.map((point) => this.toScreen(point)), [[x, y]] = at, size = force && Math.hypot(...force);
    const [dx, dy] = size ? [force[0] / size, -force[1] / size] : [0, -1]; // where it pushes to, on the screen
    const circle = (cx, cy, r, name) => element("circle", { cx: cx.toFixed(1), cy: cy.toFixed(1), r, class: name ?? "" });
    const bar = (side) => circle(x - side * dx * (BAR + 3), y - side * dy * (BAR + 3), BAR, "solid");
    const arrow = () => {
      const [tx, ty] = [x - dx * ARROW, y - dy * ARROW], head = [1, -1].map((side) => `${(x - BAR * (2 * dx + side * dy)).toFixed(1)},${(y - BAR * (2 * dy - side * dx)).toFixed(1)}`);
      return drawn(`M${tx.toFixed(1)},${ty.toFixed(1)}L${x.toFixed(1)},${y.toFixed(1)}M${head[0]}L${x.toFixed(1)},${y.toFixed(1)}L${head[1]}`);
    };
    const shape = { rail: () => [bar(1), ...(slot ? [bar(-1)] : [])], pin: () => [circle(x, y, BAR)],
      tie: () => [drawn(this.path(places)), ...at.map(([cx, cy]) => circle(cx, cy, 4, "solid"))],
      "point force": () => [arrow()], "point mass": () => [drawn(`M${x},${y}v14`), element("rect", { x: x - 8, y: y + 14, width: 16, height: 14 })] }[noun]();
    const said = size ? `${this.on.number(+size.toPrecision(2))} N` : mass ? `${this.on.number(+mass.toPrecision(4))} g` : "";
    const [lx, ly] = noun === "tie" ? at[0].map((v, i) => (3 * v + at[1][i]) / 4) : noun === "point mass" ? [x + 6, y + 22] : [x - dx * (noun === "point force" ? ARROW : 2 * BAR), y - dy * (noun === "point force" ? ARROW : 2 * BAR)];
    return element("g", { class: noun.replace(" ", "-") }, ...shape, element("title", {}, `${this.t(noun)} ${said}`), element("text", { x: (lx + 8).toFixed(1), y: (ly + 4).toFixed(1) }, said));
  }

  marks({ theorem: { inflections, at, off, crossings } = { inflections: [], off: [], crossings: [] }, places = [], refused }) {
    const mark = (kind, r) => (point, k) => {
      const [cx, cy] = this.toScreen(point).map((v) => v.toFixed(1));
      const name = kind === "inflection" ? `${k + 1}` : "";
      const said = kind === "inflection" ? `${this.t("Inflection")} ${k + 1}, ${this.on.number(at[k])} mm` : this.t({ off: "Not on the line", crossing: "The line meets the curve", place: "Place of the refusal" }[kind]);
      return element("g", { class: kind }, element("circle", { cx, cy, r }, element("title", {}, said)),
        element("text", { x: +cx + 9, y: +cy - 9 }, name));
    };
    return [...(refused ? [...places.map(mark("place", 11)), ...off.map(mark("off", 9)), ...crossings.map(mark("crossing", 8))] : []), ...inflections.map(mark("inflection", 4))];
  }
}

const drawn = (d) => element("path", { d });

export const rounded = (value, step) => +(Math.round(value / step) * step).toPrecision(12);

export const range = (values) => [Math.min(...values), Math.max(...values)];
