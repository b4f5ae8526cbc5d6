// The studio: one design, its drawing, everything that the server says about it, and points that stop where the strip becomes impossible.
import { EMPTY, emptied, HOLDERS, History, movePoint, packed, same, tableOf } from "./design.js";
import { Drawing, element } from "./drawing.js";
import { showFlat } from "./flat.js";
import { Form, html } from "./forms.js";
import { Space } from "./space.js";
import { STARTS } from "./starts.js";
import { COLORS, STEPS } from "./colors.js";

const ICONS = { // paths in a square of 24
  undo: "M8 5L3 10l5 5M3 10h11a5.500 5.500 0 0 1 0 11h-4", redo: "M16 5l5 5-5 5M21 10H10a5.500 5.500 0 0 0 0 11h4",
  draw: "M4 20l1-5L16 4l4 4L9 19zM14 6l4 4", keep: "M12 3l8 3v6c0 5-3.500 8-8 9-4.500-1-8-4-8-9V6zM8 12l3 3 5-6",
  hold: "M3 14c4-8 14-8 18 0M12 2v6M9.500 5.500L12 8l2.500-2.500M12 13a3 3 0 1 0 .01 0", nearest: "M3 17C8 3 16 3 21 17M3 21c5-11 13-11 18 0",
  sheets: "M12 4l9 4-9 4-9-4zM3 12l9 4 9-4M3 16l9 4 9-4", pair: "M3 12c5-10 13-10 18 0M3 12c5 10 13 10 18 0",
  starts: "M4 4h7v7H4zM13 4h7v7h-7zM4 13h7v7H4zM13 13h7v7h-7z", open: "M3 6h6l2 2h10v11H3z", save: "M4 4h13l3 3v13H4zM8 4v5h7V4M7 20v-7h10v7",
  link: "M10 14a4 4 0 0 0 6 0l4-4a4 4 0 0 0-6-6l-1 1M14 10a4 4 0 0 0-6 0l-4 4a4 4 0 0 0 6 6l1-1", download: "M12 4v11M7 11l5 5 5-5M4 20h16",
  more: "M4 6h16M4 12h16M4 18h16", fit: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5", "zoom-in": "M12 5v14M5 12h14", "zoom-out": "M5 12h14",
};
const LANGUAGES = { en: "English", de: "Deutsch", zh: "中文" };
const FILES = { dxf: "DXF", svg: "SVG", pdf: "PDF at 1:1", step: "STEP", stl: "STL", kit: "Kit as zip", design: "Design file" };
// What holds or loads a strip between its ends, as the records of a design; rails and pins keep their point.
const ELEMENTS = {
  rail: ["between", ([{ point }]) => ({ kind: "rail", at: point })],
  pin: ["between", ([{ point }]) => ({ kind: "pin", at: point })],
  tie: ["between", (places) => { const [start, end] = places.map(({ s }) => s).sort((a, b) => a - b); return { kind: "tie", start, end }; }],
  "point mass": ["loads", ([{ s }]) => ({ at: s, mass: 10 })],
  "point force": ["loads", ([{ s }]) => ({ at: s, force: [0, -1] })],
};
const STATES = ["first", "second"]; // of a part that rests in two curves
const SNAPS = [0, 1, 5, 10];
const SPACE_MS = 30, SLOW_SPACE_MS = 300; // between two pictures of the bent strip while it is dragged
const FURTHEST = 1.4; // of the slider that bends: as far as the server presses the ends together
const REST_MS = 250; // after the last change, until the whole model is made

export function mount(root, channel, hello, { linked = null, unread = false, address = false, kept = "elastica-studio", onchange = () => {} } = {}) {
  const history = History.kept(kept, linked ?? hello.design) ?? new History(kept, EMPTY);
  const chosen = localStored("elastica-language") ?? navigator.language.slice(0, 2);
  const other = linked && hello.design && !same(linked, hello.design);
  if (other) history.replace(hello.design); // the file comes first; the address is one step back
  const studio = new Studio(root, channel, hello, history, { address, onchange });
  studio.build(LANGUAGES[chosen] ? chosen : "en");
  if (other) studio.offer(linked);
  if (unread) studio.tell(studio.t("The design in this page's address cannot be read."));
  if (hello.refused) studio.ask({ do: "open" }); // which says in the language of the page why the file was not read
  return studio;
}

function localStored(key, value) {
  try {
    if (value !== undefined) localStorage.setItem(key, value);
    return localStorage.getItem(key);
  } catch { return null; }
}

