// Ranges: one for each quantity, so that plots which share an axis move together.
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
// One cycle of the loop that is read, with the others pale; 0: all.
const cycleText = make("output", { id: "review-cycle" });
const cyclesOf = (loop) => (loop.frequency_Hz ? Math.floor(loop.t[loop.t.length - 1] * loop.frequency_Hz + 0.02) : 0);
const showCycle = (cycle) => {
  state.cycle = cycle;
  cycleText.textContent = cycle === 0 ? t("all cycles") : t("cycle {0}", cycle);
};
const stepCycle = (by) => {
  const loop = loops[state.loop];
  const count = cyclesOf(loop) + 1;
  const cycle = (state.cycle + by + count) % count;
  showCycle(cycle);
  if (cycle === 0) {
    setRange("t", ...ranges.t.full);
  } else {
    setRange("t", (cycle - 1) / loop.frequency_Hz, cycle / loop.frequency_Hz);
    setSample(nearestInTime(loop, (cycle - 1) / loop.frequency_Hz));
  }
  say(cycleText.textContent);
};
const resetRanges = () => {
  for (const name in ranges) setRange(name, ...ranges[name].full);
  showCycle(0);
  if (state.closeUp) showCloseUp();
  say(t("All plots show everything."));
};
// Plots that share an axis with it follow.
const resetPlot = (plot) => {
  for (const name of [plot.x, plot.y]) setRange(name, ...ranges[name].full);
  if (state.closeUp && !plot.isLoop) showCloseUp();
  say(t("This plot shows everything."));
};
