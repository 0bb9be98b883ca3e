// Switching the candidate mass: curves, errors and numbers, against the data and the tables.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNear, dataOf, everyCase, focusPlot, inkOf, listOf, plotOf, plotsOf, screenOf, settled, withReport }
  from "./open_report.mjs";

const cellsOf = (page, table) => page.evaluate((id) => Object.fromEntries(
  [...document.querySelectorAll(`#${id} tbody tr`)].map((row) =>
    [row.cells[0].textContent.trim(), [...row.cells].map((cell) => cell.textContent.trim())])), table);
/// Colour of the canvas at a value.
const colourAt = (page, id, plot, x, y) => page.evaluate(([name, at]) => {
  const canvas = document.querySelector(`[data-plot="${name}"] canvas`);
  const box = canvas.getBoundingClientRect();
  const copy = Object.assign(document.createElement("canvas"), { width: 1, height: 1 })
    .getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, -Math.floor((at.x - box.left) * devicePixelRatio),
                 -Math.floor((at.y - box.top) * devicePixelRatio));
  return "#" + [...copy.getImageData(0, 0, 1, 1).data].slice(0, 3)
    .map((part) => part.toString(16).padStart(2, "0")).join("");
}, [id, screenOf(plot, x, y)]);

for (const name of everyCase ? ["paper.html", "noisy.html"] : ["paper.html"]) {
  test(`${name}: each candidate draws its curve and error, with the tables' numbers`, () =>
    withReport(name, {}, async (page) => {
      const data = await dataOf(page);
      const masses = await cellsOf(page, "stage-4-results");
      const errors = await cellsOf(page, "stage-6-results");
      assert.ok(data.candidates.length >= 12);
      const last = data.runs.w.length - 1;
      for (const candidate of data.candidates) {
        const row = (table) => Object.values(table).find((cells) => cells[1] === candidate.what);
        await page.locator(`#review-reading-${candidate.name}`).check();
        const shown = await listOf(page, "review-reading");
        assert.equal(shown["Surrogate mass"], candidate.mass);
        assert.equal(candidate.mass, row(masses)[4] + "\u00a0kg");
        assert.equal(shown["Error, rms"], row(errors)[2] + " % of T", candidate.name);
        const drawn = await plotsOf(page);
        for (const quantity of ["f", "e"]) {
          const plot = drawn[`${quantity}-w`];
          for (const run of [0, last]) {
            const colour = await colourAt(page, `${quantity}-w`, plot, data.runs.w[run],
                                          candidate[quantity][run]);
            assert.equal(colour, candidate.style.colour, `${candidate.name} ${quantity} of run ${run}`);
          }
        }
      }
    }));
}

test("runs are read by key and by click, in both plots", () =>
  withReport("noisy.html", {}, async (page) => {
    const { runs, candidates } = await dataOf(page);
    const B = candidates.find(({ name }) => name === "B");
    await page.locator("#review-reading-B").check();
    await focusPlot(page, "f-w");
    const check = async (run) => {
      for (const quantity of ["f", "e"]) {
        const plot = await plotOf(page, `${quantity}-w`);
        assertNear(plot.now.x, runs.w[run], plot.x, "w");
        assertNear(plot.now.y, B[quantity][run], plot.y, quantity);
      }
      const text = await page.locator("#review-run").innerText();
      assert.ok(text.includes(runs.torque_texts[run]), text);
      assert.ok(text.includes(runs.names[run]), text);
      assert.ok(text.includes(B.f[run].toFixed(4).replace("-", "−")), text);
      const error = Number(text.match(/error (−?[\d.]+) %/)[1].replace("−", "-"));
      assert.ok(Math.abs(error - B.e[run]) <= 0.0051 * Math.abs(B.e[run]), text);
    };
    await page.keyboard.press("PageDown");
    await check(0);
    await page.keyboard.press("PageDown");
    await check(1);
    const plot = await plotOf(page, "e-w");
    const run = runs.w.length - 2;
    const at = screenOf(plot, runs.w[run], plot.y[0]);
    await page.mouse.click(at.x, at.y - 6);
    await check(run);
  }));

test("the level of the reading moves in T(q)", () =>
  withReport("noisy.html", {}, async (page) => {
    const { candidates } = await dataOf(page);
    const E = candidates.find(({ name }) => name === "E");
    await page.locator("#review-reading-midline").check();
    await settled(page);
    assert.equal(await inkOf(page, "T-q", E.style.colour), 0);
    await page.locator("#review-reading-E").check();
    await settled(page);
    assert.ok(await inkOf(page, "T-q", E.style.colour) > 100);
    assert.ok(await inkOf(page, "T-t", E.style.colour) > 100);
  }));

test("the close-up follows the candidate; the others can be taken away", () =>
  withReport("noisy.html", {}, async (page) => {
    const { candidates } = await dataOf(page);
    const full = await plotOf(page, "e-w");
    await page.getByRole("button", { name: "Close-up" }).click();
    for (const name of ["midline", "A", "sweep"]) {
      await page.locator(`#review-reading-${name}`).check();
      const { e } = candidates.find((one) => one.name === name);
      const plot = await plotOf(page, "e-w");
      assert.ok(plot.y[0] < Math.min(0, ...e) && plot.y[1] > Math.max(0, ...e), name);
      assert.ok(plot.y[1] - plot.y[0] < 1.3 * (Math.max(0, ...e) - Math.min(0, ...e)), name);
    }
    await page.getByRole("button", { name: "Close-up" }).click();
    assert.deepEqual((await plotOf(page, "e-w")).y, full.y);
    assert.ok(await inkOf(page, "e-w", "#c3c9d0") > 500);
    await page.getByRole("checkbox", { name: "other candidates" }).uncheck();
    await settled(page);
    assert.equal(await inkOf(page, "e-w", "#c3c9d0"), 0);
  }));

test("laws are laid over the curve: the likeliest at first, each by its box", () =>
  withReport("noisy.html", {}, async (page) => {
    const { laws } = await dataOf(page);
    const [likeliest, ...others] = laws.list;
    assert.deepEqual(laws.list.filter((law) => law.chosen), [likeliest]);
    assert.match(likeliest.note, /%$/);
    const waiboer = others.find((law) => law.words.startsWith("Waiboer"));
    for (const law of laws.list) {
      const box = page.getByRole("checkbox", { name: law.words + " (" });
      assert.equal(await box.isChecked(), law.chosen, law.words);
    }
    assert.equal(await inkOf(page, "f-w", waiboer.style.colour), 0);
    await page.getByRole("checkbox", { name: waiboer.words + " (" }).check();
    await page.getByRole("button", { name: "Close-up" }).click();
    await settled(page);
    assert.ok(await inkOf(page, "f-w", waiboer.style.colour) > 30);
    // Two descriptions of the same runs.
    const fastest = likeliest.f.at(-1);
    laws.w.forEach((w, i) => assert.ok(Math.abs(waiboer.f[i] - likeliest.f[i]) < 0.03 * fastest, `at ${w} rad/s`));
  }));
