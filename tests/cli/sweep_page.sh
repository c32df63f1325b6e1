#!/usr/bin/env bash
# The page of a sweep in a browser without a display: it opens from disk, says nothing on the console, asks nothing of a
# network; tables sort, points are chosen by a click, the curtain moves, and videos keep in step.
# Usage: sweep_page.sh PROGRAM, from the source tree's root. Returns 1 if a check fails, 77 without a browser.
set -uo pipefail
program=$(readlink -f "$1")
for tool in chromium chromedriver; do
  command -v $tool >/dev/null ||
    { echo "skipped: $tool is not installed (apt-get install chromium chromium-driver)"; exit 77; }
done
folder=$(mktemp -d)
driver=
finish() {
  [[ -n ${session-} ]] && request DELETE "/session/$session" >/dev/null 2>&1
  [[ -n $driver ]] && kill "$driver" 2>/dev/null && wait "$driver" 2>/dev/null
  rm -rf "$folder"
}
trap finish EXIT
fail() { echo "FAILED: $*"; exit 1; }

# request METHOD PATH [BODY]: prints the driver's answer (WebDriver, www.w3.org/TR/webdriver2).
request() {
  local body=${3-} line length=0
  exec 3<>"/dev/tcp/127.0.0.1/$port" || return 1
  printf '%s %s HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n%s' \
    "$1" "$2" "$(printf %s "$body" | wc -c)" "$body" >&3
  while IFS= read -r line <&3 && [[ $line != $'\r' ]]; do
    [[ ${line,,} == content-length:* ]] && length=${line#*:}
  done
  head -c "$((${length//[$' \r']/}))" <&3
  exec 3>&-
}

# js SCRIPT: what it returns; it must do without double quotes and backslashes.
js() {
  request POST "/session/$session/execute/sync" "{\"script\": \"$(tr '\n' ' ' <<<"$1")\", \"args\": []}" |
    sed 's/^{"value":"\?//; s/"\?}$//'
}

# expect WANTED SCRIPT: tries for some seconds.
expect() {
  local found try
  for try in $(seq 100); do
    found=$(js "$2")
    [[ $found == "$1" ]] && return
    sleep 0.1
  done
  fail "found \"$found\" instead of \"$1\": $2"
}

"$program" sweep scenes/small_dam_break.json --set fluid.spacing=0.06 --set video.duration=0.4 --set video.width=160 \
  --set video.height=96 --set fluid.viscosity=0.1,20 --set surface.smoothing=0,30 --quiet \
  --reference viscosity=0.1,smoothing=0 -o "$folder/a sweep" </dev/null || fail "the sweep returned $?"

chromedriver --port=0 >"$folder/driver.log" 2>&1 &
driver=$!
port=
for _ in $(seq 100); do
  port=$(sed -n 's/.*successfully on port \([0-9]*\).*/\1/p' "$folder/driver.log")
  [[ -n $port ]] && break
  sleep 0.1
done
[[ -n $port ]] || fail "chromedriver did not start"
sandbox=
((EUID == 0)) && sandbox=', "--no-sandbox"'
# Driver and browser talk through a pipe: a fresh machine without /etc/hosts does not know localhost.
session=$(request POST /session '{"capabilities": {"alwaysMatch": {"goog:loggingPrefs": {"browser": "ALL"},
  "goog:chromeOptions": {"args": ["--headless=new", "--remote-debugging-pipe", "--disable-gpu", "--window-size=1200,900"'"$sandbox"']}}}}' |
  grep -o '"sessionId":"[^"]*"' | cut -d '"' -f 4)
[[ -n $session ]] || fail "chromium did not start"
request POST "/session/$session/url" "{\"url\": \"file://$folder/a%20sweep/report.html\"}" >/dev/null

expect "Sweep of small_dam_break.json" "return document.querySelector('h1').textContent"
expect 4 "return String(document.querySelectorAll('#videos .run').length)"
expect 20 "return String(document.querySelectorAll('#pictures img').length)"

