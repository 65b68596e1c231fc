// Makes one file of the page: what it shows, all it may be asked, and itself.

import { w, tongue } from "./words.js";
import { strokesOf, nameIn } from "./picture.js";
import { shadedAs } from "./kinds.js";
import { PICTORIAL } from "./sight.js";
import { childrenOf } from "./tree.js";

const SIDES = ["front", "top", "right", "left", "back", "bottom"];
const MOST_NAMES = 1500;
// What the page fetches when it is wanted, of that what a file may want.
const LATE = ["commands", "editor", "find", "fold", "kept", "menus", "pens", "why"];
const LATER = new RegExp(`import\\("\\./(${LATE.join("|")})\\.js"\\)`, "g");

function base64(body) {
  let text = "";
  for (const octet of new Uint8Array(body)) text += String.fromCharCode(octet);
  return btoa(text);
}

const kept = ({ head, body }, more = {}) => ({ ...more, head, body: base64(body) });

// `told` hears how far it is, 0 to 1.
export async function recorded(studio, told) {
  // What another pane stopped is asked again.
  const wire = { ask: async (request, keys) => {
    for (let again = 0; ; again++) {
      try {
        return await studio.wire.ask(request, keys);
      } catch (error) {
        if (error.message !== "interrupted" || again > 9) throw error;
      }
    }
  } };
  const names = {}, reasons = {}, replies = {}, views = [], seen = new Set();
  // What is refused is refused in the file too.
  const asked = async (request, keys, part = (reply) => reply) => {
    try {
      return kept(part(await wire.ask(request, keys)));
    } catch (error) {
      if (!error.head || error.message === "interrupted") throw error;
      return undefined;
    }
  };
  const eyes = [PICTORIAL, ...SIDES];
  for (const phi of [35, 60, 85]) for (let theta = 0; theta < 360; theta += 20) eyes.push([theta, phi]);
  for (const [i, view] of eyes.entries()) {
    const reply = await wire.ask("view", { format: "strokes", ...studio.looks, view, size: [160, 120], margin: 8 });
    views.push(kept(reply, { view }));
    for (const stroke of strokesOf(reply).strokes) for (const edge of stroke.edges) seen.add(nameIn(stroke, edge));
    told(i / eyes.length * 0.3);
  }
  for (const request of ["tree", "text", "rules", "unfold", "fold"]) replies[request] = await asked(request);
  if (replies.tree) replies.tree.head.saved = true;
  const lang = tongue();
  const options = ["--sheet", "A3", "--language", lang];
  replies.sheet = await asked("sheet", { options });
  replies.pens = await asked("sheet", { options, pens: true });
  replies.shaded = await asked("shaded", { options: [...shadedAs(views[0], studio.looks, PICTORIAL, [0, 0, ...views[0].head.sheet]),
    "--size", "800x600", "--background", "none"] });
  replies.open = { head: { segments: studio.segments, replayed: 0, rev: 1 } };
  const asks = {}, { answered, questions } = studio.asking;
  for (const { goal } of questions) asks[goal] = await asked("ask", { goal, ...studio.seen() });
  if (answered) asks[answered.goal] = answered;
  const parts = replies.tree ? replies.tree.head.segments.map(({ segment }) => segment) : [];
  for (const part of parts) {
    const goal = childrenOf(part);
    asks[goal] = await asked("ask", { goal });
    for (const one of asks[goal]?.head.answers[0]?.[0] || []) if (!parts.includes(one)) parts.push(one);
  }
  const all = [...parts.map((part) => "s" + part), ...seen].slice(0, MOST_NAMES);
  for (let i = 0; i < all.length; i += 50) {
    const reply = await asked("select", { names: all.slice(i, i + 50), keep: false });
    for (const one of reply?.head.selected || []) names[one.name] = one;
  }
  const items = [...new Set(Object.values(names).flatMap(({ explain }) => explain))];
  for (const [i, item] of items.entries()) {
    reasons[item] = await asked("explain", { item, lang, options: ["--view", "iso"] },
      ({ head: { stdout }, body }) => ({ head: { stdout }, body: body.slice(0, stdout) }));
    told(0.3 + i / items.length * 0.7);
  }
  const words = JSON.parse(await textAt("words.json"));
  return { words, asked: answered?.goal, views, names, reasons, replies, asks,
    hello: { file: studio.file, models: [studio.file], owner: false, rev: 0 },
    refused: { words: { en: words.kept_only[0], ko: words.kept_only[1] } } };
}

// One script of the modules of the page: each a function that gives its exports.
async function bundled() {
  const done = new Set();
  let out = "const M = {};\n";
  const add = async (name) => {
    if (done.has(name)) return;
    done.add(name);
    const text = await textAt(name + ".js");
    const imports = /^import \{([^}]*)\} from "\.\/(\w+)\.js";$/gm;
    for (const [, , from] of text.matchAll(imports)) await add(from);
    const names = [...text.matchAll(/^export (?:async )?(?:const|class|function) ([\w$]+)/gm)].map(([, one]) => one);
    const body = text.replace(imports, "const {$1} = M.$2;").replace(LATER, "M.$1").replace(/^export /gm, "");
    out += `M.${name} = await (async () => {\n${body}\nreturn { ${names.join(", ")} };\n})();\n`;
  };
  for (const name of LATE) await add(name);
  await add("main");
  return `(async () => {\n"use strict";\n${out}})();`;
}

const digest = async (text) => {
  const octets = new TextEncoder().encode(text);
  return `'sha256-${base64(await crypto.subtle.digest("SHA-256", octets))}'`;
};

const textAt = async (name) => (await fetch(name)).text();

const plain = (text) => text.replace(/[<>&]/g, (letter) => `&#${letter.charCodeAt(0)};`);

// The text of the file: the page, with all that it fetches in it.
export async function keptPage(studio, told = () => {}) {
  studio.recording = true;
  let record;
  try {
    record = JSON.stringify(await recorded(studio, told)).replace(/</g, "\\u003c");
  } finally {
    studio.recording = false;
  }
  const [script, style, page] = await Promise.all([bundled(), textAt("studio.css"), textAt("index.html")]);
  const policy = `default-src 'none'; script-src ${await digest(script)}; style-src ${await digest(style)}; img-src blob:`;
  const put = (text, [at, part]) => text.replace(at, () => part);
  return [[/<(link|script) .*\n/g, ""], ["<html lang=\"en\"", `<html lang="${tongue()}"`], ["<body", '<body class="kept"'],
    [/<title>.*/, `<meta http-equiv="Content-Security-Policy" content="${policy}">
<title>${plain(studio.file)} · ${plain(w("title"))}</title>
<style>${style}</style>`],
    ["</body>", `<script type="application/json" id="record">${record}</script>
<script>${script}</script>
</body>`]].reduce(put, page);
}