class Studio {
  constructor(root, channel, hello, history, { address, onchange }) {
    Object.assign(this, { root, hello, history, address, onchange, mark: hello.mark, strip: 0, shown: 0, answer: null, frames: null, idle: [] });
    this.channel = { ask: (question) => channel.ask({ ...question, language: this.language }) };
    history.listeners.push(() => this.changed());
    channel.onstate = (alive, hello) => this.alive(alive, hello);
    root.classList.add("elastica-studio");
    root.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || event.target.matches("input")) return;
      event.preventDefault();
      event.shiftKey ? history.redo() : history.undo();
    });
    // A press beside an open menu, or Escape, closes it; a press on the drawing does nothing else.
    const opened = () => [...root.querySelectorAll(".menu[open]")];
    root.addEventListener("pointerdown", (event) => {
      const left = opened().filter((menu) => !menu.contains(event.target));
      for (const menu of left) menu.open = false;
      if (left.length && event.target.closest(".plane > svg")) event.stopPropagation();
    }, { capture: true });
    root.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      for (const menu of opened()) {
        menu.open = false;
        menu.firstChild.focus();
      }
    });
    root.addEventListener("dragover", (event) => event.preventDefault());
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      this.open(event.dataTransfer.files[0]);
    });
  }

  get design() { return this.history.design; }

  // ---- what is seen

  build(language) {
    const words = this.hello.words[language] ?? {}, t = this.t = (text) => words[`page|${text}`] ?? words[text] ?? text, digits = new Intl.NumberFormat(language, { maximumSignificantDigits: 5 });
    this.language = language;
    this.number = (value) => digits.format(value);
    const [, separator] = digits.format(0.5);
    this.boxed = (value) => `${value}`.replace(".", separator); // of a number box: all digits
    this.sheetsOf = this.hello.sheets.map(([kind, titles]) => [kind, titles.map(([name, title]) => { // the words of a title, and its thickness
      const [, material, size, unit] = title.match(/^(.*) ([\d.]+) (\S+)$/) ?? [];
      return [name, size ? `${t(material)} ${this.number(+size)} ${unit}` : title];
    })]);
    const button = (text, onclick, more = {}) => html("button", { type: "button", onclick, ...more }, t(text));
    const drawn = this.drawn = (icon) => element("svg", { viewBox: "0 0 24 24", "aria-hidden": "true", class: "icon" }, element("path", { d: ICONS[icon] }));
    const tool = (icon, text, onclick, more = {}) => html("button", { type: "button", onclick, "data-do": icon, ...more }, drawn(icon), html("span", {}, t(text)));
    const sign = (icon, text, onclick) => html("button", { type: "button", onclick, "aria-label": t(text), title: t(text) }, drawn(icon)); // without words
    const menu = (name, icon, text, ...items) => {
      const host = html("details", { class: `menu ${name}`, onfocusout: ({ relatedTarget }) => { if (relatedTarget && !host.contains(relatedTarget)) host.open = false; }, ontoggle: () => {
        const list = host.lastChild, over = host.getBoundingClientRect().left + list.offsetWidth + 8 - this.root.getBoundingClientRect().right;
        list.style.left = `${-Math.max(over, 0)}px`; // within the window
      } }, html("summary", {}, drawn(icon), html("span", {}, t(text))), html("div", {}, ...items.map(([label, key, value, act]) => button(label, act && (() => {
        host.open = false;
        host.firstChild.focus();
        act();
      }), { [key]: value, disabled: !act, title: act ? null : value }))));
      return host;
    };
    const select = (label, options, onchange, value) => html("select", { "aria-label": t(label), title: t(label), onchange: (event) => onchange(event.target.value) },
      ...options.map(([key, text]) => html("option", { value: key, selected: key === value }, text)));
    this.say = html("p", { class: "said", role: "status" });
    this.verdict = html("div", { class: "verdict", "aria-live": "polite", tabindex: "0" });
    this.sum = html("button", { type: "button", class: "sum", hidden: true, onclick: () => this.verdict.scrollIntoView({ block: "center" }) }); // on a phone, while the verdict is out of view
    new IntersectionObserver(([{ isIntersecting }]) => { this.sum.hidden = isIntersecting; }).observe(this.verdict);
    this.offers = html("div", { class: "offers" });
    this.numbers = html("dl", { class: "numbers", tabindex: "0" });
    this.empty = html("p", { class: "empty" });
    this.point = html("div", { class: "point", role: "group", hidden: true });
    this.dialog = html("dialog", { "aria-label": t("Start from") });
    this.bar = html("input", { type: "range", min: 0, max: FURTHEST, step: "any", value: 1, "aria-label": t("Bend"), oninput: () => this.bent() });
    this.forces = html("output", { class: "forces" });
    this.marks = html("div", { class: "marks" });
    this.whole = html("input", { type: "checkbox", id: "whole", checked: this.whole?.checked, onchange: () => this.model() });
    this.fields = html("div", { class: "fields" });
    this.which = html("div", {});
    const plane = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    plane.setAttribute("tabindex", 0);
    plane.setAttribute("role", "group");
    plane.setAttribute("aria-label", t("Drawing of the curve. Tab selects a control point, arrow keys move it, Insert adds a point, Delete removes it."));
    this.flat = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.flat.setAttribute("role", "img");
    this.flat.setAttribute("aria-label", t("Flat strip"));
    new ResizeObserver(() => this.flatten()).observe(this.flat);
    const space = html("div", { class: "scene" }, this.empty);
    this.pairing = tool("pair", "Two states", () => this.twoStates(), { class: "rare" });
    this.keeping = tool("keep", "Keep it possible", () => { this.keeping.setAttribute("aria-pressed", (this.keeps = !this.keeps)); this.judge(); }, { class: "rare", "aria-pressed": `${Boolean(this.keeps)}`, title: t("A dragged point stops at the border of what a strip can take. A point that makes the strip impossible is not added. Copies and holders are not checked.") });
    this.nearing = tool("nearest", "Nearest curve", () => this.nearest(), { class: "rare", title: t("The strip takes the nearest curve that is stable and within the strain limit.") });
    this.mode = tool("draw", "Draw", () => this.draws(this.drawing.mode !== "draw"));
    const all = tool("more", "More", () => all.setAttribute("aria-expanded", tools.classList.toggle("all")), { class: "more", "aria-expanded": "false" });
    const adding = menu("holding rare", "hold", "Hold and load", ...Object.keys(ELEMENTS).map((noun) => [noun, "data-put", noun, () => {
      this.draws(false);
      this.drawing.mode = noun;
      this.tell(t(noun === "tie" ? "Click on both places of the curve, or drag from one to the other." : "Click on the curve."));
    }]));
    const file = html("input", { type: "file", accept: this.hello.dropped.join(), hidden: true, onchange: () => this.open(file.files[0]) });
    const missing = Object.entries(this.hello.missing);
    const downloads = this.downloads = menu("downloads", "download", "Download", ...[...this.hello.downloads, "design"].map((kind) => [FILES[kind], "data-kind", kind, () => this.download(kind)]));
    for (const [kind, reason] of missing) downloads.lastChild.append(html("p", {}, `${t("Not available")}: ${t(FILES[kind])}. ${t("To get it")}: `, html("code", {}, reason)));
    // On a phone the tools of class `rare` are behind `all`.
    const tools = html("div", { class: "tools", role: "toolbar", "aria-label": t("Strip") },
      html("div", {}, tool("starts", "Start from", () => this.starts()), tool("open", "Open", () => file.click(), { title: `${t("Drop a file on the drawing")}: ${this.hello.dropped.join(", ")}` }), file,
        this.hello.file ? tool("save", "Save", () => this.save(), { class: "save rare", title: this.hello.file }) : null),
      html("div", { class: "steps" }, tool("undo", "Undo", () => this.history.undo()), tool("redo", "Redo", () => this.history.redo())),
      html("div", {}, this.mode, this.keeping, adding, this.pairing),
      html("div", {}, this.nearing, tool("sheets", "Suitable sheets", () => this.sheets(), { class: "rare" })),
      html("div", {}, this.address ? tool("link", "Copy link", () => this.link(), { class: "rare" }) : null, downloads, all));
    this.root.replaceChildren(
      html("header", {}, html("h1", {}, "elastica studio"), tools,
        select("Language", Object.entries(LANGUAGES), (one) => { localStored("elastica-language", one); this.build(one); }, language)),
      html("section", { class: "plane", "aria-label": t("Draw") }, html("div", { class: "view" }, this.point,
        select("Snap", SNAPS.map((step) => [`${step}`, step ? `${t("Snap")} ${step} mm` : `${t("Snap")} ${t("off")}`]), (step) => { this.drawing.snap = +step; this.drawing.paint(); }, "0"),
        sign("fit", "Fit", () => this.drawing.fit()), sign("zoom-in", "Zoom in", () => this.drawing.zoom(1.25)), sign("zoom-out", "Zoom out", () => this.drawing.zoom(0.8))), plane, this.legend()),
      html("section", { class: "told", "aria-label": t("Strip") }, this.verdict, this.numbers, this.say),
      html("section", { class: "space", "aria-label": t("Bent strip") }, space,
        html("div", { class: "bend", onpointerenter: () => this.framed(), onfocusin: () => this.framed() }, html("label", {}, t("Bend"), html("span", {}, this.bar, this.marks)), this.forces),
        html("div", { class: "whole" }, this.whole, html("label", { for: "whole" }, t("Show the whole model")))),
      html("section", { class: "flat", "aria-label": t("Flat strip") }, this.flat),
      html("section", { class: "settings", "aria-label": t("Settings") }, html("h2", {}, t("Settings")), this.which, this.fields),
      this.sum, this.dialog);
    document.documentElement.lang = language;
    this.drawing = new Drawing(plane, t, {
      number: this.number,
      grab: () => { this.fresh = true; },
      move: (k, point) => (this.keeps && !this.design.pair && this.answer?.position ? this.lead(k, point) : this.edit((curve) => movePoint(curve, k, point), this.fresh)),
      release: () => { if (!this.leading) this.released(); },
      put: (noun, places) => this.put(noun, places),
      slide: ({ element: { key, index }, end }, { s, point }) => {
        const table = tableOf(this.design, this.strip, key)[key][index], name = ["at", "start", "end"].filter((each) => each in table)[end];
        this.history.change((design) => { tableOf(design, this.strip, key)[key][index][name] = Array.isArray(table[name]) ? point : s; }, { step: this.fresh });
        this.fresh = false;
      },
      append: (point) => this.checked((design) => {
        const curve = this.curve(design);
        curve.spline.push(point);
        delete curve.knots;
        delete curve.weights;
        curve.degree = Math.max(2, Math.min(4, curve.spline.length - 1));
      }),
      add: (point) => this.counted({ near: point }),
      remove: (k) => this.counted({ remove: k }),
      undo: () => this.history.undo(),
      select: (k) => this.selected(k),
    });
    this.space = new Space(space, t);
    this.formFor(this.design);
    this.draws(!this.points().length);
    this.refit = this.drawing.mode === "move"; // a view that moves while points are set would misplace them
    this.changed();
    this.drawing.fit();
  }

  // The fields of a strip and its copies, or of a part with two states.
  formFor(design) {
    const pair = this.formOf = Boolean(design.pair), table = (one, key) => (pair ? one.pair : tableOf(one, this.strip, key));
    const { fields, pair_fields } = this.hello, all = pair ? pair_fields : [...fields, ...COPIES];
    const groups = Object.entries(GROUPS).map(([title, names]) => [title, names.flatMap((name) => all.filter((field) => field.name === name))]);
    for (const field of COPIES) if (field.held) field.when = () => Boolean(holding(this.design));
      else if (field.many) field.when = () => this.isModel();
    const shown = groups.flatMap(([, of]) => of);
    this.form = new Form(this.fields, groups.filter(([, of]) => of.length), all.filter((field) => !shown.includes(field)), {
      t: this.t, boxed: this.boxed, sheets: this.sheetsOf, begin: (table) => this.begin(table), aside: (path) => this.aside(path), isIdle: ({ name }) => this.idle.includes(name),
      get: (path) => (copyOf(path)?.get(this.design) ?? reach(table(this.design, path[0]) ?? {}, path)),
      set: (path, value) => {
        const copy = copyOf(path);
        this.history.change((one) => {
          if (copy) copy.set(one, value);
          else put(table(one, path[0]), path, value);
          if (path[0] === "loads" && this.weighed && !JSON.stringify(value ?? []).includes('"mass"')) delete table(one, "gravity").gravity;
        });
      },
    });
  }

  // The values of the kinds of a setting that are not chosen, by kind.
  aside(path) { return this.history.aside[`${this.formOf ? "pair" : this.strip} ${path.join(" ")}`] ??= {}; }

  // A click on the drawing sets the next point of the curve, or moves the view.
  draws(on) {
    this.drawing.mode = on ? "draw" : "move";
    this.mode.setAttribute("aria-pressed", on);
  }

  legend() {
    return html("ul", { class: "legend" }, html("li", {}, this.t("Strain / limit")), ...STEPS.map((most, k) => {
      const swatch = html("span", { class: "swatch" });
      swatch.style.background = COLORS[k];
      return html("li", {}, swatch, Number.isFinite(most) ? `≤ ${100 * most} %` : "> 100 %");
    }));
  }

  // ---- what is asked

  // A design of several strips, or of a strip and what holds it: the kit and the verdict are of all.
  isModel(design = this.design) { return design.strips?.length > 1 || design.strips?.some((strip) => "count" in strip) || this.hello.model_keys.some((key) => key in design); }

  curve(design = this.design) { return design.pair ? design.pair[STATES[this.strip]] : design.strips?.[this.strip]?.curve; }

  // A part that rests in two curves is asked for in a table of its own. Without it, the design is the one of before, or the first curve of a part that was opened.
  twoStates() {
    const { design, history, strip } = this, { pair } = design;
    if (!pair && this.points().length < 2) return this.tell(this.t("Draw at least three points"));
    this.strip = 0;
    history.replace(!pair ? paired(design, strip) : history.before((one) => (one.strips ?? []).map((_, k) => paired(one, k))) ?? { ...EMPTY, sheet: pair.sheet ?? EMPTY.sheet, strips: [{ label: "A1", curve: pair.first }] });
    this.drawing.fit();
  }

  points(design = this.design) {
    const points = this.curve(design)?.spline;
    return Array.isArray(points) && points.every((point) => point.length === 2 && point.every(Number.isFinite)) ? points : [];
  }

  edit(change, step = true) {
    this.reshape((design) => change(this.curve(design)), step);
    this.fresh = false;
  }

  // Keep it possible: the point follows the answers, which stop it at the border of what can be made.
  async lead(k, point) {
    this.wanted = { k, point };
    if (this.leading) return;
    this.leading = true;
    this.drawing.svg.setAttribute("aria-busy", "true");
    let turn = 0, last = k; // direction in which the next answer searches, and the point that it is for
    const strain = Math.max(...this.answer.shares) <= 1; // the strain limit is a border only from below
    while (this.wanted) {
      const { design, strip, wanted } = this, { spline } = this.curve(), length = this.length ?? this.answer?.path?.length;
      this.wanted = null;
      if (wanted.k !== last) [turn, last] = [0, wanted.k];
      const moved = movePoint(this.curve(design), wanted.k, wanted.point), from = moved.map((j) => spline[j]);
      const answer = await this.channel.ask({ do: "strip", design, strip, length, live: true, hold: { point: moved, from, step: 1 / this.drawing.view.scale, turn, strain } });
      turn = answer?.turn ?? 0;
      if (turn) this.wanted ??= wanted;
      if (!answer?.position) { // the point stays at the border
        this.held(answer);
        continue;
      }
      this.shown = answer.id;
      this.answered = answer;
      this.edit((curve) => { moved.forEach((j, i) => { curve.spline[j] = answer.point?.[i] ?? this.curve(design).spline[j]; }); }, this.fresh);
      this.answered = null;
      this.held(answer);
      if (answer.point) this.wanted ??= wanted; // the border may be farther on
    }
    this.leading = false;
    this.drawing.svg.setAttribute("aria-busy", "false");
    if (this.drawing.grabbed == null) this.released();
  }

  // Keep it possible: a change of the number of points is made only if the strip stays possible. True if it was made at once.
  checked(change) {
    const { design, strip, answer } = this, changed = this.design;
    if (!this.keeps || design.pair || !answer?.position) {
      this.reshape(change);
      return true;
    }
    change(changed);
    const strain = Math.max(...answer.shares) <= 1;
    this.following.then(() => this.channel.ask({ do: "strip", design: changed, strip, live: true })).then((tried) => {
      if (!tried || !same(design, this.design)) return;
      if (tried.position && !(strain && Math.max(...tried.shares) > 1)) this.reshape(change);
      else this.stopped("Not changed: the strip could not be made then.");
    });
    return false;
  }

  held(answer) {
    if (answer?.point) this.stopped("Stopped: the strip cannot be made beyond this place.");
  }

  // Until the next change.
  stopped(text) {
    this.tell(this.t(text));
    this.say.classList.add("held");
  }

  // The last change of a drag: what is left out while the pointer moves is computed.
  released() {
    this.before = this.length;
    this.changed();
  }

  // Ties and loads keep their fraction of the length: the server moves them from the length to which they refer.
  reshape(change, step = true) {
    this.before = this.length ?? this.answer?.path?.length;
    this.history.change(change, { step });
  }

  // The required fields of a new table: places on the curve, else the smallest number allowed.
  begin({ fields }) {
    const length = this.answer?.path?.length ?? 100, part = { start: 0.25, end: 0.75 };
    return Object.fromEntries(fields.filter(({ required }) => required).map(({ name, kind, least }) => [name,
      kind === "either" || name === "at" ? +(length * (part[name] ?? 0.5)).toFixed(1) : kind === "list" ? [0, -1] : Math.max(least ?? 1, 1)]));
  }

  put(noun, places) {
    const [key, made] = ELEMENTS[noun];
    this.draws(false);
    if (!Array.isArray(tableOf(this.design, this.strip, key)[key] ?? [])) return this.tell(this.t("The loads are a weight. Remove it to set loads on the curve."));
    this.tell("");
    this.history.change((design) => {
      this.listOf(design, key).push(made(places));
      const table = tableOf(design, this.strip, "gravity");
      if (noun !== "point mass" || "gravity" in table) return;
      table.gravity = this.weighed = true; // or the mass has no weight; it goes with the last mass
    });
  }

  // The list of elements or loads of the strip; where there is none, a new one in its table.
  listOf(design, key) {
    const table = tableOf(design, this.strip, key);
    return table[key] ?? (design.strips[this.strip][key] = []);
  }

  changed() {
    const design = this.design;
    if (this.strip >= (design.pair ? 2 : design.strips?.length ?? 0)) this.strip = 0;
    this.pairing.setAttribute("aria-pressed", Boolean(design.pair));
    if (this.formOf !== Boolean(design.pair)) this.formFor(design);
    const isModel = this.isModel(design);
    if (isModel !== this.wasModel) this.whole.checked = this.wasModel = isModel;
    this.frames = this.framing = this.slid = null;
    this.length = this.before;
    this.before = null;
    Object.assign(this.bar, { max: FURTHEST, value: 1 });
    this.scale();
    if (this.say.matches(".no, .held")) this.tell(""); // it was about the design before
    this.nearing.setAttribute("aria-pressed", Boolean(design.strips?.length && "limits" in tableOf(design, this.strip, "limits")));
    this.nearing.disabled = !design.strips?.length;
    const axis = Boolean(design.revolution || design.patterns?.some((pattern) => pattern.rotate));
    this.drawing.show({ points: this.points(design) });
    const at = this.points(design)[this.chosen]; // its boxes follow the pointer and the keys
    if (at) this.point.querySelectorAll("input").forEach((input, axis) => { input.value = this.boxed(+at[axis].toFixed(3)); });
    if (axis !== this.drawing.axis) Object.assign(this.drawing, { axis }).fit();
    if (!this.drawing.fingers.size) {
      this.form.show();
      this.choose(design);
    }
    this.previewed = null;
    this.offers.replaceChildren();
    this.following = this.follow(design);
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.rested(), REST_MS);
    this.onchange(design);
  }

  choose(design) {
    const strips = design.pair ? STATES.map((state) => ({ label: design.pair[`${state}_state`] || this.t(state) })) : design.strips ?? [];
    this.which.replaceChildren(...(strips.length > 1 ? [html("label", {}, `${this.t(design.pair ? "State" : "Strip")} `, html("select", { onchange: (event) => {
      this.strip = +event.target.value;
      this.changed();
      this.drawing.fit();
    } }, ...strips.map((one, k) => html("option", { value: k, selected: k === this.strip }, one.label ?? `S${k + 1}`))))] : []));
  }

  async follow(design) {
    if ((!design.strips?.length && !design.pair) || this.curve(design)?.spline?.length < 3) {
      this.paint(null);
      return;
    }
    const answer = this.answered ?? await this.channel.ask({ do: design.pair ? "pair" : "strip", design, strip: this.strip, live: this.drawing.grabbed != null, length: this.length });
    if (!answer || answer.id < this.shown) return;
    this.shown = answer.id;
    if (this.length && Object.keys(answer.kept ?? {}).length) this.keep(answer);
    this.paint(answer);
  }

  keep({ kept, path }) {
    this.history.amend((design) => { for (const [key, records] of Object.entries(kept)) this.listOf(design, key).splice(0, Infinity, ...records); });
    this.length = path.length;
    if (!this.drawing.fingers.size) this.form.show();
    this.onchange(this.design);
  }

  async rested() {
    const design = this.design;
    if (this.address) history.replaceState(null, "", `#${await packed(design)}`);
    this.model();
    await this.following;
    this.suggest(design, this.strip);
  }

  // After a refusal: the changes that make the strip possible, each a button that shows its strip while it is pointed at.
  async suggest(design, strip) {
    if (design.pair || !this.answer?.refused || this.drawing.fingers.size || !same(design, this.design)) return;
    this.offers.replaceChildren(html("p", {}, `${this.t("Searching for changes that help")} …`));
    const answer = await this.channel.ask({ do: "cures", design, strip });
    if (!answer || !same(design, this.design) || strip !== this.strip) return;
    if (!answer.cures?.length) return this.offers.replaceChildren(html("p", {}, answer.reason ?? this.t("No change was found that makes the strip possible. Follow the instruction above.")));
    this.offers.replaceChildren(...answer.cures.map(({ text, effect, strips, removed }) => {
      const change = (one) => {
        if (strips) one.strips.splice(strip, 1, ...strips);
        for (const key of removed ?? []) for (const table of [one, one.strips[strip]]) delete table[key];
      }, changed = structuredClone(design);
      change(changed);
      const [show, hide] = [() => this.preview(changed), () => this.preview(null)];
      return html("button", { type: "button", class: "cure", onpointerenter: show, onfocus: show, onpointerleave: hide, onblur: hide, onclick: () => this.history.change(change) }, text, html("small", {}, effect));
    }));
    this.explain(false);
  }

  // The strip of another design over the drawn curve; without one, the strip of this design again.
  async preview(design) {
    this.previewed = design;
    const answer = design ? await this.channel.ask({ do: "strip", design, strip: this.strip, live: true }) : this.answer;
    if (this.previewed !== design || !answer || (design && answer.refused)) return;
    this.alone(answer);
    this.drawing.show({ points: this.points(design ?? this.design), answer, ghost: design ? this.answer.drawn : null });
  }

  async model() {
    const design = this.design;
    if (!(this.whole.checked || this.isModel()) || !(design.strips?.length || design.revolution)) {
      this.alone();
      this.assembly = null;
      this.tabulate();
      if (this.answer || design.revolution) this.judge();
      return;
    }
    this.tell(`${this.t("Working")} …`);
    const answer = await this.channel.ask({ do: "model", design });
    if (!answer) return;
    this.tell("");
    if (!(this.whole.checked || this.isModel())) return;
    this.assembly = answer;
    if (this.answer || design.revolution) this.judge();
    if (answer.places && this.whole.checked) {
      this.space.showModel(answer);
      this.explain(true);
    } else this.alone();
    this.tabulate();
    this.offers.append(...(answer.offers ?? []).map(({ text, gap, tab }) => html("button", { type: "button", class: "cure", onclick: () => this.history.change((one) => {
      const longer = (ends = {}) => (Array.isArray(ends) ? ends.map(longer) : { ...ends, ...tab });
      put(holding(one), ["gap"], gap);
      for (const table of [one, ...one.strips.filter((strip) => strip.ends)]) table.ends = longer(table.ends);
    }) }, text)));
  }

  alone(answer = this.answer) {
    this.space.showAll(answer?.position ? answer.states ?? [answer] : []);
    this.explain(Boolean(answer?.position));
  }

  // The reason why the view in space is empty.
  explain(isShown) {
    const { t, answer } = this, reasons = answer?.refused ? ["No bent strip is shown, because the strip cannot be made.", ...(this.offers.querySelector(".cure") ? ["Point at a change to see its strip."] : [])]
      : ["The bent strip is shown here as soon as the curve has three points."];
    this.empty.textContent = isShown || this.lost ? "" : reasons.map(t).join(" ");
  }

  // ---- what is answered

  paint(answer) {
    const { t } = this;
    if (answer?.states) Object.assign(answer, answer.states[this.strip], { other: answer.states[1 - this.strip]?.position ?? answer.states[1 - this.strip]?.drawn });
    this.answer = answer;
    if (answer && `${answer.idle ?? []}` !== `${this.idle}`) {
      this.idle = answer.idle ?? [];
      this.form.show();
    }
    this.drawing.show({ answer, ghost: answer?.other ?? null });
    if (answer && this.refit) this.drawing.fit(); // the tabs are known now
    if (answer) this.refit = false;
    this.judge();
    this.flatten();
    this.tabulate();
    this.travel(answer);
    if (!this.whole.checked) this.spaceSoon ??= setTimeout(() => {
      this.spaceSoon = null; // the drawing under the pointer comes first
      if (!this.whole.checked) this.alone();
    }, this.space.isSlow ? SLOW_SPACE_MS : SPACE_MS);
  }

  flatten() { showFlat(this.flat, this.answer?.flat, this.answer && `${this.t("Flat strip")}, ${this.number(this.answer.length)} mm`); }

  // One verdict on the strip and on what holds it, which waits for the answer on the whole model. Warnings of the shape that the slider shows come last.
  judge() {
    const { t, answer } = this, assembly = answer || this.design.revolution ? this.assembly : null, refused = answer?.refused ?? assembly?.refused;
    const stops = (rows = []) => rows.filter((row) => row.stops).map((row) => row.text);
    const known = !refused && (this.isModel() ? assembly : answer ?? assembly);
    const warnings = known ? [...stops(answer?.rows), ...(assembly?.warnings ?? [])] : [], slid = known ? stops(this.slid?.rows) : [];
    const state = refused ? "no" : warnings.length || slid.length ? "care" : known ? "yes" : "";
    const clashes = Array.isArray(refused?.where?.field); // of several settings
    const title = { yes: "It can be made", care: warnings.length ? "Read the warnings before you cut" : "Read the warnings before you bend it this far", no: clashes ? "These settings cannot be combined" : "It cannot be made" }[state] ?? (answer || this.design.revolution || this.lost ? "" : "Draw at least three points");
    const unchecked = this.keeps && refused && !answer?.refused ? [t("“Keep it possible” checks each strip alone, not its copies and holders.")] : [];
    const all = refused ? [refused.message, ...unchecked] : state ? [...warnings, ...slid, ...(answer && answer.deviation == null ? [answer.text] : [])]
      : title ? [t("Click on the drawing to set the first points of a curve, or start from an example.")] : [];
    const texts = [...new Set(all)].filter((text) => !all.some((other) => other !== text && other.includes(text)));
    const said = [title, ...texts].join();
    if (said !== this.verdict.said) { // a reader of the screen hears what is new
      this.verdict.className = `verdict ${state}`;
      this.sum.className = `sum ${state}`;
      this.sum.replaceChildren(html("strong", {}, t(title)));
      this.verdict.replaceChildren(html("strong", {}, t(title)), ...(state === "care" ? [this.offers] : []), ...texts.map((text) => html("p", {}, ...this.form.linked(text))), ...(state === "care" ? [] : [this.offers]));
    }
    this.verdict.said = said;
    this.offerFiles(title);
    this.root.classList.toggle("no-strip", !answer?.position && (!assembly || Boolean(assembly.refused)));
  }

  // The kit of all strips comes before the files of one strip; what cannot be made has no files, and one line with the reason.
  offerFiles(title) {
    const { t, answer, assembly, design } = this, several = this.isModel(), list = this.downloads.lastChild, buttons = [...list.querySelectorAll("[data-kind]")];
    const isMade = (kind) => kind === "design" || (kind === "kit" && assembly ? !assembly.refused : Boolean(answer?.position) || (kind === "kit" && Boolean(design.revolution)));
    for (const button of buttons) {
      const { kind } = button.dataset;
      button.textContent = several && !["kit", "design"].includes(kind) ? `${t(FILES[kind])}, ${t("one strip")}` : t(FILES[kind]);
      button.disabled = !isMade(kind);
    }
    const [kit, saved] = ["kit", "design"].map((kind) => buttons.find((button) => button.dataset.kind === kind));
    if (several) list.prepend(kit);
    else saved.before(kit);
    list.querySelector(".reason")?.remove();
    if (buttons.some((button) => button.disabled)) list.prepend(html("p", { class: "reason" }, `${t("Not available")}: ${t(title || "It cannot be made")}`));
  }

  // The report on the strip; the slider has other rows for the shape that it shows.
  rows() {
    const { rows = [] } = this.answer ?? {}, shape = this.slid?.rows ?? [], isOfShape = ({ label }) => shape.some((row) => row.label === label);
    return rows.filter((row) => !isOfShape(row)).toSpliced(rows.findIndex(isOfShape), 0, ...shape);
  }

  // Only the values that change are written anew.
  tabulate() {
    const { t, answer } = this, row = (label, text) => ({ label: t(label), text, details: [] });
    const read = this.read && same(this.read.curve, this.curve()) ? [row("Read", this.read.text)] : []; // until the curve is changed
    const model = (answer || this.design.revolution) && this.assembly?.text ? [row("Model", this.assembly.text), ...this.assembly.notes.map((text) => row("Note", text))] : [];
    const rows = [...read, ...this.rows().filter(({ stops }) => !stops), ...model];
    const cells = this.numbers.children;
    if (cells.length !== 2 * rows.length) this.numbers.replaceChildren(...rows.flatMap(() => [html("dt"), html("dd")]));
    rows.forEach(({ label, text, details }, k) => [label, text].forEach((content, i) => {
      const cell = cells[2 * k + i];
      if (cell.textContent !== content) cell.textContent = content;
      cell.title = details.join(" ");
    }));
  }

  tell(text, ...more) {
    this.say.classList.remove("no", "held");
    this.say.replaceChildren(text, ...more);
  }

  refuse({ message }) {
    if (this.verdict.textContent.includes(message)) return this.tell(""); // it is printed there
    this.tell(message);
    this.say.classList.add("no");
  }

  // An answer, or null; what is refused is told.
  async ask(question) {
    this.tell(`${this.t("Working")} …`);
    const answer = await this.channel.ask(question);
    if (answer?.refused) this.refuse(answer.refused);
    else if (answer) this.tell("");
    if (answer?.refused && answer.mark !== undefined) this.differs(answer);
    if (this.lost) this.alive(false);
    return answer?.refused ? null : answer;
  }

  alive(alive, hello) {
    if (!this.t) return;
    this.lost = !alive;
    if (alive) {
      if (hello.file !== this.hello.file) { // another server, at the address of the last one
        this.hello = hello;
        this.build(this.language);
      }
      this.tell("");
      this.changed();
      if (hello.refused) this.ask({ do: "open" });
      else if (hello.file && hello.mark !== this.mark) this.differs(hello);
      return;
    }
    this.assembly = null;
    this.paint(null);
    this.tell(this.t("The server has stopped. Your design is kept in this page and its address. Run elastica studio again and open its address in this tab."));
  }

  // The file is not as this page read it last: the user chooses, and nothing is lost.
  differs({ mark, design }) {
    if (same(design, this.design)) {
      this.mark = mark;
      this.tell(`${this.t("Saved")}: ${this.hello.file}`);
      return;
    }
    const { t } = this, choice = (name, text, act) => html("p", {}, html("button", { type: "button", "data-choice": name, onclick: () => {
      this.dialog.close();
      act();
    } }, t(name)), ` ${t(text)}`);
    const take = () => {
      this.mark = mark;
      this.tell("");
      this.history.replace(design);
      this.drawing.fit();
    };
    const changed = `${this.hello.file}: ${t("The file was changed since this page read it.")}`;
    this.tell(changed);
    this.ask1(changed,
      choice("Keep this page's design", "This page's design replaces the design in the file.", () => {
        this.mark = mark;
        this.save();
      }),
      ...(design ? [choice("Use the file's design", "The page shows the file's design. Undo brings back the design that the page has now.", take),
        choice("Keep both designs", "This page's design is downloaded. Then the file's design is shown.", async () => { if (await this.download("design")) take(); })] : []));
  }

  // The address holds another design than the file, which is shown.
  offer(design) {
    const { t } = this, done = () => this.tell("");
    this.tell(`${t("The design in this page's address differs from the file. The file's design is shown.")} `,
      html("button", { type: "button", class: "take", onclick: () => {
        this.history.replace(design);
        this.drawing.fit();
        done();
      } }, t("Use it")),
      html("button", { type: "button", onclick: done }, t("Discard it")));
  }

  // ---- what is done by one click

  async counted(which) {
    const answer = await this.ask({ do: "edit", design: this.design, strip: this.strip, ...which });
    if (answer) this.checked((design) => { put(design, this.place(design), answer.curve); });
  }

  place(design) { return design.pair ? ["pair", STATES[this.strip]] : ["strips", this.strip, "curve"]; }

  selected(k) {
    const { t } = this;
    const point = () => this.points()[k];
    if (!point()) return;
    this.chosen = k;
    const input = (axis) => html("input", { value: this.boxed(+point()[axis].toFixed(3)), inputmode: "decimal", "aria-label": "xy"[axis], onchange: (event) => {
      const value = Number(event.target.value.replace(",", "."));
      if (Number.isFinite(value)) this.edit((curve) => movePoint(curve, k, curve.spline[k].with(axis, value)));
    } });
    this.point.hidden = false;
    this.point.setAttribute("aria-label", `${t("Control point")} ${k + 1}`);
    this.point.replaceChildren(html("span", {}, `${t("Control point")} `), html("b", {}, `${k + 1}`), html("label", {}, "x ", input(0)), html("label", {}, "y ", input(1)), html("span", {}, "mm"),
      html("button", { type: "button", onclick: () => this.counted({ remove: k }) }, t("Remove")));
  }

  forget() {
    this.chosen = null;
    this.point.hidden = true;
  }

  // The strip takes the nearest possible curve; the control points stay as they are drawn.
  nearest() {
    const aside = this.aside(["limits"]);
    this.history.change((design) => {
      const table = tableOf(design, this.strip, "limits");
      if ("limits" in table) {
        aside[0] = table.limits;
        delete table.limits;
      } else design.strips[this.strip].limits = aside[0] ?? { ...this.hello.nearest };
    });
  }

  async sheets() {
    const { t, design, strip } = this, fitting = html("tbody", {}), progress = html("p", { role: "status" }), others = new Map();
    this.ask1(t("Suitable sheets"), progress, html("table", {}, fitting));
    const kinds = this.sheetsOf, percent = ({ used }) => `${Math.round(100 * used)} %`;
    for (const [k, [, titles]] of kinds.entries()) {
      progress.textContent = `${t("Working")} … ${Math.round((100 * k) / kinds.length)} %`;
      const answer = await this.channel.ask({ do: "sheets", names: titles.map(([name]) => name), design, strip });
      if (!answer || !progress.isConnected || !this.dialog.open) return;
      if (answer.refused) return void (progress.textContent = answer.refused.message);
      for (const row of answer.sheets) {
        const title = Object.fromEntries(titles)[row.name], { kind, text } = row;
        if (!row.fits) others.set(kind, [...(others.get(kind) ?? []), [row.used == null ? title : `${title} (${percent(row)})`, text ?? t("Strain / limit")]]);
        else fitting.append(html("tr", {}, html("td", {}, html("button", { type: "button", onclick: () => {
          this.history.change((design) => { tableOf(design, strip, "sheet").sheet = row.name; });
          this.dialog.close();
        } }, title)), html("td", {}, `${percent(row)} ${t("of the sheet's limit")}, ${this.number(row.mass)} g`)));
      }
    }
    const suits = [...others].some(([kind, rows]) => kind !== "strain" && (others.size > 1 || new Set(rows.map(([, text]) => text)).size > 1)); // with a change that depends on the sheet
    progress.textContent = fitting.children.length ? "" : t(suits ? "No sheet fits as it is. Some fit with the change that is named above them." : "No sheet fits. Change the curve first.");
    if (others.size) this.dialog.append(html("details", { open: !fitting.children.length }, html("summary", {}, t("Sheets that do not fit")), ...[...others.values()].map((rows) => { // each reason once
      const texts = new Set(rows.map(([, text]) => text));
      return html("p", {}, html("b", {}, `${texts.size > 1 ? `${t("For example")}: ` : ""}${[...texts][0]}`), html("br"), rows.map(([name]) => name).join(", "));
    })));
  }

  ask1(title, ...content) {
    this.dialog.setAttribute("aria-label", title);
    this.dialog.replaceChildren(html("div", { class: "title" }, html("h2", {}, title), html("button", { type: "button", class: "close", onclick: () => this.dialog.close() }, this.t("Close"))), ...content);
    this.dialog.showModal();
  }

  async starts() {
    const { t } = this, all = [...STARTS, ...Object.values(this.hello.starts)];
    const cards = [{ ...EMPTY, name: t("Empty drawing") }, ...all].map((design, k) => html("button", { type: "button", class: "card", "data-name": k ? design.name : "empty", onclick: () => {
      this.strip = 0;
      this.refit = k > 0;
      this.forget();
      this.history.replace(k ? design : emptied(this.design));
      this.dialog.close();
      this.draws(!this.points().length);
      this.changed();
      this.drawing.fit();
    } }, html("span", { class: "picture" }), t(design.name)));
    cards[0].firstChild.append(this.drawn("draw"));
    this.ask1(t("Start from"), html("div", { class: "cards" }, ...cards));
    for (const [k, design] of all.entries()) {
      const answer = design.revolution ? null : await this.channel.ask({ do: "strip", design, strip: 0 });
      if (!this.dialog.open) return;
      const half = design.revolution?.points ?? [], points = answer?.position ?? answer?.drawn ?? [...half, ...half.map(([x, y]) => [-x, y]).reverse()];
      if (points.length) cards[k + 1].firstChild.append(thumbnail(points));
    }
  }

  // The shapes of the slider, computed once when the pointer or the keyboard reaches it.
  async framed() {
    if (!this.answer?.position || this.answer.states) return;
    this.framing ??= this.channel.ask({ do: "bend", design: this.design, strip: this.strip });
    const { framing } = this, answer = await framing;
    if (!answer?.frames || framing !== this.framing || this.frames) return answer?.refused;
    this.frames = answer.frames;
    this.bar.max = this.frames.at(-1).part;
    this.scale();
  }

  // Below the slider: the force over the travel, red where the strip is not stable, and the places of the flat and the drawn shape.
  scale() {
    const { t } = this, frames = this.frames ?? [], most = Math.max(...frames.map(({ force }) => force)), left = (part) => (100 * part) / this.bar.max;
    const line = (some) => element("path", { d: some.map(({ part, force }, k) => `${k ? "L" : "M"}${left(part)},${22 - (20 * force) / (most || 1)}`).join(""), class: some.at(-1).stable ? "" : "snaps" });
    const mark = (part, ...text) => {
      const frame = frames.find((one) => one.part === part);
      return html("span", {}, ...text, ...(frame ? [html("br"), `${this.number(frame.force)} N`] : []));
    };
    const back = html("button", { type: "button", class: "link", onclick: () => {
      this.bar.value = 1;
      this.bent();
    } }, t("as drawn"));
    const before = html("span", {}, mark(0, t("flat")), mark(1, back)); // ends below the drawn shape, or before the label of the last one
    before.style.flexBasis = `calc(${left(1)}% + 8px)`;
    const snap = frames.find(({ part, stable }) => part && !stable);
    this.marks.replaceChildren(element("svg", { viewBox: "0 0 100 24", preserveAspectRatio: "none", "aria-hidden": "true" }, ...frames.slice(1).map((frame, k) => line([frames[k], frame])), ...(frames.length ? [element("path", { d: `M${left(1)},0V24`, class: "place" })] : [])),
      html("p", {}, before, ...(this.bar.max > 1 && frames.length ? [mark(+this.bar.max, t("pressed"))] : [])),
      ...(snap ? [html("span", { class: "snaps" }, t("it snaps"))] : []));
    if (snap) this.marks.lastChild.style.left = `${Math.min(left(snap.part), 75)}%`;
    else this.marks.append(html("p", { class: "caption" }, frames.length ? t("does not snap on the way") : ""));
    if (frames.length) this.marks.append(html("span", { class: "force" }, t("Force")));
  }

  async bent() {
    const refused = await this.framed();
    if (refused) this.refuse(refused);
    if (!this.frames) return;
    const { t } = this, part = +this.bar.value;
    const frame = this.frames.reduce((best, one) => (Math.abs(one.part - part) < Math.abs(best.part - part) ? one : best));
    const moved = frame.part !== 1, shape = { ...this.answer, ...frame, moved };
    this.slid = moved ? frame : null;
    this.judge();
    this.tabulate();
    this.drawing.show({ answer: shape });
    if (!this.whole.checked) this.space.showAll([shape]);
    this.travel(shape, frame);
  }

  // Beside the slider: the distance of the ends and how far they moved, and their force and moment once they did.
  travel(shape, frame = null) {
    const { t } = this, apart = ({ position }) => Math.hypot(...[0, 1].map((axis) => position.at(-2)[axis] - position[1][axis]));
    const moved = shape?.position && apart(shape) - apart(this.answer), value = (label, text) => html("span", {}, `${t(label)} `, html("b", {}, text));
    const way = Math.abs(moved) < 0.05 ? "" : ` (${moved > 0 ? "+" : "−"}${this.number(+Math.abs(moved).toFixed(1))})`;
    this.forces.replaceChildren(...(shape?.position && !shape.states ? [value("Distance of the ends", `${this.number(+apart(shape).toFixed(1))} mm${way}`)] : []),
      ...(frame ? [value("Force", `${this.number(frame.force)} N`), value("Moment", `${this.number(frame.moment)} N mm`)] : []),
      ...(frame?.stable === false ? [html("strong", {}, t("it snaps"))] : []));
    this.forces.classList.toggle("snaps", frame?.stable === false);
  }

  async link() {
    await this.rested();
    await navigator.clipboard?.writeText(location.href);
    this.tell(this.t("Copied"));
  }

  // One after the other, each on the mark that the last one left.
  save() {
    this.saving = (this.saving ?? Promise.resolve()).then(async () => {
      const answer = await this.ask({ do: "save", design: this.design, mark: this.mark });
      if (!answer) return;
      this.mark = answer.mark;
      this.tell(`${this.t("Saved")}: ${answer.saved}`);
    });
  }

  async download(kind) {
    const { design } = this;
    const answer = await this.ask(kind === "design" ? { do: "save", copy: true, design } : { do: "file", kind, design, strip: this.strip });
    if (!answer) return false;
    const link = html("a", { href: URL.createObjectURL(new Blob([answer.content ?? answer.text])), download: answer.name ?? `${design.name ?? design.strips?.[0]?.label ?? "strip"}.toml` });
    this.root.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
    return true;
  }

  // A file that was dropped or chosen: curves for this strip, or a whole design.
  async open(file) {
    if (!file) return;
    const answer = await this.ask({ do: "read", name: file.name, text: await file.text() });
    if (!answer) return;
    const name = file.name.replace(/\.[^.]*$/, "");
    this.forget();
    if (answer.design) this.history.replace(answer.design);
    else if (answer.curves.length === 1) this.take(answer.curves[0], name);
    else this.ask1(this.t("Choose a curve"), ...answer.curves.map((one) => html("button", { type: "button", onclick: () => {
      this.dialog.close();
      this.take(one, name);
    } }, one.called)));
    if (answer.notes?.length) this.tell(answer.notes.join(" · "));
    this.draws(false);
    this.drawing.fit();
  }

  take({ curve, read }, name) {
    if (read) this.read = { curve, text: read };
    this.reshape((design) => { put(Object.assign(design, { name }), this.place(design), curve); });
    this.drawing.fit();
  }
}

