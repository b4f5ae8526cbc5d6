// The flat strip to scale, as it is cut.
import { element, range } from "./drawing.js";

export function showFlat(svg, flat, said) {
  const all = (flat ?? []).flatMap((layer) => layer.loops.flat()), [width, height] = [svg.clientWidth, svg.clientHeight];
  if (!all.length || !width) {
    svg.replaceChildren();
    return;
  }
  const [x0, x1] = range(all.map((p) => p[0])), [y0, y1] = range(all.map((p) => p[1]));
  const px = parseFloat(getComputedStyle(svg).fontSize), below = 1.5 * px; // the scale bar and its text
  const scale = Math.min((width - px) / (x1 - x0), (height - px - below) / (y1 - y0)); // px per mm
  const top = (height - below - scale * (y1 - y0)) / 2, bar = 10 ** Math.floor(Math.log10((x1 - x0) / 2));
  svg.setAttribute("viewBox", [(x0 + x1 - width / scale) / 2, -y1 - top / scale, width / scale, height / scale].join(" "));
  const loops = flat.map(({ layer, loops: drawn }) => element("path", {
    class: layer.toLowerCase().replaceAll("_", "-"),
    d: drawn.map((loop) => `M${loop.map(([x, y]) => `${x},${-y}`).join("L")}`).join(""),
  }));
  const line = element("path", { class: "scale", d: `M${x0},${px / scale - y0}h${bar}` });
  const text = element("text", { x: x0 + bar + px / 2 / scale, y: 1.35 * px / scale - y0, "font-size": px / scale }, `${bar} mm`);
  svg.replaceChildren(element("title", {}, said), ...loops, line, text);
}
