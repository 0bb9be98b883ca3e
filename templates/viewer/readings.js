// Readings: the values at an instant, at chosen points, of a run.
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

// From the marked instant to the present one.
const markBox = make("div", { hidden: "" });
const markList = make("dl", { class: "values", id: "review-mark" });
const markButton = make("button", { type: "button", "aria-pressed": "false" });

// Of loops whose time is not kept.
const isPhase = loops.length > 0 && quantities.t.unit === "°";
const timeText = (loop, i) => withUnit(fixed(loop.t0_s + loop.t[i], isPhase ? 1 : 4), "t");
const phaseText = (loop, i) => {
  if (!loop.frequency_Hz) return "–";
  const turns = loop.t[i] * loop.frequency_Hz;
  return t("{0}° of cycle {1}", Math.floor(360 * (turns % 1)), Math.floor(turns) + 1);
};
const showInstant = () => {
  const loop = loops[state.loop];
  const i = state.sample;
  const degrees = loop.centre_deg + loop.q[i] * quantities.q.degrees;
  const rows = [...(isPhase ? [[t("Phase"), timeText(loop, i)]]
    : [["t", timeText(loop, i)], [t("Phase"), phaseText(loop, i)]]),
                ["q", isNumber(loop.q[i]) ? fixed(degrees, 4) + "°" : "–"],
                ["q − q₀", valueText(loop.q[i], "q")], ["T", valueText(loop.T[i], "T")]];
  if (loop.fit) rows.push([t("T, LuGre fit"), valueText(loop.fit[i], "T")]);
  if (loop.m) rows.push([t("misfit"), valueText(loop.m[i], "T")]);
  for (const name of ["z", "dz"]) {
    if (loop[name]) rows.push([quantities[name].symbol, valueText(loop[name][i], name)]);
  }
  fillList(instant, rows);
  instantOf.textContent = loop.name || "";
  slider.max = loop.t.length - 1;
  slider.value = i;
  const place = isPhase ? t("Phase {0}", timeText(loop, i)) : `t ${timeText(loop, i)}`;
  slider.setAttribute("aria-valuetext", `${place}, T ${valueText(loop.T[i], "T")}`);
  sliderText.textContent = isPhase ? place : `t = ${timeText(loop, i)}, ${phaseText(loop, i)}`;
  root.dataset.sample = i;
  root.dataset.loop = state.loop;
  showMark();
  requestFrame();
};
// The integral of the torque over the angle on the way between two samples.
const areaBetween = ({ q, T }, from, to) => {
  const [first, last] = from < to ? [from, to] : [to, from];
  let area = 0;
  for (let i = first; i < last; ++i) {
    if (isNumber(q[i]) && isNumber(q[i + 1])) area += (T[i] + T[i + 1]) / 2 * (q[i + 1] - q[i]);
  }
  return from < to ? area : -area;
};
const showMark = () => {
  const { mark, sample } = state;
  const isOn = mark !== null && mark.loop === state.loop;
  markBox.hidden = !isOn;
  markButton.textContent = isOn ? t("Remove the mark") : t("Mark this instant");
  markButton.setAttribute("aria-pressed", isOn);
  if (!isOn) return;
  const loop = loops[state.loop];
  const apart = (name) => loop[name][sample] - loop[name][mark.sample];
  const { q, T } = quantities;
  const rows = [isPhase ? [t("Phase"), withUnit(fixed(apart("t"), 1), "t")] : ["Δt", withUnit(fixed(apart("t"), 4), "t")],
                ["Δq", valueText(apart("q"), "q")], ["ΔT", valueText(apart("T"), "T")]];
  if (apart("q") !== 0) rows.push(["ΔT/Δq", `${significant(apart("T") / apart("q"), 4)} ${T.unit}/${q.unit}`]);
  if (T.joules) {
    rows.push([t("Energy on the way"), `${significant(T.joules * areaBetween(loop, mark.sample, sample), 4)} J`]);
  }
  fillList(markList, rows);
};
const toggleMark = () => {
  state.mark = state.mark && state.mark.loop === state.loop ? null : { loop: state.loop, sample: state.sample };
  showMark();
  say(state.mark ? t("Marked.") : t("No mark."));
  requestFrame();
};
markButton.addEventListener("click", toggleMark);
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
    runLine.textContent = t("Click on a curve, or press Page Down in it, to read a run.");
    return "";
  }
  const parts = [`${quantities.w.words} ${withUnit(significant(runs.w[i], 4), "w")}`,
                 curves ? `Tf ${runs.value_texts[i]}` : `T ${runs.torque_texts[i]}`];
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
    // Of curves over each other the height counts too.
    const away = (i) => Math.hypot(plot.px(runs.w[i]) - x, curves ? plot.py(runs.value[i]) - y : 0);
    runs.w.forEach((_, i) => {
      if (isOfShownCurve(i) && (best < 0 || away(i) < away(best))) best = i;
    });
    return best < 0 ? undefined : setRun(best);
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
