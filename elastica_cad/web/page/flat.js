// The flat strip to scale, as it is cut.
import { element, range } from "./drawing.js";

const EDGE = 0.03; // about the strip, in its length

export function showFlat(svg, flat, said) {
  const all = (flat ?? []).flatMap((layer) => layer.loops.flat());
  if (!all.length) {
    svg.replaceChildren();
    return;
  }
  const [x0, x1] = range(all.map((p) => p[0])), [y0, y1] = range(all.map((p) => p[1]));
  const edge = EDGE * (x1 - x0), bar = 10 ** Math.floor(Math.log10((x1 - x0) / 2));
  svg.setAttribute("viewBox", [x0 - edge, -y1 - edge, x1 - x0 + 2 * edge, y1 - y0 + 3 * edge].join(" "));
  const loops = flat.map(({ layer, loops: drawn }) => element("path", {
    class: layer.toLowerCase().replaceAll("_", "-"),
    d: drawn.map((loop) => `M${loop.map(([x, y]) => `${x},${-y}`).join("L")}`).join(""),
  }));
  const below = -y0 + edge;
  const scale = element("path", { class: "scale", d: `M${x0},${below}h${bar}` });
  const text = element("text", { x: x0 + bar + edge / 2, y: below + edge / 3, "font-size": edge * 0.5 }, `${bar} mm`);
  svg.replaceChildren(element("title", {}, said), ...loops, scale, text);
}
