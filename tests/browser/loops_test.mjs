// Scrubbing, reading and choosing in the loops, against the embedded data and the report's tables.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { assertNear, dataOf, everyCase, focusPlot, inkOf, listOf, plotOf, plotsOf, reportPath, screenOf, settled, withReport }
  from "./open_report.mjs";

const plots = [["T-q", "q", "T"], ["z-q", "q", "z"], ["dz-q", "q", "dz"], ["T-t", "t", "T"],
               ["q-t", "t", "q"]];
const number = (text) => Number(text.replace("−", "-").match(/-?[\d.]+/)[0]);

for (const name of everyCase ? ["paper.html", "noisy.html"] : ["paper.html"]) {
  test(`${name}: the slider marks the same instant in all plots`, () =>
    withReport(name, {}, async (page) => {
      const { loops: [loop] } = await dataOf(page);
      const last = loop.t.length - 1;
      await page.locator("#review-slider").focus();
      let seen = 0;
      const check = async (expected) => {
        const i = Number(await page.locator("#review-slider").inputValue());
        if (expected !== undefined) assert.equal(i, expected);
        const drawn = await plotsOf(page);
        for (const [id, x, y] of plots) {
          const plot = drawn[id];
          assertNear(plot.now.x, loop[x][i], plot.x, `${id} at ${i}, x`);
          assertNear(plot.now.y, loop[y][i], plot.y, `${id} at ${i}, y`);
        }
        const shown = await listOf(page, "review-instant");
        assert.ok(Math.abs(number(shown.T) - loop.T[i]) <= 5.1e-5);
        assert.ok(Math.abs(number(shown["q − q₀"]) - loop.q[i]) <= 5.1e-3);
        assert.ok(Math.abs(number(shown.z) - loop.z[i]) <= 5.1e-5);
        assert.ok(Math.abs(number(shown.t) - loop.t0_s - loop.t[i]) <= 5.1e-5);
        ++seen;
      };
      await check();
      await page.keyboard.press("Home");
      await check(0);
      await page.keyboard.press("ArrowRight");
      await check(1);
      await page.keyboard.press("End");
      await check(last);
      for (let k = 0; k < 6; ++k) {
        await page.keyboard.press("PageDown");
        await check();
      }
      const box = await page.locator("#review-slider").boundingBox();
      for (const share of [0.2, 0.37, 0.8]) {
        await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
        await check();
      }
      assert.equal(seen, 13);
    }));

  test(`${name}: points A to F are those of the table, in every plot`, () =>
    withReport(name, {}, async (page) => {
      const data = await dataOf(page);
      const table = await page.evaluate(() => Object.fromEntries(
        [...document.querySelectorAll("#stage-3-points tbody tr")].map((row) =>
          [row.cells[0].textContent.trim(), [...row.cells].slice(2).map((cell) => cell.textContent.trim())])));
      for (const point of data.points.first) {
        await page.locator(`#review-reading-${point.name}`).check();
        const drawn = await plotsOf(page);
        for (const [id, x, y] of plots) {
          const plot = drawn[id];
          assert.deepEqual(plot.rings.map((ring) => ring.name), [point.name], id);
          assertNear(plot.rings[0].x, point[x], plot.x, `${point.name} in ${id}, x`);
          assertNear(plot.rings[0].y, point[y], plot.y, `${point.name} in ${id}, y`);
        }
        const shown = Object.values(await listOf(page, "review-reading"));
        for (const cell of table[point.name].filter((text) => text !== "–")) {
          assert.ok(shown.some((text) => text.startsWith(cell)), `${point.name}: ${cell} of ${shown}`);
        }
        // The instant goes there too, to the nearest sample.
        const { t } = data.loops[0];
        const i = Number(await page.locator("#review-slider").inputValue());
        const nearest = Math.min(...t.map((time) => Math.abs(time - point.t)));
        assert.ok(Math.abs(Math.abs(t[i] - point.t) - nearest) < 1e-9, point.name);
      }
      assert.equal(data.points.first.length, 6);
    }));
}

