// Friction curves of compared calibrations: stretches of the runs.
const isOfShownCurve = (i) => !curves || curves.some(({ from, to }, k) => state.curves[k] && i >= from && i < to);
const paintIntervals = (plot, pen, { from, to, style }) => {
  setPen(pen, { colour: style.colour, line: "solid" }, 1.2);
  pen.beginPath();
  for (let i = from; i < to; ++i) {
    if (!isNumber(runs.half[i])) continue;
    const x = plot.px(runs.w[i]);
    pen.moveTo(x, plot.py(runs.value[i] - runs.half[i]));
    pen.lineTo(x, plot.py(runs.value[i] + runs.half[i]));
  }
  pen.stroke();
};
const paintCurves = (plot, pen) => {
  acrossAt(plot, pen, 0, { colour: "#8b939c", line: "solid" });
  curves.forEach((curve, k) => {
    if (!state.curves[k]) return;
    const { from, to, style } = curve;
    paintIntervals(plot, pen, curve);
    setPen(pen, style, 2);
    // Broken at standstill.
    const middle = from + runs.w.slice(from, to).filter((w) => w < 0).length;
    trace(plot, pen, runs.w, runs.value, from, middle);
    trace(plot, pen, runs.w, runs.value, middle, to);
    // Where both coincide, the second's dots lie within the first's.
    paintDots(plot, pen, runs.value.map((value, i) => (i >= from && i < to ? value : null)), style.colour, k ? 2.5 : 4.5);
  });
};
const curveControls = () => {
  const line = make("fieldset", { class: "readings wide" }, make("legend", {}, quantities.f.words));
  curves.forEach((curve, k) => line.append(check(curve.label, true, (isOn) => {
    state.curves[k] = isOn;
    redraw((plot) => !plot.isLoop);
  }, swatch(curve.style))));
  return line;
};
