// A review session in the loop viewer: two instants, cycles one by one, the whole window, files.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { dataOf, focusPlot, listOf, plotOf, settled, withReport } from "./open_report.mjs";

const button = (page, name) => page.getByRole("button", { name, exact: true });
const numberOf = (text) => Number(text.replace("−", "-").split(" ")[0]);
const atSample = (page, sample) => page.evaluate((value) => {
  const slider = document.getElementById("review-slider");
  slider.value = value;
  slider.dispatchEvent(new Event("input"));
}, sample);
const near = (actual, expected, share, what) =>
  assert.ok(Math.abs(actual - expected) <= share * Math.abs(expected), `${what}: ${actual}, expected ${expected}`);

test("by keys: a mark, and the differences and the energy since it", () =>
  withReport("noisy.html", {}, async (page) => {
    const { loops: [loop], quantities } = await dataOf(page);
    // Samples are kept where they show the curve, so that they are not evenly apart.
    const [from, to] = [1, 2].map((cycles) => loop.t.findIndex((time) => time >= cycles / loop.frequency_Hz));
    await atSample(page, from);
    await focusPlot(page, "T-q");
    await page.keyboard.press("x");
    await atSample(page, to);
    const read = await listOf(page, "review-mark");
    near(numberOf(read["Δt"]), loop.t[to] - loop.t[from], 1e-3, "time");
    assert.ok(Math.abs(numberOf(read["ΔT"]) - (loop.T[to] - loop.T[from])) < 1e-3);
    // Over a whole cycle the energy is the loop's area: computed here anew.
    let area = 0;
    for (let i = from; i < to; ++i) area += (loop.T[i] + loop.T[i + 1]) / 2 * (loop.q[i + 1] - loop.q[i]);
    near(numberOf(read["Energy on the way"]), area * quantities.T.joules, 1e-3, "energy");
    const stated = JSON.parse(await page.evaluate(() => document.getElementById("tribolog-result").textContent));
    near(numberOf(read["Energy on the way"]), stated.loop_shapes[0].dissipated_J, 0.1, "dissipated");
    assert.equal(await page.locator('[data-plot="T-q"] .marked').count(), 1);
    // The way back takes as much.
    await atSample(page, to);
    await button(page, "Remove the mark").click();
    await button(page, "Mark this instant").click();
    await atSample(page, from);
    near(numberOf((await listOf(page, "review-mark"))["Energy on the way"]), -area * quantities.T.joules, 1e-3, "back");
    await button(page, "Remove the mark").click();
    assert.ok(await page.locator("#review-mark").isHidden());
  }));

test("cycles are shown one by one, and all again", () =>
  withReport("noisy.html", {}, async (page) => {
    const { loops: [loop] } = await dataOf(page);
    const full = (await plotOf(page, "T-t")).x;
    await button(page, "Next cycle").click();
    await button(page, "Next cycle").click();
    const shown = (await plotOf(page, "T-t")).x;
    near(shown[0], 1 / loop.frequency_Hz, 1e-6, "from");
    near(shown[1], 2 / loop.frequency_Hz, 1e-6, "to");
    assert.equal(await page.locator("#review-cycle").textContent(), "cycle 2");
    for (let k = 0; k < 2; ++k) await button(page, "Previous cycle").click();
    assert.deepEqual((await plotOf(page, "T-t")).x, full);
    assert.equal(await page.locator("#review-cycle").textContent(), "all cycles");
    await button(page, "Previous cycle").click();
    await button(page, "Home: show all").click();
    assert.equal(await page.locator("#review-cycle").textContent(), "all cycles");
  }));

test("what a plot shows is saved as numbers and as a picture", () =>
  withReport("noisy.html", { acceptDownloads: true }, async (page) => {
    const { loops: [loop] } = await dataOf(page);
    const saved = async (name) => {
      const [file] = await Promise.all([page.waitForEvent("download"), button(page, name).click()]);
      return [file.suggestedFilename(), await readFile(await file.path())];
    };
    await focusPlot(page, "T-q");
    const [csvName, csv] = await saved("Save what the plot shows as CSV");
    assert.match(csvName, /_T-q\.csv$/);
    const rows = csv.toString().trim().split("\n");
    assert.equal(rows.length, loop.t.length + 1);
    const heads = rows[0].split(",");
    assert.match(heads[2], /^"driving torque \[N·m\]"$/);
    assert.equal(Number(rows[11].split(",")[2]), loop.T[10]);
    const [svgName, svg] = await saved("Save the plot as SVG");
    assert.match(svgName, /_T-q\.svg$/);
    const drawn = await page.evaluate((text) => {
      const picture = new DOMParser().parseFromString(text, "image/svg+xml");
      const lines = [...picture.querySelectorAll("svg > g > svg path")].map((path) => path.getAttribute("d").split("L").length);
      return { error: picture.querySelector("parsererror") !== null, longest: Math.max(...lines), text: picture.documentElement.textContent };
    }, svg.toString());
    assert.ok(!drawn.error && drawn.longest > 200, drawn.longest);
    assert.match(drawn.text, /driving torque T \[N·m\]/);
    const [pngName, png] = await saved("Save the plot as PNG");
    assert.match(pngName, /_T-q\.png$/);
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.ok(png.length > 5000, png.length);
    await focusPlot(page, "f-w");
    const [, curve] = await saved("Save what the plot shows as CSV");
    assert.ok(curve.toString().split("\n").length > 20);
  }));

test("remarks are pinned to instants, listed, saved and removed", () =>
  withReport("noisy.html", { acceptDownloads: true }, async (page) => {
    const remark = async (sample, text) => {
      await atSample(page, sample);
      await page.getByLabel("Remark on this instant").fill(text);
      await page.keyboard.press("Enter");
    };
    await remark(100, "a step");
    await remark(300, "noise <b>");
    await settled(page);
    assert.deepEqual(await page.locator('[data-plot="T-q"] .pin-number').allTextContents(), ["1", "2"]);
    await button(page, "a step").click();
    assert.equal(await page.locator("#review").getAttribute("data-sample"), "100");
    const [file] = await Promise.all([page.waitForEvent("download"), button(page, "Save remarks").click()]);
    const number = (await dataOf(page)).report;
    assert.equal(file.suggestedFilename(), `${number}_remarks.json`);
    const saved = JSON.parse(await readFile(await file.path()));
    assert.equal(saved.report, number);
    assert.deepEqual(saved.remarks.map(({ text }) => text), ["a step", "noise <b>"]);
    assert.match(saved.remarks[0].place, /t .* s, T .* N·m, q − q₀ /);
    await button(page, "Remove remark 1").click();
    assert.deepEqual(await page.locator('[data-plot="T-q"] .pin-number').allTextContents(), ["1"]);
    await button(page, "Remove remark 1").click();
    assert.ok(await button(page, "Save remarks").isHidden());
  }));

test("the viewer fills the window, and Escape gives it back", () =>
  withReport("noisy.html", {}, async (page) => {
    const box = () => page.evaluate(() => {
      const { width, height } = document.getElementById("review").getBoundingClientRect();
      return [width, height, innerWidth, innerHeight];
    });
    await button(page, "Full window").click();
    await settled(page);
    const [width, height, innerWidth, innerHeight] = await box();
    assert.ok(width >= innerWidth - 20 && height === innerHeight, [width, height].join());
    await page.keyboard.press("Escape");
    assert.ok((await box())[0] < innerWidth);
    assert.equal(await button(page, "Full window").getAttribute("aria-pressed"), "false");
  }));