test("pairs mark both points of the steady loop; the mid-line is that of the table", () =>
  withReport("noisy.html", {}, async (page) => {
    const data = await dataOf(page);
    await page.locator("#review-reading-CD").check();
    const plot = await plotOf(page, "T-q");
    assert.deepEqual(plot.rings.map((ring) => ring.name).sort(), ["C", "D"]);
    for (const ring of plot.rings) {
      const steady = data.points.steady.find((point) => point.name === ring.name);
      assertNear(ring.y, steady.T, plot.y, ring.name);
    }
    await page.locator("#review-reading-midline").check();
    const shown = await listOf(page, "review-reading");
    const cells = await page.locator("#stage-3-results tbody tr").first().textContent();  // folded
    assert.equal(shown["T at q_peak"], data.midline.text);
    assert.ok(cells.replace(/\s+/g, " ").includes(data.midline.text.split("\u00a0")[0]), cells);
  }));

test("a click reads the nearest sample, and a point where one is near", () =>
  withReport("noisy.html", {}, async (page) => {
    const data = await dataOf(page);
    const [loop] = data.loops;
    await focusPlot(page, "z-q");
    let plot = await plotOf(page, "z-q");
    const i = loop.z.findIndex((z, k) => k > 100 && z > 1 && z < 1.3 && loop.q[k] < 0);  // clear of the points
    let at = screenOf(plot, loop.q[i], loop.z[i]);
    await page.mouse.click(at.x, at.y);
    const k = Number(await page.locator("#review-slider").inputValue());
    const found = screenOf(plot, loop.q[k], loop.z[k]);
    const off = Math.hypot(found.x - at.x, found.y - at.y);  // the mouse has whole pixels
    assert.ok(off < 1, `sample ${k} for ${i}, ${off} px away`);

    const D = data.points.first.find((point) => point.name === "D");
    at = screenOf(plot, D.q, D.z);
    await page.mouse.click(at.x + 5, at.y - 4);
    assert.ok(await page.locator("#review-reading-D").isChecked());

    await focusPlot(page, "T-t");
    plot = await plotOf(page, "T-t");
    at = screenOf(plot, loop.t[700], plot.y[0]);
    await page.mouse.click(at.x, at.y - 5);
    const found700 = Number(await page.locator("#review-slider").inputValue());
    const px = plot.width / (plot.x[1] - plot.x[0]);
    assert.ok(Math.abs(loop.t[found700] - loop.t[700]) * px < 0.6);
  }));

test("keys in a plot step through samples and choose readings; the live region tells once", () =>
  withReport("noisy.html", {}, async (page) => {
    await focusPlot(page, "T-q");
    const before = Number(await page.locator("#review-slider").inputValue());
    // A pause ends when the test says so: between two keys a busy machine may take longer than one.
    await page.evaluate(() => {
      window.told = [];
      new MutationObserver(() => window.told.push(document.querySelector("#review [role=status]").textContent))
        .observe(document.querySelector("#review [role=status]"), { childList: true });
      let last = 0;
      window.pauses = new Map();
      window.setTimeout = (say, duration) => window.pauses.set(++last, { say, duration }) && last;
      window.clearTimeout = (pause) => window.pauses.delete(pause);
    });
    const endPause = async () => {
      const durations = await page.evaluate(() => {
        const ended = [...window.pauses.values()];
        window.pauses.clear();
        for (const { say } of ended) say();
        return ended.map(({ duration }) => duration);
      });
      assert.equal(durations.length, 1, `one pause, not ${durations}`);
      assert.ok(durations[0] > 200 && durations[0] < 1000, durations[0]);
    };
    for (let k = 0; k < 5; ++k) await page.keyboard.press("PageDown");
    assert.equal(Number(await page.locator("#review-slider").inputValue()), before + 5);
    await page.keyboard.press("PageUp");
    assert.equal(Number(await page.locator("#review-slider").inputValue()), before + 4);
    await endPause();
    await page.keyboard.press("e");
    assert.ok(await page.locator("#review-reading-E").isChecked());
    await page.keyboard.press("m");
    assert.ok(await page.locator("#review-reading-midline").isChecked());
    await endPause();
    const told = await page.evaluate(() => window.told);
    assert.equal(told.length, 2, "one text for each pause: " + told);
    assert.match(told[0], /T .* N·m/);
    assert.match(told[1], /^mid-line/);
  }));

