// Two runs under a curtain, and the picture of their difference.
const pair = {left: null, right: null};

function comparison_of(a, b) {
  return data.comparisons.find((c) => (c.a === a.name && c.b === b.name) || (c.a === b.name && c.b === a.name));
}

function nearest(numbers, wanted) {
  return numbers.reduce((best, n) => Math.abs(n - wanted) < Math.abs(best - wanted) ? n : best, numbers[0]);
}

function show_pair() {
  for (const side of ["left", "right"]) {
    const run = pair[side];
    by_id(side).value = run.name;
    by_id(`name-${side}`).replaceChildren(name_of(run));
    const video = by_id(`video-${side}`);
    video.poster = frame_file(run, frame_at(run, state.time || first_time));
    add_video(video, run);
    if (video.hasAttribute("src")) video.src = run_file(run, "video.mp4");
  }
  by_id("curtain").style.aspectRatio = `${pair.left.width}/${pair.left.height}`;
  const found = comparison_of(pair.left, pair.right);
  by_id("difference-curve").replaceChildren(...(found?.all_frames ? [difference_curve(found)] : []));
  show_difference();
}

function difference_curve(found) {
  const rate = pair.left.frames_per_second;
  const points = found.frames.map((f) => [f.frame / rate, f.flip]);
  return draw_over_time([{points, color: palette[0]}], "mean FLIP", 170).svg;
}

function show_difference() {
  const place = by_id("difference");
  place.style.aspectRatio = `${pair.left.width}/${pair.left.height}`;
  const found = pair.left === pair.right ? undefined : comparison_of(pair.left, pair.right);
  if (!found) {
    const why = pair.left === pair.right ? "The same run on both sides."
      : "No difference pictures were made of these two: of many runs, only those with the reference are; sizes and frame rates must be equal.";
    place.replaceChildren(element("p", {}, why));
    by_id("difference-caption").textContent = "";
    return;
  }
  const rate = pair.left.frames_per_second;
  const frame = nearest(found.pictures, state.time * rate);
  const file = path_of(found.folder, `${String(frame).padStart(4, "0")}.png`);
  const shown = place.querySelector("img");
  if (shown?.getAttribute("src") !== file)
    place.replaceChildren(element("img", {src: file, alt: `FLIP difference at ${(frame / rate).toFixed(2)} s`}));
  const here = found.frames.find((f) => f.frame === frame);
  by_id("difference-caption").replaceChildren(
    element("span", {}, `FLIP at ${(frame / rate).toFixed(2)} s: ${number_text(here.flip)}, dark where they look the same`),
    element("span", {}, `mean of ${found.frames.length} ${found.all_frames ? "frames" : "pictures"} ${number_text(found.flip)}, `
      + `SSIM ${number_text(found.ssim)}`));
}

function set_pair(side, run) {
  const other = side === "left" ? "right" : "left";
  if (pair[other] === run) pair[other] = pair[side];
  pair[side] = run;
  show_pair();
}

function make_compare() {
  const reference = complete.find((run) => run.name === data.reference);
  pair.right = reference ?? complete[complete.length - 1];
  pair.left = complete.find((run) => run !== pair.right) ?? pair.right;
  for (const side of ["left", "right"]) {
    fill_select(by_id(side), complete.map((run) => [run.name, run.name]));
    by_id(side).addEventListener("change", (event) =>
      set_pair(side, complete.find((run) => run.name === event.target.value)));
  }
  by_id("swap").addEventListener("click", () => set_pair("left", pair.right));
  by_id("slider").addEventListener("input", (event) =>
    by_id("curtain").style.setProperty("--at", `${event.target.value}%`));
  show_pair();
  on_choice(() => {
    if (state.chosen.complete && state.chosen !== pair.right) set_pair("left", state.chosen);
  });
  on_time(show_difference);
}
