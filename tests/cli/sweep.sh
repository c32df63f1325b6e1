#!/usr/bin/env bash
# Sweeps: each simulation once, what was done before an end by force not again, the same bytes either way, and what
# is said of runs that fail and of bad input.
# Usage: sweep.sh PROGRAM [shipped], from the source tree's root; with `shipped`, the sweep that ships is
# ended by force several times instead. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

small=(scenes/small_dam_break.json --set fluid.spacing=0.06 --set video.duration=0.3 --set video.width=160
       --set video.height=96 --set probes_rate=100)
varied=("${small[@]}" --set "fluid.viscosity=0.1,2,20" --set "surface.smoothing=0,5,30")
grid=("${varied[@]}" --reference "viscosity=2,smoothing=5" --target gauge_m=0.41 --threads 2)
sweep() { spindrift sweep "$@"; }
children_of() { cat /proc/"$1"/task/*/children 2>/dev/null; }
count() { find "$1" -name "$2" 2>/dev/null | wc -l; }
complete_in() { grep -sl '"complete": true' "$1"/*/run.json | wc -l; }
has_complete() { (($(complete_in "$1") >= $2)); }
has_kept() { (($(count "$1" '*.particles') >= $2)); }

# What does not depend on the machine's speed, as a list of checksums.
checksums() {
  (cd "$1" && find . -type f ! -name '.*' ! -name run.json ! -name simulation.json ! -name seconds.txt \
    ! -name report.html ! -name sweep.csv ! -name sweep.json -exec sha256sum {} + | sort -k 2
    sed '/_seconds"/d' sweep.json | sha256sum)
}

# Ends a sweep, and waits until the processes that it began are gone too.
end_by_force() {
  local child children
  children=$(children_of "$1")
  kill -KILL "$1"
  wait "$1" 2>/dev/null
  for child in $children; do
    while [[ -e /proc/$child ]]; do sleep 0.02; done
  done
}

# ended_by_force FOLDER COMPLETE ARGUMENT...: ends the sweep once so many runs are complete, lists what is there, goes on
# to the end, and checks that nothing of the list was made again.
ended_by_force() {
  local out=$1 complete=$2 pid
  shift 2
  "$program" sweep "$@" -o "$out" --quiet </dev/null 2>"$folder/err" &
  pid=$!
  wait_until has_complete "$out/runs" "$complete"
  sweep "$@" -o "$out"
  (($? == 3)) && grep -q "sweep .*(process $pid) has been at work here" "$folder/err" ||
    fail "a second sweep in the same folder was not refused"
  end_by_force $pid
  find "$out/simulations" "$out/runs" -type f \( -name '*.particles' -o -name '*.readings' \) -printf '%p %T@ %i\n' \
    2>/dev/null >"$folder/before"
  local run
  for run in "$out"/runs/*; do
    grep -qs '"complete": true' "$run/run.json" && stat -c '%n %y %i' "$run/video.mp4" "$run/run.json" "$run/frames/0000.png"
  done >"$folder/videos_before"
}

went_on() {
  local out=$1
  shift
  sweep "$@" -o "$out" || fail "going on returned $?"
  (($(count "$out" '.*.part*') == 0)) || fail "temporary files are left"
  while read -r file rest; do
    [[ $(find "$file" -printf '%T@ %i') == "$rest" ]] || fail "$file was made twice"
  done <"$folder/before"
  while read -r file rest; do
    [[ $(stat -c '%y %i' "$file") == "$rest" ]] || fail "$file was drawn twice"
  done <"$folder/videos_before"
}

if [[ ${2-} == shipped ]]; then
  shipped=(scenes/sweeps/viscosity.json --threads 2)
  sweep "${shipped[@]}" -o "$folder/whole" || fail "the sweep returned $?"
  for complete in 0 2 5 8; do
    ended_by_force "$folder/cut" "$complete" "${shipped[@]}"
  done
  went_on "$folder/cut" "${shipped[@]}"
  diff <(checksums "$folder/whole") <(checksums "$folder/cut") || fail "the results differ"
  # The page and the pictures that it shows.
  pictures=$(cd "$folder/whole/differences" && printf '%s\n' */*.png | xargs -n 1 basename | sort -u)
  bytes=$(cd "$folder/whole" && { stat -c %s report.html differences/*/*.png
    for picture in $pictures; do stat -c %s runs/*/frames/"$picture"; done; } | awk '{ s += $1 } END { print s }')
  ((bytes < 30000000)) || fail "the report and its pictures take $bytes bytes"
  exit 0