test("playing moves the instant; with reduced motion it is not offered", async () => {
  await withReport("noisy.html", {}, async (page) => {
    const before = Number(await page.locator("#review-slider").inputValue());
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction((i) => Number(document.getElementById("review-slider").value) > i + 10, before);
    await page.getByRole("button", { name: "Pause" }).click();
    const stopped = await page.locator("#review-slider").inputValue();
    await page.waitForTimeout(150);
    assert.equal(await page.locator("#review-slider").inputValue(), stopped);
  });
  await withReport("noisy.html", { reducedMotion: "reduce" }, async (page) => {
    assert.ok(await page.locator("#review").isVisible());
    assert.equal(await page.getByRole("button", { name: "Play" }).count(), 0);
  });
});

// A copy of a report with other data in it; the policy does not cover data.
function altered(name, copy, change) {
  const html = readFileSync(reportPath(name), "utf8");
  const at = /(id="tribolog-loops">)(.*?)(<\/script>)/s;
  const data = JSON.parse(html.match(at)[2]);
  change(data);
  writeFileSync(reportPath(copy), html.replace(at, (_, a, b, c) => a + JSON.stringify(data) + c));
  return data;
}
test("loops are overlaid, switched and read one by one", async () => {
  const styles = [["#0072b2", "solid"], ["#d55e00", "dash"], ["#009e73", "dash_dot"]];
  const data = altered("noisy.html", "three.html", (all) => {
    const [first] = all.loops;
    all.loops = [1, 0.7, 0.4].map((share, k) => ({
      ...first, name: `log_${k + 1}.csv`, fit: undefined, midline: null,
      style: { colour: styles[k][0], line: styles[k][1] },
      q: first.q.map((q) => q * share), T: first.T.map((T) => 3.8 + (T - 3.8) * share),
      z: first.z.map((z) => z * share), dz: first.dz.map((dz) => dz * share),
    }));
    all.candidates = [];
  });
  await withReport("three.html", {}, async (page) => {
    assert.equal(await inkOf(page, "z-q", "#d55e00"), 0);
    await page.getByLabel("2: log_2.csv").check();
    await settled(page);
    assert.ok(await inkOf(page, "z-q", "#0072b2") > 300);
    assert.ok(await inkOf(page, "z-q", "#d55e00") > 150);
    await page.getByLabel("1: log_1.csv").uncheck();
    await settled(page);
    assert.equal(await inkOf(page, "z-q", "#0072b2"), 0);
    await page.getByLabel("Read and scrub").selectOption("2");
    assert.ok(await page.getByLabel("3: log_3.csv").isChecked());
    await page.locator("#review-slider").focus();
    await page.keyboard.press("End");
    const last = data.loops[2].t.length - 1;
    for (const [id, x, y] of plots) {
      const plot = await plotOf(page, id);
      assertNear(plot.now.x, data.loops[2][x][last], plot.x, id);
      assertNear(plot.now.y, data.loops[2][y][last], plot.y, id);
    }
  });
});

test("the fit can be taken away, and a part of the time leaves the rest pale", () =>
  withReport("noisy.html", {}, async (page) => {
    const { fit_style: fit } = await dataOf(page);
    assert.ok(await inkOf(page, "T-t", fit.colour) > 100);
    await page.getByRole("checkbox", { name: "LuGre fit" }).uncheck();
    await settled(page);
    assert.equal(await inkOf(page, "T-t", fit.colour), 0);
    assert.equal(await inkOf(page, "z-q", "#c3c9d0"), 0);
    await focusPlot(page, "q-t");
    for (let k = 0; k < 9; ++k) await page.keyboard.press("+");
    await settled(page);
    assert.ok(await inkOf(page, "z-q", "#c3c9d0") > 100);
  }));

