// A report in a browser without network, and what is read from it.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after } from "node:test";
import { pathToFileURL } from "node:url";

const require = createRequire(join(process.env.TRIBOLOG_PACKAGES, "package.json"));
const { chromium } = require("playwright-core");
/// Each night (tests/nightly.sh cases) what is looked at in part at every change is looked at whole.
export const everyCase = process.env.TRIBOLOG_EVERY_CASE !== undefined;
export const eachNight = { skip: everyCase ? false : "each night" };

export const axePath = require.resolve("axe-core/axe.min.js");
export const reportPath = (name) => join(process.env.TRIBOLOG_REPORTS, name);

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM, args: ["--no-sandbox", "--disable-gpu"],
});
after(() => browser.close());

/// Opens a report of the directory. `problems` gets every request that leaves the file, every
/// error and every violation of the policy; closing fails if there is one.
export async function open(name, { width = 1400, height = 1000, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, offline: true, ...options });
  const page = await context.newPage();
  const file = pathToFileURL(reportPath(name)).href;
  const problems = [];
  page.on("request", (request) => {
    if (request.url() !== file && !request.url().startsWith("data:image/png;base64,")) {
      problems.push("request: " + request.url().slice(0, 200));
    }
  });
  page.on("console", (message) => problems.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => problems.push(`error: ${error.message}`));
  page.on("dialog", (dialog) => { problems.push("dialog"); dialog.dismiss(); });
  await page.goto(file);
  const close = async () => {
    await context.close();
    assert.deepEqual(problems, []);
  };
  return { page, problems, context, close };
}

/// Runs `act` on a report of its own.
export async function withReport(name, options, act) {
  const report = await open(name, options);
  await act(report.page, report);
  await report.close();
}

/// The embedded data of the viewer.
export const dataOf = (page) =>
  page.evaluate(() => JSON.parse(document.getElementById("tribolog-loops").textContent));

/// Lets the viewer draw what was asked for.
export const settled = (page) => page.evaluate(
  () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/// What each plot shows: area, ranges and the marker of the instant, in the units of its axes.
export async function plotsOf(page) {
  await settled(page);
  return page.evaluate(() => Object.fromEntries(
    [...document.querySelectorAll("#review .plot")].filter((element) => element.dataset.area).map((element) => {
      const numbers = (text) => text.split(" ").map(Number);
      const [left, top, width, height] = numbers(element.dataset.area);
      const x = numbers(element.dataset.xRange);
      const y = numbers(element.dataset.yRange);
      const value = (circle) => circle && {
        x: x[0] + (circle.getAttribute("cx") - left) / width * (x[1] - x[0]),
        y: y[1] - (circle.getAttribute("cy") - top) / height * (y[1] - y[0]),
      };
      const box = element.querySelector(".view").getBoundingClientRect();
      return [element.dataset.plot, {
        x, y, left: box.left + left, top: box.top + top, width, height,
        now: value(element.querySelector(".now")),
        rings: [...element.querySelectorAll(".point:has(.ring)")].map((point) => (
          { name: point.dataset.point, ...value(point.querySelector(".ring")) })),
      }];
    })));
}
export const plotOf = async (page, id) => (await plotsOf(page))[id];

/// Place on the screen of a value.
export const screenOf = (plot, x, y) => ({
  x: plot.left + (x - plot.x[0]) / (plot.x[1] - plot.x[0]) * plot.width,
  y: plot.top + (plot.y[1] - y) / (plot.y[1] - plot.y[0]) * plot.height,
});

/// Within a thousandth of a pixel.
export function assertNear(actual, expected, range, message) {
  const allowed = 2e-6 * (range[1] - range[0]);
  assert.ok(Math.abs(actual - expected) <= allowed, `${message}: ${actual}, expected ${expected}`);
}

/// Texts of a definition list by their names.
export const listOf = (page, id) => page.evaluate((name) => Object.fromEntries(
  [...document.querySelectorAll(`#${name} > div`)].map((row) =>
    [row.querySelector("dt").textContent, row.querySelector("dd").textContent])), id);

/// Scrolls a plot into view and gives it the focus.
export async function focusPlot(page, id) {
  await page.locator(`[data-plot="${id}"] .view`).focus();
  await page.locator(`[data-plot="${id}"]`).scrollIntoViewIfNeeded();
  await settled(page);
}

/// How many pixels of a plot's canvas have a colour.
export const inkOf = (page, id, colour) => page.evaluate(([name, hex]) => {
  const canvas = document.querySelector(`[data-plot="${name}"] canvas`);
  const copy = Object.assign(document.createElement("canvas"),
    { width: canvas.width, height: canvas.height }).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  const [r, g, b] = [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const distance = Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b);
    if (data[i + 3] && distance < 12) ++count;
  }
  return count;
}, [id, colour]);

/// The same key so many times in some plots, at once.
export async function press(page, plots, key, times) {
  await page.evaluate(([names, pressed, count]) => {
    for (const name of names) {
      const view = document.querySelector(`[data-plot="${name}"] .view`);
      for (let k = 0; k < count; ++k) view.dispatchEvent(new KeyboardEvent("keydown", { key: pressed }));
    }
  }, [plots, key, times]);
  await settled(page);
}
