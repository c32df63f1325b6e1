#!/usr/bin/env bash
# Names, paths and values that would be script if a page took them as more than text go through every page, in a browser:
# nothing runs, and the page says them letter by letter.
# Usage: hostile_pages.sh PROGRAM, from the source tree's root. Returns 1 if a check fails.
# shellcheck source=tests/cli/browser.sh
. "$(dirname "$0")/browser.sh"

names=('{{data}}' '{{#pairs}}' '<img src=x onerror=window.hit=1>' '"><svg onload=window.hit=1>' '<!--' 'a&lt;b'
  "' onmouseover='window.hit=1" '${window.hit=1}' 'javascript:window.hit=1')
# A path can hold a slash, and so the end of an element.
base="$folder/<"/'script><script>window.hit=1<'/"script><img src=x onerror=window.hit=1>"
mkdir -p "$base"
small=(--set fluid.spacing=0.1 --set video.duration=0.1 --set video.width=32 --set video.height=32)
scene='{
  "fluid": {"spacing": 0.1, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.4, 0.8, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [0.8, 1.2, 0.4]},
  "probes": [{"name": "tap", "pressure": {"point": [0.2, 0, 0.2]}}],
  "solver": {"speed_of_sound": 40},
  "video": {"duration": 0.1, "frames_per_second": 20, "width": 32, "height": 32}
}'

# check_page FILE TEXT...: the page shows the texts; nothing in it has run, not even when everything is pointed at.
check_page() {
  local file=$1 text
  shift
  [[ -s $file ]] || fail "there is no $file"
  open_page "$file"
  expect complete "return document.readyState"
  for text; do
    expect shown "return document.documentElement.textContent.includes(atob('$(printf %s "$text" | base64 -w 0)')) ?
      'shown' : document.body.textContent.slice(0, 300)"
  done
  js "for (const node of document.querySelectorAll('*'))
      for (const kind of ['mouseover', 'click', 'focus'])
        if (!(node instanceof HTMLAnchorElement)) node.dispatchEvent(new MouseEvent(kind, {bubbles: true}))" >/dev/null
  sleep 0.3
  expect undefined "return String(window.hit)"
  expect "" "return [...document.querySelectorAll('.scale, .pair img')].filter((i) => i.naturalWidth === 0)
    .map((i) => i.src.slice(0, 40)).join(' ')"
  expect "" "return [...document.querySelectorAll('.plot')].filter((plot) => !plot.querySelector('.curve path'))
    .map((plot) => plot.textContent).join(' ')"
  expect "" "return [...document.querySelectorAll('*')].flatMap((node) => [...node.attributes])
    .filter((a) => a.name.startsWith('on') || a.value.startsWith('javascript:')).map((a) => a.name).join(' ')"
  expect "" "return [...document.querySelectorAll('a')].map((a) => a.protocol).filter((p) => p !== 'file:').join(' ')"
}

start_browser

# Pictures under all names, in folders of such names.
spindrift render scenes/dam_break.json "${small[@]}" --quiet -o "$folder/plain" || fail "render returned $?"
mkdir "$base/a" "$base/b"
for name in "${names[@]}"; do
  cp "$folder/plain/frames/0000.png" "$base/a/$name.png"
  cp "$folder/plain/frames/0002.png" "$base/b/$name.png"
done
spindrift compare "$base/a" "$base/b" --show 20 --max-flip 0 --quiet -o "$base/compared"
[[ $? == 1 ]] || fail "compare found no difference"
check_page "$base/compared/compare.html" "${names[@]}" "$base/a" "$base/b"
expect "${#names[@]} 5" "return [document.querySelectorAll('.pair').length,
  document.querySelector('.pair').querySelectorAll('img').length + document.querySelectorAll('.plot > svg').length].join(' ')"
# Where a link leads there is a file.
expect "" "return [...document.querySelectorAll('a')].map((a) => decodeURIComponent(new URL(a.href).pathname))
  .filter((path) => !path.endsWith('.png') || !path.includes('/differences/')).join(' ')"
js "const picture = new Image(); picture.onload = () => window.loaded = 'loaded';
  picture.src = [...document.querySelectorAll('a')].at(-1).href" >/dev/null
expect loaded "return String(window.loaded)"

# A golden test whose picture has changed, one whose reference is missing.
printf %s "$scene" >"$base/scene.json"
list="$base/<img src=x onerror=window.hit=1>.json"
cat >"$list" <<'JSON'
{"width": 32, "height": 32, "references": "<img src=x onerror=window.hit=1>",
 "goldens": [{"scene": "scene.json", "name": "changed", "frames": [1]},
             {"scene": "scene.json", "name": "missing", "frames": [1]}]}
JSON
spindrift golden update "$list" --only changed --quiet -o "$base/golden" || fail "golden update returned $?"
spindrift golden check "$list" --set look.floor_color=[1,0,0] --quiet -o "$base/golden"
[[ $? == 1 ]] || fail "golden found no difference"
check_page "$base/golden/golden.html" changed/0001.png '/<img src=x onerror=window.hit=1>/missing/0001.png' "$base"

# Scenes named by their files: probes and benchmark.
for name in "${names[@]}"; do
  printf %s "$scene" >"$base/$name.json"
done
for name in '{{data}}' '{{#pairs}}' '<img src=x onerror=window.hit=1>' '"><svg onload=window.hit=1>'; do
  spindrift simulate "$base/$name.json" --quiet -o "$base/probed" || fail "simulate returned $?"
  check_page "$base/probed/probes.html" "Probes of $name"
done
spindrift bench "$base/"*.json --spacing 1 --tolerance 1 --time-step 1 --solver sph --quiet -o "$base/bench" ||
  fail "bench returned $?"
check_page "$base/bench/bench.html" "${names[@]}"
# What a plot is told to say: its labels, the titles of its curves, and all of these where the pointer is.
for name in "${names[@]}"; do
  text="atob('$(printf %s "$name" | base64 -w 0)')"
  js "const curves = [{title: $text, line: true, points: [[0, 1], [1, 2]]}];
    const {svg, x, y} = draw_curves({x_label: $text, y_label: $text, curves}, 420);
    document.body.replaceChildren(legend_of(curves), svg, tip);
    const at = new DOMPoint(x(1), y(2)).matrixTransform(svg.getScreenCTM());
    svg.dispatchEvent(new PointerEvent('pointermove', {clientX: at.x, clientY: at.y}))" >/dev/null
  expect "1 2 3" "return ['figcaption', 'svg:not(.swatch)', '.tip'].map((part) =>
    document.querySelector(part).textContent.split($text).length - 1).join(' ')"
done
expect undefined "return String(window.hit)"

# A sweep of a scene named as the place of the page's data, with values that are markup, one of which fails.
spindrift sweep "$base/{{data}}.json" --quiet -o "$base/swept" --set 'name=
  "<img src=x onerror=window.hit=1>","\"><svg onload=window.hit=1>","{{title}}","<!--","${window.hit=1}"' ||
  fail "the sweep returned $?"
check_page "$base/swept/report.html" 'Sweep of {{data}}.json' '<img src=x onerror=window.hit=1>' \
  '"><svg onload=window.hit=1>' '{{title}}' '<!--' '${window.hit=1}'
expect 5 "return String(document.querySelectorAll('#videos .run').length)"
exit 0
