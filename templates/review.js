// The loop viewer. It shows what stands in #tribolog-loops (src/report/review/review_json.h) and
// computes no result: every number shown is one of the embedded ones, or their unit's multiple.
// Without this script the report lacks nothing but the viewer.
"use strict";
(() => {
  const root = document.getElementById("review");
  const source = document.getElementById("tribolog-loops");
  if (!root || !source) return;
  const data = JSON.parse(source.textContent);
  const { loops, runs, candidates, quantities } = data;
  // A text in the page's language, with the parts in its places {0}, {1}.
  const says = data.says || {};
  const t = (text, ...parts) => (says[text] || text).replace(/\{(\d)\}/g, (_, k) => parts[k]);

  // state
  const state = {
    // The loop that is scrubbed and read.
    loop: 0,
    // Its sample: the instant marked in all plots.
    sample: 0,
    shown: loops.map((_, k) => k === 0),
    fit: true,
    // A to F, a pair, midline, fit, sweep ...
    reading: "",
    // The run marked in the curves.
    run: -1,
    // The other candidates' curves.
    others: true,
    closeUp: false,
    // Dragging zooms to a box.
    box: false,
  };
  // By quantity: { full: [a, b], now: [a, b], decimals }.
  const ranges = {};
  const plots = [];
  // The plot that the zoom buttons act on.
  let current = null;

  // elements and numbers
  const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const name in attributes) element.setAttribute(name, attributes[name]);
    element.append(...children);
    return element;
  };
  const draw = (tag, attributes, ...children) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const name in attributes) element.setAttribute(name, attributes[name]);
    element.append(...children);
    return element;
  };
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
  const isNumber = (value) => typeof value === "number";
  const minus = (text) => (/[1-9]/.test(text) ? text.replace("-", "−") : text.replace("-", ""));
  const fixed = (value, decimals) => (isNumber(value) ? minus(value.toFixed(decimals)) : "–");
  // So many significant digits, as the report rounds what has no interval.
  const significant = (value, digits) => {
    if (!isNumber(value)) return "–";
    const size = Math.abs(value);
    if (size === 0) return "0";
    if (size >= 1e-6) return fixed(value, Math.max(0, digits - 1 - Math.floor(Math.log10(size))));
    return minus(value.toExponential(digits - 1))
      .replace(/e-(\d+)/, (_, n) => "×10⁻" + [...n].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).join(""));
  };
  const withUnit = (number, name) => number + " " + quantities[name].unit;
  const valueText = (value, name) => withUnit(fixed(value, ranges[name].decimals), name);
  const find = (list, name) => list.find((one) => one.name === name);
  const dashes = {
    solid: [], level: [15, 4], dash: [8, 4], dot: [2, 3], dash_dot: [9, 3, 2, 3], dash_dot_dot: [9, 3, 2, 3, 2, 3],
  };
  // Level with a reading's torque: as no curve is.
  const levelStyle = (candidate) => ({ colour: candidate.style.colour, line: "level" });
  const ink = "#1b1f24";
  const pale = "#c3c9d0";
  const midlineStyle = { colour: "#000000", line: "dash" };
  const peakStyle = { colour: "#00694b", line: "dash_dot" };

  const status = make("p", { class: "spoken", role: "status" });
  let speaking = 0;
  // Waits for a pause, so that a held key is not read out value by value.
  const say = (text) => {
    clearTimeout(speaking);
    speaking = setTimeout(() => { status.textContent = text; }, 400);
  };

  // ranges: one for each quantity, so that plots which share an axis move together
  const addRange = (name, columns, from = Infinity) => {
    let low = from;
    let high = -from;
    for (const column of columns) {
      for (const value of column || []) {
        if (!isNumber(value)) continue;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    if (!(high >= low)) return;
    const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
    const margin = 0.05 * (high - low || size);
    const full = [low - margin, high + margin];
    const decimals = clamp(4 - Math.floor(Math.log10(size)), 0, 9);
    ranges[name] = { full, now: full.slice(), decimals };
  };
  const isWithin = (name, value) =>
    isNumber(value) && value >= ranges[name].full[0] && value <= ranges[name].full[1];
  const setRange = (name, low, high) => {
    const [first, last] = ranges[name].full;
    const span = clamp(high - low, 1e-4 * (last - first), 1.5 * (last - first));
    const middle = clamp((low + high) / 2, first, last);
    ranges[name].now = [middle - span / 2, middle + span / 2];
    // Loops are drawn pale outside the time shown.
    const isTime = name === "t";
    for (const plot of plots) {
      if (plot.x === name || plot.y === name || (isTime && plot.isLoop)) plot.dirty = true;
    }
    requestFrame();
  };
  const zoom = (plot, factor, atX = 0.5, atY = 0.5) => {
    for (const [name, at] of [[plot.x, atX], [plot.y, atY]]) {
      const [low, high] = ranges[name].now;
      const fixedPoint = low + at * (high - low);
      setRange(name, fixedPoint - at * (high - low) * factor,
               fixedPoint + (1 - at) * (high - low) * factor);
    }
  };
  const pan = (plot, shareX, shareY) => {
    for (const [name, share] of [[plot.x, shareX], [plot.y, shareY]]) {
      const [low, high] = ranges[name].now;
      if (share) setRange(name, low + share * (high - low), high + share * (high - low));
    }
  };
  const resetRanges = () => {
    for (const name in ranges) setRange(name, ...ranges[name].full);
    if (state.closeUp) showCloseUp();
    say(t("All plots show everything."));
  };

  // one plot: canvas for curves, SVG for what is sharp, moves or is written
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

  // what the loops' plots show
  const chosen = () => find(candidates, state.reading);
  const firstAtOrAfter = (t, time) => {
    let low = 0;
    let high = t.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (t[middle] < time) low = middle + 1; else high = middle;
    }
    return low;
  };
  const timeWindow = (loop) => {
    const [from, to] = ranges.t.now;
    return [Math.max(0, firstAtOrAfter(loop.t, from) - 1),
            Math.min(loop.t.length, firstAtOrAfter(loop.t, to) + 1)];
  };
  const paintLoops = (plot, pen) => {
    const isOver = (k) => (k === state.loop ? 1 : 0);
    const order = loops.map((_, k) => k).filter((k) => state.shown[k])
      .sort((a, b) => isOver(a) - isOver(b));
    for (const k of order) {
      const loop = loops[k];
      if (!loop[plot.y]) continue;
      const [from, to] = timeWindow(loop);
      if (plot.x !== "t" && to - from < loop.t.length) {
        setPen(pen, { colour: pale, line: "solid" }, 1);
        trace(plot, pen, loop[plot.x], loop[plot.y]);
      }
      setPen(pen, loop.style, k === state.loop ? 1.7 : 1.2);
      trace(plot, pen, loop[plot.x], loop[plot.y], from, to);
    }
    const loop = loops[state.loop];
    const isShown = state.shown[state.loop];
    if (plot.y === "T" && isShown && state.fit && loop.fit) {
      setPen(pen, data.fit_style, 2);
      trace(plot, pen, loop[plot.x], loop.fit, ...timeWindow(loop));
    }
    if (plot.y === "T" && plot.x === "q" && isShown && loop.midline) {
      setPen(pen, midlineStyle, state.reading === "midline" ? 3.5 : 1.6);
      trace(plot, pen, loop.midline.q, loop.midline.T);
    }
    if (plot.x === "q" && isShown && isNumber(loop.q_peak)) {
      setPen(pen, peakStyle, 1.6);
      trace(plot, pen, [loop.q_peak, loop.q_peak], ranges[plot.y].now);
    }
    const level = chosen();
    if (plot.y === "T" && level && isNumber(level.T)) {
      acrossAt(plot, pen, level.T, levelStyle(level));
    }
  };

  // Points chosen by the reading: its own, or both of a pair.
  const chosenPoints = () => {
    const list = state.reading.length === 2 ? data.points.steady : data.points.first;
    return list.filter((point) => /^[A-F]{1,2}$/.test(state.reading) &&
                                  state.reading.includes(point.name));
  };
  // A letter beside its point, away from the others' middle if there is room.
  const letterPlace = (plot, x, y, centre, taken) => {
    const right = x < centre.x ? -1 : 1;
    const below = y < centre.y ? -1 : 1;
    const places = [[right, below], [right, 0], [0, below], [right, -below], [-right, below],
                    [-right, 0], [0, -below], [-right, -below], [0, 2 * below], [2 * right, 0]];
    for (const [dx, dy] of places) {
      const at = { x: x + 12 * dx, y: y + 13 * dy };
      if (isInside(plot, at.x - 6, at.y - 6) && isInside(plot, at.x + 6, at.y + 6) &&
          taken.every((other) => Math.abs(other.x - at.x) > 10 || Math.abs(other.y - at.y) > 11)) {
        return at;
      }
    }
    return null;
  };
  const pointMarks = (plot) => {
    const marked = chosenPoints();
    const steady = state.reading.length === 2 ? marked : [];
    const places = data.points.first.filter((point) => !find(steady, point.name)).concat(steady)
      .filter((point) => isNumber(point[plot.x]) && isNumber(point[plot.y]))
      .map((point) => ({ point, x: plot.px(point[plot.x]), y: plot.py(point[plot.y]) }));
    const mean = (axis) => places.reduce((sum, place) => sum + place[axis], 0) / places.length;
    const centre = { x: mean("x"), y: mean("y") };
    const taken = places.slice();
    const isChosen = ({ point }) => marked.includes(point);
    return places.filter(({ x, y }) => isInside(plot, x, y))
      .sort((a, b) => isChosen(b) - isChosen(a)).map((place) => {
        const { point, x, y } = place;
        const mark = draw("g", { class: "point", "data-point": point.name });
        if (isChosen(place)) mark.append(draw("circle", { cx: x, cy: y, r: 8, class: "ring" }));
        mark.append(draw("circle", { cx: x, cy: y, r: 3.5, class: "dot" }));
        const at = letterPlace(plot, x, y, centre, taken);
        if (at) {
          taken.push(at);
          mark.append(draw("text", { x: at.x, y: at.y + 4.5, "text-anchor": "middle" }, point.name));
        }
        return mark;
      });
  };
  const isInside = (plot, x, y) =>
    x >= margin.left - 1 && x <= margin.left + plot.width + 1 &&
    y >= margin.top - 1 && y <= margin.top + plot.height + 1;

  const loopMarks = (plot) => {
    const out = [];
    if (state.shown[0]) out.push(...pointMarks(plot));
    const loop = loops[state.loop];
    if (!state.shown[state.loop] || !loop[plot.y]) return out;
    const i = state.sample;
    const period = loop.frequency_Hz ? 1 / loop.frequency_Hz : loop.t[loop.t.length - 1] / 10;
    const tail = [];
    for (let k = i; k >= 0 && loop.t[k] >= loop.t[i] - 0.12 * period; --k) {
      if (!isNumber(loop[plot.x][k]) || !isNumber(loop[plot.y][k])) break;
      const x = plot.px(loop[plot.x][k]);
      const y = plot.py(loop[plot.y][k]);
      if (!isInside(plot, x, y)) break;
      tail.push(`${x.toFixed(1)},${y.toFixed(1)}`);
    }
    out.unshift(draw("polyline", { class: "tail", points: tail.join(" ") }));
    const x = plot.px(loop[plot.x][i]);
    const y = plot.py(loop[plot.y][i]);
    if (isNumber(loop[plot.x][i]) && isNumber(loop[plot.y][i]) && isInside(plot, x, y)) {
      out.push(draw("circle", { class: "now", cx: x, cy: y, r: 6 }));
    }
    return out;
  };

  // what the candidates' plots show
  const hasRun = (i) => i >= 0 && isNumber(runs.w[i]);
  // Broken at standstill.
  const paintRunCurve = (plot, pen, ys) => {
    const middle = runs.w.filter((w) => w <= 0).length;
    trace(plot, pen, runs.w, ys, 0, middle);
    trace(plot, pen, runs.w, ys, middle);
  };
  const paintDots = (plot, pen, ys, colour, radius) => {
    setPen(pen, { colour: ink }, 1);
    pen.fillStyle = colour;
    ys.forEach((y, i) => {
      if (!isNumber(y) || !hasRun(i)) return;
      pen.beginPath();
      pen.arc(plot.px(runs.w[i]), plot.py(y), radius, 0, 7);
      pen.fill();
      pen.stroke();
    });
  };
  const paintRuns = (plot, pen) => {
    const isLine = !runs.from_sweep;
    acrossAt(plot, pen, 0, { colour: "#8b939c", line: "solid" });
    if (state.others) {
      setPen(pen, { colour: pale, line: "solid" }, 1.2);
      for (const other of candidates) {
        const ys = other[plot.y];
        if (!ys || other.name === state.reading) continue;
        if (isLine) paintRunCurve(plot, pen, ys); else paintDots(plot, pen, ys, pale, 2);
      }
    }
    if (plot.y === "e" && runs.band) {
      setPen(pen, { colour: "#78787a", line: "solid" }, 1);
      pen.beginPath();
      runs.band.forEach((half, i) => {
        if (!isNumber(half)) return;
        pen.moveTo(plot.px(runs.w[i]), plot.py(-half));
        pen.lineTo(plot.px(runs.w[i]), plot.py(half));
      });
      pen.stroke();
    }
    const reference = plot.y === "f" && runs.f;
    if (reference && isLine) {
      setPen(pen, runs.style, 1.6);
      paintRunCurve(plot, pen, reference);
    }
    const ys = (chosen() || {})[plot.y];
    if (ys) {
      setPen(pen, chosen().style, 2.4);
      if (isLine) paintRunCurve(plot, pen, ys);
      paintDots(plot, pen, ys, chosen().style.colour, isLine ? 3 : 4.5);
    }
    if (reference && !isLine) paintDots(plot, pen, reference, ink, 1.5);
  };
  const runMarks = (plot) => {
    const candidate = chosen();
    const ys = candidate && candidate[plot.y];
    if (!ys || !hasRun(state.run) || !isNumber(ys[state.run])) return [];
    const x = plot.px(runs.w[state.run]);
    const y = plot.py(ys[state.run]);
    return isInside(plot, x, y) ? [draw("circle", { class: "now", cx: x, cy: y, r: 6 })] : [];
  };
  const showCloseUp = () => {
    const candidate = chosen();
    for (const name of ["e", "f"]) {
      if (!ranges[name]) continue;
      let [low, high] = ranges[name].full;
      const values = ((candidate && candidate[name]) || []).filter(isNumber);
      if (state.closeUp && values.length) {
        if (name === "e") values.push(0);
        const spare = 0.1 * (Math.max(...values) - Math.min(...values));
        low = Math.min(...values) - spare;
        high = Math.max(...values) + spare;
      }
      setRange(name, low, high);
    }
  };

  // readings
  const fillList = (list, rows) => list.replaceChildren(...rows.map(([name, text]) =>
    make("div", {}, make("dt", {}, name), make("dd", {}, text))));
  const instant = make("dl", { class: "values", id: "review-instant" });
  const readingTitle = make("h4", { id: "review-reading-title" });
  const readingWhat = make("p", {});
  const instantOf = make("p", {});
  const readingList = make("dl", { class: "values", id: "review-reading" });
  const runLine = make("p", { class: "run-line", id: "review-run" });
  const slider = make("input", { type: "range", id: "review-slider", min: "0", step: "1" });
  const sliderText = make("output", { for: "review-slider", id: "review-slider-text" });

  const timeText = (loop, i) => withUnit(fixed(loop.t0_s + loop.t[i], 4), "t");
  const phaseText = (loop, i) => {
    if (!loop.frequency_Hz) return "–";
    const turns = loop.t[i] * loop.frequency_Hz;
    return t("{0}° of cycle {1}", Math.floor(360 * (turns % 1)), Math.floor(turns) + 1);
  };
  const showInstant = () => {
    const loop = loops[state.loop];
    const i = state.sample;
    const degrees = loop.centre_deg + loop.q[i] * quantities.q.degrees;
    const rows = [["t", timeText(loop, i)], [t("Phase"), phaseText(loop, i)],
                  ["q", isNumber(loop.q[i]) ? fixed(degrees, 4) + "°" : "–"],
                  ["q − q₀", valueText(loop.q[i], "q")], ["T", valueText(loop.T[i], "T")]];
    if (loop.fit) rows.push([t("T, LuGre fit"), valueText(loop.fit[i], "T")]);
    for (const name of ["z", "dz"]) {
      if (loop[name]) rows.push([quantities[name].symbol, valueText(loop[name][i], name)]);
    }
    fillList(instant, rows);
    instantOf.textContent = loop.name || "";
    slider.max = loop.t.length - 1;
    slider.value = i;
    slider.setAttribute("aria-valuetext", `t ${timeText(loop, i)}, T ${valueText(loop.T[i], "T")}`);
    sliderText.textContent = `t = ${timeText(loop, i)}, ${phaseText(loop, i)}`;
    root.dataset.sample = i;
    root.dataset.loop = state.loop;
    requestFrame();
  };
  const setSample = (i, isSpoken) => {
    const loop = loops[state.loop];
    state.sample = clamp(i, 0, loop.t.length - 1);
    showInstant();
    if (isSpoken) say(slider.getAttribute("aria-valuetext"));
  };

  const showReading = () => {
    const candidate = chosen();
    const marked = chosenPoints();
    const isPair = state.reading.length === 2 && marked.length > 0;
    const rows = [];
    if (isPair) {
      for (const point of marked) {
        rows.push(...point.texts.filter(([name]) => name === t("Torque T") || name === "t")
          .map(([name, text]) => [t("{0}, steady: {1}", point.name, name), text]));
      }
    } else if (marked.length) {
      rows.push(...marked[0].texts);
      rows.splice(2, 0, ["q − q₀", valueText(marked[0].q, "q")]);
    } else if (state.reading === "midline" && data.midline) {
      rows.push([t("T at q_peak"), data.midline.text]);
    } else if (candidate) {
      rows.push([t("Torque T"), candidate.torque]);
    }
    if (candidate) {
      rows.push([t("Surrogate mass"), candidate.mass]);
      if (candidate.rms) rows.push([t("Error, rms"), t("{0} % of T", candidate.rms)]);
    }
    const words = candidate ? candidate.words
      : state.reading === "midline" ? t("mid-line") : state.reading;
    const what = candidate ? candidate.what : marked.length ? marked[0].where : "";
    readingTitle.textContent = marked.length === 1 ? t("Point {0}", words) : words;
    const titles = candidate ? [candidate.recommended && t("recommended"),
                                candidate.papers && t("the paper's rule")] : [];
    readingWhat.textContent = [what !== "–" && what, ...titles].filter(Boolean).join("; ");
    fillList(readingList, rows);
    levelKey.replaceChildren(...(candidate && ranges.T && isWithin("T", candidate.T)
      ? [swatch(levelStyle(candidate)), t("T of {0}", candidate.words)] : []));
    root.dataset.reading = state.reading;
    return [words].concat(rows.map((row) => row.join(" "))).join(", ");
  };
  const choose = (name, isSpoken) => {
    const radio = document.getElementById("review-reading-" + name);
    if (!radio) return;
    radio.checked = true;
    state.reading = name;
    const marked = chosenPoints();
    if (isSpoken && marked.length && loops.length && state.loop === 0) {
      setSample(nearestInTime(loops[0], marked[0].t));
    }
    if (runs) showCloseUp();
    const words = showReading();
    showRun();
    redraw();
    if (isSpoken) say(words);
  };
  const nearestInTime = (loop, time) => {
    const i = clamp(firstAtOrAfter(loop.t, time), 1, loop.t.length - 1);
    return time - loop.t[i - 1] < loop.t[i] - time ? i - 1 : i;
  };
  const showRun = () => {
    if (!runs) return "";
    const candidate = chosen();
    const i = state.run;
    if (!hasRun(i)) {
      runLine.textContent = t("Click into a curve, or press Page Down in it, to read a run.");
      return "";
    }
    const parts = [`${quantities.w.words} ${withUnit(significant(runs.w[i], 4), "w")}`,
                   `T ${runs.torque_texts[i]}`];
    if (candidate && candidate.f) parts.push(`Tf (${candidate.words}) ${valueText(candidate.f[i], "f")}`);
    if (runs.f) parts.push(t("reference {0}", valueText(runs.f[i], "f")));
    if (candidate && candidate.e) parts.push(t("error {0} %", significant(candidate.e[i], 3)));
    if (runs.names[i]) parts.unshift(runs.names[i]);
    return (runLine.textContent = parts.join(" · "));
  };
  const setRun = (i) => {
    state.run = clamp(i, 0, runs.w.length - 1);
    root.dataset.run = state.run;
    say(showRun());
    requestFrame();
  };
  const step = (plot, by) => {
    if (plot.isLoop) setSample(state.sample + by, true); else setRun(state.run + by);
  };

  // A click reads: a point if it is near, else the nearest sample of the loop, or the nearest run.
  const readAt = (plot, x, y) => {
    if (!plot.isLoop) {
      let best = -1;
      runs.w.forEach((w, i) => {
        if (best < 0 || Math.abs(plot.px(w) - x) < Math.abs(plot.px(runs.w[best]) - x)) best = i;
      });
      return setRun(best);
    }
    for (const mark of plot.marks.querySelectorAll(".point")) {
      const dot = mark.querySelector(".dot");
      if (Math.hypot(dot.getAttribute("cx") - x, dot.getAttribute("cy") - y) < 13) {
        return choose(mark.dataset.point, true);
      }
    }
    const loop = loops[state.loop];
    const [from, to] = timeWindow(loop);
    let best = -1;
    let least = Infinity;
    for (let i = from; i < to; ++i) {
      if (!isNumber(loop[plot.x][i]) || !loop[plot.y] || !isNumber(loop[plot.y][i])) continue;
      const dx = plot.px(loop[plot.x][i]) - x;
      const dy = plot.x === "t" ? 0 : plot.py(loop[plot.y][i]) - y;
      if (dx * dx + dy * dy < least) {
        least = dx * dx + dy * dy;
        best = i;
      }
    }
    if (best >= 0) setSample(best, true);
  };

  // pointer, wheel and keys
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
    const place = (event) => {
      const box = view.getBoundingClientRect();
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
    for (const name of "ABCDEF") keys[name.toLowerCase()] = () => choose(name, true);
    view.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const act = keys[event.key] || keys[event.key.toLowerCase()];
      if (!act) return;
      event.preventDefault();
      act();
    });
  };

  // controls
  const button = (words, act, attributes = {}) => {
    const element = make("button", { type: "button", ...attributes }, words);
    element.addEventListener("click", () => act(element));
    return element;
  };
  const toggle = (words, isOn, act) => button(words, (element) => {
    const now = element.getAttribute("aria-pressed") !== "true";
    element.setAttribute("aria-pressed", now);
    act(now);
  }, { "aria-pressed": isOn });
  const swatch = (style) => draw("svg", { class: "swatch", viewBox: "0 0 34 10", "aria-hidden": "true" },
    draw("line", { x1: 1, x2: 33, y1: 5, y2: 5, stroke: style.colour, "stroke-width": 2.5,
                   "stroke-dasharray": (dashes[style.line] || []).join(" ") }));
  const key = (style, words) => make("span", { class: "key" }, swatch(style), words);
  // Of the level line of the reading.
  const levelKey = make("span", { class: "key" });
  const check = (words, isOn, act, ...before) => {
    const input = make("input", { type: "checkbox" });
    input.checked = isOn;
    input.addEventListener("change", () => act(input.checked, input));
    return make("label", { class: "key" }, input, ...before, words);
  };

  const zoomControls = () => {
    const box = toggle(t("Box zoom"), false, (isOn) => {
      state.box = isOn;
      root.classList.toggle("boxing", isOn);
    });
    // What a drag does must be possible without one, too.
    const moves = [["←",  t("Move left"), -0.2, 0], ["→",  t("Move right"), 0.2, 0],
                   ["↑",  t("Move up"), 0, 0.2], ["↓",  t("Move down"), 0, -0.2]];
    return make("div", { class: "controls", role: "group", "aria-label": t("Zoom") },
      button("+", () => zoom(current, 0.7), { "aria-label": t("Zoom in") }),
      button("−", () => zoom(current, 1 / 0.7), { "aria-label": t("Zoom out") }),
      ...moves.map(([sign, name, x, y]) =>
        button(sign, () => pan(current, x, y), { "aria-label": name })),
      box, button(t("Reset"), resetRanges));
  };

  const readings = () => {
    const names = [];
    const add = (name, words) => names.some(([n]) => n === name) || names.push([name, words]);
    for (const point of data.points.first) add(point.name, point.name);
    for (const candidate of candidates) {
      add(candidate.name, candidate.name.length < 3 ? candidate.name : candidate.words);
    }
    if (data.midline) add("midline", t("mid-line"));
    return names;
  };
  const readingControls = () => {
    const set = make("fieldset", { class: "readings" },
      make("legend", {},  t("Reading, and candidate for the surrogate mass")));
    for (const [name, words] of readings()) {
      const radio = make("input", { type: "radio", name: "review-reading", value: name,
                                    id: "review-reading-" + name });
      radio.addEventListener("change", () => choose(name, true));
      set.append(make("label", {}, radio, words));
    }
    return set;
  };

  const loopControls = () => {
    const line = make("div", { class: "keys" });
    loops.forEach((loop, k) => {
      const words = loops.length > 1 ? `${k + 1}: ${loop.name || t("loop")}` +
        (loop.amplitude ? `, ± ${loop.amplitude}` : "") : t("measured");
      line.append(loops.length === 1 ? key(loop.style, words) : check(words, state.shown[k], (isOn) => {
        state.shown[k] = isOn;
        redraw((plot) => plot.isLoop);
      }, swatch(loop.style)));
    });
    if (loops.some((loop) => loop.fit)) {
      line.append(check(t("LuGre fit"), true, (isOn) => {
        state.fit = isOn;
        redraw((plot) => plot.isLoop);
      }, swatch(data.fit_style)));
    }
    if (loops.some((loop) => loop.midline)) line.append(key(midlineStyle, t("mid-line")));
    if (loops.some((loop) => isWithin("q", loop.q_peak))) line.append(key(peakStyle, t("gravity peak")));
    if (candidates.length) line.append(levelKey);
    if (loops.length < 2) return line;
    const select = make("select", { id: "review-loop" });
    loops.forEach((loop, k) =>
      select.append(make("option", { value: k }, `${k + 1}: ${loop.name || t("loop")}`)));
    select.addEventListener("change", () => {
      state.loop = Number(select.value);
      state.shown[state.loop] = true;
      line.querySelectorAll("input")[state.loop].checked = true;
      setSample(state.sample);
      redraw((plot) => plot.isLoop);
      say(t("Loop {0} is read.", state.loop + 1));
    });
    line.append(make("label", { class: "key", for: "review-loop" },  t("Read and scrub")), select);
    return line;
  };

  const playControl = () => {
    const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
    let isPlaying = false;
    let last = 0;
    let time = 0;
    const show = () => {
      element.textContent = isPlaying ? t("Pause") : t("Play");
      element.hidden = calm.matches;
    };
    const advance = (now) => {
      if (!isPlaying) return;
      const loop = loops[state.loop];
      const period = loop.frequency_Hz ? 1 / loop.frequency_Hz : loop.t[loop.t.length - 1] / 10;
      // A cycle lasts four seconds.
      time += Math.min(now - last, 100) / 4000 * period;
      last = now;
      setSample(nearestInTime(loop, time));
      if (state.sample === loop.t.length - 1) isPlaying = false;
      show();
      requestAnimationFrame(advance);
    };
    const element = button(t("Play"), () => {
      isPlaying = !isPlaying;
      const { t } = loops[state.loop];
      time = state.sample === t.length - 1 ? 0 : t[state.sample];
      last = performance.now();
      show();
      requestAnimationFrame(advance);
    });
    slider.addEventListener("input", () => { isPlaying = false; show(); });
    calm.addEventListener("change", () => { isPlaying = false; show(); });
    show();
    return element;
  };

  // put together
  const buildLoops = () => {
    for (const name of ["t", "q", "T", "z", "dz"]) {
      const columns = loops.map((loop) => loop[name]);
      if (name === "T") {
        columns.push(...loops.flatMap((loop) => [loop.fit, (loop.midline || {}).T]));
      }
      addRange(name, columns.concat(data.points.first.map((point) => [point[name]])));
    }
    const left = make("div", { class: "column" });
    const right = make("div", { class: "column" });
    left.append(addPlot("q", "T", true, paintLoops));
    if (ranges.z) left.append(addPlot("q", "z", true, paintLoops));
    if (ranges.dz) left.append(addPlot("q", "dz", true, paintLoops));
    right.append(addPlot("t", "T", true, paintLoops), addPlot("t", "q", true, paintLoops));
    right.append(make("div", { class: "beside" }, make("div", { class: "numbers" },
      make("div", {}, make("h4", {},  t("At the instant")), instantOf, instant),
      make("div", {}, readingTitle, readingWhat, readingList))));
    slider.addEventListener("input", () => setSample(Number(slider.value)));
    root.append(loopControls(), make("div", { class: "columns" }, left, right),
      make("div", { class: "scrub" }, make("label", { for: "review-slider" }, t("Instant")), slider,
        playControl(), sliderText));
  };
  const buildCandidates = () => {
    addRange("w", [runs.w]);
    addRange("f", candidates.map((one) => one.f).concat([runs.f]), 0);
    const hasErrors = candidates.some((one) => one.e);
    if (hasErrors) addRange("e", candidates.map((one) => one.e), 0);
    const line = make("div", { class: "keys" });
    if (runs.f) line.append(key(runs.style, t("reference: {0}", runs.reference || "")));
    if (candidates.length > 1) {
      line.append(check(t("other candidates"), true, (isOn) => {
        state.others = isOn;
        redraw((plot) => !plot.isLoop);
      }, swatch({ colour: pale, line: "solid" })));
    }
    line.append(toggle(t("Close-up of the chosen one"), false, (isOn) => {
      state.closeUp = isOn;
      showCloseUp();
    }));
    const grid = make("div", { class: "columns" },
      make("div", { class: "column" }, addPlot("w", "f", false, paintRuns)));
    if (hasErrors) grid.append(make("div", { class: "column" }, addPlot("w", "e", false, paintRuns)));
    if (!loops.length) {
      root.append(make("div", { class: "numbers alone" }, readingTitle, readingWhat, readingList));
    }
    root.append(line, grid, runLine);
  };

  const hasCurves = runs && candidates.some((one) => one.f);
  root.append(make("p", { id: "review-help", class: "help" },
    t("Drag to move, Shift and drag for a box, click to read.") + " " +
    t("The wheel and two fingers zoom the plot that was clicked last.") + " " +
    t("Keys in a plot: arrows move, + and − zoom, 0 shows all, Page Up and Page Down step.") + " " +
    t("A to F and M choose a reading.") + " " +
    t("Plots that share a quantity move together.") + " " +
    t("A part of the time leaves the rest of the loops pale.")));
  root.append(make("div", { class: "top" }, zoomControls(), readingControls()));
  if (loops.length) buildLoops();
  if (hasCurves) buildCandidates();
  root.append(status);
  root.hidden = false;
  setCurrent(plots[0]);
  // Inside the first stroke, clear of the points.
  if (loops.length) {
    const { t, frequency_Hz } = loops[0];
    setSample(nearestInTime(loops[0], 0.6 * (frequency_Hz ? 1 / frequency_Hz : t[t.length - 1])));
  }
  const names = readings().map(([name]) => name);
  const best = candidates.find((one) => one.recommended);
  if (names.length) choose(best ? best.name : names[0], false);
  redraw();
})();
