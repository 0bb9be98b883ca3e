// What the loops' plots show.
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
  // Of two calibrations the dashes lie over the solid line: where loops coincide, both are seen.
  const isOver = (k) => (k === state.loop && !isPhase ? 1 : 0);
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
    uprightAt(plot, pen, loop.q_peak, peakStyle);
  }
  if (plot.y === "T" && plot.x === "q" && state.earlier) {
    setPen(pen, data.earlier.style, 1.7);
    for (const { q, T } of data.earlier.loops) trace(plot, pen, q, T);
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
  state.remarks.forEach(({ loop: of, sample }, k) => {
    const [rx, ry] = [plot.px(loop[plot.x][sample]), plot.py(loop[plot.y][sample])];
    if (of !== state.loop || !isInside(plot, rx, ry)) return;
    out.push(draw("circle", { class: "pin", cx: rx, cy: ry, r: 8 }),
      draw("text", { class: "pin-number", x: rx, y: ry + 4, "text-anchor": "middle" }, String(k + 1)));
  });
  if (state.mark && state.mark.loop === state.loop) {
    const [mx, my] = [plot.px(loop[plot.x][state.mark.sample]), plot.py(loop[plot.y][state.mark.sample])];
    if (isInside(plot, mx, my)) out.push(draw("rect", { class: "marked", x: mx - 5, y: my - 5, width: 10, height: 10 }));
  }
  return out;
};
