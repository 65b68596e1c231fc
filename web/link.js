// The address of the page: behind the # the secret, if it has that, and what is seen.

import { calm } from "./dom.js";
import { w } from "./words.js";

export const LOOKS = {
  projection: ["parallel", "central"],
  hidden: ["dashed", "removed", "shown"],
  lines: ["feature", "all", "penetration"],
  up: ["z", "y", "x"],
};

// What a value of these is called: an axis as it is.
export const lookCalled = (value) => (value.length > 1 ? w(value) : value);

export class Link {
  constructor() {
    const parts = location.hash.slice(1).split("&");
    this.given = parts.find((part) => !part.includes("="));
    this.words = new URLSearchParams(parts.filter((part) => part.includes("=")).join("&"));
    this.secret = this.given || sessionStorage.getItem("secret") || "";
    if (this.secret) sessionStorage.setItem("secret", this.secret);
    window.addEventListener("hashchange", () => location.reload());
  }

  // What it says of a key.
  get(key) {
    return this.words.get(key);
  }

  // The same, once.
  taken(key) {
    const value = this.get(key);
    this.words.delete(key);
    return value;
  }

  // How lines are drawn: as the address says, or as the reader had it before.
  looks() {
    const looks = JSON.parse(localStorage.getItem("looks") || "{}");
    for (const [key, values] of Object.entries(LOOKS)) {
      if (values.includes(this.get(key))) looks[key] = this.get(key);
    }
    return looks;
  }

  // It says what `studio` shows.
  follow = calm(300, (studio) => {
    const looks = Object.keys(LOOKS).map((key) => [key, studio.looks[key]]);
    const seen = [["ports", studio.ports.ports.map((port) => port.link()).join(";")], ...looks, ["chosen", studio.names.join(",")]];
    const words = seen.filter(([, value]) => value).map(([key, value]) => `${key}=${value}`);
    history.replaceState(null, "", "#" + [this.given, ...words].filter(Boolean).join("&"));
  });
}
