// The report in Polish: the same numbers, the same viewer, and nothing of it left in English.
import assert from "node:assert/strict";
import { test } from "node:test";
import { dataOf, eachNight, listOf, settled, withReport } from "./open_report.mjs";

const read = (page) => page.evaluate(() => ({
  language: document.documentElement.lang,
  numbers: [...document.querySelectorAll("td.number")].map((cell) => cell.textContent.trim())
    .filter((text) => /^[−\d.\s  ]+$/.test(text)),
  ids: [...document.querySelectorAll("[id]")].map((element) => element.id),
  classes: [...new Set([...document.querySelectorAll("[class]")].map((one) => one.className.toString()))],
  result: document.getElementById("tribolog-result").textContent,
  viewer: document.getElementById("review").innerText.split("\n").map((line) => line.trim()),
  labels: [...document.querySelectorAll("#review [aria-label]")].map((one) => one.getAttribute("aria-label")),
}));

async function both(act) {
  const found = [];
  for (const name of ["noisy.html", "polish.html"]) {
    await withReport(name, {}, async (page) => { found.push(await act(page)); });
  }
  return found;
}

test("numbers, anchors, classes and the embedded result are the same in Polish", async () => {
  const [english, polish] = await both(read);
  assert.equal(english.language, "en");
  assert.equal(polish.language, "pl");
  assert.ok(english.numbers.length > 100);
  assert.deepEqual(polish.numbers, english.numbers);
  assert.deepEqual(polish.ids, english.ids);
  assert.deepEqual(polish.classes, english.classes);
  const numbersOf = (text) => ({ ...JSON.parse(text), provenance: 0 });
  assert.deepEqual(numbersOf(polish.result), numbersOf(english.result));
});

test("the viewer speaks Polish", async () => {
  const [english, polish] = await both(read);
  // Symbols, units, file names and people's names stay.
  const words = (texts) => texts.filter((text) => /[a-z]{4}/.test(text.replace(/mrad|\S*\.csv|Coulomb/g, "")));
  const left = words(polish.viewer.concat(polish.labels))
    .filter((text) => english.viewer.concat(english.labels).includes(text));
  assert.deepEqual(left, []);
  assert.ok(words(polish.viewer).length > 20);
});

test("readings in Polish have the English ones' numbers", eachNight, async () => {
  const [english, polish] = await both(async (page) => {
    const { candidates } = await dataOf(page);
    const readings = {};
    for (const name of ["A", "E", "AB", "midline", candidates[candidates.length - 1].name]) {
      await page.locator(`#review-reading-${name}`).check();
      await settled(page);
      const texts = Object.values(await listOf(page, "review-reading"));
      readings[name] = texts.map((text) => text.replace("% of T", "% T"));
    }
    return readings;
  });
  assert.deepEqual(polish, english);
  assert.ok(english.AB.length > english.midline.length);
});

test("no horizontal scroll in Polish at 390, 768 and 1400 px", eachNight, async () => {
  for (const width of [390, 768, 1400]) {
    await withReport("polish.html", { width }, async (page) => {
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${wide} px at ${width}`);
    });
  }
});
