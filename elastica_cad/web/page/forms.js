// Controls made of declared fields: the server says what can be asked, and in which words and units.

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

// What was typed: a number, a length with its unit, a list or table as JSON writes it, or a text (a formula too).
export function read(text, unit) {
  const typed = text.trim();
  if (!typed) return undefined;
  const number = typed.match(/^(-?[\d.,]+(?:e-?\d+)?)\s*(mm|cm|m|in|inch|")?$/i);
  const value = number && Number(number[1].replace(",", "."));
  if (number && Number.isFinite(value)) return unit === "mm" && number[2] ? value * PER[number[2].toLowerCase()] : value;
  if (/^[[{]|^(true|false)$/.test(typed)) {
    try { return JSON.parse(typed); } catch { /* a text after all */ }
  }
  return typed;
}

export class Form {
  // get(path) and set(path, value) reach into the design; undefined is what is not given.
  constructor(host, fields, { t, get, set, sheets }) {
    Object.assign(this, { t, get, set, sheets, controls: [] });
    const groups = new Map();
    for (const field of fields) {
      const key = field.common ? "" : field.group || "more";
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(this.control(field, [field.name]));
    }
    host.replaceChildren(...(groups.get("") ?? []), ...[...groups].filter(([key]) => key).map(([key, made]) =>
      html("details", {}, html("summary", {}, t(key)), ...made)));
    this.show();
  }

  show() { for (const control of this.controls) control(); }

  control(field, path) {
    const kinds = field.of?.length ? field.of : [field];
    const tables = kinds.filter((kind) => kind.fields);
    return tables.length ? this.table(field, tables, kinds, path) : this.plain(field, path);
  }

  plain(field, path) {
    const { t } = this, id = `field-${path.join("-")}`;
    const choices = field.name === "sheet" ? this.sheets : field.choices?.length ? field.choices : field.kind === "flag" ? ["true", "false"] : null;
    const changed = (event) => this.set(path, choices && field.kind !== "flag" ? event.target.value || undefined : read(event.target.value, field.unit));
    const input = choices
      ? html("select", { id, onchange: changed }, field.default == null && field.name === "sheet" ? null : html("option", { value: "" }, this.absent(field)),
        ...choices.map((one) => html("option", { value: one }, { true: t("yes"), false: t("no") }[one] ?? one)))
      : html("input", { id, onchange: changed, inputmode: field.kind === "text" ? "text" : "decimal", placeholder: this.absent(field), spellcheck: "false" });
    this.controls.push(() => {
      const value = this.get(path);
      if (document.activeElement !== input || choices) input.value = value == null ? "" : typeof value === "object" ? JSON.stringify(value) : `${value}`;
    });
    return html("div", { class: "field", title: t(field.help) }, html("label", { for: id }, this.named(field)), input,
      html("span", { class: "unit" }, field.unit ?? ""));
  }

  absent(field) { return field.default == null || typeof field.default === "object" ? "–" : `${field.default}`; }

  named(field) { return this.t(field.name.replaceAll("_", " ")); }

  // A table is there or not; of several the kind is chosen.
  table(field, tables, kinds, path) {
    const { t } = this, id = `field-${path.join("-")}`;
    const plain = kinds.find((kind) => !kind.fields);
    const select = html("select", { id }, html("option", { value: "" }, "–"),
      ...(plain?.kind === "flag" ? [html("option", { value: "true" }, t("yes"))] : []),
      ...tables.map((one, k) => html("option", { value: `${k}` }, t(one.title ?? "as below"))));
    const inner = html("div", { class: "inner" });
    const index = (value) => (value == null || value === false ? "" : value === true ? "true"
      : `${Math.max(tables.findIndex((one) => one.title === value.kind), 0)}`);
    let shown = null;
    select.addEventListener("change", () => {
      const one = tables[select.value];
      this.set(path, select.value === "" ? undefined : select.value === "true" ? true : one.tagged ? { kind: one.title } : {});
    });
    this.controls.push(() => {
      select.value = index(this.get(path));
      if (shown === select.value) return;
      shown = select.value;
      const count = this.controls.length;
      inner.replaceChildren(...(tables[shown]?.fields ?? []).map((one) => this.control(one, [...path, one.name])));
      for (const control of this.controls.slice(count)) control();
    });
    return html("div", { class: "table" }, html("div", { class: "field", title: t(field.help) },
      html("label", { for: id }, this.named(field)), select), inner);
  }
}
