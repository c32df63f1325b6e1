#!/usr/bin/env bash
# Where the machine has too little of something, a run ends in words that name it, or is refused before it begins; and
# what is kept of runs can be listed and removed.
# Usage: limits.sh PROGRAM. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

cat >"$folder/scene.json" <<'JSON'
{
  "fluid": {"spacing": 0.05, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.4, 0.4, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [0.8, 0.6, 0.4]},
  "video": {"width": 96, "height": 64, "duration": 0.1}
}
JSON

# under LIMIT CODE TEXT COMMAND WORD...: with a limit of the shell's, it ends with the code and says the text.
under() {
  local limit=$1 code=$2 text=$3 found
  shift 3
  # Files that whoever runs this has left open would count.
  (exec >"$folder/out" 2>"$folder/err" </dev/null 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&- && eval "$limit" && exec "$program" "$@")
  found=$?
  ((found == code)) || fail "under \"$limit\" $* returned $found instead of $code"
  grep -qF -- "$text" "$folder/err" || fail "under \"$limit\" $* did not say \"$text\""
  grep -q "EGL" "$folder/err" && fail "under \"$limit\" $* blamed something else"
  return 0
}

run=(render "$folder/scene.json" -o "$folder/run")
under "ulimit -f 3" 3 "File too large" "${run[@]}"
under "ulimit -f 3" 3 "File too large" simulate "$folder/scene.json" -o "$folder/run"
under "ulimit -n 4" 3 "Too many open files" simulate "$folder/scene.json" -o "$folder/run"

# Threads are counted for a user, who must not be root; what others of that user run counts as well.
as_nobody() { setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; }
if ((EUID == 0)) && as_nobody true 2>/dev/null && as_nobody test -x "$program"; then
  chmod 777 "$folder"
  (ulimit -u 3 && HOME=$folder as_nobody "$program" render "$folder/scene.json" -o "$folder/few" --threads 4 >"$folder/out" 2>"$folder/err" </dev/null)
  code=$?
  ((code == 3)) || fail "with three processes a run returned $code instead of 3"
  grep -q "threads are needed and .* could be started" "$folder/err" || fail "it did not say that threads are missing"
  (ulimit -u 3 && HOME=$folder as_nobody "$program" sweep "$folder/scene.json" --set fluid.viscosity=1,2 --threads 2 \
    -o "$folder/sweep" >"$folder/out" 2>"$folder/err" </dev/null)
  code=$?
  ((code == 1 || code == 3)) || fail "with three processes a sweep returned $code"
fi

# Larger than the memory that the process may have, or than the disk: refused before it begins, unless that is asked for.
large=(simulate "$folder/scene.json" -o "$folder/large" --set fluid.spacing=0.003)
under "ulimit -v 600000" 2 "of memory, and there are 614 MB at most" "${large[@]}"
[[ ! -e $folder/large ]] || fail "it began"
under true 2 "of disk space" "${large[@]}" --set video.duration=1000 --set video.frames_per_second=1000
[[ ! -e $folder/large ]] || fail "it began"
processors=$(env -u OMP_NUM_THREADS nproc)
under true 0 "warning: --threads $((processors + 1)): $processors processor" "${run[@]}" --threads $((processors + 1))
(($(grep -c "processor" "$folder/err") == 1)) || fail "it said more than once that there are more threads than processors"

# Long scenes take time and memory in proportion to their length: a tenth of this is enough by far.
repeat() { local k; for ((k = 0; k < $2; ++k)); do printf '%s' "$1"; done; }
limited="ulimit -t 20 -v 2000000"
printf '{"obstacles": [%s]}' "$(repeat '{"box": {"min": [0.1, 0.1, 0.1], "max": [0.2, 0.2, 0.2]}}, ' 50000)" |
  sed 's/, \]/]/' >"$folder/bodies.json"
(eval "$limited" && exec "$program" check "$folder/bodies.json") >"$folder/out" 2>"$folder/err" || fail "50,000 bodies"
# Spread: looking at each for every place takes 7 s, a tree of boxes 0.1 s.
awk 'BEGIN { print "{\"fluid\": {\"spacing\": 0.02}, \"obstacles\": ["; for (k = 0; k < 20000; ++k)
  printf "%s{\"sphere\": {\"center\": [%g, %g, %g], \"radius\": 0.001}}", k ? "," : "",
    0.0301 * (k % 50), 0.0311 * (int(k / 50) % 20), 0.0203 * int(k / 1000); print "]}" }' >"$folder/spread.json"
