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
// A pen that writes SVG: as much of a canvas as the plots' own drawing uses.
const svgPen = () => {
  const elements = [];
  let path = "";
  let dash = [];
  const round = (...values) => values.map((value) => Number(value.toFixed(2))).join(" ");
  const add = (look) => elements.push(draw("path", { d: path, ...look }));
  const pen = {
    elements,
    beginPath: () => { path = ""; },
    moveTo: (x, y) => { path += "M" + round(x, y); },
    lineTo: (x, y) => { path += "L" + round(x, y); },
    arc: (x, y, r) => { path += `M${round(x - r, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`; },
    setLineDash: (lengths) => { dash = lengths; },
    fill: () => add({ fill: pen.fillStyle }),
    stroke: () => add({ fill: "none", stroke: pen.strokeStyle, "stroke-width": pen.lineWidth,
                        "stroke-dasharray": dash.join(" "), "stroke-linejoin": "round" }),
    strokeRect: (x, y, width, height) => {
      path = `M${round(x, y)}h${width}v${height}h${-width}Z`;
      pen.stroke();
    },
  };
  return pen;
};
// With the style that the page gives it.
const styledCopy = (element) => {
  const copy = element.cloneNode(false);
  const style = getComputedStyle(element);
  for (const name of ["fill", "stroke", "stroke-width", "font-size", "font-weight", "paint-order"]) {
    copy.setAttribute(name, style.getPropertyValue(name));
  }
  copy.append(...[...element.childNodes].map((child) => (child.nodeType === Node.TEXT_NODE ? child.data : styledCopy(child))));
  return copy;
};
const titleLine = 20;
const pictureOf = (plot) => {
  const [width, height] = [plot.box.width, plot.box.height + 2 * titleLine];
  const [frame, inside] = [svgPen(), svgPen()];
  paintAxes(plot, frame);
  plot.paint(plot, inside);
  const area = { x: margin.left, y: margin.top, width: plot.width, height: plot.height };
  const write = (text, x, y, anchor) => draw("text", { x, y, "text-anchor": anchor, "font-size": 12, fill: ink }, text);
  return draw("svg", { width, height, viewBox: `0 0 ${width} ${height}`,
                       "font-family": "sans-serif" },
    draw("rect", { width, height, fill: "#ffffff" }), write(axisTitle(plot.y), 6, 14, "start"),
    write(axisTitle(plot.x), width - 6, height - 6, "end"),
    draw("g", { transform: `translate(0 ${titleLine})` }, ...frame.elements,
      draw("svg", { ...area, viewBox: Object.values(area).join(" ") }, ...inside.elements),
      styledCopy(plot.ticks), styledCopy(plot.marks)));
};
const svgText = (plot) => new XMLSerializer().serializeToString(pictureOf(plot));
const saveSvg = (plot) => download(new Blob([svgText(plot)], { type: "image/svg+xml" }), fileName(plot, "svg"));
const savePng = (plot) => {
  const picture = new Image();
  picture.addEventListener("load", () => {
    const scale = 2 * (window.devicePixelRatio || 1);
    const canvas = make("canvas", { width: scale * picture.width, height: scale * picture.height });
    canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => download(blob, fileName(plot, "png")));
  });
  picture.src = "data:image/svg+xml," + encodeURIComponent(svgText(plot));
};
const saveRemarks = () => {
  const remarks = state.remarks.map(({ place, text }) => ({ place, text }));
  download(new Blob([JSON.stringify({ report: data.report, remarks }, null, 1) + "\n"], { type: "application/json" }),
    `${data.report}_remarks.json`);
};
