#!/usr/bin/env bash
# Ctrl-C in the middle of a run leaves a video of the finished frames and says how to go on; the same
# command then goes on from there and ends with the bytes of a run in one piece.
# Usage: interrupt.sh PROGRAM. Returns 1 if a check fails.
set -uo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; cat "$folder/err" 2>/dev/null; exit 1; }

cat >"$folder/scene.json" <<'JSON'
{
  "fluid": {"spacing": 0.04, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.6, 0.8, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [1.6, 1, 0.4]},
  "video": {"width": 160, "height": 96, "duration": 2}
}
JSON

"$program" render "$folder/scene.json" -o "$folder/cut" >"$folder/out" 2>"$folder/err" </dev/null &
pid=$!
for _ in $(seq 200); do
  [[ -e $folder/cut/frames/0003.png ]] && break
  sleep 0.1
done
kill -INT $pid
wait $pid
code=$?
((code == 3)) || fail "an interrupted run returned $code instead of 3"
grep -q "interrupted after" "$folder/err" || fail "it did not say that it was interrupted"
grep -q "The same command goes on" "$folder/err" || fail "it did not say how to go on"
[[ -s $folder/cut/video.mp4 ]] || fail "it left no video"
head -c 12 "$folder/cut/video.mp4" | grep -q ftyp || fail "the video is no MP4"
grep -q '"complete": false' "$folder/cut/run.json" || fail "the report says it is complete"
finished=$(find "$folder/cut/frames" -name '*.png' | wc -l)
((finished >= 4 && finished < 60)) || fail "$finished frames were left; the run was not cut in its middle"

"$program" render "$folder/scene.json" -o "$folder/cut" --json >"$folder/report" 2>"$folder/err" </dev/null ||
  fail "going on returned $?"
grep -q '"frames_simulated": 60' "$folder/report" && fail "it simulated everything again"
"$program" render "$folder/scene.json" -o "$folder/whole" --quiet 2>"$folder/err" </dev/null || fail "the whole run returned $?"
cmp "$folder/cut/video.mp4" "$folder/whole/video.mp4" || fail "the videos differ"
cmp "$folder/cut/frames/0059.png" "$folder/whole/frames/0059.png" || fail "the last frames differ"
exit 0
