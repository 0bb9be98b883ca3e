// What others bring into the file does not run: markup in names, and markup planted in a copy.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { everyCase, open, reportPath, settled, withReport } from "./open_report.mjs";

/// Elements and their attributes' names, in order; with JavaScript, the viewer's own too.
const skeletonOf = (page) => page.evaluate(() =>
  [...document.querySelectorAll("*")].map((element) =>
    [element.localName, element.className.baseVal ?? element.className,
     ...[...element.attributes].map(({ name }) => name).sort()].join(" ")));

for (const javaScriptEnabled of everyCase ? [true, false] : [true]) {
  test(`names full of markup leave the page as it is, JavaScript ${javaScriptEnabled ? "on" : "off"}`, async () => {
    const seen = [];
    for (const name of ["harmless.html", "hostile.html"]) {
      await withReport(name, { javaScriptEnabled }, async (page) => {
        if (javaScriptEnabled) {
          await settled(page);
          for (const radio of await page.locator("#review fieldset input").all()) await radio.check();
          await page.locator('[data-plot="f-w"] .view').press("PageDown");
          await settled(page);
        }
        seen.push(await skeletonOf(page));
        assert.equal(await page.evaluate(() => window.ran), undefined);
        await page.evaluate(() => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
        const text = await page.locator("body").innerText();
        const times = text.split("<script>window.ran=1").length - 1;
        assert.ok(name === "harmless.html" ? times === 0 : times > 20, `${name}: shown ${times} times`);
        if (javaScriptEnabled && name === "hostile.html") {
          assert.match(await page.locator("#review-run").innerText(), /<img src=x onerror=window.ran=1>/);
        }
      });
    }
    assert.ok(seen[0].length > 1000);
    assert.deepEqual(seen[1], seen[0]);
  });
}

const planted = '<script>window.ran=1</script><img src=x onerror="window.ran=2">' +
  '<p onclick="window.ran=3" id="planted">x</p><iframe srcdoc="<script>parent.ran=4</script>"></iframe>' +
  '<link rel="stylesheet" href="https://example.invalid/x.css"><form action="https://example.invalid"></form>';

test("markup planted in a copy of the file does not run, and the viewer still does", async () => {
  const html = readFileSync(reportPath("noisy.html"), "utf8");
  const withPlant = html.replace('<main id="content">', '<main id="content">' + planted);
  assert.notEqual(withPlant, html);
  writeFileSync(reportPath("planted.html"), withPlant);
  const { page, problems, context } = await open("planted.html");
  await page.locator("#planted").click();
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => window.ran), undefined);
  assert.ok(await page.locator("#review").isVisible());
  assert.ok(problems.some((text) => /Content Security Policy/.test(text)), problems.join("\n"));
  assert.ok(!problems.some((text) => /^error|^dialog/.test(text)), problems.join("\n"));
  await context.close();

  // The same plant without the policy: it is the policy that stops it.
  writeFileSync(reportPath("unguarded.html"), withPlant.replace(/<meta http-equiv="Content-Security-Policy"[^>]*>/, ""));
  const unguarded = await open("unguarded.html");
  await unguarded.page.waitForFunction(() => window.ran !== undefined);
  await unguarded.context.close();
});

test("a changed script does not run", async () => {
  const html = readFileSync(reportPath("noisy.html"), "utf8");
  writeFileSync(reportPath("changed.html"), html.replace('<script>"use strict";', '<script>window.ran=1;"use strict";'));
  const { page, context } = await open("changed.html");
  assert.equal(await page.evaluate(() => window.ran), undefined);
  assert.equal(await page.locator("#review").isVisible(), false);
  await context.close();
});

test("the policy allows what the page has, and nothing else", () =>
  withReport("paper.html", {}, async (page) => {
    const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute("content");
    assert.match(policy, new RegExp("^default-src 'none'; img-src data:; style-src 'sha256-[\\w+/]{43}='; " +
      "script-src 'sha256-[\\w+/]{43}='; base-uri 'none'; form-action 'none'$"));
    assert.equal(await page.evaluate(() => document.querySelectorAll("[style]").length), 0);
    const handlers = await page.evaluate(() => [...document.querySelectorAll("*")]
      .flatMap((element) => [...element.attributes]).filter(({ name }) => name.startsWith("on")).length);
    assert.equal(handlers, 0);
  }));
