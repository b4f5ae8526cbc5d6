// The same page in a notebook. MODULES holds its files by name, those before that others import: see notebook.py.
const addresses = {};
for (const [name, text] of Object.entries(MODULES)) {
  const linked = text.replace(/from "(\.\/[^"]+)"/g, (_, other) => `from "${addresses[other]}"`);
  addresses[name] = URL.createObjectURL(new Blob([linked], { type: "text/javascript" }));
}
const [{ mount }, { KernelChannel }] = await Promise.all([import(addresses["./studio.js"]), import(addresses["./channel.js"])]);

function render({ model, el }) {
  const host = document.createElement("div");
  el.classList.add("elastica-host");
  el.append(host);
  mount(host, new KernelChannel(model), model.get("hello"), {
    linked: model.get("design"),
    kept: null,
    onchange: (design) => {
      model.set("design", design);
      model.save_changes();
    },
  });
}

export default { render };
