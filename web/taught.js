// The picture that the teacher shows to all, in the first port.

import { say } from "./dom.js";
import { w } from "./words.js";

export function taught(studio, on) {
  const [port] = studio.ports.ports;
  if (on && port.kind === "taught") {
    port.refresh();
    return;
  }
  if (on === (port.kind === "taught")) return;
  const { activeElement } = document;
  if (on) studio.own = [port.kind, studio.ports.one];
  const [kind, one] = studio.own;
  port.turnTo(on ? "taught" : kind);
  studio.ports.only(on ? port : one);
  if (on) {
    studio.paneTo("ports");
    say(w("taught"));
  }
  activeElement?.focus();
}
