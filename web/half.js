// The two monitors as two windows, which tell each other what is pointed at.

import { tongue, otherTongue } from "./words.js";
import { commands, fullName } from "./commands.js";

export function half(studio, which) {
  document.body.dataset.half = which;
  studio.paneTo(which);
  if (studio.other) return;
  studio.other = new BroadcastChannel("studio");
  const tell = (told) => studio.other.postMessage(told);
  document.addEventListener("reworded", () => tell({ language: tongue() }));
  // Of the two the window that was opened for a half says when it is there.
  if (new URLSearchParams(location.search).has("half")) {
    studio.begun = () => tell({ begun: which });
    window.addEventListener("pagehide", () => tell({ ended: true }));
    if (studio.ready) studio.begun();
  }
  studio.other.onmessage = ({ data: { layer, names, ends, chosen, from, role, segment, went, goal, run, language, begun, ended } }) => {
    const ports = document.body.dataset.half === "ports";
    if (layer) studio.ports.light(layer, names, ends);
    else if (went) studio.ports.ghost(went);
    else if (segment !== undefined) studio.pulls(studio.tree.segment = segment);
    else if (run) commands(studio).find((row) => !row.off && fullName(row) === run)?.act();
    else if (language && language !== tongue()) otherTongue();
    else if (begun) {
      half(studio, begun === "ports" ? "left" : "ports");
      studio.light("chosen", studio.names);
      studio.toldFrom();
      studio.lightAll("lit", studio.asking.shows || []).catch(() => {});
    } else if (ended) {
      delete document.body.dataset.half;
      studio.paneTo("ports");
    } else if (!ports && goal) studio.asking.set(goal);
    else if (chosen && document.body.dataset.half === "left") {
      studio.names = chosen;
      studio.news(chosen[0]);
      studio.why.show(chosen, from, role);
    }
  };
}
