// Small multiples: a row for each run, a column for each time.
function make_pictures() {
  const grid = by_id("pictures");
  const rows = [];
  grid.style.gridTemplateColumns = `minmax(120px, max-content) repeat(${data.times.length}, minmax(120px, 1fr))`;
  grid.append(element("span"));
  for (const time of data.times) grid.append(element("span", {class: "time"}, `${Number(time.toPrecision(3))} s`));
  for (const run of complete) {
    const row = element("button", {class: "row", type: "button", click: () => choose(run)}, name_of(run));
    grid.append(row);
    rows.push([run, row]);
    for (const time of data.times) {
      const frame = frame_at(run, time);
      if (time >= duration_of(run)) {
        grid.append(element("span"));
        continue;
      }
      grid.append(element("img", {
        src: frame_file(run, frame), loading: "lazy", width: run.width, height: run.height,
        style: `aspect-ratio:${run.width}/${run.height};height:auto`,
        alt: `${run.name} at ${number_text(time)} s`, title: "Choose this run and time",
        click: () => {
          set_playing(false);
          set_time(frame / run.frames_per_second);
          choose(run);
        },
      }));
    }
  }
  on_choice(() => mark_chosen(rows));
}
