// The studio: one document, its panes, and what they tell each other.

import { $, h, arrows, calm, say } from "./dom.js";
import { w, wordsLoaded, reworded, said } from "./words.js";
import { Wire, Lost } from "./wire.js";
import { Ports } from "./ports.js";
import { Link } from "./link.js";
import { Bar } from "./bar.js";
import { Tree, childrenOf } from "./tree.js";
import { Asking, Why } from "./panels.js";

class Studio {
  constructor(link, wire) {
    this.link = link;
    this.wire = wire;
    this.record = wire.record;
    this.looks = link.looks();
    this.segments = [];
    this.names = [];
    this.models = [];
    this.uploads = [];
    this.rev = 0;
    this.saved = true;
    this.warning = "";
    this.waiting = [];
    this.tree = new Tree(this);
    this.asking = new Asking(this);
    this.why = new Why(this);
    this.ports = new Ports(this, $("ports"));
    this.left();
    $("asking").append(this.asking.element, this.why.element);
    this.bar = new Bar(this);
    reworded(document);
    document.addEventListener("reworded", () => this.reworded());
    document.addEventListener("keydown", (event) => this.keyed(event));
    const which = new URLSearchParams(location.search).get("half");
    if (which) this.half(which);
    this.wire.addEventListener("hello", async (event) => {
      await this.greeted(event.detail);
      this.here = true;
      for (const done of this.waiting.splice(0)) done();
    });
    this.wire.addEventListener("away", this.away);
    this.wire.addEventListener("refused", () => this.banner("no_secret"));
    this.wire.addEventListener("restarted", () => this.opened(this.file, "restarted"));
    this.wire.addEventListener("revision", ({ detail }) => this.heard(detail));
    this.wire.addEventListener("file", () => this.files((files) => files.written(this)));
    this.wire.addEventListener("shown", (event) => this.taught(event.detail.shown));
    this.wire.addEventListener("saved", async () => {
      await this.tree.refresh();
      this.state();
    });
    this.wire.addEventListener("class", () => this.problems?.changed());
    this.wire.addEventListener("rev", (event) => { this.rev = event.detail; });
    this.wire.begin();
  }

  // --- what stands where ---

  left() {
    const panes = {};
    const tabs = h("div", { role: "tablist", class: "tabs", onkeydown: (event) => arrows(tabs, event) });
    this.leftTo = async (name) => {
      this.pane = name;
      try {
        if (!panes[name]) await this.editors();
        if (this.pane !== name) return;
        for (const tab of tabs.children) {
          const { word } = tab.dataset;
          tab.setAttribute("aria-selected", String(word === name));
          if (panes[word]) panes[word].element.hidden = word !== name;
        }
        if (this.ready && this[name]?.field) await this[name].refresh();
      } catch (error) {
        this.failed(error);
      }
    };
    this.tabbed = (key, pane) => {
      panes[key] = pane;
      pane.element.setAttribute("role", "tabpanel");
      pane.element.hidden = this.pane !== key;
      $("left").append(pane.element);
    };
    this.tab = (key) => tabs.append(h("button", { role: "tab", "data-word": key, onclick: () => this.leftTo(key) }));
    $("left").append(tabs);
    for (const key of ["tree", "text", "rules"]) this.tab(key);
    this.tabbed("tree", this.tree);
    this.leftTo("tree");
    for (const [pane, word] of [["ports", "ports"], ["left", "tree"], ["asking", "ask_why"]]) {
      $("panes").append(h("button", { role: "tab", "data-word": word, onclick: () => this.paneTo(pane) }));
      $("panes").lastChild.dataset.to = pane;
    }
    this.paneTo("ports");
  }

  // Those of the text and the rules come when one is chosen.
  async editors() {
    const { Text, Rules } = await import("./editor.js");
    if (this.text) return;
    this.text = new Text(this);
    this.rules = new Rules(this);
    for (const key of ["text", "rules"]) this.tabbed(key, this[key]);
    reworded($("left"));
  }

  // On a phone one pane is shown at a time.
  paneTo(pane) {
    document.body.dataset.pane = pane;
    if (pane === "asking") this.news();
    for (const tab of $("panes").children) tab.setAttribute("aria-selected", String(tab.dataset.to === pane));
  }

  upload(file) {
    return this.files((files) => files.upload(this, file));
  }

  // Dots that pull the sizes of a segment come when one is chosen.
  async pulls(segment) {
    this.lit();
    if (this.record || (segment === undefined && !this.handles)) return;
    const { Handles } = await import("./handles.js");
    this.handles ??= new Handles(this);
    await this.handles.choose(segment);
  }

