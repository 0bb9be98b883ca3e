// The report is read in two minutes: few words in sight, few sheets, page one alone on the first.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { rmSync, statSync } from "node:fs";
import { test } from "node:test";
import { inSight, sheetsOf } from "./length.mjs";
import { everyCase, reportPath, withReport } from "./open_report.mjs";

function hasPoppler() {
  try {
    execFileSync("pdfinfo", ["-v"], { stdio: "ignore" });
    return true;
  } catch {
    return false;
  }
}

for (const name of ["paper.html", "noisy.html", "polish.html", "regenerated.html"]) {
  test(`${name}: at most 3,000 words in sight, and 12 printed pages`,
    { skip: !hasPoppler() && "poppler-utils is not installed" },
    () => withReport(name, {}, async (page) => {
      const { words } = await inSight(page);
      const sheets = await sheetsOf(page, name);
      console.log(`# ${name}: ${words} words, ${sheets} sheets`);
      assert.ok(words <= 3000 && words > 500, words);
      assert.ok(sheets <= 12, sheets);
    }));
}

test("the paper's page has all 22 figures in less than 2 MB", () => withReport("regenerated.html", {}, async (page) => {
  assert.equal(await page.locator("figure:has(img)").count(), 22);
  assert.ok(statSync(reportPath("regenerated.html")).size < 2e6);
}));

test("the plan goes to the robot on two sheets", { skip: !hasPoppler() && "poppler-utils is not installed" },
  () => withReport("plan.html", {}, async (page) => assert.equal(await sheetsOf(page, "plan.html"), 2)));

for (const format of ["A4", "Letter"]) {
  test(`page one is the first sheet of ${format}, whole, with its signature; each sheet has number and page`,
    { skip: hasPoppler() ? !everyCase && format === "Letter" && "each night" : "poppler-utils is not installed" },
    () => withReport("noisy.html", {}, async (page) => {
      const file = reportPath(`first-${format}.pdf`);
      await page.pdf({ path: file, format });
      const sheets = execFileSync("pdftotext", ["-layout", file, "-"], { encoding: "utf8" }).split("\f").slice(0, -1);
      rmSync(file);
      const number = await page.locator(".kicker bdi").textContent();
      assert.match(number, /^tribolog-[0-9a-f]{12}$/);
      for (const text of ["Date, signature", "Decision rule", "Friction curve", "Gravity torque"]) {
        assert.ok(sheets[0].includes(text), `${text} is not on page one`);
      }
      assert.ok(sheets[1].includes("Findings"), sheets[1].slice(0, 300));
      for (const [k, sheet] of sheets.entries()) {
        assert.ok(sheet.includes(number), `page ${k + 1} has no number`);
        assert.match(sheet, new RegExp(`(^|\\s)${k + 1}\\s*/\\s*${sheets.length}\\s*$`), `page ${k + 1} does not say so`);
      }
    }));
}

// Every width from a small phone to a wide screen.
for (const width of everyCase ? [360, 390, 480, 600, 768, 899, 900, 1024, 1400, 1920, 2560] : [360, 899, 1100, 2560]) {
  test(`nothing is cut or scrolls sideways at ${width} px, folded or not`, () =>
    withReport("noisy.html", { width }, async (page) => {
      for (const unfolded of [false, true]) {
        if (unfolded) await page.evaluate(() => document.querySelectorAll("details").forEach((d) => { d.open = true; }));
        const faults = await page.evaluate(() => {
          const found = [];
          if (document.documentElement.scrollWidth > innerWidth) found.push("the page scrolls sideways");
          for (const box of document.querySelectorAll(".table-box")) {
            if (box.checkVisibility() && box.scrollWidth > box.clientWidth + 1) {
              found.push(`${box.id}: ${box.scrollWidth} in ${box.clientWidth}`);
            }
          }
          return found;
        });
        assert.deepEqual(faults, [], unfolded ? "unfolded" : "folded");
      }
    }));
}
