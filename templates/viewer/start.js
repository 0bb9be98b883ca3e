// Put together.
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
  t("Drag to move, Shift-drag for a box, click to read.") + " " +
  t("The wheel and two fingers zoom the plot clicked last.") + " " +
  t("Keys in a plot: arrows move, + and − zoom, 0 shows all, Page Up and Page Down step.") + " " +
  t("A to F and M choose a reading.") + " " +
  t("Plots that share a quantity move together.") + " " +
  t("Selecting a part of the time dims the rest of the loops.")));
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
