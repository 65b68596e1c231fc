// The two monitors as two windows, which tell each other what is pointed at.

export function half(studio, which) {
  const ports = which === "ports";
  document.body.dataset.half = which;
  studio.paneTo(which);
  if (studio.other) return;
  studio.other = new BroadcastChannel("studio");
  if (ports) {
    window.addEventListener("pagehide", () => studio.other.postMessage({ ended: true }));
    if (studio.ready) studio.other.postMessage({ begun: true });
  }
  studio.other.onmessage = ({ data: { layer, names, ends, chosen, begun, ended } }) => {
    if (layer) studio.ports.light(layer, names, ends);
    else if (ports) return;
    else if (begun) {
      half(studio, "left");
      studio.light("chosen", studio.names);
      studio.lightAll("lit", studio.asking.shows || []).catch(() => {});
    } else if (ended) {
      delete document.body.dataset.half;
      studio.paneTo("ports");
    } else if (document.body.dataset.half === "left") {
      studio.names = chosen;
      studio.news(chosen[0]);
      studio.why.show(chosen, studio.from);
    }
  };
}
