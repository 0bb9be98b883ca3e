// What the candidates' plots show.
const hasRun = (i) => i >= 0 && isNumber(runs.w[i]);
// Broken at standstill.
const paintRunCurve = (plot, pen, ys, speeds = runs.w) => {
  const middle = speeds.filter((w) => w <= 0).length;
  trace(plot, pen, speeds, ys, 0, middle);
  trace(plot, pen, speeds, ys, middle);
};
const paintDots = (plot, pen, ys, colour, radius) => {
  setPen(pen, { colour: ink }, 1);
  pen.fillStyle = colour;
  ys.forEach((y, i) => {
    if (!isNumber(y) || !hasRun(i)) return;
    const at = [plot.px(runs.w[i]), plot.py(y)];
    noteSight(plot, ...at, ...at);
    pen.beginPath();
    pen.arc(...at, radius, 0, 7);
    pen.fill();
    pen.stroke();
  });
};
// The same in both directions.
const paintLaws = (plot, pen) => {
  const negative = (values) => values.map((value) => (isNumber(value) ? -value : null));
  laws.list.forEach((law, k) => {
    if (!state.laws[k]) return;
    setPen(pen, law.style, 2);
    if (Math.max(...runs.w) > 0) trace(plot, pen, laws.w, law.f);
    if (Math.min(...runs.w) < 0) trace(plot, pen, negative(laws.w), negative(law.f));
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
  if (ys && isLine) {
    setPen(pen, chosen().style, 2.4);
    paintRunCurve(plot, pen, ys);
  }
  if (plot.y === "f" && state.earlier) {
    setPen(pen, data.earlier.style, 2);
    paintRunCurve(plot, pen, data.earlier.f, data.earlier.w);
  }
  if (plot.y === "f" && laws) paintLaws(plot, pen);
  if (ys) {
    paintDots(plot, pen, ys, chosen().style.colour, isLine ? 3 : 4.5);
  }
  if (reference && !isLine) paintDots(plot, pen, reference, ink, 1.5);
};
const runMarks = (plot) => {
  const ys = curves ? runs.value : (chosen() || {})[plot.y];
  if (!ys || !isOfShownCurve(state.run) || !hasRun(state.run) || !isNumber(ys[state.run])) return [];
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
