// Puts the page together.
function make_header() {
  const simulations = new Set(runs.map((run) => run.simulation)).size;
  const count = (n, what) => `${n} ${what}${n === 1 ? "" : "s"}`;
  const targets = Object.entries(data.targets).map(([name, value]) => `${name} = ${number_text(value)}`);
  by_id("summary").textContent = [
    `${count(runs.length, "run")} of ${count(simulations, "simulation")}`,
    `varied: ${data.keys.join(", ")}`,
    data.reference ? `reference: ${data.reference}` : "",
    targets.length ? `target: ${targets.join(", ")}` : "",
  ].filter(Boolean).join("  ·  ");
  by_id("machine").textContent = data.machine;
  const failed = runs.filter((run) => run.failure), waiting = runs.length - complete.length - failed.length;
  if (failed.length + waiting === 0) return;
  by_id("failures").hidden = false;
  if (failed.length > 0)
    by_id("failures").append(element("p", {}, `${count(failed.length, "run")} failed`),
      element("ul", {}, ...failed.map((run) => element("li", {}, `${run.name}: ${run.failure}`))));
  if (waiting > 0) by_id("failures").append(element("p", {}, `${count(waiting, "run")} not done yet`));
}

make_header();
make_videos();
make_table();
if (complete.length > 0) {
  make_player();
  make_plot();
  make_probes();
  make_compare();
  make_pictures();
  choose(complete.find((run) => run.name === data.reference) ?? complete[0]);
  set_time(first_time);
}