fi

# A grid of three liquids and three ways to draw them: three simulations.
sweep "${grid[@]}" -o "$folder/whole" || fail "the sweep returned $?"
grep -q "^3 simulations, 9 videos and 36 comparisons made now" "$folder/out" || fail "it did not say what it did"
(($(ls "$folder/whole/simulations" | wc -l) == 3)) || fail "there are not three simulations"
(($(count "$folder/whole/runs" video.mp4) == 9)) || fail "there are not nine videos"
(($(count "$folder/whole/runs" '*.particles') == 0)) || fail "a run simulated for itself"
(($(wc -l <"$folder/whole/runs/viscosity=2,smoothing=30/probes.csv") == 28)) || fail "probes were not read at their rate"
cmp -s "$folder/whole/runs/viscosity=2,smoothing=0/video.mp4" "$folder/whole/runs/viscosity=2,smoothing=30/video.mp4" &&
  fail "two looks gave the same video"
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  $(column["steps"]) < 10 || $(column["iterations"]) < 10 || $(column["mean_compression"]) <= 0 ||
  $(column["simulation_seconds"]) <= 0 || $(column["failure"]) != "" { print; bad = 1 }
  ($1 == "viscosity=2 smoothing=5") != ($(column["flip"]) == 0) { print "flip: " $0; bad = 1 }
  { ++steps[$(column["fluid.viscosity"]), $(column["steps"])] }
  END { for (s in steps) bad = bad || steps[s] != 3; exit bad || NR != 10 }' \
  <(sed 's/"\([^",]*\),\([^"]*\)"/\1 \2/' "$folder/whole/sweep.csv") || fail "the table is not right"
# The table is ranked by the target: best first.
awk '/^viscosity/ { d = $NF < 0.41 ? 0.41 - $NF : $NF - 0.41; if (d < last) bad = 1; last = d; ++rows }
  END { exit bad || rows != 9 }' "$folder/out" || fail "the runs are not ranked by the target"
grep -q '"flip": 0\.' "$folder/whole/sweep.json" || fail "no run differs from the reference"
grep -qi "http://www.w3.org/2000/svg" "$folder/whole/report.html" || fail "there is no report"
grep -oi '"https\?://[^"]*"\|url(http[^)]*' "$folder/whole/report.html" | grep -v "www.w3.org" &&
  fail "the report needs the network"
sweep "${grid[@]}" -o "$folder/whole" || fail "the same sweep again returned $?"
grep -q "^0 simulations, 0 videos and 0 comparisons" "$folder/out" || fail "it did something again"

# Ended by force half-way: nothing twice, and the same bytes.
ended_by_force "$folder/cut" 3 "${grid[@]}"
for run in "$folder"/cut/runs/*; do  # as an end by force may leave it
  grep -qs '"complete": true' "$run/run.json" || { touch "$run/.video.1-0.part.mp4"; break; }
done
went_on "$folder/cut" "${grid[@]}"
diff <(checksums "$folder/whole") <(checksums "$folder/cut") || fail "the results differ"

# A run that fails, and one whose process dies, are named, and stop no other.
sweep "${small[@]}" --set solver.max_iterations=100,3 --set solver.min_time_step=0.002 \
  --set solver.mean_compression=1e-5 -o "$folder/failing"
code=$?
((code == 1)) || fail "a sweep with a failing run returned $code instead of 1"
grep -q "spindrift: max_iterations=3 failed: no time step" "$folder/err" || fail "it did not name the run that failed"
[[ -s $folder/failing/runs/max_iterations=100/video.mp4 ]] || fail "the other run was not done"
grep -q '"failure": "no time step' "$folder/failing/sweep.json" || fail "the report does not know of it"
"$program" sweep "${small[@]}" --set fluid.viscosity=1,2 --set video.duration=2 --jobs 1 -o "$folder/dying" \
  >"$folder/out" 2>"$folder/err" </dev/null &
pid=$!
child=
has_kept_child() { child=$(children_of $pid | tr -d ' ') && [[ -n $child ]] && has_kept "$folder/dying/simulations" 1; }
wait_until has_kept_child
kill -KILL "$child"
wait $pid
code=$?
((code == 1)) || fail "a sweep whose process died returned $code instead of 1"
grep -q "viscosity=1 failed: .*signal 9" "$folder/err" || fail "it did not say which run died"
[[ -s $folder/dying/runs/viscosity=2/video.mp4 ]] || fail "the run after the one that died was not done"

# Ended by force in the middle of a simulation: its process ends as well. Then the same by Ctrl-C.
long=("${small[@]}" --set "fluid.viscosity=1,3" --set video.duration=6 -o "$folder/interrupted")
begin_long() {
  local before
  before=$(count "$folder/interrupted/simulations" '*.particles')
  "$program" sweep "${long[@]}" >"$folder/out" 2>"$folder/err" </dev/null &
  pid=$!
  wait_until has_kept "$folder/interrupted/simulations" $((before + 2))
}
begin_long
end_by_force $pid
(($(count "$folder/interrupted/simulations" '*.particles') < 100)) || fail "simulations outlived the sweep"
begin_long
kill -INT $pid
wait $pid
code=$?
((code == 3)) || fail "an interrupted sweep returned $code instead of 3"
grep -q "interrupted after 0 of 2 runs" "$folder/err" || fail "it did not say that it was interrupted"
grep -q "The same command goes on" "$folder/err" || fail "it did not say how to go on"
[[ -s $folder/interrupted/report.html ]] || fail "it left no report"

file_with() { printf '%s\n' "$1" >"$folder/sweep.json"; }
refuse "there is no such file" sweep no_such_scene.json --set fluid.viscosity=1,2
refuse "nothing varies" sweep "${small[@]}"
refuse '--set fluid.viscosty=1,2: fluid.viscosty: unknown key; did you mean "viscosity"?' sweep \
  scenes/small_dam_break.json --set fluid.viscosty=1,2
refuse "-1 is out of range; accepted: 0 ... 10000 Pa·s" sweep scenes/small_dam_break.json --set fluid.viscosity=1,-1
refuse "two runs have the same values" sweep scenes/small_dam_break.json --set fluid.viscosity=1,1.0
refuse 'did you mean "front_m"' sweep "${grid[@]}" --target fron_m=1
refuse "--target flip=0: there is no such figure without a reference" sweep "${small[@]}" --set fluid.viscosity=1,2 --target flip=0
refuse "there is no such run" sweep "${varied[@]}" --reference viscosity=3
refuse "3 runs have these values" sweep "${varied[@]}" --reference viscosity=2
refuse "times: 9 is out of range" sweep "${grid[@]}" --times 9
file_with '{"scene": "a.json", "gird": {}}'
refuse 'sweep.json:1:21: gird: unknown key; did you mean "grid"?' sweep "$folder/sweep.json"
cp scenes/small_dam_break.json "$folder/a.json"
file_with '{"scene": "a.json",
  "grid": {"fluid.viscosity": [1, "thick"]}}'
refuse 'sweep.json:2:35: grid.fluid.viscosity[1]: fluid.viscosity: expected a number' sweep "$folder/sweep.json"
file_with '{"scene": "a.json", "latin_hypercube": {"samples": 3, "ranges": {"solver.cfl": {"min": 0.3, "max": 0.2}}}}'
refuse "latin_hypercube.ranges.solver.cfl.max: must be above min" sweep "$folder/sweep.json"
exit 0