# Every column sorts, both ways.
expect sorted "
  for (const th of document.querySelectorAll('#runs th')) {
    for (const wanted of ['ascending', 'descending']) {
      const name = th.dataset.column;
      const find = () => [...document.querySelectorAll('#runs th')].find((t) => t.dataset.column === name);
      find().querySelector('button').click();
      if (find().getAttribute('aria-sort') !== wanted) return name + ' is not ' + wanted;
      const at = [...find().parentNode.children].indexOf(find());
      const values = [...document.querySelectorAll('#runs tbody tr')].map((row) =>
        parseFloat(row.children[at].textContent.replace(',', '')));
      for (let i = 1; i < values.length; ++i)
        if (wanted === 'ascending' ? values[i] < values[i - 1] : values[i] > values[i - 1])
          return name + ': ' + values.join(' ');
    }
  }
  return document.querySelectorAll('#runs th').length > 8 ? 'sorted' : 'too few columns'"

# A click on a point chooses its run, another click the next run that has the same place.
expect 2 "return String(document.querySelectorAll('#plot circle').length)"
chosen="document.querySelector('#runs tr.chosen').dataset.run"
js "[...document.querySelectorAll('#plot circle')].find((c) => c.dataset.runs.includes('viscosity=20'))
  .dispatchEvent(new MouseEvent('click', {bubbles: true}))" >/dev/null
expect "viscosity=20,smoothing=0" "return $chosen"
js "document.querySelector('#plot circle.chosen').dispatchEvent(new MouseEvent('click', {bubbles: true}))" >/dev/null
expect "viscosity=20,smoothing=30" "return $chosen"
expect "viscosity 20smoothing 30" "return document.querySelector('#videos .run.chosen .name').textContent"
expect "viscosity=20,smoothing=30" "return document.getElementById('left').value"
expect "front" "
  const x = document.getElementById('plot-x');
  x.value = 'steps';
  x.dispatchEvent(new Event('change'));
  return document.querySelector('#plot circle.on-front') && document.querySelector('#plot .front') ? 'front' : 'none'"

# The curtain, and the picture of the difference.
js "const slider = document.getElementById('slider');
  slider.value = 20;
  slider.dispatchEvent(new Event('input'))" >/dev/null
expect "20%" "
  const edge = document.getElementById('edge'), whole = edge.parentNode.getBoundingClientRect();
  const at = edge.getBoundingClientRect();
  return Math.round(100 * (at.x + at.width / 2 - whole.x) / whole.width) + '%'"
js "document.getElementById('difference').scrollIntoView()" >/dev/null
expect 160 "return String(document.querySelector('#difference img').naturalWidth)"

# All videos show the frame that the scrubber says.
js "const scrubber = document.getElementById('scrubber');
  scrubber.value = 0.2;
  scrubber.dispatchEvent(new Event('input'));
  document.getElementById('videos').scrollIntoView()" >/dev/null
expect "6 6 6 6" "return [...document.querySelectorAll('#videos video')].map((v) =>
  v.readyState > 1 && !v.seeking ? Math.floor(v.currentTime * 30) : 'waiting').join(' ')"
js "document.getElementById('play').click()" >/dev/null
expect moving "return state.time !== 0.2 && [...document.querySelectorAll('#videos video')].every((v) => !v.paused)
  ? 'moving' : 'still'"
js "document.getElementById('play').click()" >/dev/null

# Nothing on the console, and nothing but files.
log=$(request POST "/session/$session/se/log" '{"type": "browser"}')
[[ $log == '{"value":[]}' ]] || fail "the console says: $log"
expect "" "return performance.getEntriesByType('resource').map((e) => e.name)
  .filter((name) => !name.startsWith('file://')).join(' ')"

# On a narrow screen nothing is wider than the screen.
request POST "/session/$session/window/rect" '{"width": 500, "height": 900}' >/dev/null
expect fits "return document.documentElement.scrollWidth <= innerWidth ? 'fits' : document.documentElement.scrollWidth + ' > ' + innerWidth"
exit 0