function thumbnail(points) {
  const [x, y] = [0, 1].map((axis) => points.map((point) => point[axis]));
  const [x0, y1, size] = [Math.min(...x), Math.max(...y), Math.max(Math.max(...x) - Math.min(...x), Math.max(...y) - Math.min(...y), 1)];
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", `-5 -5 110 110`);
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", `M${points.map((p) => [(100 * (p[0] - x0)) / size, (100 * (y1 - p[1])) / size]).join("L")}`);
  svg.append(path);
  return svg;
}

// A part with two states: the second begins as the curve of a strip, turned over.
function paired({ schema, name, sheet, strips }, strip = 0) {
  const first = strips?.[strip]?.curve, [a, b] = [first?.spline?.[0], first?.spline?.at(-1)];
  if (!a) return null;
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]], size = Math.hypot(dx, dy) || 1;
  const second = { ...first, spline: first.spline.map(([x, y]) => {
    const off = ((x - a[0]) * -dy + (y - a[1]) * dx) / size;
    return [x + (2 * off * dy) / size, y - (2 * off * dx) / size];
  }) };
  return { schema, name, pair: { first, second, sheet: strips[strip].sheet ?? sheet } };
}

const reach = (table, path) => path.reduce((value, key) => value?.[key], table);

function put(table, path, value) {
  for (const key of path.slice(0, -1)) table = table[key] = typeof table[key] === "object" && table[key] ? table[key] : {};
  if (value === undefined) delete table[path.at(-1)];
  else table[path.at(-1)] = value;
}