  export(what, format) {
    return this.files((files) => files.exported(this, what, format));
  }

  // What is done with files comes when it is wanted.
  async files(act) {
    try {
      await act(await import("./files.js"));
    } catch (error) {
      this.failed(error);
    }
  }

  // The picture that questions are about: that of the first port which has one.
  pictured() {
    return this.ports.ports.find(({ kind, slow }) => !slow && !["section", "shaded", "apart"].includes(kind));
  }

  seen() {
    const port = this.pictured();
    return { ...this.looks, view: port ? (port.turns ? port.angles : port.kind) : "isometric" };
  }

  looked() {
    localStorage.setItem("looks", JSON.stringify(this.looks));
    this.ports.refresh();
    this.again();
    this.linked();
  }

  keep() {
    this.ports.kept();
    this.again();
    this.linked();
  }

  linked() {
    this.link.follow(this);
  }

  reworded() {
    this.tree.draw();
    this.asking.list(this.asking.questions);
    this.ports.refresh();
    this.problems?.reworded();
    if (this.ready && this.pane === "rules") this.leftTo("rules");
    this.state();
    this.why.again();
  }

  // --- the document ---

  get isText() {
    return !this.record && /\.pl$/i.test(this.file);
  }

  async greeted(head) {
    this.models = head.models;
    this.uploads = head.uploads || [];
    this.owner = head.owner;
    $("banner").hidden = true;
    clearTimeout(this.awayTimer);
    this.awayTimer = null;
    this.gone = false;
    const file = this.file || head.file;
    if (head.class) await this.inClass(head.class);
    this.teaches = head.shows === "all";
    if (this.teaches) for (const port of this.ports.ports) port.tooled();
    this.taught(head.shows === "seen");
    if (head.rev && this.file === file && this.ready) await this.revised(head);
    else if (file) await this.opened(file);
    else if (!head.class) this.banner("open", (await this.bar.menus()).openers());
  }

  async inClass(told) {
    (await import("./problems.js")).joined(this, told);
  }

  // The teacher shows a picture to all, or does no more.
  async taught(on) {
    if (!on && this.ports.ports[0].kind !== "taught") return;
    const { taught } = await import("./taught.js");
    taught(this, on);
  }

  // Told once, however often the page tries meanwhile.
  away = () => {
    this.here = false;
    this.awayTimer ??= setTimeout(() => {
      this.gone = true;
      this.banner("away");
      this.state();
    }, 800);
  };

  async opened(file, remark, keys = {}) {
    if (!file) return;
    const before = this.ready && this.file, { sent } = this;
    keys = { ...keys, ...(file === this.file && sent ? { upload: true } : {}) };
    this.sent = Boolean(keys.upload);
    const another = file !== this.file;
    if (another) for (const port of this.ports.ports) if (!port.alone) port.emptied();
    this.file = file;
    document.body.classList.remove("bare");
    this.ports.fitted();
    this.titled();
    try {
      const { head } = await this.wire.ask("open", { file, ...keys });
      if (another) this.forget();
      this.segments = head.segments;
      this.tree.sets = this.tree.sets.filter(({ rev }) => rev === undefined);
      this.ready = true;
      $("banner").hidden = true;
      if (remark) this.banner(remark, null, 4000);
      else if (head.replayed) this.banner("replayed", null, 6000, head.replayed);
      await this.revised(head);
      if (this.text?.dirty) this.text.done();
      const names = this.link.taken("chosen");
      if (names) await this.chosen(names.split(","));
      this.begun?.();
      if (this.record?.asked) {
        this.asking.box.value = this.record.asked;
        this.asking.ask();
      }
    } catch (error) {
      if (error.head && before && this.file === file) {         // that one is open still
        Object.assign(this, { file: before, sent });
        this.titled();
        this.ports.refresh();
      }
      this.failed(error, error.head && error.head.error.code === "request_error.journal_of_another"
        ? [["recover", () => this.files((files) => files.recovered(this, file))], ["forget", () => this.opened(file, null, { replay: false })]] : []);
    }
  }

  titled() {
    $("file").textContent = this.file;
    document.title = `${this.file} · ${w("title")}`;
  }

  // What was chosen, asked and explained is of the model that was open.
  forget() {
    this.names = [];
    this.operand = null;
    this.from = null;
    this.asking.clear();
    this.why.clear();
    this.tree.forget();
    this.tried();
    for (const layer of ["chosen", "hover"]) this.light(layer, []);
  }

