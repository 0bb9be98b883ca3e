// axe-core's judgement of the whole report: light and dark, wide and narrow, the viewer in use.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { axePath, eachNight, focusPlot, press, settled, withReport } from "./open_report.mjs";

const axe = readFileSync(axePath, "utf8");

const contrast = ["color-contrast", "link-in-text-block"];

/// @param options of axe.run; all rules apply without any.
async function violationsOf(page, part, options = {}) {
  await page.evaluate(axe);
  const { violations, passes } = await page.evaluate(([selector, more]) => window.axe.run(selector, {
    resultTypes: ["violations"], rules: { "target-size": { enabled: true } }, ...more,
  }), [part, options]);
  assert.ok(passes.length > (options.runOnly ? 0 : 10), `axe-core has looked: ${passes.length}`);
  return violations.map((one) => `${one.id}: ${one.help}: ` +
    one.nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(" | "));
}

async function use(page) {
  await focusPlot(page, "T-q");
  await page.keyboard.press("c");
  await page.getByRole("button", { name: "Box zoom" }).click();
  await page.getByRole("button", { name: "Close-up" }).click();
  await settled(page);
}

test("paper.html, light, 1400 px: axe-core finds no violation", () =>
  withReport("paper.html", {}, async (page) => {
    await use(page);
    assert.deepEqual(await violationsOf(page, "html"), []);
  }));

// Contrast, which takes most of the time, does not change with the width, and nothing else with the
// colours: the whole page for what may be new, the viewer for all.
test("noisy.html, light, 390 px: axe-core finds no violation", () =>
  withReport("noisy.html", { width: 390 }, async (page) => {
    await use(page);
    const rules = Object.fromEntries(contrast.map((rule) => [rule, { enabled: false }]));
    assert.deepEqual(await violationsOf(page, "html", { rules }), []);
    assert.deepEqual(await violationsOf(page, "#review"), []);
  }));

test("paper.html, dark, 768 px: axe-core finds no violation", eachNight, () =>
  withReport("paper.html", { width: 768, colorScheme: "dark" }, async (page) => {
    await use(page);
    assert.deepEqual(await violationsOf(page, "html", { runOnly: contrast }), []);
    assert.deepEqual(await violationsOf(page, "#review"), []);
  }));

test("diff.html, light, 390 px: axe-core finds no violation", () =>
  withReport("diff.html", { width: 390 }, async (page) => {
    await press(page, ["T-q"], "+", 40);
    assert.ok(await page.locator('[data-plot="T-q"] .lost').isVisible());
    assert.deepEqual(await violationsOf(page, "html"), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }));

for (const name of ["regenerated.html", "fleet.html"]) {
  test(`${name}, light, 390 px, unfolded: axe-core finds no violation`, () =>
    withReport(name, { width: 390 }, async (page) => {
      await page.evaluate(() => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
      assert.deepEqual(await violationsOf(page, "html"), []);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    }));
}

test("a fault would be found", () =>
  withReport("noisy.html", {}, async (page) => {
    await page.evaluate(() => document.querySelector("#review .view").removeAttribute("aria-label"));
    await page.evaluate(() => { document.querySelector("#review legend").style.color = "#bbbbbb"; });
    const found = (await violationsOf(page, "#review")).map((text) => text.split(":")[0]);
    assert.ok(found.includes("color-contrast"), found.join());
  }));

test("every control is reached by Tab, in the order of the page, and its focus is seen", () =>
  withReport("noisy.html", {}, async (page) => {
    await page.locator('[data-plot="T-q"] .view').focus();
    const seen = [];
    for (let k = 0; k < 40; ++k) {
      const at = await page.evaluate(() => {
        const element = document.activeElement;
        const plot = element.closest(".plot");
        const style = getComputedStyle(element);
        return { name: plot ? plot.dataset.plot : element.id || element.textContent || element.type,
                 inside: Boolean(element.closest("#review")),
                 outline: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2 };
      });
      if (!at.inside) break;
      seen.push(at.name);
      assert.ok(k === 0 || at.outline, `${at.name} shows no focus`);
      await page.keyboard.press("Tab");
    }
    assert.deepEqual(seen, ["T-q", "checkbox", "checkbox", "+", "−", "←", "→", "↑", "↓", "Home: show all", "Box zoom",
                            "Full window", "CSV", "SVG", "PNG", "review-reading-model", "Keys, mouse and fingers", "T-t", "q-t", "z-q", "dz-q",
                            "checkbox", "Close-up of the chosen one", ...Array(2).fill("checkbox"), "f-w", "e-w",
                            "review-slider", "Play", "Mark this instant", "‹", "›",
                            "review-remark", "Pin"]);
  }));
