// Pan and zoom by wheel, keys, buttons, box, drag and two fingers; what shares a quantity follows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNear, focusPlot, plotOf, press, screenOf, settled, withReport } from "./open_report.mjs";

const span = ([low, high]) => high - low;
const button = (page, name) => page.getByRole("button", { name, exact: true });

function assertRange(actual, expected, full, message) {
  assertNear(actual[0], expected[0], full, message);
  assertNear(actual[1], expected[1], full, message);
}

test("the wheel zooms about the cursor once the plot has the focus, and scrolls the page before", () =>
  withReport("noisy.html", {}, async (page) => {
    await page.locator('[data-plot="T-q"]').scrollIntoViewIfNeeded();
    const full = await plotOf(page, "T-q");
    let at = { x: full.left + 0.3 * full.width, y: full.top + 0.4 * full.height };
    await page.mouse.move(at.x, at.y);
    const scrolled = await page.evaluate(() => scrollY);
    await page.mouse.wheel(0, 120);
    await page.waitForFunction((before) => scrollY > before, scrolled);
    const unchanged = await plotOf(page, "T-q");
    assert.deepEqual([unchanged.x, unchanged.y], [full.x, full.y]);

    await page.evaluate((y) => scrollTo(0, y), scrolled);
    await focusPlot(page, "T-q");
    const before = await plotOf(page, "T-q");
    at = { x: before.left + 0.3 * before.width, y: before.top + 0.4 * before.height };
    await page.mouse.move(at.x, at.y);
    await page.mouse.wheel(0, -200);
    const after = await plotOf(page, "T-q");
    const share = span(after.x) / span(full.x);
    assert.ok(share > 0.5 && share < 0.9, share);
    const kept = { x: full.x[0] + 0.3 * span(full.x), y: full.y[1] - 0.4 * span(full.y) };
    const now = screenOf(after, kept.x, kept.y);
    assert.ok(Math.hypot(now.x - at.x, now.y - at.y) < 1, JSON.stringify([now, at]));
  }));

test("plots that share a quantity move together; reset shows all", () =>
  withReport("noisy.html", {}, async (page) => {
    const all = {};
    for (const id of ["T-q", "z-q", "dz-q", "T-t", "q-t"]) all[id] = await plotOf(page, id);
    await focusPlot(page, "T-q");
    await page.keyboard.press("+");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    const changed = await plotOf(page, "T-q");
    const { x, y } = all["T-q"];
    // 0.8 of the range about its middle, moved by a tenth of what is left.
    assertRange(changed.x, [x[0] + 0.18 * span(x), x[0] + 0.98 * span(x)], x, "x");
    assertRange(changed.y, [y[0] + 0.18 * span(y), y[0] + 0.98 * span(y)], y, "y");
    assert.deepEqual((await plotOf(page, "z-q")).x, changed.x);
    assert.deepEqual((await plotOf(page, "dz-q")).x, changed.x);
    assert.deepEqual((await plotOf(page, "q-t")).y, changed.x);
    assert.deepEqual((await plotOf(page, "T-t")).y, changed.y);
    assert.deepEqual((await plotOf(page, "T-t")).x, all["T-t"].x);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("-");
    const back = await plotOf(page, "T-q");
    assertRange(back.x, x, x, "x back");
    await button(page, "Zoom in").click();
    assertRange((await plotOf(page, "T-q")).y,
                [y[0] + 0.15 * span(y), y[1] - 0.15 * span(y)], y, "button");
    const zoomed = await plotOf(page, "T-q");
    for (const [name, axis, by] of [["Move left", "x", -0.2], ["Move up", "y", 0.2]]) {
      await button(page, name).click();
      const { [axis]: now } = await plotOf(page, "T-q");
      const was = zoomed[axis];
      assertRange(now, was.map((end) => end + by * span(was)), was, name);
    }
    await button(page, "Home: show all").click();
    for (const id in all) {
      const plot = await plotOf(page, id);
      assertRange(plot.x, all[id].x, all[id].x, id);
      assertRange(plot.y, all[id].y, all[id].y, id);
    }
    await focusPlot(page, "z-q");
    await button(page, "Zoom out").click();
    await page.keyboard.press("Tab");
    await focusPlot(page, "z-q");
    await page.keyboard.press("0");
    assertRange((await plotOf(page, "z-q")).y, all["z-q"].y, all["z-q"].y, "key 0");
  }));