// Copies and what holds them: keys of the whole design, not of a strip.
const holderOf = (design) => HOLDERS.find((key) => key in design);
const holding = (design) => design.revolution ?? design[holderOf(design)];
const copyField = (name, value) => ({ name, common: true, group: "Copies", unit: "", default: null, ...value });
const COPIES = [
  copyField("Number of strips around the axis", {
    kind: "count", default: 1, help: "Copies of the strip, evenly around the vertical axis x = 0 of the drawing.",
    get: (design) => design.patterns?.find((one) => one.rotate)?.rotate.count,
    set: (design, count) => {
      design.patterns = [...(design.patterns ?? []).filter((one) => !one.rotate), ...(count > 1 ? [{ rotate: { count } }] : [])];
      if (!design.patterns.length) delete design.patterns;
    },
  }),
  copyField("Holders", {
    kind: "choice", choices: HOLDERS, help: "Parts that hold the ends of the strips.", get: holderOf,
    set: (design, holder) => {
      const sheet = design[holderOf(design)]?.sheet ?? "mdf-3";
      for (const key of HOLDERS) delete design[key];
      if (holder) design[holder] = holder === "fixtures" ? {} : { sheet };
    },
  }),
  copyField("Sheet of the holders", {
    kind: "choice", sheets: true, held: true, help: "Material of the rings or plates that hold the ends.", get: (design) => design[holderOf(design)]?.sheet,
    set: (design, sheet) => { if (design[holderOf(design)] && holderOf(design) !== "fixtures") design[holderOf(design)].sheet = sheet ?? "mdf-3"; },
  }),
  copyField("sheet_size", {
    kind: "number", unit: "mm", many: true, help: "Width and height of the sheets that all parts are cut from, such as 600; 400.", default: [600, 400], get: (design) => design.nest?.sheet_size,
    set: (design, size) => {
      put(design, ["nest", "sheet_size"], size);
      if (!Object.keys(design.nest).length) delete design.nest;
    },
  }),
  copyField("gap", {
    kind: "number", unit: "mm", held: true, help: "Distance between the two plates that hold inclined tabs.", get: (design) => holding(design)?.gap,
    set: (design, gap) => { if (holding(design)) put(holding(design), ["gap"], gap); },
  }),
];
// The settings that most designs need, as a maker calls them; all others are one step away.
const GROUPS = {
  Material: ["sheet", "thickness", "printed"], Size: ["max_width", "min_width", "style", "least_thickness", "fillet"], Ends: ["supports", "ends", "match", "free", "pad"],
  Holders: [...COPIES.map(({ name }) => name), "between", "loads"], Limits: ["limits", "keep", "objective"],
};
const copyOf = ([name]) => COPIES.find((one) => one.name === name);