(ulimit -t 5; exec "$program" check "$folder/spread.json") >"$folder/out" 2>"$folder/err" || fail "20,000 bodies, spread"
printf '{"fluid": {"volumes": [%s0]}}' "$(repeat '0, ' 200000)" >"$folder/volumes.json"
under "$limited" 2 "and 199981 more" check "$folder/volumes.json"
printf '{"fluid": %s%s}' "$(repeat '[' 100000)" "$(repeat ']' 100000)" >"$folder/deep.json"
under "$limited" 2 "nested too deep" check "$folder/deep.json"

# What can't be printed is told; nobody who reads is no reason to complain.
"$program" check "$folder/scene.json" >/dev/full 2>"$folder/err"
code=$?
((code == 3)) || fail "a full device returned $code"
grep -q "No space left" "$folder/err" || fail "it did not say that the device is full"

# Disk space, as said and as taken.
spindrift check "$folder/scene.json" --json || fail "check returned $?"
said=$(sed -n 's/^    "particles": \([0-9]*\).*/\1/p' "$folder/out")
rm -r "$folder/run"
spindrift "${run[@]}" --quiet || fail "a run returned $?"
taken=$(cat "$folder"/run/particles/*/*.particles | wc -c)
((said > taken * 8 / 10 && said < taken * 12 / 10)) || fail "check says $said bytes of particles, and there are $taken"

# Kept simulations: listed with their scene; removed where nobody is at work.
spindrift "${run[@]}" --set fluid.viscosity=1 --quiet || fail "another run returned $?"
spindrift cache "$folder" || fail "cache returned $?"
(($(grep -c "3 frames .*min old .*particles/.* $folder/scene.json" "$folder/out") == 2)) || fail "not both are listed"
(($(grep -c " unused " "$folder/out") == 1)) || fail "not the one that is used no more is told from the other"
spindrift cache "$folder" "$folder/run" "$folder/run/../run/particles" || fail "cache returned $?"
grep -q "^2 kept simulations" "$folder/out" || fail "one that is under two names counts twice"
spindrift cache "$folder" --remove --older-than 1h || fail "cache --remove returned $?"
(($(ls "$folder/run/particles" | wc -l) == 2)) || fail "young ones were removed"
exec 9>"$folder/run/.lock"
flock 9
spindrift cache "$folder" --remove
(($? == 3)) && grep -q "stays: .*at work here" "$folder/err" || fail "one in use was removed"
exec 9>&-
spindrift cache "$folder" --remove --unused --json || fail "cache --remove --unused returned $?"
(($(ls "$folder/run/particles" | wc -l) == 1)) || fail "the unused one was not removed"
(($(grep -c '"removed": true' "$folder/out") == 1)) || fail "it did not say what it removed"
spindrift cache "$folder/nowhere"
(($? == 2)) || fail "a folder that isn't there is no error"
spindrift cache --older-than 3
(($? == 2)) && grep -q "as in 30d" "$folder/err" || fail "an age without a unit is no error"

# Whatever writes in a folder is refused where somebody is at work.
echo '{"goldens": [{"scene": "scene.json", "frames": [0]}]}' >"$folder/golden.json"
mkdir "$folder/locked"
exec 9>"$folder/locked/.lock"
flock 9
picture=$folder/run/frames/0000.png
for command in "render $folder/scene.json" "simulate $folder/scene.json" "bench $folder/scene.json --quick" \
  "golden check $folder/golden.json" "compare $picture $picture" "sweep $folder/scene.json --set fluid.viscosity=1,2"; do
  spindrift $command -o "$folder/locked"
  code=$?
  ((code == 3)) || fail "$command returned $code in a folder that is in use"
  grep -q "locked: another process is at work here; wait for it, or give another folder" "$folder/err" ||
    fail "$command did not say that the folder is in use"
  [[ $(ls -A "$folder/locked") == .lock ]] || fail "$command wrote in a folder that is in use"
done
exec 9>&-

# Two scene files of one name in one folder.
mkdir "$folder/other" "$folder/here"
sed 's/0.05/0.06/' "$folder/scene.json" >"$folder/other/scene.json"
cd "$folder/here" || exit 1
spindrift simulate ../scene.json --quiet || fail "a run returned $?"
spindrift simulate ../other/scene.json --quiet
code=$?
((code == 2)) || fail "another scene of the same name returned $code instead of 2"
grep -q "out/scene holds the results of another scene, $folder/scene.json; give another folder by -o" "$folder/err" ||
  fail "it did not say whose the folder is"
spindrift simulate ../other/scene.json --quiet --force || fail "--force returned $?"
spindrift simulate ../other/scene.json --quiet || fail "the same scene again returned $?"
exit 0