test("a box, by its button or by Shift, becomes the range; a drag moves it", () =>
  withReport("noisy.html", {}, async (page) => {
    await focusPlot(page, "T-t");
    const full = await plotOf(page, "T-t");
    const drag = async (plot, from, to) => {
      await page.mouse.move(plot.left + from[0] * plot.width, plot.top + from[1] * plot.height);
      await page.mouse.down();
      await page.mouse.move(plot.left + (from[0] + to[0]) / 2 * plot.width,
                            plot.top + (from[1] + to[1]) / 2 * plot.height);
      await page.mouse.move(plot.left + to[0] * plot.width, plot.top + to[1] * plot.height);
      await page.mouse.up();
    };
    const rough = (range, share) => range[0] + share * span(range);
    const assertClose = (actual, expected, range, message) => {  // the mouse has whole pixels
      actual.forEach((value, k) =>
        assert.ok(Math.abs(value - expected[k]) < 0.006 * span(range), `${message}: ${actual}, ${expected}`));
    };
    await page.keyboard.down("Shift");
    await drag(full, [0.6, 0.7], [0.2, 0.3]);
    await page.keyboard.up("Shift");
    let plot = await plotOf(page, "T-t");
    assertClose(plot.x, [rough(full.x, 0.2), rough(full.x, 0.6)], full.x, "x");
    assertClose(plot.y, [rough(full.y, 0.3), rough(full.y, 0.7)], full.y, "y");

    const before = plot;
    await drag(plot, [0.5, 0.5], [0.25, 0.75]);
    plot = await plotOf(page, "T-t");
    assertClose(plot.x, before.x.map((v) => v + 0.25 * span(before.x)), before.x, "dragged x");
    assertClose(plot.y, before.y.map((v) => v + 0.25 * span(before.y)), before.y, "dragged y");

    await button(page, "Home: show all").click();
    await button(page, "Box zoom").click();
    assert.equal(await button(page, "Box zoom").getAttribute("aria-pressed"), "true");
    await page.locator('[data-plot="z-q"]').scrollIntoViewIfNeeded();
    const z = await plotOf(page, "z-q");
    await drag(z, [0.1, 0.1], [0.5, 0.6]);
    plot = await plotOf(page, "z-q");
    assertClose(plot.x, [rough(z.x, 0.1), rough(z.x, 0.5)], z.x, "box x");
    assertClose(plot.y, [rough(z.y, 0.4), rough(z.y, 0.9)], z.y, "box y");
  }));

test("the cursor's place is told in the units of the axes", () =>
  withReport("noisy.html", {}, async (page) => {
    await focusPlot(page, "T-q");
    const plot = await plotOf(page, "T-q");
    const at = screenOf(plot, -42, 4.2);
    await page.mouse.move(at.x, at.y);
    const text = await page.locator('[data-plot="T-q"] .cursor').innerText();
    const [q, T] = text.replace("−", "-").split(", ").map(Number);
    assert.ok(Math.abs(q + 42) < span(plot.x) / plot.width && Math.abs(T - 4.2) < 2 * span(plot.y) / plot.height, text);
    await page.mouse.move(2, 2);
    assert.equal(await page.locator('[data-plot="T-q"] .cursor').innerText(), "");
  }));

test("zoom and pan have ends", () =>
  withReport("noisy.html", {}, async (page) => {
    await focusPlot(page, "z-q");
    const full = await plotOf(page, "z-q");
    await press(page, ["z-q"], "+", 60);
    let plot = await plotOf(page, "z-q");
    assert.ok(Math.abs(span(plot.x) / span(full.x) - 1e-4) < 1e-8);
    await press(page, ["z-q"], "-", 80);
    await press(page, ["z-q"], "ArrowRight", 30);
    plot = await plotOf(page, "z-q");
    assert.ok(span(plot.x) <= 1.5 * span(full.x) * (1 + 1e-9));
    assert.ok((plot.x[0] + plot.x[1]) / 2 <= full.x[1] * (1 + 1e-9), "the data stay in sight");
  }));

