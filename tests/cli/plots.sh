#!/usr/bin/env bash
# The plots of reports in a browser without a display: all curves are drawn over axes whose numbers can be told apart, and
# the values of the point under the pointer are shown.
# Usage: plots.sh PROGRAM. Returns 1 if a check fails.
# shellcheck source=tests/cli/browser.sh
. "$(dirname "$0")/browser.sh"

cat >"$folder/column.json" <<'JSON'
{
  "fluid": {"spacing": 0.1, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.4, 0.8, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [0.8, 1.2, 0.4]},
  "solver": {"speed_of_sound": 40},
  "probes": [{"name": "gauge", "surface_height": {"x": 0.2, "z": 0.2}},
             {"name": "dry", "surface_height": {"x": 0.7, "z": 0.2}},
             {"name": "all", "energy": {}}],
  "video": {"duration": 0.1, "frames_per_second": 20}
}
JSON
spindrift simulate "$folder/column.json" --set probes_rate=100 --quiet -o "$folder/probed" || fail "simulate returned $?"
spindrift bench "$folder/column.json" --spacing 1,0.5 --tolerance 1,16 --time-step 0.5,1 --quiet -o "$folder/bench" ||
  fail "bench returned $?"
start_browser

# Probes: a line through every reading, as the table has it; a sentence where there was nothing to measure.
open_page "$folder/probed/probes.html"
expect "1 0 3" "return [...document.querySelectorAll('.plot')].map((plot) => plot.querySelectorAll('svg .line').length -
  plot.querySelectorAll('.swatch').length).join(' ')"
legend() { expect "$2" "return [...document.querySelectorAll('.plot')[$1].querySelectorAll('.legend')]
  .map((entry) => entry.textContent).join('; ')"; }
legend 2 "all_kinetic; all_potential; all_total"
expect "$(($(wc -l <"$folder/probed/probes.csv") - 1))" "return String(document.querySelector('.plot > svg .line')
  .getAttribute('d').split(/[ML]/).length - 1)"
expect "There are no values to plot for m over time (s)." "return document.querySelectorAll('.plot')[1].lastChild.textContent"
expect "J time (s)" "return [...[...document.querySelectorAll('.plot > svg')].at(-1).querySelectorAll('text')].slice(-2)
  .map((text) => text.textContent).reverse().join(' ')"

# The point under the pointer.
expect "gauge, time (s): 0, m: 0.8" "
  const svg = document.querySelector('.plot > svg');
  const [x, y] = svg.querySelector('.line').getAttribute('d').match(/[0-9.]+/g);
  const at = new DOMPoint(Number(x) + 3, Number(y) + 3).matrixTransform(svg.getScreenCTM());
  svg.dispatchEvent(new PointerEvent('pointermove', {clientX: at.x, clientY: at.y}));
  const tip = document.querySelector('.tip');
  return tip.hidden ? 'hidden' : tip.innerText.split(/[^ -~]/).join(', ').replace(/m: 0.[78][0-9]*/, 'm: 0.8')"
expect "hidden 0" "
  document.querySelector('.plot > svg').dispatchEvent(new PointerEvent('pointerleave'));
  return (document.querySelector('.tip').hidden ? 'hidden ' : 'shown ') + document.querySelectorAll('.mark').length"

# Numbers beside an axis: those of a logarithmic one, also of a narrow one, and of values that are nearly the same.
ticks() { expect "$1" "return ticks_of($2, 10).map((tick) => tick.text).join(' ')"; }
ticks "0.1 0.2 0.5 1 2" "{low: 0.09, high: 4, logarithmic: true}"
ticks "1e-4 0.001 0.01 0.1 1" "{low: 0.00009, high: 4, logarithmic: true}"
ticks "2.4 2.6 2.8 3 3.2 3.4 3.6 3.8" "{low: 2.3, high: 3.9, logarithmic: true}"
ticks "0 5,000 10,000 15,000 20,000 25,000" "range_of([0, 25000], {air: 0})"
ticks "0.50001 0.500015 0.50002 0.500025 0.50003 0.500035 0.50004 0.500045 0.50005" "range_of([0.50001, 0.50005], {air: 0})"
expect "true" "const {low, high} = range_of([0.5, 0.5 + 1e-16, 0.5 - 1e-16], {}); return String(low < 0.48 && high > 0.52)"
expect "0 2" "const {low, high} = range_of([1, 2], {from_zero: true, air: 0}); return low + ' ' + high"
expect "0 0.07" "const {low, high} = range_of([0], {}); return low + ' ' + high"

# Benchmark: markers of both solvers on logarithmic axes, a front for each spacing, and what is in the legend.
open_page "$folder/bench/bench.html"
expect "2 2" "return [...document.querySelectorAll('.plot > svg')].map((svg) => svg.querySelectorAll('.line.dashed').length).join(' ')"
expect "16 16" "return [...document.querySelectorAll('.plot > svg')].map((svg) => [...svg.querySelectorAll('.marker')]
  .map((path) => path.getAttribute('d').split('M').length - 1).reduce((a, b) => a + b)).join(' ')"
legend 1 "pcisph, 0.05 m; sph, 0.05 m; pcisph, 0.1 m; sph, 0.1 m"
expect "filled or open" "return [...document.querySelectorAll('.marker')].every((marker) => getComputedStyle(marker).fill ===
  (marker.classList.contains('open') ? 'rgb(255, 255, 255)' : getComputedStyle(marker).stroke)) ? 'filled or open' : 'neither'"

# Nothing on the console, and nothing but the page itself.
log=$(browser_log)
[[ $log == '{"value":[]}' ]] || fail "the console says: $log"
expect "" "return performance.getEntriesByType('resource').map((e) => e.name).join(' ')"
exit 0
