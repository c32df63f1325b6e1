#!/usr/bin/env bash
# A small benchmark: its table, its report, and what it says about bad input.
# Usage: bench.sh PROGRAM, from the source tree's root. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

cat >"$folder/drop.json" <<'JSON'
{
  "fluid": {"spacing": 0.1, "volumes": [{"box": {"min": [0, 0.1, 0], "max": [0.4, 0.9, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [0.8, 1.2, 0.4]},
  "solver": {"speed_of_sound": 40},
  "video": {"duration": 0.3}
}
JSON
bench() { spindrift bench "$@"; }

# The plane of two solvers, two tolerances and two steps.
bench "$folder/drop.json" --spacing 1 --tolerance 1,4 --time-step 0.5,1 -o "$folder/plane" ||
  fail "the plane returned $?"
grep -q "drop: speed against error" "$folder/out" || fail "no table was printed"
awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; columns = NF; next }
  function value(name) {
    if (!(name in column)) { print "no column " name; bad = 1; exit }
    return $(column[name])
  }
  function between(name, low, high) {
    if (value(name) !~ /^[0-9.]+(e[-+]?[0-9]+)?$/ || value(name) < low || value(name) > high) {
      print name " is " value(name) " in line " NR; bad = 1
    }
  }
  {
    if (NF != columns || value("failure") != "") { print "line " NR ": " $0; bad = 1 }
    ++runs[value("solver")]
    between("particles", 128, 128)
    between("simulated_s", 0.299, 0.301)
    between("wall_s_per_simulated_s", 1e-4, 1e3)
    between("steps", 60, 5000)
    between("refused_steps", 0, 1000)
    between("iterations_per_step", 0, 60)
    between("ns_per_particle_step", 1, 1e7)
    between("bytes_per_particle", 100, 1e5)
    between("peak_bytes", 1e6, 1e9)
    between("mean_compression", 0, 0.2)
    between("max_compression", 0, 0.5)
    between("energy_ratio", 0.5, 1.1)
    between("max_speed_m_per_s", 0.5, 20)
    mean_front += value("on_mean_front") == "true"
    max_front += value("on_max_front") == "true"
  }
  END {
    if (NR != 9 || runs["pcisph"] != 4 || runs["sph"] != 4) { print NR " lines"; bad = 1 }
    if (mean_front < 1 || max_front < 1) { print "no front"; bad = 1 }
    exit bad
  }' "$folder/plane/bench.csv" || fail "the table is not right"
[[ $(grep -c '"curves":\[{' "$folder/plane/bench.html") == 2 ]] || fail "the report has not its two plots"
grep -q "<table>" "$folder/plane/bench.html" || fail "the report has no table"
grep -qi 'src="[^d]\|href=.http' "$folder/plane/bench.html" && fail "the report needs other files"

# A mesh beside the scene file is found.
printf '%s\n' "v 0 0 0" "v 0.4 0 0" "v 0 0.4 0" "v 0 0 0.4" "f 1 3 2" "f 1 2 4" "f 2 3 4" "f 1 4 3" >"$folder/wedge.obj"
bench "$folder/drop.json" --spacing 1 --tolerance 1 --time-step 1 --solver pcisph --set video.duration=0.1 \
  --set 'obstacles=[{"mesh": {"file": "wedge.obj"}}]' --quiet -o "$folder/mesh" || fail "with a mesh it returned $?"

# Scaling, for machines.
bench --scaling --threads-scaling --particles 500,1000 --set fluid.spacing=0.1 --threads 2 --json \
  --set 'obstacles=[{"capsule": {"from": [0.9, 0.1, 0.2], "to": [0.9, 0.3, 0.2], "radius": 0.1}}]' \
  --quick -o "$folder/scaling" || fail "scaling returned $?"
[[ $(grep -c '"series": "particles"' "$folder/out") == 2 ]] || fail "not two sizes"
[[ $(grep -c '"series": "threads"' "$folder/out") == 2 ]] || fail "not one and two threads"
grep -q '"failure": ""' "$folder/out" || fail "a scaling run did not reach its end"

# A run that is given up is told, and is no success.
bench "$folder/drop.json" --limit 0.01 --solver sph --set video.duration=100 --spacing 1 \
  --tolerance 1 --time-step 1 --quiet -o "$folder/cut"
code=$?
((code == 3)) || fail "a benchmark without any result returned $code"
grep -q "not done within 0.01 s" "$folder/err" || fail "it did not say why there is no result"
[[ $(grep -c '"curves":\[\]' "$folder/cut/bench.html") == 2 ]] || fail "it plots what there is not"

# Ctrl-C ends the run and leaves those done before.
"$program" bench "$folder/drop.json" --spacing 1 --set video.duration=100 -o "$folder/interrupted" \
  >"$folder/out" 2>"$folder/err" </dev/null &
pid=$!
sleep 1
kill -INT $pid
wait $pid
code=$?
((code == 3)) || fail "an interrupted benchmark returned $code instead of 3"
grep -q "interrupted after [0-9]* of 18 runs" "$folder/err" ||
  fail "it did not say that it was interrupted"
[[ -s $folder/interrupted/bench.csv && -s $folder/interrupted/bench.html ]] || fail "it left nothing"

refuse "there is no such file" bench no_such_scene.json
refuse 'did you mean "spacing"?' bench --set fluid.spacng=1
refuse "solver.cfl: 1.2 is out of range" bench --time-step 3
refuse "--spacing" bench --spacing none
refuse "--spacing" bench --spacing -1
refuse "pcisph" bench --solver dfsph
refuse 'did you mean "--spacing"' bench --spacings 1
refuse "meshes can't be repeated" bench --scaling --set 'obstacles=[{"mesh": {"file": "'"$folder/wedge.obj"'"}}]'
refuse "add --plane" bench --scaling "$folder/drop.json"
exit 0
