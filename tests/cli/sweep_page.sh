#!/usr/bin/env bash
# The page of a sweep in a browser without a display: it opens from disk, says nothing on the console, asks nothing of a
# network; tables sort, points are chosen by a click, the curtain moves, and videos, of the best quality too, keep in step.
# Usage: sweep_page.sh PROGRAM, from the source tree's root. Returns 1 if a check fails.
# shellcheck source=tests/cli/browser.sh
. "$(dirname "$0")/browser.sh"

spindrift sweep scenes/small_dam_break.json --set fluid.spacing=0.06 --set video.duration=0.4 --set video.width=160 \
  --set video.height=96 --set fluid.viscosity=0.1,20 --set surface.smoothing=0,30 --set video.quality=0 --quiet \
  --reference viscosity=0.1,smoothing=0 -o "$folder/a sweep" || fail "the sweep returned $?"

start_browser
open_page "$folder/a sweep/report.html"

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
log=$(browser_log)
[[ $log == '{"value":[]}' ]] || fail "the console says: $log"
expect "" "return performance.getEntriesByType('resource').map((e) => e.name)
  .filter((name) => !name.startsWith('file://')).join(' ')"

# On a narrow screen nothing is wider than the screen.
request POST "/session/$session/window/rect" '{"width": 500, "height": 900}' >/dev/null
expect fits "return document.documentElement.scrollWidth <= innerWidth ? 'fits' : document.documentElement.scrollWidth + ' > ' + innerWidth"
exit 0
