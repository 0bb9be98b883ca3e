// The printed report: every figure whole on one page with its heading, and nothing of the viewer.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { reportPath, withReport } from "./open_report.mjs";

function hasPoppler() {
  try {
    execFileSync("pdfimages", ["-v"], { stdio: "ignore" });
    return true;
  } catch {
    return false;
  }
}

// Sizes in points.
for (const [format, width, height] of [["A4", 595, 842], ["Letter", 612, 792]]) {
  test(`${format}: each figure stands whole on one page, under its heading; the viewer is not printed`,
    { skip: hasPoppler() ? false : "poppler-utils is not installed" },
    () => withReport("paper.html", {}, async (page) => {
      const file = reportPath(`paper-${format}.pdf`);
      const headings = await page.locator("figure:has(img) h3").evaluateAll(
        (list) => list.filter((heading) => heading.checkVisibility())  // folded figures are not printed
          .map((heading) => heading.firstChild.textContent.trim()));
      assert.ok(headings.length >= 5, headings);
      await page.pdf({ path: file, format, preferCSSPageSize: true });
      const paper = execFileSync("pdfinfo", [file], { encoding: "utf8" }).match(/Page size: +([\d.]+) x ([\d.]+)/);
      for (const [k, points] of [width, height].entries()) {
        assert.ok(Math.abs(Number(paper[k + 1]) - points) < 2, `${paper[0]} for ${format}`);
      }

      // A picture that a page's end cuts is drawn, and listed, on both pages.
      const images = execFileSync("pdfimages", ["-list", file], { encoding: "utf8" }).split("\n").slice(2)
        .map((line) => line.trim().split(/\s+/)).filter((words) => words[2] === "image");
      const pagesOf = new Map();
      for (const [at, , , width, height, , , , , , object] of images) {
        assert.ok(Number(width) >= 1000 && Number(height) >= 400, `${width} x ${height}`);
        pagesOf.set(object, [...(pagesOf.get(object) || []), Number(at)]);
      }
      assert.equal(pagesOf.size, headings.length);
      for (const [object, pages] of pagesOf) assert.equal(pages.length, 1, `object ${object} on pages ${pages}`);

      const text = execFileSync("pdftotext", ["-layout", file, "-"], { encoding: "utf8" }).split("\f");
      // A page one that is too long by a margin is followed by an empty sheet.
      for (const [k, sheet] of text.slice(0, -1).entries()) {
        assert.ok(sheet.trim().split(/\s+/).length > 10, `sheet ${k + 1} is empty`);
      }
      const lines = text.map((one) => one.split("\n").map((line) => line.trim().replace(/\s+/g, " ")));
      const found = headings.map((heading) => lines.findIndex((one) => one.includes(heading)) + 1);
      const drawn = [...pagesOf.values()].map(([at]) => at);
      assert.deepEqual(found.slice().sort((a, b) => a - b), drawn.sort((a, b) => a - b));
      for (const word of ["Review the loops", "Box zoom", "At the instant"]) {
        assert.ok(text.every((one) => !one.includes(word)), word);
      }
    }));
}

test("page one of the fullest certificate prints alone on A4, down to the signature",
  { skip: hasPoppler() ? false : "poppler-utils is not installed" },
  () => withReport("certificate.html", {}, async (page) => {
    const file = reportPath("certificate.pdf");
    await page.pdf({ path: file, format: "A4", preferCSSPageSize: true });
    const sheets = execFileSync("pdftotext", ["-layout", file, "-"], { encoding: "utf8" }).split("\f");
    for (const words of ["Results with expanded", "Friction curve", "K-2026-0117", "Joint Laboratory", "Robot User Ltd",
      "2026-11-20", "AA-12, edition 3", "simple acceptance", "D-K-15195-01-00", "Dr. A. Nowak", "Authorised by",
      "Date, signature", "torque constant 100 %"]) {
      assert.ok(sheets[0].includes(words), words);
    }
    assert.ok(sheets[1].includes("Findings") && !sheets[1].includes("Authorised by"));
  }));

test("a picture cut by a page's end would be found", { skip: !hasPoppler() && "poppler-utils is not installed" },
  () => withReport("paper.html", {}, async (page) => {
    await page.evaluate(() => {
      const images = [...document.querySelectorAll("figure img")];
      for (const image of images.slice(1)) image.closest("figure").remove();
      images[0].style.cssText = "height: 400mm; max-height: none";
    });
    const file = reportPath("cut.pdf");
    await page.pdf({ path: file, preferCSSPageSize: true });
    const rows = execFileSync("pdfimages", ["-list", file], { encoding: "utf8" }).split("\n").slice(2)
      .filter((line) => line.includes(" image "));
    assert.ok(rows.length > 1, rows.join("\n"));
  }));
