// All videos on one clock. A video is loaded when it comes into view, and let go when it leaves.
const player = {playing: false, rate: 1, duration: Math.max(0.1, ...complete.map(duration_of)), videos: new Map()};
/** What the page shows at first, the middle of the times that are set side by side. */
const first_time = data.times[Math.floor(data.times.length / 2)];
const finest_rate = Math.max(1, ...complete.map((run) => run.frames_per_second));

/** Puts a video of a run on the clock; it may be given another run later. */
function add_video(video, run) {
  const known = player.videos.has(video);
  player.videos.set(video, run);
  if (known) return;
  for (const event of ["seeked", "loadeddata"]) video.addEventListener(event, () => synchronize(video));
  seen_videos.observe(video);
}

const seen_videos = new IntersectionObserver((entries) => {
  for (const {target, isIntersecting} of entries) {
    const file = run_file(player.videos.get(target), "video.mp4");
    if (isIntersecting && target.getAttribute("src") !== file) target.src = file;
    if (!isIntersecting && target.hasAttribute("src")) {
      target.removeAttribute("src");
      target.load();
    }
  }
}, {rootMargin: "300px"});

/** Brings a video to the clock's time: the middle of its frame, so that rounding does not matter. */
function synchronize(video) {
  const run = player.videos.get(video);
  if (!run || video.readyState === 0 || video.seeking) return;
  const wanted = (frame_at(run, state.time - 0.5 / run.frames_per_second) + 0.5) / run.frames_per_second;
  const at_end = state.time >= duration_of(run) - 1 / run.frames_per_second;
  const playing = player.playing && !at_end;
  video.playbackRate = player.rate;
  if (Math.abs(video.currentTime - wanted) > (playing ? 0.12 * player.rate : 0.4 / run.frames_per_second))
    video.currentTime = wanted;
  if (playing && video.paused) video.play().catch(() => {});
  if (!playing && !video.paused) video.pause();
}

function show_clock() {
  by_id("scrubber").value = state.time;
  by_id("clock").value = `${state.time.toFixed(2)} s of ${player.duration.toFixed(2)} s`;
}

function set_playing(playing) {
  if (playing && state.time >= player.duration - 1.5 / finest_rate) set_time(0);
  player.playing = playing;
  const button = by_id("play");
  button.setAttribute("aria-label", playing ? "Pause" : "Play");
  button.firstElementChild.textContent = playing ? "❚❚" : "▶";
  set_time(state.time);
  if (playing) requestAnimationFrame((now) => tick(now, now));
}

function tick(before, now) {
  if (!player.playing) return;
  const time = state.time + (now - before) / 1000 * player.rate;
  set_time(time > player.duration ? 0 : Math.max(0, time));
  requestAnimationFrame((next) => tick(now, next));
}

/** A row for each combination of all keys but the last, where they are few; so large that four rows are seen at once. */
function lay_out_videos() {
  const style = by_id("videos").style;
  const last_key = data.keys[data.keys.length - 1];
  const values = new Set(runs.map((run) => JSON.stringify(run.values[last_key]))).size;
  const is_grid = data.keys.length > 1 && values > 1 && values <= 6 && runs.length % values === 0;
  const across = is_grid ? values : Math.min(6, Math.ceil(Math.sqrt(1.3 * runs.length)));
  const rows = Math.min(4, Math.ceil(runs.length / across));
  const aspect = Math.max(...runs.map((run) => run.width / run.height));
  style.setProperty("--across", across);
  style.setProperty("--most", `max(200px, ((100vh - 140px) / ${rows} - 52px) * ${aspect})`);
}

function make_videos() {
  const cards = [];
  lay_out_videos();
  for (const run of runs) {
    const screen = element("span", {class: "screen", style: `aspect-ratio:${run.width}/${run.height}`});
    if (run.complete) {
      const video = element("video", {playsinline: "", preload: "auto", poster: frame_file(run, frame_at(run, first_time))});
      video.muted = true;
      screen.append(video);
      add_video(video, run);
    } else {
      screen.append(element("span", {class: "missing"}, run.failure || "not done yet"));
    }
    const card = element("button", {class: "run", type: "button", "aria-pressed": "false", click: () => choose(run)},
      screen, name_of(run));
    by_id("videos").append(card);
    cards.push([run, card]);
  }
  on_choice(() => mark_chosen(cards));
}

function make_player() {
  const scrubber = by_id("scrubber");
  scrubber.max = player.duration - 1 / finest_rate;
  scrubber.step = 1 / finest_rate;
  scrubber.addEventListener("input", () => {
    if (player.playing) set_playing(false);
    set_time(Number(scrubber.value));
  });
  by_id("play").addEventListener("click", () => set_playing(!player.playing));
  by_id("rate").addEventListener("change", (event) => player.rate = Number(event.target.value));
  document.addEventListener("keydown", (event) => {
    if (event.key !== " " || event.target.closest("button, select, input")) return;
    event.preventDefault();
    set_playing(!player.playing);
  });
  on_time(show_clock);
  on_time(() => {
    for (const video of player.videos.keys()) synchronize(video);
  });
}
