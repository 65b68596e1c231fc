// The way to the program: requests out, replies and events in.

import { w } from "./words.js";

const HELLO = 0;
const MOST = 1048000;            // octets of a request
const encoder = new TextEncoder();
const decoder = new TextDecoder();

// Who this page is in a class: known to it and the program alone.
function pupil() {
  let secret = localStorage.getItem("pupil");
  if (!secret) {
    secret = [...crypto.getRandomValues(new Uint8Array(16))].map((octet) => octet.toString(16).padStart(2, "0")).join("");
    localStorage.setItem("pupil", secret);
  }
  return secret;
}

export class Lost extends Error {}

// A longer one ends the connection.
function tooLong() {
  const said = w("too_long");
  return Object.assign(new Error("too_long"), { head: { error: { code: "too_long", words: { en: said, ko: said } } } });
}

export class Wire extends EventTarget {
  constructor(token) {
    super();
    this.token = token;
    this.page = crypto.getRandomValues(new Uint32Array(2)).join("");
    this.number = HELLO;
    this.extra = {};
    this.waiting = new Map();
    this.wait = 250;
    this.early = [];
    this.alive = setInterval(() => this.open && this.send({ do: "alive" }), 25000);
    this.connect();
  }

  // What came before there was somebody to hear it.
  begin() {
    const { early } = this;
    this.early = null;
    for (const told of early) told();
  }

  get open() {
    return this.socket && this.socket.readyState === WebSocket.OPEN;
  }

  connect() {
    const address = new URL("ws", location.href);       // also below a folder of a proxy
    address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
    address.hash = "";
    const socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.onopen = () => this.send({ id: HELLO, do: "hello", token: this.token, pupil: pupil() });
    const told = (hears) => (this.early ? this.early.push(hears) : hears());
    socket.onmessage = (event) => told(() => this.heard(event.data));
    socket.onclose = (event) => told(() => this.closed(event.code));
  }

  send(head) {
    this.socket.send(JSON.stringify(head));
  }

  closed(code) {
    for (const { reject } of this.waiting.values()) reject(new Lost("away"));
    this.waiting.clear();
    if (code === 1008) {
      this.dispatchEvent(new Event("refused"));
      return;
    }
    this.dispatchEvent(new Event("away"));
    setTimeout(() => this.connect(), this.wait);
    this.wait = Math.min(this.wait * 1.6, 5000);
  }

  heard(data) {
    const length = new DataView(data).getUint32(0);
    const head = JSON.parse(decoder.decode(new Uint8Array(data, 4, length)));
    const body = data.slice(4 + length);
    if (head.event) {
      this.dispatchEvent(new CustomEvent(head.event, { detail: head }));
    } else if (head.id === HELLO) {
      this.wait = 250;
      this.dispatchEvent(new CustomEvent("hello", { detail: head }));
    } else if (head.progress) {
      Object.assign(this.waiting.get(head.id) || {}, head.progress);
    } else {
      const asked = this.waiting.get(head.id);
      this.waiting.delete(head.id);
      if (!asked) return;
      if (head.rev !== undefined) {
        this.dispatchEvent(new CustomEvent("rev", { detail: head.rev }));
      }
      if (head.error) asked.reject(Object.assign(new Error(asked.stopped ? "stopped" : head.error.code), { head }));
      else asked.resolve({ head, body });
    }
  }

  // Resolves to { head, body }; rejects with Lost, or an Error that has the head.
  ask(request, keys = {}) {
    if (!this.open) return Promise.reject(new Lost("away"));
    if (this.slow && this.waiting.has(this.slow)) this.send({ do: "stop", of: this.slow });
    const id = this.number + 1;
    this.slow = ["unfold", "fold", "sheet"].includes(request) ? id : 0;
    // The ports of another window are others, though they are called the same.
    const port = keys.port && { port: `${this.page} ${keys.port}` };
    const text = JSON.stringify({ ...this.extra, ...keys, ...port, id, do: request, progress: request !== "view" });
    if (text.length > MOST / 3 && encoder.encode(text).length > MOST) return Promise.reject(tooLong());
    this.number = id;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, since: Date.now() });
      this.socket.send(text);
    });
  }

  // Whoever looks at the page does not want to wait any longer.
  stop() {
    for (const asked of this.waiting.values()) asked.stopped = true;
    this.send({ do: "stop" });
  }
}

export const textOf = (body) => decoder.decode(body);
