// The design as the tables of a design file, every earlier state of it, and how it fits into an address.

const MOST_STATES = 100;
export const HOLDERS = ["rings", "base", "fixtures", "stand"];
const SMOOTH = 1e-3; // rad: the largest turn of a joint that is kept smooth

export const EMPTY = {
  schema: 1, sheet: "birch-plywood-0.8", max_width: 30,
  strips: [{ label: "A1", curve: { spline: [], degree: 4 } }],
};

// An empty drawing for the same sheet and the same copies.
export function emptied(design) {
  const kept = ["sheet", "thickness", "max_width", "ends", "nest", ...(design.patterns?.every((one) => one.rotate) ? ["patterns", ...HOLDERS] : [])];
  return { ...structuredClone(EMPTY), sheet: design.pair?.sheet ?? EMPTY.sheet, ...Object.fromEntries(kept.filter((key) => key in design).map((key) => [key, design[key]])) };
}

export class History {
  constructor(key, design) {
    this.key = key;
    this.past = [];
    this.future = [];
    this.now = JSON.stringify(design);
    this.aside = {}; // by strip and key: the values of the kinds that are not chosen, which wait until they are chosen again
    this.listeners = [];
    addEventListener("pagehide", () => this.timer && this.keep()); // a page that is left at once loses nothing
  }

  // What this tab held before it was loaded again; with `design` only where that is what it showed.
  static kept(key, design) {
    try {
      const kept = JSON.parse(sessionStorage.getItem(key));
      if (kept && (!design || kept.now === JSON.stringify(design))) {
        return Object.assign(new History(key, JSON.parse(kept.now)), kept);
      }
    } catch { /* nothing is kept where the browser forbids it */ }
    return design ? new History(key, design) : null;
  }

  get design() { return JSON.parse(this.now); }

  // Change a copy of the design; steps of one drag are one state to go back to.
  change(edit, { step = true } = {}) {
    const design = this.design;
    edit(design);
    this.set(design, step);
  }

  // Another design, to which the values of kinds that are not chosen do not belong.
  replace(design) {
    this.aside = {};
    this.set(design);
  }

  set(design, step = true) {
    const text = JSON.stringify(design);
    if (text === this.now) return;
    if (step) {
      this.past = [...this.past.slice(1 - MOST_STATES), this.now];
      this.future = [];
    }
    this.now = text;
    this.tell();
  }

  // A change that follows from the last one: no state of its own.
  amend(edit) {
    const design = this.design;
    edit(design);
    this.now = JSON.stringify(design);
    this.keep();
  }

  // The last design of the history whose next design is one of those that `made` returns for it; null if there is none.
  before(made) {
    const states = [...this.past, this.now], isNext = (k) => made(JSON.parse(states[k])).some((design) => JSON.stringify(design) === states[k + 1]);
    const last = states.findLastIndex((_, k) => k + 1 < states.length && isNext(k));
    return last < 0 ? null : JSON.parse(states[last]);
  }

  undo() { this.go(this.past, this.future); }
  redo() { this.go(this.future, this.past); }

  go(from, to) {
    if (!from.length) return;
    to.push(this.now);
    this.now = from.pop();
    this.tell();
  }

  tell() {
    for (const listener of this.listeners) listener(this.design);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.keep(), 150);
  }

  keep() {
    const { past, future, now, aside } = this;
    clearTimeout(this.timer);
    this.timer = 0;
    if (this.key) try { sessionStorage.setItem(this.key, JSON.stringify({ past, future, now, aside })); } catch { /* no room */ }
  }
}

const squeezed = (stream) => new Response(stream).arrayBuffer();

export async function packed(design) {
  const stream = new Blob([JSON.stringify(design)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await squeezed(stream));
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

const LARGEST = 4e6; // letters of a design that is unpacked: an address may come from anybody

export async function unpacked(text) {
  if (!text) return null;
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))
      .pipeThrough(new TextDecoderStream()).getReader();
    let json = "";
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      json += part.value;
      if (json.length > LARGEST) return null;
    }
    const design = JSON.parse(json);
    return isDesign(design) ? design : null;
  } catch {
    return null; // no design, or a part of one
  }
}

// Tables where the page reads tables and lists where it reads lists; the core checks the rest.
function isDesign(design) {
  const isTable = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
  const isCurve = (curve) => !isTable(curve) || curve.spline === undefined || (Array.isArray(curve.spline) && curve.spline.every(Array.isArray));
  const tables = (key, isRight) => design[key] === undefined || (Array.isArray(design[key]) && design[key].every((one) => isTable(one) && isRight(one)));
  return isTable(design) && (design.strips || design.revolution || design.pair) && tables("strips", (strip) => isCurve(strip.curve))
    && tables("patterns", ({ rotate }) => rotate === undefined || isTable(rotate))
    && ["revolution", "pair", "rings", "base", "fixtures", "stand"].every((key) => design[key] === undefined || isTable(design[key]))
    && (!design.pair || (isCurve(design.pair.first) && isCurve(design.pair.second)));
}

const sorted = (_, value) => (value && typeof value === "object" && !Array.isArray(value) ? Object.fromEntries(Object.entries(value).sort()) : value);

// Equal designs, in whatever order their keys are written.
export const same = (one, other) => JSON.stringify(one, sorted) === JSON.stringify(other, sorted);

// Move control point k. At a smooth joint of Bezier pieces the handles stay in line: they follow the joint, and the opposite handle turns.
export function movePoint({ spline, knots, degree }, k, [x, y]) {
  const isJoint = (j) => knots && degree > 1 && spline[j - 1] && spline[j + 1] && knots[j + 1] === knots[j + degree], way = (a, b) => [b[0] - a[0], b[1] - a[1]];
  const ratio = (j, one, other) => { // of the lengths of two handles; 0 at a corner
    if (!isJoint(j)) return 0;
    const [a, b] = [way(spline[j], spline[one]), way(spline[j], spline[other])], size = Math.hypot(...a), along = a[0] * b[0] + a[1] * b[1];
    return along < 0 && Math.abs(a[0] * b[1] - a[1] * b[0]) < SMOOTH * -along ? Math.hypot(...b) / size : 0;
  };
  const step = way(spline[k], [x, y]), moved = new Map([[k, [x, y]]]), shift = (j, by) => moved.set(j, [spline[j][0] + by * step[0], spline[j][1] + by * step[1]]);
  if (ratio(k, k - 1, k + 1)) [k - 1, k + 1].forEach((j) => shift(j, 1));
  else for (const side of [-1, 1]) {
    const turn = ratio(k + side, k, k + 2 * side);
    if (turn) shift(k + 2 * side, -turn);
  }
  for (const [j, point] of moved) spline[j] = point;
  return [...moved.keys()];
}

// A key of a strip may stand in its own table or, for all strips, at the top.
export function tableOf(design, strip, key) {
  return design.strips?.[strip] && key in design.strips[strip] ? design.strips[strip] : design;
}
