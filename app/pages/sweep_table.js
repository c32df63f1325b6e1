// The table of all runs; a click on a heading sorts by it, a second one the other way round.
const sorting = {column: null, descending: false};

/** All columns: those that differ between runs are shown, the others told below. */
function columns_now() {
  const statistic = by_id("statistic").value;
  const probes = new Set(complete.flatMap((run) => Object.keys(run.curves ?? {})));
  const columns = data.keys.map((key) => ({
    name: key, title: key_title(key), unit: "", value: (run) => run.values[key], text: (run) => value_text(run.values[key]),
  }));
  if (Object.keys(data.targets).length > 0)
    columns.push({name: "distance", title: "off the target", unit: "", bar: true,
      value: (run) => run.distance, text: (run) => number_text(run.distance)});
  for (const metric of data.metrics) {
    if (metric.name.includes(".") && probes.has(metric.name.split(".")[0])) continue;
    const name = probes.has(metric.name) ? metric.name + statistic : metric.name;
    columns.push({name, title: metric_named[name].title, unit: unit_of(name), bar: true,
      value: (run) => run.figures[name], text: (run) => figure_text(name, run.figures[name])});
  }
  return columns;
}

const is_constant = (column) => !data.keys.includes(column.name) &&
  complete.length > 1 && complete.every((run) => column.text(run) === column.text(complete[0]));

/** Numbers by size, all else by its text; what is missing comes last either way. */
function in_order(a, b, descending) {
  if (a === undefined || b === undefined) return (a === undefined) - (b === undefined);
  const order = typeof a === "number" && typeof b === "number" ? a - b : value_text(a).localeCompare(value_text(b));
  return descending ? -order : order;
}

function sort_by(column) {
  sorting.descending = sorting.column === column.name && !sorting.descending;
  sorting.column = column.name;
  draw_table();
}

function draw_table() {
  const all = columns_now();
  const columns = all.filter((column) => !is_constant(column));
  const sorted_by = columns.find((column) => column.name === sorting.column);
  const order = sorted_by
    ? [...runs].sort((a, b) => in_order(sorted_by.value(a), sorted_by.value(b), sorting.descending)) : runs;
  const head = element("tr");
  for (const column of columns)
    head.append(element("th", {scope: "col", "data-column": column.name,
      "aria-sort": column === sorted_by ? (sorting.descending ? "descending" : "ascending") : "none"},
      element("button", {type: "button", click: () => sort_by(column)}, 
        element("span", {}, column.title), element("small", {}, column.unit || "\u00a0"))));
  const rows = [];
  for (const run of order) {
    const row = element("tr", {"data-run": run.name, class: run.failure ? "failed" : "", title: run.failure || run.name,
      click: () => choose(run)});
    for (const column of columns) row.append(cell_of(column, run));
    rows.push([run, row]);
  }
  by_id("runs").tHead.replaceChildren(head);
  by_id("runs").tBodies[0].replaceChildren(...rows.map(([, row]) => row));
  draw_table.mark = () => mark_chosen(rows);
  draw_table.mark();
  const same = all.filter((column) => is_constant(column) && column.value(complete[0]) !== undefined);
  by_id("same").textContent = same.length === 0 ? "" : "The same in all runs: "
    + same.map((column) => `${column.title} ${column.text(complete[0])}${column.unit && " " + column.unit}`).join(", ") + ".";
}

/** A cell; behind numbers, a bar that is as long as the number is large. */
function cell_of(column, run) {
  const cell = element("td", {}, column.text(run));
  const value = column.value(run);
  if (column.bar && typeof value === "number") {
    const largest = Math.max(...complete.map((other) => Math.abs(column.value(other) ?? 0)));
    cell.classList.add("bar");
    cell.style.setProperty("--part", `${largest > 0 ? 100 * Math.abs(value) / largest : 0}%`);
  }
  if (column.name === data.keys[0]) {
    cell.prepend(element("span", {class: "dot", style: `background:${color_of(run)}`}));
    if (run.name === data.reference) cell.append(" ", element("span", {class: "badge"}, "reference"));
    if (run.failure) cell.append(" ", element("span", {class: "badge"}, "failed"));
  }
  return cell;
}

function make_table() {
  by_id("statistic-label").hidden = !complete.some((run) => run.curves);
  by_id("statistic").addEventListener("change", draw_table);
  if (Object.keys(data.targets).length > 0) sorting.column = "distance";
  on_choice(() => draw_table.mark());
  draw_table();
}
