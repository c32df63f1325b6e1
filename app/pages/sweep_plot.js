// Plots as SVG: axes, the runs' speed against their error, curves over time.
const plot_width = 640;

/** Round numbers within a range; powers of ten where it is logarithmic. */
function ticks_of({low, high, logarithmic}) {
  const ticks = [];
  if (logarithmic) {
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power)
      for (const digit of high / low > 300 ? [1] : [1, 2, 5]) {
        const tick = digit * 10 ** power;
        if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push(tick);
      }
    return ticks;
  }
  const raw = (high - low) / 5;
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = unit * [1, 2, 5, 10].find((factor) => factor * unit >= raw);
  for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-9); ++k) ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
}

/** A range that holds all values, with some air. */
function range_of(values, may_be_logarithmic) {
  let low = Math.min(...values), high = Math.max(...values);
  const logarithmic = may_be_logarithmic && low > 0 && high / low > 20;
  if (logarithmic) return {low: low / 1.3, high: high * 1.3, logarithmic};
  if (low > 0 && low < 0.6 * high && may_be_logarithmic) low = 0;
  const air = (high - low || Math.abs(high) || 1) * 0.07;
  return {low: low === 0 ? 0 : low - air, high: high + air, logarithmic};
}

function scale_of({low, high, logarithmic}, from, to) {
  const f = logarithmic ? Math.log : (v) => v;
  return (value) => from + (to - from) * (f(value) - f(low)) / (f(high) - f(low));
}

/** Axes with their grid. Returns the picture and where values go in it. */
function make_axes(x_range, y_range, x_title, y_title, height) {
  const svg = drawn("svg", {viewBox: `0 0 ${plot_width} ${height}`, role: "img"});
  const left = 70, bottom = height - 42, right = plot_width - 12, top = 12;
  const x = scale_of(x_range, left, right), y = scale_of(y_range, bottom, top);
  for (const tick of ticks_of(x_range))
    svg.append(drawn("line", {class: "grid", x1: x(tick), x2: x(tick), y1: top, y2: bottom}),
      drawn("text", {x: x(tick), y: bottom + 17, "text-anchor": "middle"}, number_text(tick)));
  for (const tick of ticks_of(y_range))
    svg.append(drawn("line", {class: "grid", x1: left, x2: right, y1: y(tick), y2: y(tick)}),
      drawn("text", {x: left - 7, y: y(tick) + 4, "text-anchor": "end"}, number_text(tick)));
  svg.append(drawn("path", {class: "axis", d: `M${left} ${top}V${bottom}H${right}`}),
    drawn("text", {x: (left + right) / 2, y: height - 6, "text-anchor": "middle"}, x_title),
    drawn("text", {transform: `translate(14 ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle"}, y_title));
  return {svg, x, y, top, bottom, left, right};
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
  const axes = make_axes(range_of(points.map((p) => p.x), true), range_of(points.map((p) => p.y), true),
    title_of(x_name), title_of(y_name), 420);
  const {svg, x, y} = axes;
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
    }, drawn("title", {}, `${names}\n${title_of(x_name)}: ${number_text(point.x)}\n${title_of(y_name)}: ${number_text(point.y)}`)));
    if (point.runs.length > 1)
      svg.append(drawn("text", {class: "count", x: x(point.x), y: y(point.y) + 3.5}, point.runs.length));
    if (chosen) {
      const to_left = x(point.x) > 0.6 * plot_width;
      svg.append(drawn("text", {class: "label", x: x(point.x) + (to_left ? -14 : 14), y: y(point.y) - 10,
        "text-anchor": to_left ? "end" : "start"}, state.chosen.name));
    }
  }
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

/** Curves over time; `cursor` marks the clock's time. */
function line_chart({curves, x: x_title, y: y_title, height, cursor}) {
  const all = curves.flatMap((curve) => curve.points).filter((p) => p[1] !== null);
  const axes = make_axes({low: 0, high: Math.max(0.01, ...all.map((p) => p[0]))},
    range_of(all.length ? all.map((p) => p[1]) : [0, 1], false), x_title, y_title, height);
  for (const curve of curves) {
    let pen = "M";
    const d = curve.points.map(([px, py]) => {
      if (py === null) return (pen = "M", "");
      const part = `${pen}${axes.x(px).toFixed(1)} ${axes.y(py).toFixed(1)}`;
      pen = "L";
      return part;
    }).join("");
    const line = drawn("path", {class: "curve", d: d || "M0 0", stroke: curve.color});
    if (curve.title) line.append(drawn("title", {}, curve.title));
    curve.drawn?.(line);
    axes.svg.append(line);
  }
  if (cursor) {
    const mark = drawn("line", {class: "cursor", y1: axes.top, y2: axes.bottom});
    axes.svg.append(mark);
    const move = () => {
      const at = Math.min(axes.right, axes.x(state.time));
      mark.setAttribute("x1", at);
      mark.setAttribute("x2", at);
    };
    move();
    axes.svg.move_cursor = move;
  }
  return axes.svg;
}

function draw_probes() {
  const name = by_id("probe").value;
  const lines = [];
  const curves = complete.filter((run) => run.curves?.[name]).map((run) => ({
    points: run.curves.time_s.map((time, i) => [time, run.curves[name][i]]),
    color: color_of(run), title: run.name, drawn: (line) => lines.push([run, line]),
  }));
  by_id("probes").replaceChildren(line_chart({curves, x: "time (s)", y: title_of(name), height: 420, cursor: true}));
  const mark = () => {
    mark_chosen(lines);
    const chosen = lines.find(([run]) => run === state.chosen);
    if (chosen) chosen[1].parentNode.append(chosen[1]);
  };
  for (const [run, line] of lines) line.addEventListener("click", () => choose(run));
  draw_probes.mark = mark;
  mark();
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
