// The fleet's tables, which are one: sorted by their heads, and shortened to what is looked for.
import assert from "node:assert/strict";
import { test } from "node:test";
import { withReport } from "./open_report.mjs";

const rowsOf = (page) => page.evaluate(() =>
  [...document.querySelectorAll("#fleet tbody tr")].filter((row) => !row.hidden)
    .map((row) => [...row.cells].map((cell) => cell.textContent.trim())));
const headsOf = (page) => page.evaluate(() =>
  [...document.querySelectorAll("#fleet table:first-child thead th")].map((head) => head.textContent.trim()));
const numberOf = (text) => Number(text.replace("−", "-"));

test("a head sorts the joints of all tables upwards, downwards and back", () =>
  withReport("fleet.html", {}, async (page) => {
    const given = await rowsOf(page);
    assert.equal(given.length, 120);
    assert.ok(await page.locator("#fleet table").count() > 1);
    const heads = await headsOf(page);
    const column = heads.findIndex((head) => head.startsWith("Coulomb torque"));
    assert.ok(column > 0, heads.join());
    // By a click on that of the last table, then by keys.
    const click = page.locator("#fleet table").last().locator("thead button").nth(column);
    await click.click();
    const values = async () => (await rowsOf(page)).map((row) => numberOf(row[column]));
    const upwards = await values();
    assert.deepEqual(upwards, [...upwards].sort((a, b) => a - b));
    assert.equal(await page.locator('#fleet [aria-sort="ascending"]').count(), await page.locator("#fleet table").count());
    await page.locator("#fleet thead button").nth(column).focus();
    await page.keyboard.press("Enter");
    assert.deepEqual(await values(), [...upwards].reverse());
    await page.keyboard.press("Enter");
    assert.deepEqual(await rowsOf(page), given);
    await page.locator("#fleet thead button").first().click();
    const robots = (await rowsOf(page)).map((row) => row[0]);
    assert.deepEqual(robots, [...robots].sort((a, b) => a.localeCompare(b, undefined, { numeric: true })));
  }));

test("what is looked for leaves its joints alone", () =>
  withReport("fleet.html", {}, async (page) => {
    const given = await rowsOf(page);
    const [robot, joint] = given[50];
    const find = page.getByRole("searchbox");
    await find.fill(`${robot.split(" ")[0].toLowerCase()} ${joint}`);
    const left = await rowsOf(page);
    assert.ok(left.length >= 1 && left.length < 10, left.length);
    for (const row of left) assert.ok(row.slice(0, 2).join(" ").includes(joint));
    assert.equal(await page.locator("#fleet-found").textContent(), `${left.length} / 120`);
    await find.fill(given[7].at(-1));
    assert.deepEqual((await rowsOf(page)).map((row) => row.at(-1)), [given[7].at(-1)]);
    await find.fill("");
    assert.deepEqual(await rowsOf(page), given);
  }));
