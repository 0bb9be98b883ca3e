// One plot: canvas for curves, SVG for what is sharp, moves or is written.
const margin = { left: 62, right: 16, top: 8, bottom: 22 };
const axisTitle = (name) => {
  const { words, symbol, unit } = quantities[name];
  return `${words} ${symbol}${symbol && " "}[${unit}]`;
};

const addPlot = (x, y, isLoop, paint) => {
  const view = make("div", {
    class: "view", tabindex: "0", role: "application", "aria-describedby": "review-help",
    "aria-label": t("{0} over {1}", quantities[y].words, quantities[x].words),
  });
  const canvas = make("canvas", { "aria-hidden": "true" });
  const svg = draw("svg", { "aria-hidden": "true", focusable: "false" });
  const ticks = draw("g", { class: "ticks" });
  const marks = draw("g", {});
  const band = draw("rect", { class: "band", visibility: "hidden" });
  svg.append(ticks, marks, band);
  view.append(canvas, svg);
  const cursor = make("span", { class: "cursor" });
  const lost = make("div", { class: "lost", hidden: "" }, make("span", {}, t("No data in sight.")),
    button(t("Show all"), () => {
      resetRanges();
      view.focus({ preventScroll: true });
    }), make("span", {}, t("or press Home")));
  const element = make("div", { class: "plot", "data-plot": `${y}-${x}` },
    make("p", { class: "axis-title" }, axisTitle(y)), make("div", { class: "frame" }, view, lost),
    make("p", { class: "foot" }, cursor, make("span", { class: "axis-title" }, axisTitle(x))));
  const plot = { x, y, isLoop, paint, view, canvas, svg, ticks, marks, band, cursor, lost, element,
                 width: 0, height: 0, dirty: true, hasData: false, isInSight: false };
  plot.px = (value) => {
    const [low, high] = ranges[x].now;
    return margin.left + (value - low) / (high - low) * plot.width;
  };
  plot.py = (value) => {
    const [low, high] = ranges[y].now;
    return margin.top + (high - value) / (high - low) * plot.height;
  };
  plot.atX = (px) => {
    const [low, high] = ranges[x].now;
    return low + (px - margin.left) / plot.width * (high - low);
  };
  plot.atY = (py) => {
    const [low, high] = ranges[y].now;
    return high - (py - margin.top) / plot.height * (high - low);
  };
  plots.push(plot);
  listen(plot);
  // Asking for the size while drawing would make the browser lay out the page each time.
  new ResizeObserver(([{ contentRect }]) => {
    plot.box = contentRect;
    plot.dirty = true;
    requestFrame();
  }).observe(view);
  return element;
};

