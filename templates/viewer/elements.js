// Elements of the page, and numbers as text.
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