test("two calibrations' loops are laid over each other, told apart by colour and dashes", () =>
  withReport("diff.html", {}, async (page) => {
    const { loops: [a, b] } = await dataOf(page);
    const ink = async (loop) => (await settled(page), inkOf(page, "T-q", loop.style.colour));
    assert.deepEqual([a.style.line, b.style.line], ["solid", "dash"]);
    assert.ok(await ink(a) > 100 && await ink(b) > 100);
    await page.getByLabel(b.label).first().uncheck();
    assert.equal(await ink(b), 0);
    assert.ok(await ink(a) > 100);
    await page.getByLabel("Read and scrub").selectOption({ label: b.label });
    await page.locator("#review-slider").focus();
    await page.keyboard.press("Home");
    for (const [id, x, y] of [["T-q", "q", "T"], ["T-t", "t", "T"], ["q-t", "t", "q"]]) {
      const plot = await plotOf(page, id);
      assertNear(plot.now.x, b[x][0], plot.x, id);
      assertNear(plot.now.y, b[y][0], plot.y, id);
    }
    assert.equal((await listOf(page, "review-instant")).Phase, "0.0 °");
    assert.equal(b.q[0], Math.max(...b.q));
  }));

test("two calibrations' friction curves are laid over each other; a click reads the nearer one", () =>
  withReport("diff.html", {}, async (page) => {
    const { runs, curves: [a, b] } = await dataOf(page);
    const ink = async ({ style }) => (await settled(page), inkOf(page, "f-w", style.colour));
    assert.ok(await ink(a) > 100 && await ink(b) > 100);
    await focusPlot(page, "f-w");
    const readAt = async (i) => {
      const plot = await plotOf(page, "f-w");
      const at = screenOf(plot, runs.w[i], runs.value[i]);
      await page.mouse.click(at.x, at.y);
      return page.locator("#review-run").textContent();
    };
    // Both have the same speeds: the height tells them apart.
    for (let k = 0; k < 9; ++k) await page.keyboard.press("+");
    await page.keyboard.press("Home");
    const last = b.to - 1;
    await page.getByRole("group", { name: "friction torque" }).getByLabel(a.label).uncheck();
    assert.equal(await ink(a), 0);
    const words = await readAt(last);
    assert.ok(words.startsWith(b.label) && words.includes(runs.value_texts[last]), words);
    const { now, x, y } = await plotOf(page, "f-w");
    assertNear(now.x, runs.w[last], x, "speed");
    assertNear(now.y, runs.value[last], y, "friction");
  }));

test("the misfit is the measured torque less the fitted one, drawn once it is asked for", () =>
  withReport("noisy.html", {}, async (page) => {
    const { loops: [loop], fit_style: fit } = await dataOf(page);
    assert.equal((await plotsOf(page))["m-q"], undefined);
    await page.getByRole("checkbox", { name: "misfit" }).check();
    await page.locator("#review-slider").focus();
    for (const key of ["End", "PageDown", "Home", "ArrowRight"]) {
      await page.keyboard.press(key);
      const i = Number(await page.locator("#review-slider").inputValue());
      for (const [id, x] of [["m-q", "q"], ["m-t", "t"]]) {
        const plot = await plotOf(page, id);
        assertNear(plot.now.x, loop[x][i], plot.x, id);
        assertNear(plot.now.y, loop.T[i] - loop.fit[i], plot.y, id);
      }
      const shown = number((await listOf(page, "review-instant")).misfit);
      assert.ok(Math.abs(shown - loop.T[i] + loop.fit[i]) <= 5.1e-5, shown);
    }
    assert.ok(await inkOf(page, "m-q", loop.style.colour) > 300);
    assert.equal(await inkOf(page, "m-q", fit.colour), 0);
  }));

