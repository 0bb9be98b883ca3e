// What a plot shows, as a file: its numbers, or its picture.
const download = (blob, name) => {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};
const fileName = (plot, ending) => `${document.title.replace(/[^\p{L}\d]+/gu, "_")}_${plot.y}-${plot.x}.${ending}`;
const csvText = (columns, from, to) => {
  const quoted = columns.map(([head]) => `"${head.replaceAll('"', '""')}"`);
  const lines = [quoted.join(",")];
  for (let i = from; i < to; ++i) lines.push(columns.map(([, values]) => values[i] ?? "").join(","));
  return lines.join("\n") + "\n";
};
const headOf = (name, words) => `${words || quantities[name].words} [${quantities[name].unit}]`;
// Of a loop all columns in the time shown, of runs each curve that has a number there.
const saveCsv = (plot) => {
  const loop = loops[state.loop];
  const columns = plot.isLoop
    ? [...["t", "q", "T", "m", "z", "dz"].filter((name) => loop[name]).map((name) => [headOf(name), loop[name]]),
       ...(loop.fit ? [[headOf("T", t("T, LuGre fit")), loop.fit]] : [])]
    : [[headOf("w"), runs.w], ...(runs.value ? [[headOf("f"), runs.value]] : []),
       ...candidates.filter((one) => one[plot.y]).map((one) => [headOf(plot.y, one.words), one[plot.y]])];
  const window = plot.isLoop ? timeWindow(loop) : [0, runs.w.length];
  download(new Blob([csvText(columns, ...window)], { type: "text/csv" }), fileName(plot, "csv"));
};
const savePng = (plot) => {
  const line = 20;
  const { width, height } = plot.box;
  const scale = plot.canvas.width / width;
  const canvas = make("canvas", { width: plot.canvas.width, height: plot.canvas.height + 2 * line * scale });
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#ffffff";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(plot.canvas, 0, line * scale);
  pen.scale(scale, scale);
  const write = (text, x, y, anchor) => {
    pen.textAlign = anchor === "middle" ? "center" : anchor;
    pen.fillText(text, x, y);
  };
  pen.fillStyle = ink;
  pen.font = "12px sans-serif";
  write(axisTitle(plot.y), 6, 14, "start");
  write(axisTitle(plot.x), width - 6, height + 2 * line - 6, "end");
  pen.translate(0, line);
  for (const element of plot.svg.querySelectorAll("circle, text")) {
    const number = (name) => Number(element.getAttribute(name));
    if (element.tagName === "text") {
      write(element.textContent, number("x"), number("y"), element.getAttribute("text-anchor"));
      continue;
    }
    const { fill, stroke } = getComputedStyle(element);
    pen.beginPath();
    pen.arc(number("cx"), number("cy"), number("r"), 0, 2 * Math.PI);
    [pen.strokeStyle, pen.lineWidth] = [stroke, 2];
    pen.stroke();
    if (fill === "none") continue;
    pen.save();
    pen.fillStyle = fill;
    pen.fill();
    pen.restore();
  }
  canvas.toBlob((blob) => download(blob, fileName(plot, "png")));
};
