// What all parts of the page share: the data, the chosen run, the time, and small helpers.
const data = JSON.parse(document.getElementById("data").textContent);
const runs = data.runs;
const complete = runs.filter((run) => run.complete);
const metric_named = Object.fromEntries(data.metrics.map((metric) => [metric.name, metric]));

const state = {chosen: null, time: 0};
const listeners = {choice: [], time: []};
const on_choice = (f) => listeners.choice.push(f);
const on_time = (f) => listeners.time.push(f);

/** Chooses a run in all parts of the page. */
function choose(run) {
  state.chosen = run;
  for (const f of listeners.choice) f();
}

function set_time(time) {
  state.time = time;
  for (const f of listeners.time) f();
}

const by_id = (id) => document.getElementById(id);

const path_of = (...parts) =>
  parts.join("/").split("/").map(encodeURIComponent).join("/");
const run_file = (run, file) => path_of("runs", run.name, file);
const frame_file = (run, frame) => run_file(run, `frames/${String(frame).padStart(4, "0")}.png`);
const duration_of = (run) => run.frames / run.frames_per_second;
const frame_at = (run, time) =>
  Math.min(run.frames - 1, Math.max(0, Math.round(time * run.frames_per_second)));

const last_part = (key) => key.split(".").pop();
/** A key as people call it: its last part, where that is not another's too. */
const key_title = (key) =>
  data.keys.filter((other) => last_part(other) === last_part(key)).length === 1 ? last_part(key) : key;
const value_text = (value) =>
  typeof value === "string" ? value : Array.isArray(value) ? value.map(value_text).join(" ") : JSON.stringify(value);

const is_percent = (name) => name.endsWith("compression");
/** A figure with the unit that unit_of() tells. */
const figure_text = (name, value) =>
  value === undefined ? "–" : number_text(is_percent(name) ? 100 * value : value);
const unit_of = (name) => is_percent(name) ? "%" : (metric_named[name]?.unit ?? "").replace("m3", "m³");
const title_of = (name) =>
  metric_named[name].title + (unit_of(name) ? ` (${unit_of(name)})` : "");

// Runs with the same value of the first key have the same colour: each its own where they are few, else from blue for
// the lowest through red to orange for the highest.
const first_value = (run) => JSON.stringify(run.values[data.keys[0]]);
const color_values = [...new Set(runs.map(first_value))];
const in_steps = color_values.length > 5 && color_values.every((value) => typeof JSON.parse(value) === "number");
if (in_steps) color_values.sort((a, b) => JSON.parse(a) - JSON.parse(b));
function color_at(i) {
  if (!in_steps) return palette[i % palette.length];
  const part = i / (color_values.length - 1);
  return `hsl(${(212 + 175 * part) % 360} ${60 + 20 * part}% ${52 - 6 * Math.sin(Math.PI * part)}%)`;
}
const color_of = (run) => color_at(color_values.indexOf(first_value(run)));

/** The values of a run, as a line of a card. */
function name_of(run) {
  const name = element("span", {class: "name"});
  for (const key of data.keys)
    name.append(element("span", {}, element("i", {}, key_title(key) + " "), element("b", {}, value_text(run.values[key]))));
  name.firstChild.prepend(element("span", {class: "dot", style: `background:${color_of(run)}`}));
  if (run.name === data.reference) name.append(element("span", {class: "badge"}, "reference"));
  return name;
}

/** What the colours mean. Of many steps, the first, the middle and the last are told. */
function make_legend() {
  const last = color_values.length - 1;
  const told = in_steps ? [0, Math.round(last / 2), last] : [...color_values.keys()].slice(0, palette.length);
  return told.map((i) => element("span", {class: "legend"},
    element("span", {class: "dot", style: `background:${color_at(i)}`}),
    `${key_title(data.keys[0])} ${value_text(JSON.parse(color_values[i]))}`));
}

function mark_chosen(elements) {
  for (const [run, node] of elements) {
    node.classList.toggle("chosen", run === state.chosen);
    if (node.hasAttribute("aria-pressed")) node.setAttribute("aria-pressed", run === state.chosen);
  }
}

function fill_select(select, options, value) {
  select.replaceChildren(...options.map(([name, title]) => element("option", {value: name}, title)));
  if (value !== undefined) select.value = value;
}
