// The tables of the fleet, which are one: sorted by a click on a head, and shortened to what is looked for.
const tables = [...document.getElementById("fleet").querySelectorAll("table")];
const columns = [...tables[0].tHead.rows[0].cells].map((_, k) => tables.map((one) => one.tHead.rows[0].cells[k]));
const rows = tables.flatMap((one) => [...one.tBodies[0].rows]);
const lengths = tables.map((one) => one.tBodies[0].rows.length);
const textOf = (row, k) => row.cells[k].textContent.trim();
const numberOf = (text) => (text === "" ? NaN : Number(text.replace("\u2212", "-")));
// What a joint has no value of comes last, whichever way it is sorted.
const compare = (a, b, way) => {
  if (a === "" || b === "") return (a === "") - (b === "");
  const [x, y] = [numberOf(a), numberOf(b)];
  return way * (Number.isNaN(x) || Number.isNaN(y) ? a.localeCompare(b, undefined, { numeric: true }) : x - y);
};
const ways = ["none", "ascending", "descending"];
const sortBy = (k) => {
  const way = ways[(ways.indexOf(columns[k][0].ariaSort || "none") + 1) % ways.length];
  for (const head of columns.flat()) head.ariaSort = null;
  for (const head of columns[k]) head.ariaSort = way;
  const sign = way === "ascending" ? 1 : -1;
  const keyed = rows.map((row) => [textOf(row, k), row]);
  if (way !== "none") keyed.sort(([a], [b]) => compare(a, b, sign));
  let first = 0;
  tables.forEach((one, i) => {
    one.tBodies[0].append(...keyed.slice(first, first + lengths[i]).map(([, row]) => row));
    first += lengths[i];
  });
};
columns.forEach((heads, k) => heads.forEach((head) => {
  const button = document.createElement("button");
  button.type = "button";
  button.append(...head.childNodes);
  button.addEventListener("click", () => sortBy(k));
  head.append(button);
}));
const find = document.getElementById("fleet-find");
const found = document.getElementById("fleet-found");
const named = [0, 1, 2, columns.length - 1];
const namesOf = rows.map((row) => named.map((k) => textOf(row, k)).join(" ").toLowerCase());
find.addEventListener("input", () => {
  const words = find.value.toLowerCase().split(/\s+/);
  let shown = 0;
  rows.forEach((row, k) => {
    row.hidden = !words.every((word) => namesOf[k].includes(word));
    shown += row.hidden ? 0 : 1;
  });
  found.textContent = `${shown} / ${rows.length}`;
});
find.closest("p").hidden = false;