  // What the rules that are tried made of the lines.
  tried({ came = [], changed = [], went = [] } = {}) {
    this.light("came", came);
    this.light("changed", changed);
    this.ports.ghost(went);
    this.other?.postMessage({ went });
    if (came.length + changed.length + went.length) this.light("chosen", []);    // what is chosen is red too
  }

  // Another window has another revision, or another file.
  heard(head) {
    const { file } = head;
    if (!file || file === this.file) return this.revised(head);
    return this.opened(file, null, this.models.includes(file) ? {} : { upload: true });
  }

  // Every pane shows the new revision.
  async revised(head) {
    this.rev = head.rev;
    if (this.fault) $("banner").hidden = true;
    this.warned(head.messages);
    $("ports").dataset.rev = head.rev;
    this.ports.refresh();
    this.again();
    this.state();
    try {
      await this.tree.refresh();
      if (this.pane === "text") await this.text?.refresh();
      if (this.pane === "rules") await this.rules?.refresh();
    } catch (error) {
      this.failed(error);
    }
    this.state();
  }

  // What was asked and explained is so of the model, and the picture, of now.
  again = calm(400, () => {
    if (this.record) return;
    this.asking.again();
    this.why.again();
  });

  edited(head) {
    this.saved = false;       // or as it was before: the tree says it
    this.tried();
    return this.revised(head);
  }

  state() {
    this.bar.state();
  }

  // One change after the other; those that were not sent wait for the program.
  inLine(change) {
    this.line = (this.line || Promise.resolve()).then(() => this.there()).then(change);
    return this.line;
  }

  // A socket that is being closed is not open, and nobody was told of it yet.
  async there() {
    while (!this.here || !this.wire.open) await new Promise((done) => { this.waiting.push(done); });
  }

  // What was made and not shown yet.
  async shown() {
    const { made } = this;
    this.made = null;
    if (made) await this.edited(made);
  }

  // The panes show what the last of several made. Resolves to whether it is done.
  change(request, keys) {
    this.queued = (this.queued || 0) + 1;
    return this.inLine(async () => {
      this.queued -= 1;
      this.tree.done = null;
      try {
        const { head } = await this.wire.ask(request, keys);
        this.segments = head.segments;
        if (this.text) this.text.dirty = false;
        this.made = head;
        if (!this.queued) await this.shown();
        return true;
      } catch (error) {
        if (!this.queued) {
          await this.shown();
          this.failed(error);
        }
        return false;
      }
    });
  }

  async save(keys = {}) {
    try {
      await this.wire.ask("save", keys);
      this.saved = true;
      this.state();
      say(w("saved"));
    } catch (error) {
      this.failed(error, error.head && error.head.error.code === "request_error.file_changed"
        ? [["force", () => this.save({ force: true })]] : []);
    }
  }

  // The page as one file, which needs no program.
  async page() {
    const { keptPage } = await import("./keep.js");
    return keptPage(this, (part) => this.banner("keeping", null, 0, Math.round(part * 100)));
  }

  // --- what is pointed at ---

  // A port shows itself what is under the pointer there.
  hovered(port, names) {
    this.hover = names;
    this.light("hover", names, {}, port);
    this.hoveredAll(port, names);
  }

  hoveredAll = calm(60, (port, names) => {
    if (names === this.hover && names.length) this.lightAll("hover", names, port).catch(() => {});
  });

  light(layer, names, ends, but) {
    this.ports.light(layer, names, ends, but);
    this.other?.postMessage({ layer, names: [...names], ends });
  }

  // The two monitors as two windows: one of them is a new window.
  halved(which) {
    window.open(`?half=${which}#${this.wire.token}`, "_blank", "popup,width=1200,height=900");
    this.half(which === "ports" ? "left" : "ports");
  }

  async half(which) {
    document.body.dataset.half = which;
    const { half } = await import("./half.js");
    half(this, which);
  }

