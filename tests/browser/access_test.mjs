// axe-core's judgement of the whole report: light and dark, wide and narrow, the viewer in use.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { axePath, focusPlot, settled, withReport } from "./open_report.mjs";

const axe = readFileSync(axePath, "utf8");

async function violationsOf(page, part = "html") {
  await page.evaluate(axe);
  const { violations, passes } = await page.evaluate((selector) => window.axe.run(selector, {
    resultTypes: ["violations"],
    rules: { "target-size": { enabled: true } },
  }), part);
  assert.ok(passes.length > 10, `axe-core has looked: ${passes.length}`);
  return violations.map((one) => `${one.id}: ${one.help}: ` +
    one.nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(" | "));
}

const views = [["paper.html", "light", 1400, "html"], ["noisy.html", "light", 390, "html"],
               ["paper.html", "dark", 1400, "html"], ["noisy.html", "dark", 768, "#review"]];
for (const [name, colorScheme, width, part] of views) {
  test(`${name}, ${colorScheme}, ${width} px, ${part}: axe-core finds no violation`, () =>
    withReport(name, { width, colorScheme }, async (page) => {
      await focusPlot(page, "T-q");
      await page.keyboard.press("c");
      await page.getByRole("button", { name: "Box zoom" }).click();
      await page.getByRole("button", { name: "Close-up" }).click();
      await settled(page);
      assert.deepEqual(await violationsOf(page, part), []);
    }));
}

test("a fault would be found", () =>
  withReport("noisy.html", {}, async (page) => {
    await page.evaluate(() => document.querySelector("#review .view").removeAttribute("aria-label"));
    await page.evaluate(() => { document.querySelector("#review .help").style.color = "#bbbbbb"; });
    const found = (await violationsOf(page, "#review")).map((text) => text.split(":")[0]);
    assert.ok(found.includes("color-contrast"), found.join());
  }));

test("every control is reached by Tab, in the order of the page, and its focus is seen", () =>
  withReport("noisy.html", {}, async (page) => {
    await page.getByRole("button", { name: "Zoom in" }).focus();
    const seen = [];
    for (let k = 0; k < 20; ++k) {
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
    assert.deepEqual(seen, ["+", "−", "Box zoom", "Reset", "review-reading-midline", "checkbox",
                            "T-q", "z-q", "dz-q", "T-t", "q-t", "review-slider", "Play", "checkbox",
                            "Close-up of the chosen one", "f-w", "e-w"]);
  }));
