// Files: one of the reader's machine, one that another program wrote, and exports.

import { $, h, calm } from "./dom.js";
import { w } from "./words.js";
import { textOf } from "./wire.js";
import { eyeWords, sheetWords, upWords } from "./kinds.js";
import { LOOKS } from "./link.js";

const VERBS = { drawing: "draw", shaded: "render", pattern: "unfold", model: "convert" };

// A file of the reader's machine: the program keeps it, and opens it.
export async function upload(studio, file) {
  const { head } = await studio.wire.ask("upload", { name: file.name });
  const answer = await fetch("up/" + head.ticket, { method: "POST", body: file });
  if (!answer.ok) throw new Error(await answer.text());
  studio.uploads = [...new Set([...studio.uploads, file.name])].sort();
  await studio.opened(file.name, null, { upload: true, replay: false });
}

// The text of the file beside the text here; lines that only one has are marked.
export async function compare(studio, take) {
  const [there, here] = await Promise.all([studio.wire.ask("reload", { look: true }), studio.wire.ask("text")]);
  const texts = [there, here].map(({ body }) => textOf(body).split("\n"));
  const column = (word, i) => h("div", {}, h("h2", {}, w(word)), h("pre", { tabindex: 0 }, ...texts[i].map((line) =>
    h("span", { class: texts[1 - i].includes(line) ? "" : "other" }, line + "\n"))));
  const box = h("dialog", { class: "compare", onclose: () => box.remove() },
    h("div", { class: "both" }, column("in_file", 0), column("in_page", 1)),
    h("p", { class: "wishes" }, h("button", { class: "main", onclick: () => { box.close(); take(); } }, w("take")),
      h("button", { onclick: () => box.close() }, w("keep_mine"))));
  document.body.append(box);
  box.showModal();
}

const stem = (name) => name.replace(/\.[^.]*$/, "");

async function exportPage(studio) {
  const text = await studio.page();
  $("banner").hidden = true;
  const address = URL.createObjectURL(new Blob([text], { type: "text/html" }));
  h("a", { href: address, download: stem(studio.file) + ".html" }).click();
  calm(60000, () => URL.revokeObjectURL(address))();
}

// The options of a drawing of what a port shows.
function drawingWords(port) {
  const { kind, settings, studio } = port;
  if (kind === "sheet") return sheetWords(port);
  const cut = { section: ["--cutaway", `${settings.axis}=${port.at}`], apart: ["--explode", String(port.factor)] }[kind] || [];
  const looks = { ...(cut[0] && { hidden: "removed" }), ...studio.looks, ...(kind === "section" && { projection: "" }) };
  const words = [...cut, ...Object.keys(LOOKS).flatMap((key) => (looks[key] ? ["--" + key, looks[key]] : []))];
  if (port.turns) return [...eyeWords(port), ...words];
  return port.slow ? words : ["--view", kind, ...words];
}

function shadedWords(port) {
  const { projection } = port.studio.looks;
  return [...eyeWords(port), "--shade", port.settings.shade || "lambert", ...(projection ? ["--projection", projection] : []),
    ...upWords(port.studio),
    ...(port.kind === "section" ? ["--section", `${port.settings.axis}=${port.at}`] : [])];
}

export async function exported(studio, what, format) {
  if (what === "page") {
    await exportPage(studio);
    return;
  }
  const port = studio.ports.focused();
  const options = what === "shaded" ? shadedWords(port) : what === "drawing" ? drawingWords(port) : [];
  const name = stem(studio.file) + (what === "pattern" ? "_flat." : ".") + format;
  const { head } = await studio.wire.ask("export", { argv: [VERBS[what], ...options], name });
  if (!head.ticket) throw Object.assign(new Error(name), { head });
  h("a", { href: "x/" + head.ticket, download: head.name }).click();
}

// Another program wrote the file: a change like any other, which undo takes back.
// If something was changed here too, whoever looks at the page chooses.
export async function written(studio) {
  const close = () => { $("banner").hidden = true; };
  const take = async () => {
    close();
    const done = await studio.change("reload");
    if (done) studio.banner("taken", null, 6000);
    else studio.saved = false;
    studio.state();
  };
  if (!studio.isText) studio.opened(studio.file);
  else if (studio.saved) await take();
  else {
    studio.banner("file_new", [["take", take], ["compare_texts", () => studio.files(() => compare(studio, take))], ["keep_mine", close]]
      .map(([word, onclick]) => h("button", { onclick }, w(word))));
  }
}

// What was changed here before another program wrote the file.
export async function recovered(studio, file) {
  await studio.opened(file, null, { replay: "journal" });
  studio.saved = false;
  if (studio.ready) await written(studio);
}