const tickStep = (span, most) => {
  const rough = span / Math.max(most, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((step) => step * power >= rough * 0.999);
};
const tickValues = ([low, high], most) => {
  const step = tickStep(high - low, most);
  const out = [];
  for (let k = Math.ceil(low / step); k * step <= high; ++k) out.push(k * step);
  return { values: out, share: step / (high - low),
           decimals: clamp(-Math.floor(Math.log10(step) + 1e-9), 0, 9) };
};
const longest = ({ values, decimals }) =>
  Math.max(0, ...values.map((value) => fixed(value, decimals).length));

const setIfOther = (element, name, value) => {
  const text = String(value);
  if (element.getAttribute(name) !== text) element.setAttribute(name, text);
};
const paintAxes = (plot, pen) => {
  // Elements that are there are used again: new ones cost more than all the rest.
  let used = 0;
  const right = margin.left + plot.width;
  const bottom = margin.top + plot.height;
  const tick = (text, x, y, anchor) => {
    const label = plot.ticks.children[used] || plot.ticks.appendChild(draw("text", {}));
    ++used;
    setIfOther(label, "x", x);
    setIfOther(label, "y", y);
    setIfOther(label, "text-anchor", anchor);
    if (label.textContent !== text) label.textContent = text;
  };
  pen.lineWidth = 1;
  // As many as have room for the longest label, and two at least.
  const pick = (name, size, distances, needs) => {
    const all = distances.map((apart) => tickValues(ranges[name].now, size / apart));
    const have = all.filter((some) => some.share * size > needs(some));
    return have.find((some) => some.values.length > 1) || have[0];
  };
  const xs = pick(plot.x, plot.width, [44, 58, 75, 100], (some) => 14 + 7.2 * longest(some)) ||
    tickValues(ranges[plot.x].now, 2);
  const ys = pick(plot.y, plot.height, [42, 32, 24, 18], () => 15) ||
    tickValues(ranges[plot.y].now, plot.height / 42);
  pen.beginPath();
  for (const value of xs.values) {
    const x = Math.round(plot.px(value)) + 0.5;
    pen.moveTo(x, margin.top);
    pen.lineTo(x, bottom);
    const text = fixed(value, xs.decimals);
    // A label that the edge would cut is left out; its grid line stays.
    if (x + 3.8 * text.length < right + margin.right) tick(text, x, bottom + 15, "middle");
  }
  for (const value of ys.values) {
    const y = Math.round(plot.py(value)) + 0.5;
    pen.moveTo(margin.left, y);
    pen.lineTo(right, y);
    tick(fixed(value, ys.decimals), margin.left - 6, clamp(y + 4, 12, bottom + 4), "end");
  }
  pen.strokeStyle = "#e3e7eb";
  pen.stroke();
  pen.strokeStyle = "#8b939c";
  pen.strokeRect(margin.left + 0.5, margin.top + 0.5, plot.width - 1, plot.height - 1);
  while (plot.ticks.children.length > used) plot.ticks.lastChild.remove();
};

const setPen = (pen, style, width) => {
  pen.strokeStyle = style.colour;
  pen.lineWidth = width;
  pen.setLineDash(dashes[style.line] || []);
};
// Whether a line between two places passes through the plot's area.
const passes = (plot, x1, y1, x2, y2) => {
  let [first, last] = [0, 1];
  for (const [at, by, low, high] of [[x1, x2 - x1, margin.left, margin.left + plot.width],
                                     [y1, y2 - y1, margin.top, margin.top + plot.height]]) {
    if (by === 0) {
      if (at < low || at > high) return false;
      continue;
    }
    const ends = [(low - at) / by, (high - at) / by];
    first = Math.max(first, Math.min(...ends));
    last = Math.min(last, Math.max(...ends));
  }
  return first <= last;
};
// Notes whether any of the data are in sight.
const noteSight = (plot, x1, y1, x2, y2) => {
  plot.hasData = true;
  if (!plot.isInSight) plot.isInSight = passes(plot, x1, y1, x2, y2);
};
// Paths of whole columns as shares of their full ranges: the browser moves them faster than a script
// could draw them anew.
const paths = new Map();
const pathOf = (plot, xs, ys) => {
  if (!paths.has(xs)) paths.set(xs, new Map());
  const known = paths.get(xs);
  if (known.has(ys)) return known.get(ys);
  const path = new Path2D();
  const [[x0, x1], [y0, y1]] = [ranges[plot.x].full, ranges[plot.y].full];
  let isDown = false;
  for (let i = 0; i < xs.length; ++i) {
    const isThere = xs[i] !== null && ys[i] !== null;
    const place = [(xs[i] - x0) / (x1 - x0), (ys[i] - y0) / (y1 - y0)];
    if (isThere && isDown) path.lineTo(...place);
    if (isThere && !isDown) path.moveTo(...place);
    isDown = isThere;
  }
  known.set(ys, path);
  return path;
};
const isAnyInSight = (plot, xs, ys) => {
  const [[left, right], [low, high]] = [ranges[plot.x].now, ranges[plot.y].now];
  for (let i = 0; i < xs.length; ++i) {
    if (xs[i] !== null && xs[i] >= left && xs[i] <= right && ys[i] !== null && ys[i] >= low && ys[i] <= high) return true;
  }
  return false;
};
// The same in the plot's own scale: while the view is only shifted, it is not scaled anew.
const scaledPathOf = (plot, xs, ys, width, height) => {
  plot.scaledPaths ??= new Map();
  const path = pathOf(plot, xs, ys);
  const known = plot.scaledPaths.get(path);
  const isSame = (one, other) => Math.abs(one - other) <= 1e-9 * Math.abs(other);
  if (known && isSame(known.width, width) && isSame(known.height, height)) return known.scaled;
  const scaled = new Path2D();
  scaled.addPath(path, new DOMMatrix([width, 0, 0, height, 0, 0]));
  plot.scaledPaths.set(path, { width, height, scaled });
  return scaled;
};
const traceWhole = (plot, pen, xs, ys) => {
  const [[x0, x1], [y0, y1]] = [ranges[plot.x].full, ranges[plot.y].full];
  const [left, top] = [plot.px(x0), plot.py(y0)];
  const scaled = scaledPathOf(plot, xs, ys, plot.px(x1) - left, plot.py(y1) - top);
  pen.save();
  pen.translate(left, top);
  pen.stroke(scaled);
  pen.restore();
};
// Closer, the browser's numbers would be too coarse.
const closest = 0.01;
const isNear = ({ full, now }) => now[1] - now[0] < closest * (full[1] - full[0]);
const trace = (plot, pen, xs, ys, from = 0, to = xs.length) => {
  // A pen that writes text has no scaled paths.
  const isWhole = pen.translate && from === 0 && to === xs.length && xs.length > 100;
  if (isWhole && !isNear(ranges[plot.x]) && !isNear(ranges[plot.y]) &&
      (plot.isInSight || isAnyInSight(plot, xs, ys))) {
    plot.hasData = plot.isInSight = true;
    traceWhole(plot, pen, xs, ys);
    return;
  }
  const [x0, y0] = [plot.px(0), plot.py(0)];
  const [dx, dy] = [plot.px(1) - x0, plot.py(1) - y0];
  let isDown = false;
  let [atX, atY] = [0, 0];
  pen.beginPath();
  for (let i = from; i < to; ++i) {
    if (xs[i] === null || ys[i] === null) {
      isDown = false;
      continue;
    }
    const x = x0 + xs[i] * dx;
    const y = y0 + ys[i] * dy;
    // Steps that nobody can see cost as much as others.
    if (isDown && i + 1 < to && Math.abs(x - atX) + Math.abs(y - atY) < 0.5) continue;
    if (isDown) {
      pen.lineTo(x, y);
      if (!plot.isInSight) noteSight(plot, atX, atY, x, y);
    } else {
      pen.moveTo(x, y);
    }
    isDown = true;
    [atX, atY] = [x, y];
  }
  pen.stroke();
};
// A line that is no data, across the plot or upright.
const acrossAt = (plot, pen, value, style) => {
  const y = plot.py(value);
  setPen(pen, style, 1.6);
  pen.beginPath();
  pen.moveTo(margin.left, y);
  pen.lineTo(margin.left + plot.width, y);
  pen.stroke();
};
const uprightAt = (plot, pen, value, style) => {
  const x = plot.px(value);
  setPen(pen, style, 1.6);
  pen.beginPath();
  pen.moveTo(x, margin.top + plot.height);
  pen.lineTo(x, margin.top);
  pen.stroke();
};

// Says so in the plot, with the way back.
const showLost = (plot, isLost) => {
  if (plot.lost.hidden === !isLost) return;
  // The focus must not vanish with the button.
  if (!isLost && plot.lost.contains(document.activeElement)) plot.view.focus({ preventScroll: true });
  plot.lost.hidden = !isLost;
  if (isLost && plot === current) say(t("No data in sight.") + " " + t("Home shows all."));
};
const paintPlot = (plot) => {
  const { box } = plot;
  if (!box) return;
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(box.width * ratio);
  const height = Math.round(box.height * ratio);
  if (!width || !height) return;
  if (plot.canvas.width !== width) plot.canvas.width = width;
  if (plot.canvas.height !== height) plot.canvas.height = height;
  plot.width = box.width - margin.left - margin.right;
  plot.height = box.height - margin.top - margin.bottom;
  setIfOther(plot.svg, "viewBox", `0 0 ${box.width} ${box.height}`);
  const pen = plot.canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, box.width, box.height);
  pen.setLineDash([]);
  paintAxes(plot, pen);
  pen.save();
  pen.beginPath();
  pen.rect(margin.left, margin.top, plot.width, plot.height);
  pen.clip();
  pen.lineJoin = "round";
  plot.hasData = plot.isInSight = false;
  plot.paint(plot, pen);
  pen.restore();
  showLost(plot, plot.hasData && !plot.isInSight);
  plot.element.dataset.xRange = ranges[plot.x].now.join(" ");
  plot.element.dataset.yRange = ranges[plot.y].now.join(" ");
  setIfOther(plot.element, "data-area", [margin.left, margin.top, plot.width, plot.height].join(" "));
};

let isFrameRequested = false;
const requestFrame = () => {
  if (isFrameRequested) return;
  isFrameRequested = true;
  requestAnimationFrame(() => {
    isFrameRequested = false;
    for (const plot of plots) {
      if (plot.dirty) paintPlot(plot);
      plot.dirty = false;
      plot.marks.replaceChildren(...(plot.isLoop ? loopMarks(plot) : runMarks(plot)));
    }
  });
};
const redraw = (which = () => true) => {
  for (const plot of plots) if (which(plot)) plot.dirty = true;
  requestFrame();
};
