// How long a page is for its reader: words, tables and figures in sight, screens, printed sheets.
// As a program it prints a row for each page:
//   run.sh PACKAGES DIRECTORY length.mjs NAME.html...
import { execFileSync } from "node:child_process";
import { statSync, rmSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { open, reportPath } from "./open_report.mjs";

/// What stands in sight while nothing is unfolded. Labels of plots count as the viewer's.
export const inSight = (page) => page.evaluate(() => {
  const isSeen = (element) => element.checkVisibility() && !element.closest(".spoken, .skip, script, style, svg");
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  let words = 0;
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (isSeen(node.parentElement)) words += (node.data.match(/[^\s]*[\p{L}\p{N}][^\s]*/gu) || []).length;
  }
  const count = (selector) => [...document.querySelectorAll(selector)].filter(isSeen).length;
  return { words, tables: count("table"), figures: count("figure"), height: document.documentElement.scrollHeight };
});

/// A4, as the page's own style asks for.
export async function sheetsOf(page, name) {
  const file = reportPath(`${name}-length.pdf`);
  await page.pdf({ path: file, format: "A4", preferCSSPageSize: true });
  const sheets = Number(execFileSync("pdfinfo", [file], { encoding: "utf8" }).match(/Pages: +(\d+)/)[1]);
  rmSync(file);
  return sheets;
}

/// Median first paint [ms] of five loads of an open page's report, each in a new page of a browser at rest: what
/// starts and ends beside a load takes the processor from it, and reads as a slow page.
async function firstPaintOf(opened) {
  const restMs = 1500;
  const times = [];
  for (let k = 0; k < 5; ++k) {
    const page = await opened.context().newPage();
    await page.waitForTimeout(restMs);
    await page.goto(opened.url());
    await page.waitForTimeout(restMs);
    // Not painted yet: later than any.
    times.push(await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? Infinity));
    await page.close();
  }
  return times.sort((a, b) => a - b)[2];
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  console.log("| page | words in sight | tables | figures | screens (1400 x 900) | printed pages | kB | first paint [ms] |");
  console.log("|---|---|---|---|---|---|---|---|");
  for (const name of process.argv.slice(2)) {
    const { page, close } = await open(name, { width: 1400, height: 900 });
    const seen = await inSight(page);
    const paint = await firstPaintOf(page);
    const sheets = await sheetsOf(page, name);
    const size = Math.round(statSync(reportPath(name)).size / 1000);
    console.log(`| ${name} | ${seen.words} | ${seen.tables} | ${seen.figures} | ${(seen.height / 900).toFixed(1)} | ${sheets} | ${size} | ${paint.toFixed(0)} |`);
    await close();
  }
  process.exit(0);
}
