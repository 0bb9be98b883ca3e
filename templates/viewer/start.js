// Put together: the first plot, what is chosen and read beside it, the others below.
const stage = make("div", { class: "stage" });
const numbers = make("div", { class: "numbers" });
const addOthers = (pairs, isLoop, paint, kind = "") => {
  for (const [x, y] of pairs) {
    if (!ranges[y]) continue;
    const element = addPlot(x, y, isLoop, paint);
    if (kind) element.classList.add(kind);
    stage.append(element);
  }
};
const buildPanel = (first, keys) => {
  if (loops.length) {
    markBox.append(make("h4", {}, t("Since the mark")), markList);
    numbers.append(make("div", {}, make("h4", {}, t("At the instant")), instantOf, instant, markBox));
  }
  if (readings().length) numbers.append(make("div", {}, readingTitle, readingWhat, readingList));
  stage.append(make("div", { class: "main" }, first, keys),
    make("div", { class: "panel" }, zoomControls(), ...(readings().length ? [readingControls()] : []), numbers,
      make("details", { class: "help" }, make("summary", {}, t("Keys, mouse and fingers")), helpText)));
};
const buildLoops = () => {
  if (loops.some((loop) => loop.fit)) {
    quantities.m = { words: t("misfit, measured less LuGre fit"), symbol: "", unit: quantities.T.unit };
    for (const loop of loops) {
      if (loop.fit) loop.m = loop.T.map((T, i) => (isNumber(T) && isNumber(loop.fit[i]) ? T - loop.fit[i] : null));
    }
  }
  for (const name of ["t", "q", "T", "z", "dz", "m"]) {
    const columns = loops.map((loop) => loop[name]);
    if (name === "T") {
      columns.push(...loops.flatMap((loop) => [loop.fit, (loop.midline || {}).T]));
      columns.push(...(data.earlier ? data.earlier.loops.map((loop) => loop.T) : []));
    }
    addRange(name, columns.concat(data.points.first.map((point) => [point[name]])));
  }
  const first = addPlot("q", "T", true, paintLoops);
  buildPanel(first, loopControls());
  addOthers([["t", "T"], ["t", "q"], ["q", "z"], ["q", "dz"]], true, paintLoops);
  addOthers([["q", "m"], ["t", "m"]], true, paintLoops, "of-misfit");
  slider.addEventListener("input", () => setSample(Number(slider.value)));
};
const buildCandidates = () => {
  addRange("w", [runs.w]);
  addRange("f", candidates.map((one) => one.f).concat([runs.f, (data.earlier || {}).f]), 0);
  const hasErrors = candidates.some((one) => one.e);
  if (hasErrors) addRange("e", candidates.map((one) => one.e), 0);
  const keys = candidateControls();
  if (loops.length) stage.append(keys);
  else buildPanel(addPlot("w", "f", false, paintRuns), keys);
  addOthers(loops.length ? [["w", "f"], ["w", "e"]] : [["w", "e"]], false, paintRuns);
  stage.append(runLine);
};

const buildCurves = () => {
  addRange("w", [runs.w]);
  const ends = [-1, 1].map((sign) => runs.value.map((value, i) => value + sign * (runs.half[i] || 0)));
  addRange("f", ends, 0);
  const plot = addPlot("w", "f", false, paintCurves);
  plot.classList.add("wide");
  if (loops.length) stage.append(curveControls(), plot);
  else buildPanel(plot, curveControls());
  stage.append(runLine);
  showRun();
};

const hasCurves = runs && candidates.some((one) => one.f);
const helpText = make("p", { id: "review-help" },
  t("Drag to move, Shift-drag for a box, click to read.") + " " +
  t("A double click shows all of a plot, Home all of every plot.") + " " +
  t("The wheel and two fingers zoom the plot clicked last.") + " " +
  t("Keys in a plot: arrows move, + and − zoom, Page Up and Page Down step.") + " " +
  (candidates.length ? t("A to F and M choose a reading.") + " " : "") +
  (loops.length ? t("X marks the instant, from which differences are read.") + " " : "") +
  t("Plots that share a quantity move together.") + " " +
  t("Selecting a part of the time dims the rest of the loops."));
root.append(stage);
if (loops.length) buildLoops();
if (hasCurves) buildCandidates();
if (curves) buildCurves();
if (loops.length) {
  root.append(make("div", { class: "scrub" }, make("label", { for: "review-slider" }, t("Instant")), slider,
    playControl(), markButton, ...(loops.some((loop) => cyclesOf(loop) > 1) ? [cycleControl()] : []), sliderText));
  if (data.report) root.append(remarkControl());
  showCycle(0);
}
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
