#!/usr/bin/env bash
# Ctrl-C in the middle of a run leaves a video of the finished frames and says how to go on; the same
# command then goes on from there and ends with the bytes of a run in one piece. So it does after a
# run that was killed, in a scene whose particles come and go.
# Usage: interrupt.sh PROGRAM. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

cat >"$folder/scene.json" <<'JSON'
{
  "fluid": {"spacing": 0.04, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.6, 0.8, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [1.6, 1, 0.4]},
  "video": {"width": 160, "height": 96, "duration": 1}
}
JSON

"$program" render "$folder/scene.json" -o "$folder/cut" >"$folder/out" 2>"$folder/err" </dev/null &
pid=$!
wait_until test -e "$folder/cut/frames/0003.png"
kill -INT $pid
wait $pid
code=$?
((code == 3)) || fail "an interrupted run returned $code instead of 3"
grep -q "interrupted after" "$folder/err" || fail "it did not say that it was interrupted"
grep -q "The same command goes on" "$folder/err" || fail "it did not say how to go on"
[[ -s $folder/cut/video.mp4 ]] || fail "it left no video"
head -c 12 "$folder/cut/video.mp4" | grep -q ftyp || fail "the video is no MP4"
grep -q '"complete": false' "$folder/cut/run.json" || fail "the report says it is complete"
grep -q '^scene: 30 frames, [0-9]* particles at the start$' "$folder/err" || fail "the log does not show that it has begun"
finished=$(find "$folder/cut/frames" -name '*.png' | wc -l)
((finished >= 4 && finished < 30)) || fail "$finished frames were left; the run was not cut in its middle"

spindrift render "$folder/scene.json" -o "$folder/cut" --json || fail "going on returned $?"
grep -q '"frames_simulated": 30' "$folder/out" && fail "it simulated everything again"
spindrift render "$folder/scene.json" -o "$folder/whole" --quiet || fail "the whole run returned $?"
cmp "$folder/cut/video.mp4" "$folder/whole/video.mp4" || fail "the videos differ"
cmp "$folder/cut/frames/0029.png" "$folder/whole/frames/0029.png" || fail "the last frames differ"

# Where all particles are there at once, and large pictures wait to be drawn.
"$program" render "$folder/scene.json" -o "$folder/whole" --set video.width=3840 --set video.height=2160 --frames 0:4 \
  >"$folder/out" 2>"$folder/err" </dev/null &
pid=$!
has_large_picture() { [[ -n $(find "$folder/whole/frames/0000.png" -size +100000c 2>/dev/null) ]]; }
wait_until has_large_picture
kill -INT $pid
wait $pid
code=$?
((code == 3)) || fail "interrupted while pictures waited it returned $code instead of 3"
grep -q "interrupted after [1-4] of 5 frames" "$folder/err" || fail "it did not say how many pictures are there"

cat >"$folder/tap.json" <<'JSON'
{
  "fluid": {
    "spacing": 0.04, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.8, 0.2, 0.4]}}],
    "emitters": [{"disc": {"center": [0.2, 0.6, 0.2], "direction": [1, 0, 0], "radius": 0.1}, "speed": 2}]
  },
  "domain": {"min": [0, 0, 0], "max": [0.8, 0.8, 0.4]},
  "sinks": [{"sphere": {"center": [0.8, 0, 0.2], "radius": 0.15}}],
  "video": {"width": 96, "height": 64, "duration": 1}
}
JSON

"$program" render "$folder/tap.json" -o "$folder/killed" >"$folder/out" 2>"$folder/err" </dev/null &
pid=$!
has_six_kept() { [[ -n $(find "$folder/killed" -name 0005.particles 2>/dev/null) ]]; }
wait_until has_six_kept
kill -KILL $pid
{ wait $pid; } 2>/dev/null  # without the word of it
code=$?
((code == 137)) || fail "a run that was killed returned $code instead of 137"
kept=$(find "$folder/killed/particles" -name '[0-9]*.particles' | wc -l)
((kept >= 6 && kept < 30)) || fail "$kept frames were kept; the run was not killed in its middle"

spindrift render "$folder/tap.json" -o "$folder/killed" --json || fail "going on after a kill returned $?"
grep -q "\"frames_simulated\": $((30 - kept))," "$folder/out" || fail "it did not go on from the $kept kept frames"
spindrift render "$folder/tap.json" -o "$folder/alive" --quiet || fail "the undisturbed run returned $?"
for change in entered drained; do
  (($(grep -c "\"$change\": [1-9]" "$folder/alive/run.json") > 10)) || fail "few frames in which particles $change"
done
for part in particles frames video.mp4; do
  diff -r -x '.*' -x simulation.json "$folder/alive/$part" "$folder/killed/$part" >"$folder/err" || fail "$part of the killed run differ"
done

# A lost terminal is as Ctrl-C; a second word of it does no harm. With nohup the run goes on.
begin() {
  "$@" "$program" render "$folder/scene.json" -o "$folder/hangup" --no-cache --quiet --progress json \
    >"$folder/out" 2>"$folder/err" </dev/null &
  pid=$!
  wait_until test -e "$folder/hangup/frames/0001.png"
}
begin env
kill -HUP $pid
sleep 0.02
kill -HUP $pid 2>/dev/null
wait $pid
code=$?
((code == 3)) || fail "a run whose terminal was lost returned $code instead of 3"
grep -q "interrupted after" "$folder/err" || fail "it did not say that it was interrupted"
[[ -s $folder/hangup/video.mp4 ]] || fail "without its terminal it left no video"
head -n 1 "$folder/err" | grep -q '^{"frame":0,"finished":1,"of":30,"time":0.0,"particles":[0-9]*,"seconds":[0-9.e-]*,"seconds_left":[0-9.e-]*}$' ||
  fail "there is no line of JSON for the first frame"
rm -r "$folder/hangup"
begin nohup
kill -HUP $pid
wait $pid || fail "with nohup the run ended on SIGHUP"
(($(grep -c '^{"frame":' "$folder/err") == 30)) || fail "there is not a line of JSON for each frame"

# A second run in the folder is told who is at work there; nobody who reads the log is no reason to end.
rm -r "$folder/hangup"
begin env
"$program" render "$folder/scene.json" -o "$folder/hangup" >"$folder/out" 2>"$folder/second" </dev/null
code=$?
((code == 3)) || fail "a second run in the same folder returned $code instead of 3"
grep -q "hangup: .*render.*(process $pid) has been at work here since 20" "$folder/second" ||
  fail "it did not say who is at work: $(cat "$folder/second")"
kill -KILL $pid
wait $pid 2>/dev/null
"$program" render "$folder/scene.json" -o "$folder/hangup" --no-cache --progress json 2>&1 >/dev/null </dev/null | head -n 1 >/dev/null
((PIPESTATUS[0] == 0)) || fail "a run ended since nobody read its log"
[[ -z $(find "$folder/hangup" -name '.*.part*') ]] || fail "part files of the killed run are left"
exit 0