// Measured as a ratio, since machines differ and tests share theirs: half a million sines take a little longer than
// the 4 ms that a pointer move may take on a free machine.
test("a pointer move with ten loops overlaid costs less script than half a million sines", async () => {
  altered("noisy.html", "ten.html", (all) => {
    const [first] = all.loops;
    // Ten loops share the room of five.
    const thinned = (values) => values && values.filter((_, k) => k % 2 === 0);
    all.loops = Array.from({ length: 10 }, (_, k) => {
      const share = 1 - 0.07 * k;
      return { ...first, name: `log_${k + 1}.csv`, midline: null, shown: true,
               ...Object.fromEntries(["t", "fit"].map((name) => [name, thinned(first[name])])),
               ...Object.fromEntries(["q", "z", "dz"].map((name) => [name, thinned(first[name]).map((v) => v * share)])),
               T: thinned(first.T).map((T) => 3.8 + (T - 3.8) * share) };
    });
  });
  await withReport("ten.html", {}, async (page, { context }) => {
    await focusPlot(page, "T-q");
    const { left, top, width, height } = await plotOf(page, "T-q");
    // The thread's own time: other work on the machine is not in it.
    const session = await context.newCDPSession(page);
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    const seconds = async () => (await session.send("Performance.getMetrics")).metrics
      .find(({ name }) => name === "ScriptDuration").value;
    const moves = 15;
    const cost = async (isMove) => {
      const before = await seconds();
      await page.evaluate(async ([x0, y0, w, h, last, isMove]) => {
        const view = document.querySelector('[data-plot="T-q"] .view');
        const send = (type, k) => view.dispatchEvent(new PointerEvent(type, {
          pointerId: 1, bubbles: true, clientX: x0 + w / 2 + 30 * Math.sin(k), clientY: y0 + h / 2 + 20 * Math.cos(k),
        }));
        const sines = (k) => {
          let sum = 0;
          for (let i = 0; i < 5e5; ++i) sum += Math.sin(i + k);
          view.dataset.sum = sum;
        };
        view.setPointerCapture = () => {};  // of a pointer that is not there
        if (isMove) send("pointerdown", 0);
        for (let k = 1; k <= last; ++k) {
          if (isMove) send("pointermove", k);
          await new Promise((done) => requestAnimationFrame(() => {
            if (!isMove) sines(k);  // where the viewer draws too
            done();
          }));
        }
        if (isMove) send("pointerup", last);
        delete view.dataset.sum;
      }, [left, top, width, height, moves, isMove]);
      return 1000 * (await seconds() - before) / moves;
    };
    // The least of some rounds: in the others the machine's other work was in the way.
    const rounds = [];
    for (let round = 0; round < 6; ++round) rounds.push([await cost(true), await cost(false)]);
    const [move, sines] = [0, 1].map((k) => Math.min(...rounds.map((round) => round[k])));
    console.log(`# a pointer move with ten loops of ${(await dataOf(page)).loops[0].t.length} samples takes ` +
      `${move.toFixed(2)} ms of script, half a million sines ${sines.toFixed(2)} ms`);
    assert.ok(move > 0.05 && move < sines, `${move} ms against ${sines} ms`);
  });
});

test("without a bristle only what exists is shown", async () => {
  altered("noisy.html", "no_bristle.html", (all) => {
    for (const name of ["z", "dz", "fit"]) delete all.loops[0][name];
    all.points = { first: [], steady: [] };
    all.candidates = all.candidates.filter(({ name }) => name.length > 2);
  });
  await withReport("no_bristle.html", {}, async (page) => {
    const shown = await page.evaluate(() =>
      [...document.querySelectorAll("#review .plot")].map((plot) => plot.dataset.plot));
    assert.deepEqual(shown, ["T-q", "T-t", "q-t", "f-w", "e-w"]);
    assert.equal(await page.locator("#review-reading-A").count(), 0);
    assert.equal((await listOf(page, "review-instant")).z, undefined);
    await focusPlot(page, "T-q");
    await page.keyboard.press("c");  // no such point: nothing happens
    assert.ok(await page.locator("#review-reading-model").isChecked());
  });
});
