// Why what was pointed at is as it is.

import { h } from "./dom.js";
import { w, tongue } from "./words.js";
import { textOf } from "./wire.js";
import { upWords } from "./kinds.js";

// Text in which names of lines are buttons.
function linked(text, studio) {
  const parts = text.split(/\b(s\d+(?:[epvj]-?\d+)?|l\d+)\b/);
  return parts.map((part, i) => i % 2
    ? h("button", { class: "name", onclick: () => studio.chosen([part]) }, part) : part);
}

// An explanation of an item: a line that is too long goes on further in than it began.
async function explained(studio, item, options) {
  const { head, body } = await studio.wire.ask("explain", { item, lang: tongue(), options });
  const text = textOf(body.slice(0, head.stdout)).trimEnd();
  return !text ? h("p", { class: "quiet", "data-word": "nothing_why" }) : h("pre", {}, ...text.split("\n").map((line, i, lines) => {
    const one = h("span", { class: "step" }, ...linked(line + (i + 1 < lines.length ? "\n" : ""), studio));
    one.style.setProperty("--in", /^ */.exec(line)[0].length + 2);
    return one;
  }));
}

export const reason = async (studio, item, options) => [h("p", { class: "chip" }, h("strong", {}, item)),
  await explained(studio, item, options)];

export async function reasons(studio, { name, goal, explain, shows }, port, role) {
  const edge = /^s(\d+)e(\d+)$/.exec(name);
  const face = /^s\d+p/.test(name) && port?.kind === "section";
  // Of another picture than that which is whole, hidden/2 does not tell.
  if (["section", "apart"].includes(port?.kind)) explain = explain.map((item) => item.replace(/^hidden/, "edge"));
  const joint = { cut: "seam", fold_up: "fold", fold_down: "fold" }[role];
  if (edge && joint && port.kind === "unfold") explain = [`${joint}(${edge[1]}, ${edge[2]})`];
  const parts = [h("p", { class: "chip" }, h("strong", {}, name), " ",
    h("button", { class: "goal", onclick: () => studio.asking.set(goal) }, goal))];
  if (face) parts.push(h("p", {}, w("cut_face", port.said)));
  const { lines, projection } = studio.looks;
  const looks = [...(port && port.turns ? ["--view", port.angles.map((angle) => angle.toFixed(6)).join(",")]
    : port && !port.slow ? ["--view", port.kind] : []),
  ...(lines ? ["--lines", lines] : []), ...(projection ? ["--projection", projection] : []), ...upWords(studio)];
  for (const item of explain) parts.push(await explained(studio, item, looks));
  if (!explain.length && !face) parts.push(h("p", { class: "quiet", "data-word": "nothing_why" }));
  if (edge && studio.isText) {
    const wish = (keep) => () => studio.change("cut", { segment: Number(edge[1]), edge: Number(edge[2]), keep });
    parts.push(h("p", { class: "wishes" },
      h("button", { "data-word": "cut", onclick: wish(false) }),
      h("button", { "data-word": "join", onclick: wish(true) }),
      h("button", { "data-word": "either", onclick: wish(null) })));
  }
  if (shows.length) {
    parts.push(h("p", { class: "shows" }, h("span", { "data-word": "shows" }), " ",
      ...shows.slice(0, 24).flatMap((other) => linked(other, studio))));
  }
  return parts;
}
