// Pointer, wheel and keys.
const setCurrent = (plot) => {
  current = plot;
  for (const one of plots) one.element.classList.toggle("current", one === plot);
};
const listen = (plot) => {
  const { view } = plot;
  const pointers = new Map();
  // Of a press that may still be a click.
  let start = null;
  // Of a box.
  let corner = null;
  // Asking for the box makes the browser lay out the page: not at each move.
  let box = null;
  const forget = () => { box = null; };
  window.addEventListener("scroll", forget, { passive: true, capture: true });
  window.addEventListener("resize", forget);
  view.addEventListener("pointerenter", forget);
  const place = (event) => {
    if (event.type !== "pointermove" || !box) box = view.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const showBox = (to) => {
    const left = Math.min(corner.x, to.x);
    const top = Math.min(corner.y, to.y);
    const attributes = { x: left, y: top, width: Math.abs(to.x - corner.x),
                         height: Math.abs(to.y - corner.y), visibility: "visible" };
    for (const name in attributes) plot.band.setAttribute(name, attributes[name]);
  };
  const hideBox = () => {
    corner = null;
    plot.band.setAttribute("visibility", "hidden");
  };
  view.addEventListener("focus", () => setCurrent(plot));
  view.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    const at = place(event);
    view.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at);
    setCurrent(plot);
    start = pointers.size === 1 ? at : null;
    if (pointers.size > 1) hideBox();
    else if (state.box || event.shiftKey) corner = at;
  });
  view.addEventListener("pointermove", (event) => {
    const at = place(event);
    const before = pointers.get(event.pointerId);
    const [xName, yName] = [plot.x, plot.y];
    const decimals = (name, size) =>
      clamp(Math.ceil(-Math.log10((ranges[name].now[1] - ranges[name].now[0]) / size)), 0, 9);
    plot.cursor.textContent = isInside(plot, at.x, at.y)
      ? `${fixed(plot.atX(at.x), decimals(xName, plot.width))}, ` +
        `${fixed(plot.atY(at.y), decimals(yName, plot.height))}` : "";
    if (!before) return;
    if (start && Math.hypot(at.x - start.x, at.y - start.y) < 5) return;
    start = null;
    if (pointers.size === 2) {
      const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
      const length = (p) => Math.max(20, Math.hypot(p.x - other.x, p.y - other.y));
      pan(plot, (before.x - at.x) / 2 / plot.width, (at.y - before.y) / 2 / plot.height);
      zoom(plot, length(before) / length(at),
           clamp(((at.x + other.x) / 2 - margin.left) / plot.width, 0, 1),
           clamp(1 - ((at.y + other.y) / 2 - margin.top) / plot.height, 0, 1));
    } else if (corner) {
      showBox(at);
    } else {
      pan(plot, (before.x - at.x) / plot.width, (at.y - before.y) / plot.height);
    }
    pointers.set(event.pointerId, at);
  });
  view.addEventListener("dblclick", (event) => {
    event.preventDefault();
    resetPlot(plot);
  });
  view.addEventListener("pointerleave", () => { plot.cursor.textContent = ""; });
  view.addEventListener("pointerup", (event) => {
    const at = place(event);
    pointers.delete(event.pointerId);
    if (start) {
      readAt(plot, at.x, at.y);
    } else if (corner && Math.abs(at.x - corner.x) > 4 && Math.abs(at.y - corner.y) > 4) {
      const xs = [plot.atX(corner.x), plot.atX(at.x)].sort((a, b) => a - b);
      const ys = [plot.atY(corner.y), plot.atY(at.y)].sort((a, b) => a - b);
      setRange(plot.x, ...xs);
      setRange(plot.y, ...ys);
    }
    start = null;
    hideBox();
  });
  view.addEventListener("pointercancel", (event) => {
    pointers.delete(event.pointerId);
    start = null;
    hideBox();
  });
  // The wheel scrolls the page until the plot has the focus.
  view.addEventListener("wheel", (event) => {
    if (document.activeElement !== view && !event.ctrlKey) return;
    event.preventDefault();
    const at = place(event);
    const lines = event.deltaMode ? 16 : 1;
    zoom(plot, Math.exp(clamp(event.deltaY * lines, -200, 200) * 0.0016),
         clamp((at.x - margin.left) / plot.width, 0, 1),
         clamp(1 - (at.y - margin.top) / plot.height, 0, 1));
  }, { passive: false });
  const keys = {
    ArrowLeft: () => pan(plot, -0.1, 0), ArrowRight: () => pan(plot, 0.1, 0),
    ArrowUp: () => pan(plot, 0, 0.1), ArrowDown: () => pan(plot, 0, -0.1),
    "+": () => zoom(plot, 0.8), "=": () => zoom(plot, 0.8), "-": () => zoom(plot, 1.25),
    0: resetRanges, PageDown: () => step(plot, 1), PageUp: () => step(plot, -1),
    Escape: () => { start = null; hideBox(); }, m: () => choose("midline", true),
  };
  if (plot.isLoop) keys.x = toggleMark;
  for (const name of "ABCDEF") keys[name.toLowerCase()] = () => choose(name, true);
  view.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = keys[event.key] || keys[event.key.toLowerCase()];
    if (!act) return;
    event.preventDefault();
    act();
  });
};
// Home leads back from everywhere but where it has a meaning of its own.
root.addEventListener("keydown", (event) => {
  if (event.key !== "Home" || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
  if (event.target.matches("input[type=range], select")) return;
  event.preventDefault();
  resetRanges();
});
