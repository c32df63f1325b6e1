// The plots of a sweep: the runs' speed against their error, and curves over time.

/** The range of figures: logarithmic where they are far apart, from zero on where they are not all close together. */
function range_of_figures(values) {
  const low = Math.min(...values), high = Math.max(...values);
  return range_of(values, {logarithmic: low > 0 && high / low > 20, from_zero: low > 0 && low < 0.6 * high});
}

/** The points that no other is below in both. */
function pareto_front(points) {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const front = [];
  for (const point of sorted)
    if (front.length === 0 || point.y < front[front.length - 1].y) front.push(point);
  return front;
}

/** Runs by their place in the plot; those that share one are one point. */
function plot_points(x_name, y_name) {
  const points = [];
  const factor = (name) => is_percent(name) ? 100 : 1;
  for (const run of complete) {
    const x = run.figures[x_name] * factor(x_name), y = run.figures[y_name] * factor(y_name);
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    const same = points.find((point) => point.x === x && point.y === y);
    if (same) same.runs.push(run);
    else points.push({x, y, runs: [run]});
  }
  return points;
}

/** The chosen run's point is chosen; a click on it again goes on to the next run there. */
function choose_at(point) {
  choose(point.runs[(point.runs.indexOf(state.chosen) + 1) % point.runs.length]);
}

function draw_plot() {
  const x_name = by_id("plot-x").value, y_name = by_id("plot-y").value;
  const points = plot_points(x_name, y_name);
  if (points.length === 0) {
    by_id("plot").replaceChildren(element("p", {class: "note"}, "No run has these figures."));
    return;
  }
  const {svg, x, y} = draw_axes({
    x_range: range_of_figures(points.map((p) => p.x)), y_range: range_of_figures(points.map((p) => p.y)),
    x_label: title_of(x_name), y_label: title_of(y_name), height: 420});
  const front = pareto_front(points);
  const steps = front.map((p, i) => i === 0 ? `M${x(p.x)} ${y(p.y)}` : `H${x(p.x)}V${y(p.y)}`).join("");
  svg.append(drawn("path", {class: "front", d: steps}));
  for (const point of points) {
    const chosen = point.runs.includes(state.chosen);
    const classes = ["point", front.includes(point) ? "on-front" : "off-front", chosen ? "chosen" : ""].join(" ");
    const names = point.runs.map((run) => run.name).join("\n");
    svg.append(drawn("circle", {
      class: classes, cx: x(point.x), cy: y(point.y), r: point.runs.length > 1 ? 9 : 7,
      fill: color_of(chosen ? state.chosen : point.runs[0]), tabindex: 0, role: "button",
      "aria-label": names.replaceAll("\n", " and "), "data-runs": names,
      click: () => choose_at(point),
      keydown: (event) => (event.key === "Enter" || event.key === " ") && (event.preventDefault(), choose_at(point)),
    }));
    if (point.runs.length > 1)
      svg.append(drawn("text", {class: "count", x: x(point.x), y: y(point.y) + 3.5}, point.runs.length));
    if (chosen) {
      const to_left = x(point.x) > 0.6 * plot_width;
      svg.append(drawn("text", {class: "label", x: x(point.x) + (to_left ? -14 : 14), y: y(point.y) - 10,
        "text-anchor": to_left ? "end" : "start"}, state.chosen.name));
    }
  }
  tell_values(svg, points.map((point) => ({x: x(point.x), y: y(point.y), text: () => [...point.runs.map((run) => run.name),
    `${title_of(x_name)}: ${number_text(point.x)}`, `${title_of(y_name)}: ${number_text(point.y)}`]})));
  by_id("plot").replaceChildren(svg);
}

function make_plot() {
  const names = data.metrics.map((metric) => metric.name).filter((name) =>
    complete.some((run) => run.figures[name] !== undefined));
  const options = names.map((name) => [name, metric_named[name].title]);
  fill_select(by_id("plot-x"), options, "simulation_seconds");
  fill_select(by_id("plot-y"), options, "mean_compression");
  for (const id of ["plot-x", "plot-y"]) by_id(id).addEventListener("change", draw_plot);
  by_id("plot-legend").replaceChildren(...make_legend());
  on_choice(draw_plot);
  draw_plot();
}

/** Draws curves over time, with a line at the clock's time. Returns the picture and the groups that are its curves. */
function draw_over_time(curves, y_label, height) {
  const plot = {x_label: "time (s)", y_label, curves: curves.map((curve) => ({...curve, line: true}))};
  const {svg, groups, x, top, bottom, right} = draw_curves(plot, height);
  const cursor = drawn("line", {class: "cursor", y1: top, y2: bottom});
  svg.append(cursor);
  svg.move_cursor = () => {
    const at = Math.min(right, x(state.time));
    filled(cursor, {x1: at, x2: at});
  };
  svg.move_cursor();
  return {svg, groups};
}

function draw_probes() {
  const name = by_id("probe").value;
  const shown = complete.filter((run) => run.curves?.[name]);
  const {svg, groups} = draw_over_time(shown.map((run) => ({title: run.name, color: color_of(run),
    points: run.curves.time_s.map((time, i) => [time, run.curves[name][i]])})), title_of(name), 420);
  by_id("probes").replaceChildren(svg);
  const lines = shown.map((run, i) => [run, groups[i]]);
  for (const [run, line] of lines) line.addEventListener("click", () => choose(run));
  draw_probes.mark = () => {
    mark_chosen(lines);
    const chosen = lines.find(([run]) => run === state.chosen);
    if (chosen) svg.append(chosen[1]);
  };
  draw_probes.mark();
}

function make_probes() {
  const names = data.metrics.map((metric) => metric.name).filter((name) =>
    complete.some((run) => run.curves?.[name]));
  if (names.length === 0) return;
  by_id("probes-section").hidden = false;
  by_id("probes-note").replaceChildren(...make_legend());
  fill_select(by_id("probe"), names.map((name) => [name, title_of(name)]));
  by_id("probe").addEventListener("change", draw_probes);
  on_choice(() => draw_probes.mark());
  draw_probes();
}

on_time(() => {
  for (const svg of document.querySelectorAll("#probes svg, #difference-curve svg")) svg.move_cursor?.();
});
