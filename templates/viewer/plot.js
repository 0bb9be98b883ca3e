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
  const element = make("div", { class: "plot", "data-plot": `${y}-${x}` },
    make("p", { class: "axis-title" }, axisTitle(y)), view,
    make("p", { class: "foot" }, cursor, make("span", { class: "axis-title" }, axisTitle(x))));
  const plot = { x, y, isLoop, paint, view, canvas, svg, ticks, marks, band, cursor, element,
                 width: 0, height: 0, dirty: true };
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

const paintAxes = (plot, pen) => {
  const labels = [];
  const right = margin.left + plot.width;
  const bottom = margin.top + plot.height;
  const tick = (text, x, y, anchor) =>
    labels.push(draw("text", { x, y, "text-anchor": anchor }, text));
  pen.lineWidth = 1;
  // As many as have room for the longest label.
  const xs = [44, 58, 75, 100].map((apart) => tickValues(ranges[plot.x].now, plot.width / apart))
    .find((some) => some.share * plot.width > 14 + 7.2 * longest(some)) ||
    tickValues(ranges[plot.x].now, 2);
  const ys = tickValues(ranges[plot.y].now, plot.height / 42);
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
  plot.ticks.replaceChildren(...labels);
};

const setPen = (pen, style, width) => {
  pen.strokeStyle = style.colour;
  pen.lineWidth = width;
  pen.setLineDash(dashes[style.line] || []);
};
const trace = (plot, pen, xs, ys, from = 0, to = xs.length) => {
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
    if (isDown) pen.lineTo(x, y); else pen.moveTo(x, y);
    isDown = true;
    [atX, atY] = [x, y];
  }
  pen.stroke();
};
const acrossAt = (plot, pen, value, style) => {
  setPen(pen, style, 1.6);
  trace(plot, pen, ranges[plot.x].now, [value, value]);
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
  plot.svg.setAttribute("viewBox", `0 0 ${box.width} ${box.height}`);
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
  plot.paint(plot, pen);
  pen.restore();
  plot.element.dataset.xRange = ranges[plot.x].now.join(" ");
  plot.element.dataset.yRange = ranges[plot.y].now.join(" ");
  plot.element.dataset.area = [margin.left, margin.top, plot.width, plot.height].join(" ");
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