  // The facts of the title block are of the text.
  async titleBlock() {
    this.paneTo("left");
    await this.leftTo("text");
    this.text.within(/^\s*title_block\(\w+, *"([^"]*)/m, `title_block(name, "${this.file.replace(/\.\w+$|["\\]/g, "")}").\n`);
  }

  // Also names that have no line of their own: polygons, vertices, joints,
  // penetration lines are lit by the edges that show them, and edges that are not
  // drawn where they are.
  async lightAll(layer, names, but) {
    const edges = names.filter((name) => /^s\d+e\d+$/.test(name));
    const others = names.filter((name) => !/^s\d+(e-?\d+)?$/.test(name));
    this.light(layer, names, {}, but);
    const asked = (this.ports.draws(edges) ? others : [...others, ...edges]).slice(0, 1000);
    if (!asked.length) return;
    const { head } = await this.wire.ask("select", { names: asked, keep: false });
    if (layer === "hover" && names !== this.hover) return;
    const more = head.selected.flatMap(({ name, shows }) => (others.includes(name) ? shows.filter((one) => /^s\d+e/.test(one)) : []));
    this.light(layer, [...names, ...more], head.ends, but);
  }

  // `path`: of an operand that has no number in the text, which operand it is of
  // which one of the segment.
  lightSegment(segment, path = []) {
    this.operand = { segment, path };
    this.light("chosen", ["s" + segment]);
    this.other?.postMessage({ segment });
  }

  // The operand that was chosen is not drawn itself: what it made is lit.
  async lit() {
    const { operand } = this;
    if (!operand) return;
    let { segment } = operand;
    try {
      for (const i of operand.path) {
        const { head } = await this.wire.ask("ask", { goal: childrenOf(segment) });
        segment = head.answers[0][0][i];
      }
      const names = ["s" + segment];
      const { head } = await this.wire.ask("select", { names, keep: false });
      if (this.operand === operand) this.light("chosen", [...names, ...head.selected[0].shows]);
    } catch (error) {
      this.operand = null;                // it is not there any more, or nobody answers
    }
  }

  // `role` is that of the line in `port`, where it was chosen.
  chosen(names, port, role) {
    this.names = names;
    this.operand = null;
    this.from = port || this.from || this.pictured();
    this.light("chosen", names);
    this.linked();
    this.toldFrom(role);
    this.news(names[0]);
    return this.why.show(names, this.from, role);
  }

  // What the other window says of what was chosen here: with the picture it is in.
  toldFrom(role) {
    const { kind, angles, turns, slow, said } = this.from || {};
    this.other?.postMessage({ chosen: this.names, from: this.from && { kind, angles, turns, slow, said }, role });
  }

  // On a phone the reason is in another pane: its tab says of what.
  news(name) {
    const tab = $("panes").querySelector("[data-to=asking]");
    if (name && document.body.dataset.pane !== "asking") tab.dataset.news = name;
    else delete tab.dataset.news;
  }

  async askAbout(name) {
    const { head } = await this.wire.ask("select", { names: [name] });
    this.paneTo("asking");
    this.asking.set(head.selected[0].goal);
    this.other?.postMessage({ goal: head.selected[0].goal });
  }

  // --- what is said ---

  wrong(error) {
    if (error instanceof Lost) return w("away");
    return error.head ? said(error.head.error) : String(error);
  }

  failed(error, ways = []) {
    if (error instanceof Lost) return;
    const passing = error.message === "request_error.nothing_to";
    this.tell(this.wrong(error), passing ? null : ways.map(([word, act]) => h("button", { onclick: act }, w(word))),
      passing ? 4000 : 0);
    this.fault = true;
  }

  // What is not as it should be, though there is a model: once.
  warned(messages = []) {
    const text = messages.filter(({ kind }) => kind === "warning").map(said).join("\n");
    if (text === this.warning) return;
    this.warning = text;
    this.tell(text, []);
    $("banner").hidden = !text;
  }

  banner(word, more = null, milliseconds = 0, ...given) {
    this.tell(w(word, ...given), more, milliseconds);
  }

  // With `ways`, elements, it stays until it is closed.
  tell(text, ways, milliseconds = 0) {
    const close = () => { $("banner").hidden = true; };
    this.fault = false;
    $("banner").replaceChildren(h("span", {}, text), ...(ways ? [...ways, h("button", { onclick: close }, w("close"))] : []));
    $("banner").hidden = false;
    if (milliseconds) calm(milliseconds, close)();
  }

  // The table of keys comes with the first of them.
  async keyed(event) {
    const { key, ctrlKey, metaKey, target } = event;
    const ours = ctrlKey || metaKey ? /^[ks]$/i.test(key) : key === "F6" || (key === "/" && !/^(input|textarea|select)$/i.test(target.tagName));
    if (!this.table && ours) event.preventDefault();       // later it is too late
    this.table ??= await import("./commands.js");
    this.table.keyed(this, event);
  }

  // Ctrl-K, or the help.
  async find(what = "find") {
    const found = await import("./find.js");
    if (!document.querySelector("dialog[open]")) found[what](this);
  }
}

// The program hears of the page before the words are there.
const link = new Link();
const recorded = document.getElementById("record");             // if this page is a file
const record = recorded && JSON.parse(recorded.textContent);
const wire = record ? new (await import("./kept.js")).Kept(record) : new Wire(link.secret);
await wordsLoaded(record);
window.studio = new Studio(link, wire);
