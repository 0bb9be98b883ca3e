// Buttons, boxes to tick, the slider's playing.
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
    button(t("Home: show all"), resetRanges), box, fullControl(),
    button("CSV", () => saveCsv(current), { "aria-label": t("Save what the plot shows as CSV") }),
    button("SVG", () => saveSvg(current), { "aria-label": t("Save the plot as SVG") }),
    button("PNG", () => savePng(current), { "aria-label": t("Save the plot as PNG") }));
};
const fullControl = () => {
  const element = toggle(t("Full window"), false, (isOn) => root.classList.toggle("full", isOn));
  root.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && root.classList.contains("full")) element.click();
  });
  return element;
};
// A remark on the instant that is read; saved, `tribolog review` takes it up.
const remarkList = make("ol", { class: "remarks" });
const showRemarks = () => {
  remarkList.replaceChildren(...state.remarks.map((remark, k) => make("li", {},
    button(remark.text, () => {
      if (remark.loop === state.loop) setSample(remark.sample, true);
    }, { title: remark.place }), " ",
    button("×", () => {
      state.remarks.splice(k, 1);
      showRemarks();
    }, { "aria-label": t("Remove remark {0}", k + 1) }))));
  saveRemarksButton.hidden = state.remarks.length === 0;
  requestFrame();
};
const saveRemarksButton = button(t("Save remarks"), () => saveRemarks(), { hidden: "" });
const remarkControl = () => {
  const input = make("input", { type: "text", id: "review-remark", maxlength: "300", autocomplete: "off" });
  const form = make("form", { class: "controls" }, make("label", { for: "review-remark" }, t("Remark on this instant")),
    input, make("button", { type: "submit" }, t("Pin")), saveRemarksButton);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const text = input.value.trim();
    if (!text) return;
    const { loop, sample } = state;
    const place = [loops[loop].name, slider.getAttribute("aria-valuetext"),
                   `q − q₀ ${valueText(loops[loop].q[sample], "q")}`].filter(Boolean).join(", ");
    state.remarks.push({ loop, sample, place, text });
    input.value = "";
    showRemarks();
    say(t("Remark {0} is pinned.", state.remarks.length));
  });
  return make("div", { class: "pinning" }, form, remarkList);
};
const cycleControl = () => make("div", { class: "controls", role: "group", "aria-label": t("Cycles one by one") },
  button("‹", () => stepCycle(-1), { "aria-label": t("Previous cycle") }), cycleText,
  button("›", () => stepCycle(1), { "aria-label": t("Next cycle") }));

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

const earlierControl = () => check(data.earlier.words, false, (isOn) => {
  state.earlier = isOn;
  redraw();
}, swatch(data.earlier.style));

const loopControls = () => {
  const line = make("div", { class: "keys" });
  loops.forEach((loop, k) => {
    const words = loop.label ? loop.label : loops.length > 1 ? `${k + 1}: ${loop.name || t("loop")}` +
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
  if (loops.some((loop) => loop.m)) {
    line.append(check(t("misfit"), false, (isOn) => {
      root.classList.toggle("with-misfit", isOn);
      redraw((plot) => plot.isLoop);
    }));
  }
  if (data.earlier) line.append(earlierControl());
  if (loops.some((loop) => loop.midline)) line.append(key(midlineStyle, t("mid-line")));
  if (loops.some((loop) => isWithin("q", loop.q_peak))) line.append(key(peakStyle, t("gravity peak")));
  if (candidates.length) line.append(levelKey);
  if (loops.length < 2) return line;
  const select = make("select", { id: "review-loop" });
  loops.forEach((loop, k) =>
    select.append(make("option", { value: k }, loop.label || `${k + 1}: ${loop.name || t("loop")}`)));
  select.addEventListener("change", () => {
    state.loop = Number(select.value);
    state.shown[state.loop] = true;
    line.querySelectorAll("input")[state.loop].checked = true;
    setSample(state.sample);
    redraw((plot) => plot.isLoop);
    say(t("Readings are from loop {0}.", state.loop + 1));
  });
  line.append(make("label", { class: "key", for: "review-loop" },  t("Read and scrub")), select);
  return line;
};

const candidateControls = () => {
  const box = make("div", { class: "wide" });
  const line = make("div", { class: "keys" });
  if (runs.f) line.append(key(runs.style, t("reference: {0}", runs.reference || "")));
  if (data.earlier && !loops.length) line.append(earlierControl());
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
  box.append(line);
  if (!laws) return box;
  const set = make("fieldset", { class: "readings" }, make("legend", {}, t("Laws of friction, with their probability")));
  laws.list.forEach((law, k) => {
    set.append(check(`${law.words} (${law.note})`, state.laws[k], (isOn) => {
      state.laws[k] = isOn;
      redraw((plot) => !plot.isLoop);
    }, swatch(law.style)));
  });
  box.append(set);
  return box;
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
