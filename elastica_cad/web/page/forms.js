// Controls made of declared fields: the server says what can be asked, and in which words and units.

const LABELS = { true: "yes", false: "no", blank: "pre-bent strip", "drawn blank": "pre-bent strip, drawn", base: "base plate", fixtures: "printed blocks", stand: "first that fits" }; // of values and tables
const ABSENT = { // what holds where nothing is set, as the server decides it
  thickness: "as listed", min_width: "automatic", compensate: "automatic", smooth: "automatic", samples: "automatic", seam_position: "automatic", engrave: "label", style: "one sheet", ends: "10 mm tabs", gravity: "not counted",
  limits: "no", keep: "nothing", natural_curvature: "flat sheet", section: "by width", tolerance: "usual", shop: "usual", between: "none", loads: "none", Holders: "none",
};
const TITLES = { between: "rails, pins and ties", loads: "masses and forces", limits: "curve may change", keep: "curve keeps", gravity: "own weight", match: "equal length of" }; // of fields whose names say little
const HELPS = { sheet: "Material of the strip." }; // where the declared text is about files
const PER = { mm: 1, cm: 10, m: 1000, in: 25.4, inch: 25.4, '"': 25.4 };

export function html(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, "");
    else if (value !== false && value != null) made.setAttribute(key, value);
  }
  made.append(...children.filter((child) => child != null));
  return made;
}

