// The loop viewer, in the parts that page_style.cpp puts together, in that order, into one block.
// It shows what stands in #tribolog-loops (src/report/review_json.h) and computes no result:
// every number shown is one of the embedded ones, their unit's multiple, the difference of the measured
// and the fitted torque, or what lies between two instants. Without this script the report lacks nothing
// but the viewer.
//
// This part: what is shown, and what of it is chosen.
const root = document.getElementById("review");
const source = document.getElementById("tribolog-loops");
const data = JSON.parse(source.textContent);
const { loops, runs, candidates, curves, quantities, laws } = data;
// A text in the page's language, with the parts in its places {0}, {1}.
const says = data.says || {};
const t = (text, ...parts) => (says[text] || text).replace(/\{(\d)\}/g, (_, k) => parts[k]);

const state = {
  // The loop that is scrubbed and read.
  loop: 0,
  // Its sample: the instant marked in all plots.
  sample: 0,
  // Another instant, from which differences are read: { loop, sample }.
  mark: null,
  // Pinned to instants: { loop, sample, place, text }.
  remarks: [],
  // The joint's calibration before, over loops and runs.
  earlier: false,
  // The cycle shown alone, from 1; 0: all.
  cycle: 0,
  shown: loops.map((loop, k) => (loop.shown === undefined ? k === 0 : loop.shown)),
  fit: true,
  // A to F, a pair, midline, fit, sweep ...
  reading: "",
  // The run marked in the curves.
  run: -1,
  // The laws drawn over the chosen curve.
  laws: laws ? laws.list.map((law) => law.chosen) : [],
  // Of compared calibrations.
  curves: (curves || []).map(() => true),
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