test("fingers: a tap reads, then one finger moves and two zoom; before, the page scrolls", () =>
  withReport("noisy.html", { width: 390, height: 844, hasTouch: true, isMobile: true },
    async (page, { context }) => {
      const view = page.locator('[data-plot="T-q"] .view');
      const action = () => view.evaluate((element) => getComputedStyle(element).touchAction);
      await page.evaluate(() => document.querySelector('[data-plot="T-q"]').scrollIntoView({ block: "center" }));
      assert.equal(await action(), "pan-y");
      const full = await plotOf(page, "T-q");
      const sample = await page.locator("#review-slider").inputValue();
      await page.touchscreen.tap(full.left + 0.6 * full.width, full.top + 0.1 * full.height);
      await settled(page);
      assert.notEqual(await page.locator("#review-slider").inputValue(), sample);
      assert.equal(await action(), "none");

      const session = await context.newCDPSession(page);
      const touch = (type, points) => session.send("Input.dispatchTouchEvent", {
        type, touchPoints: points.map(([x, y], id) => (
          { x: full.left + x * full.width, y: full.top + y * full.height, id })),
      });
      await touch("touchStart", [[0.4, 0.5], [0.6, 0.5]]);
      for (const d of [0.15, 0.2, 0.3, 0.4]) await touch("touchMove", [[0.5 - d, 0.5], [0.5 + d, 0.5]]);
      await touch("touchEnd", []);
      const near = await plotOf(page, "T-q");
      assert.ok(Math.abs(span(near.x) / span(full.x) - 0.25) < 0.03, span(near.x) / span(full.x));
      const middle = (range) => (range[0] + range[1]) / 2;
      assert.ok(Math.abs(middle(near.x) - middle(full.x)) < 0.03 * span(full.x));

      await touch("touchStart", [[0.5, 0.5]]);
      for (const d of [0.1, 0.2, 0.3]) await touch("touchMove", [[0.5 - d, 0.5 + d]]);
      await touch("touchEnd", []);
      const moved = await plotOf(page, "T-q");
      assert.ok(Math.abs(moved.x[0] - near.x[0] - 0.3 * span(near.x)) < 0.03 * span(near.x));
      assert.ok(Math.abs(moved.y[0] - near.y[0] - 0.3 * span(near.y)) < 0.03 * span(near.y));
      assert.deepEqual((await plotOf(page, "z-q")).x, moved.x);
    }));

const hintsOf = (page) => page.evaluate(() => [...document.querySelectorAll("#review .plot")]
  .filter((plot) => plot.querySelector(".lost").checkVisibility()).map((plot) => plot.dataset.plot));

test("there is always a way back: a hint where no data are in sight, Home by key and button, a double click", () =>
  withReport("noisy.html", {}, async (page) => {
    await focusPlot(page, "T-q");
    const all = {};
    for (const id of ["T-q", "z-q", "T-t", "q-t"]) all[id] = await plotOf(page, id);
    const assertHome = async (what) => {
      for (const id in all) {
        const plot = await plotOf(page, id);
        assertRange(plot.x, all[id].x, all[id].x, `${what}: ${id}`);
        assertRange(plot.y, all[id].y, all[id].y, `${what}: ${id}`);
      }
      assert.deepEqual(await hintsOf(page), []);
    };
    assert.deepEqual(await hintsOf(page), []);
    // The middle of the loop is empty; in T(t) the torque crosses what is left of its range.
    await press(page, ["T-q"], "+", 40);
    const lost = await hintsOf(page);
    assert.ok(lost.includes("T-q") && !lost.includes("T-t") && !lost.includes("f-w"), lost.join());
    await page.waitForFunction(() => document.querySelector("#review [role=status]").textContent.includes("Home"));
    await page.keyboard.press("Home");
    await assertHome("key");

    await press(page, ["T-q"], "+", 40);
    const hint = page.locator('[data-plot="T-q"] .lost');
    assert.match(await hint.innerText(), /No data in sight\.\s*Show all\s*or press Home/);
    const box = await hint.getByRole("button").boundingBox();
    assert.ok(box.width >= 24 && box.height >= 24, JSON.stringify(box));
    await hint.getByRole("button").click();
    await assertHome("button in the plot");
    assert.equal(await page.evaluate(() => document.activeElement.closest(".plot").dataset.plot), "T-q");

    // From a control that has no use for the key, too; where it has one, it stays.
    await press(page, ["z-q"], "+", 3);
    await page.locator("#review-slider").focus();
    await page.keyboard.press("Home");
    assert.equal(await page.locator("#review-slider").inputValue(), "0");
    assert.notDeepEqual((await plotOf(page, "z-q")).y, all["z-q"].y);
    await button(page, "Box zoom").focus();
    await page.keyboard.press("Home");
    await assertHome("key on a button");

    // Of one plot: what it does not share with others stays.
    await press(page, ["T-q", "T-t"], "+", 3);
    const near = await plotOf(page, "T-t");
    const plot = await plotOf(page, "T-q");
    await page.mouse.dblclick(plot.left + 0.5 * plot.width, plot.top + 0.5 * plot.height);
    const back = await plotOf(page, "T-q");
    assertRange(back.x, all["T-q"].x, all["T-q"].x, "double click, x");
    assertRange(back.y, all["T-q"].y, all["T-q"].y, "double click, y");
    assert.deepEqual((await plotOf(page, "T-t")).x, near.x);
  }));