// What was typed: a number, a length with its unit, several numbers with a semicolon, a cross or a comma and a space between, a list or table as JSON writes it, or a text (a formula too).
export function read(text, unit) {
  const typed = text.trim();
  if (!typed) return undefined;
  const several = typed.replace(/\s*mm$/i, "").split(/\s*[;x×*]\s*|,\s+/i);
  if (several.length > 1 && several.every((one) => /^-?[\d.,]*\d$/.test(one))) return several.map((value) => Number(value.replace(",", ".")));
  const number = typed.match(/^(-?[\d.,]+(?:e-?\d+)?)\s*(mm|cm|m|in|inch|")?$/i);
  const value = number && Number(number[1].replace(",", "."));
  if (number && Number.isFinite(value)) return unit === "mm" && number[2] ? value * PER[number[2].toLowerCase()] : value;
  if (/^[[{]|^(true|false)$/.test(typed)) {
    try { return JSON.parse(typed); } catch { /* a text after all */ }
  }
  return typed;
}

// The things that the value of a field may be.
const valuesOf = (field) => (field.kind === "either" ? field.of : [field]);
// The tables of which a value is a list.
const listed = (value) => (value?.kind === "list" ? value.of.flatMap(valuesOf).filter((entry) => entry.fields) : []);
const titleOf = (table) => LABELS[table.word ?? table.table] ?? table.word ?? table.table;

export class Form {
  // Groups are titles with their fields; others are behind one step. get(path) and set(path, value) reach into the design; undefined is what is not given.
  // aside(path) holds the values of the kinds that are not chosen, by kind; isIdle(field) is true for a field without effect beside the others.
  constructor(host, groups, others, { t, boxed, get, set, aside, isIdle, sheets, begin }) {
    Object.assign(this, { t, boxed, get, set, aside, isIdle, sheets, begin, controls: [], named: new Map() });
    const made = (fields) => fields.map((field) => this.greyed(field, this.control(field, [field.name]))), by = new Map();
    for (const field of others) by.set(field.group, [...(by.get(field.group) ?? []), field]);
    host.replaceChildren(...groups.map(([title, fields]) => html("fieldset", { class: title.toLowerCase() }, html("legend", {}, t(title)), ...made(fields))),
      ...(by.size ? [html("details", { class: "rest" }, html("summary", {}, t("More settings")),
        ...[...by].map(([title, fields]) => html("fieldset", {}, title ? html("legend", {}, t(title)) : null, ...made(fields))))] : []));
    this.show();
  }

  // A value as text in a box; boxed(number) has the decimal separator of the language.
  shown(value, unit) {
    if (typeof value === "number") return this.boxed(unit === "mm" ? +value.toPrecision(6) : value);
    if (Array.isArray(value) && value.length === 2 && value.every(Number.isFinite)) return value.map(this.boxed).join("; ");
    return typeof value === "object" && value ? JSON.stringify(value) : `${value ?? ""}`;
  }

  show() { for (const control of [...this.controls]) control(); }

  // What has no effect is grey, and keeps its value.
  greyed(field, host) {
    this.controls.push(() => host.querySelectorAll(":is(input, select, button):not(.aside)").forEach((one) => { one.disabled = this.isIdle(field); }));
    return host;
  }

  control(field, path) {
    const tables = valuesOf(field).filter((value) => value.fields);
    return tables.length ? this.table(field, tables, path) : listed(field).length ? this.list(field, listed(field), path) : this.plain(field, path);
  }

  // A text in which the quoted names of settings lead to them.
  linked(text) {
    return text.split(/([“„].+?[”“])/).map((part, k) => {
      const input = k % 2 ? this.named.get(part.slice(1, -1)) : null;
      return input ? html("button", { type: "button", class: "link", onclick: () => {
        for (let box = input.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
        input.scrollIntoView({ block: "center" });
        (input.id ? input : input.firstChild).focus();
      } }, part) : part;
    });
  }

  // Controls of a part of the form that is made anew: those before are dropped.
  renew(host, before, make) {
    this.controls = this.controls.filter((control) => !before.includes(control));
    const count = this.controls.length;
    host.replaceChildren(...make());
    const made = this.controls.slice(count);
    for (const control of made) control();
    return made;
  }

  // A list of tables: each with its fields and a button that removes it, and below a choice of what to add.
  list(field, tables, path) {
    const { t } = this, id = `${idOf(path)}-add`, rows = html("div", { class: "inner" });
    const kindOf = (entry) => Math.max(tables.findIndex((table) => (table.word && "kind" in entry ? table.word === entry.kind : Object.keys(entry).every((key) => table.fields.some(({ name }) => name === key)))), 0);
    const add = this.select([["", t("add …")], ...tables.map((table, k) => [`${k}`, t(titleOf(table))])], { id, onchange: () => {
      const table = tables[add.value];
      if (table) this.set(path, [...(this.get(path) ?? []), { ...(table.word ? { kind: table.word } : {}), ...this.begin(table) }]);
      add.value = "";
    } });
    const entries = () => (Array.isArray(this.get(path)) ? this.get(path) : []);
    let kinds = null, made = [];
    this.controls.push(() => {
      const now = entries().map(kindOf);
      if (`${now}` === kinds) return;
      kinds = `${now}`;
      made = this.renew(rows, made, () => now.map((kind, k) => html("div", { class: "entry" },
        html("div", { class: "title" }, `${t(titleOf(tables[kind]))} ${k + 1}`, html("button", { type: "button", "aria-label": `${t("Remove")}: ${t(titleOf(tables[kind]))} ${k + 1}`, onclick: () => {
          const rest = entries().filter((_, other) => other !== k);
          kinds = null; // the entries behind it move up
          this.set(path, rest.length ? rest : undefined);
        } }, t("Remove"))), ...tables[kind].fields.map((one) => this.control(one, [...path, k, one.name])))));
    });
    return html("div", { class: "table list" }, this.row(field, add, id), rows);
  }

  // The help is also printed where names say little, among the limits and the other settings, and everywhere on a phone.
  row(field, input, id) {
    const { t } = this, help = t(HELPS[field.name] ?? field.help);
    if (!input.disabled) this.named.set(t(field.name.replaceAll("_", " ")), input);
    (input.id ? input : input.firstChild).title = help; // read as its description
    return html("div", { class: "field" }, html("label", { for: id }, t(TITLES[field.name] ?? field.name.replaceAll("_", " "))), input, html("span", { class: "unit" }, field.unit),
      field.help ? html("p", { class: "help", "aria-hidden": "true" }, help) : null);
  }

  // A value and its text each; or the title of a group and the options in it.
  select(options, more) {
    const made = ([value, text]) => (Array.isArray(text) ? html("optgroup", { label: this.t(value) }, ...text.map(made)) : html("option", { value }, text));
    return html("select", more, ...options.map(made));
  }

  plain(field, path) {
    const { t } = this, id = idOf(path), values = valuesOf(field), [value] = values;
    const absent = t(ABSENT[field.name] ?? LABELS[field.default] ?? this.shown(field.default, ""));
    if (value.size === 2 && value.of[0].choices) return this.pair(field, path, value.of[0].choices);
    const words = (value.kind === "flag" && values.length === 1 ? ["true", "false"] : value.choices ?? []).map((one) => [one, t(LABELS[one] ?? one)]);
    const choices = field.sheets || ["sheet", "backing"].includes(field.name) ? this.sheets : words;
    const changed = ({ target }) => {
      const typed = value.kind === "text" || value.kind === "choice" ? target.value || undefined : read(target.value, field.unit);
      if (typed === undefined && field.required && path.length > 1) target.value = this.shown(this.get(path), field.unit); // an entry of a list is not complete without it
      else this.set(path, typed);
    };
    const input = choices.length
      ? this.select([...(field.name === "sheet" ? [] : [["", absent]]), ...choices], { id, onchange: changed })
      : html("input", { id, onchange: changed, inputmode: value.kind === "text" ? "text" : "decimal", placeholder: absent, spellcheck: "false" });
    this.controls.push(() => {
      const now = this.get(path);
      if (document.activeElement !== input || choices.length) input.value = this.shown(now, field.unit);
    });
    const row = this.row(field, input, id);
    if (field.when) this.controls.push(() => { row.hidden = !field.when(); });
    return row;
  }

  // One choice for the start, one for the end.
  pair(field, path, choices) {
    const { t } = this, id = idOf(path);
    const made = ["start", "end"].map((end, k) => this.select([["", t(choices[0])], ...choices.slice(1).map((one) => [one, t(one)])], { id: k ? `${id}-end` : id, "aria-label": `${t(field.name)}, ${t(end)}`,
      onchange: () => this.set(path, made.some((one) => one.value) ? made.map((one) => one.value || choices[0]) : undefined) }));
    this.controls.push(() => made.forEach((one, k) => { one.value = this.get(path)?.[k] === choices[0] ? "" : this.get(path)?.[k] ?? ""; }));
    return this.row(field, html("span", { class: "pair" }, ...made), id);
  }

  // A table is there or not; of several the kind is chosen; some may be a plain value instead.
  table(field, tables, path) {
    const { t } = this, id = idOf(path), plain = valuesOf(field).filter((value) => !value.fields);
    const flag = plain.some((value) => value.kind === "flag"), others = plain.filter((value) => value.kind !== "flag");
    const titled = tables.length > 1 || flag;
    const select = this.select([["", t(ABSENT[field.name] ?? "none")], ...(flag ? [["true", t("yes")]] : []), ...tables.map((one, k) => [`${k}`, t(titled ? titleOf(one) : "as below")]),
      ...(others.length ? [["value", t(listed(others[0]).length ? "each as below" : "value")]] : [])], { id });
    const inner = html("div", { class: "inner" }), unchosen = html("div", { class: "inner" });
    const kindOf = (now) => (now == null || now === false ? "" : now === true ? "true" : typeof now !== "object" || Array.isArray(now) ? "value"
      : `${Math.max(tables.findIndex((one) => (one.word ? one.word === now.kind : Object.keys(now).every((key) => one.fields.some(({ name }) => name === key)))), 0)}`);
    const isBegun = !others[0] || others[0].kind === "number" || (others[0].kind === "list" && !others[0].size); // else only a file has such a value
    select.addEventListener("change", () => {
      const one = tables[select.value], now = this.get(path), aside = this.aside(path);
      if (now !== undefined) aside[kindOf(now)] = now;
      this.set(path, aside[select.value] ?? { "": undefined, "true": true, "value": others[0]?.kind === "number" ? 0 : [] }[select.value] ?? (one && (one.word ? { kind: one.word } : {})));
    });
    // The values of the kinds that are not chosen, of a name that several kinds have the chosen one.
    const greyed = (chosen, aside) => {
      const entries = new Map(tables.flatMap(({ fields }, k) => fields.filter(({ name }) => aside[k]?.[name] !== undefined).map((one) => [one.name, [one, aside[k][one.name]]])));
      if ("value" in aside) entries.set("value", [{ ...field, name: "value" }, aside.value]);
      for (const { name } of chosen === "value" ? [{ name: "value" }] : tables[chosen]?.fields ?? []) entries.delete(name);
      return [...entries].map(([name, [one, value]]) => this.row(one, html("input", { id: idOf([...path, name]), class: "aside", disabled: true, value: this.shown(value, one.unit) }), idOf([...path, name])));
    };
    let kind = null, made = [], waited = null;
    this.controls.push(() => {
      const aside = this.aside(path);
      select.value = kindOf(this.get(path));
      const waiting = JSON.stringify([select.value, aside]);
      if (waiting !== waited) unchosen.replaceChildren(...greyed(select.value, aside));
      waited = waiting;
      if (!isBegun) select.lastChild.hidden = select.value !== "value" && !("value" in aside);
      if (kind === select.value) return;
      kind = select.value;
      made = this.renew(inner, made, () => (kind === "value" ? [this.control({ ...field, ...(others.length > 1 ? { kind: "either", of: others } : others[0]), name: "value" }, path)]
        : (tables[kind]?.fields ?? []).map((one) => this.control(one, [...path, one.name]))));
    });
    return html("div", { class: "table" }, this.row({ ...field, unit: "" }, select, id), inner, unchosen);
  }
}

const idOf = (path) => `field-${path.join("-").replaceAll(/[^\w-]+/g, "-")}`;
