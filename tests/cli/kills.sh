#!/usr/bin/env bash
# Ends runs at random moments, over scenes that are plain, that export, whose particles come and go and whose bodies
# move; in runs that go on, are shorter, have another look, draw a part or only simulate; one at a time and two at
# once. After each end the folder must be of one scene, the one that run.json names, with no wrong byte in it; in the
# end, the bytes of a run in one piece.
# Usage: kills.sh PROGRAM [COUNT [SEED]]. Returns 1 if a check fails, with what to run to see it again.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
count=${2:-10}
seed=${3:-1}
RANDOM=$seed
frames=8
history=()
fail() {
  echo "FAILED: $* (kills.sh PROGRAM $count $seed; scene $scene)"
  printf '  %s\n' "${history[@]}"
  cat "$folder"/err* 2>/dev/null
  exit 1
}

tank='"domain": {"min": [0, 0, 0], "max": [0.8, 0.6, 0.4]},
  "video": {"width": 96, "height": 64, "frames_per_second": 20, "duration": 0.4}'
column='{"box": {"min": [0, 0, 0], "max": [0.4, 0.4, 0.4]}}'
cat >"$folder/plain.json" <<JSON
{"fluid": {"spacing": 0.05, "volumes": [$column]}, $tank,
  "probes": [{"name": "e", "energy": {}}], "probes_rate": 100}
JSON
cat >"$folder/exporting.json" <<JSON
{"fluid": {"spacing": 0.05, "volumes": [$column], "viscosity": 0.5}, $tank}
JSON
cat >"$folder/emitter.json" <<JSON
{"fluid": {"spacing": 0.05, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.8, 0.1, 0.4]}}],
  "emitters": [{"disc": {"center": [0.3, 0.45, 0.2], "direction": [1, 0, 0], "radius": 0.1}, "speed": 2}]},
  "sinks": [{"sphere": {"center": [0.8, 0, 0.2], "radius": 0.15}}], $tank}
JSON
cat >"$folder/moving.json" <<JSON
{"fluid": {"spacing": 0.05, "volumes": [$column]}, $tank,
  "obstacles": [{"box": {"min": [0.55, 0.05, 0.1], "max": [0.65, 0.25, 0.3]},
                 "motion": {"pivot": [0.6, 0.1, 0.2], "spin": {"axis": [0, 1, 0], "frequency": 1}}}]}
JSON
scenes=(plain exporting emitter moving)
looks=(plain green)
# shellcheck disable=SC2034  # named by what "looks" holds
plain_look=()
green_look=(--set 'look.liquid_color=[0.2,0.7,0.3]')

# run NUMBER COMMAND WORD...: in the scene's folder, its messages kept.
run() {
  local number=$1 command=$2
  shift 2
  exec "$program" "$command" "$folder/$scene.json" -o "$folder/run/$scene" --quiet --threads 1 "$@" \
    </dev/null >"$folder/out$number" 2>"$folder/err$number"
}

# The folder of an undisturbed run of so many frames with a look; made once, from the same kept particles.
reference() {
  local look=$1 length=$2
  local -n words=${look}_look
  local made=$folder/reference/$scene/$look$length duration
  duration=$(awk "BEGIN { print $length / 20 }")
  if [[ ! -e $made/run.json ]]; then
    mkdir -p "$made"
    [[ -e $folder/reference/$scene/plain$frames/particles ]] &&
      cp -r "$folder/reference/$scene/plain$frames/particles" "$made"
    "$program" render "$folder/$scene.json" -o "$made" --quiet --threads 1 --export meshes,particles \
      --set "video.duration=$duration" "${words[@]}" </dev/null >"$folder/out" 2>"$folder/err" ||
      fail "a run in one piece returned $?"
  fi
  echo "$made"
}

# value_of KEY FILE: of the hash of a part in run.json.
hash_of() { sed -n '/"made_of"/,/}/s/.*"'"$1"'": "\([0-9a-f]*\)".*/\1/p' "$2"; }

# same_files PART EXTENSION REFERENCE: each file that is there is the one of the reference.
same_files() {
  local file
  for file in "$run/$1"/[0-9]*."$2"; do
    [[ -e $file ]] || continue
    cmp -s "$file" "$3/$1/${file##*/}" || fail "$file is not that of its scene"
  done
}

# The folder's files are those of the scene that run.json names.
check_folder() {
  local look found='' length video
  run=$folder/run/$scene
  local kept
  for kept in "$run"/particles/*/[0-9]*; do
    [[ -e $kept ]] || continue
    cmp -s "$kept" "$folder/reference/$scene/plain$frames/particles/${kept#"$run/particles/"}" || fail "$kept differs"
  done
  if [[ ! -e $run/run.json ]]; then
    [[ -z $(find "$run" -type f ! -name '.*' 2>/dev/null) ]] || fail "there are files, and no run.json"
    return
  fi
  for look in "${looks[@]}"; do
    [[ $(hash_of pictures "$run/run.json") == "$(hash_of pictures "$folder/reference/$scene/$look$frames/run.json")" ]] &&
      found=$look
  done
  [[ -n $found ]] || fail "run.json is of no scene that was run"
  local whole=$folder/reference/$scene/$found$frames
  same_files frames png "$whole"
  same_files meshes ply "$whole"
  same_files particles_ply ply "$whole"
  for video in "$run"/video*.mp4; do
    [[ -e $video ]] || continue
    check_video "$video" "$found"
  done
  if [[ -e $run/probes.csv ]]; then
    head -n "$(wc -l <"$run/probes.csv")" "$whole/probes.csv" | cmp -s - "$run/probes.csv" || fail "probes.csv differs"
  fi
  if grep -q '"complete": true' "$run/run.json" && grep -q '"command": "render"' "$run/run.json"; then
    length=$(sed -n 's/.*"duration": \([0-9.]*\).*/\1/p' "$run/run.json" | awk '{ printf "%d", 20 * $1 + 0.5 }')
    (($(ls "$run/frames" | wc -l) == length)) || fail "complete, and not $length pictures"
    cmp -s "$run/video.mp4" "$(reference "$found" "$length")/video.mp4" || fail "complete, and not the whole video"
  fi
}

# check_video FILE LOOK: whole from its first frame to one of the next, and as long as run.json says.
check_video() {
  local name=${1##*/} length stated numbers first last part
  stated=$(awk -v name="\"$name\"" '/"file":/ { mine = index($0, name) } mine && /"frames":/ { gsub(/[^0-9]/, ""); print; exit }' \
    "$run/run.json")
  if [[ $name == video.mp4 ]]; then
    for ((length = frames; length > 0; --length)); do
      cmp -s "$1" "$(reference "$2" "$length")/video.mp4" || continue
      [[ -z $stated || $stated == "$length" ]] || fail "$name has $length frames, and run.json says $stated"
      return
    done
    fail "$name is of no run of this look"
  fi
  numbers=${name#video_}
  numbers=${numbers%.mp4}
  first=$((10#${numbers%-*})) last=$((10#${numbers#*-}))
  part=$folder/reference/$scene/$2-$numbers.mp4
  if [[ ! -e $part ]]; then
    local -n words=${2}_look
    "$program" render "$folder/$scene.json" -o "$folder/part" --no-cache --quiet --threads 1 "${words[@]}" \
      --frames "$first:$last" </dev/null >"$folder/out" 2>"$folder/err" || fail "a part in one piece returned $?"
    mv "$folder/part/$name" "$part"
    rm -rf "$folder/part"
  fi
  cmp -s "$1" "$part" || fail "$name is not of frames $first to $last"
  [[ -z $stated || $stated == $((last - first + 1)) ]] || fail "$name: run.json says $stated frames"
}

# A command as somebody might type it next.
choose() {
  words=(render)
  local a b
  case $((RANDOM % 8)) in
    0 | 1) ;;
    2 | 3) words+=("${green_look[@]}") ;;
    4) words+=(--set video.duration=0.2) ;;
    5)
      a=$((RANDOM % frames)) b=$((RANDOM % frames))
      words+=(--frames "$((a < b ? a : b)):$((a < b ? b : a))")
      ((RANDOM % 2)) && words+=("${green_look[@]}")
      ;;
    6) words=(simulate) ;;
    7) words+=("${green_look[@]}" --set video.duration=0.3) ;;
  esac
  [[ $scene == exporting ]] && ((RANDOM % 4)) && words+=(--export particles)
  [[ $scene == exporting && ${words[0]} == render ]] && ((RANDOM % 4)) && words+=(--export meshes)
  return 0
}

# Whole, undisturbed: the bytes of a run that nothing happened to.
check_end() {
  local whole=$folder/reference/$scene/plain$frames extra=() part
  [[ $scene == exporting ]] && extra=(--export "meshes,particles")
  (run 0 render "${extra[@]}") || fail "the last run returned $?"
  check_folder
  grep -q '"complete": true' "$run/run.json" || fail "the last run is not complete"
  for part in frames video.mp4 ${extra[0]:+meshes particles_ply}; do
    diff -r "$whole/$part" "$run/$part" >"$folder/err" || fail "$part of the last run differ"
  done
  diff -r -x simulation.json "$whole/particles" "$run/particles" >"$folder/err" || fail "the kept particles differ"
  [[ -z $(find "$run" -name '.*.part*') ]] || fail "part files are left"
}

declare -A longest
for scene in "${scenes[@]}"; do
  start=${EPOCHREALTIME/./}
  reference plain $frames >/dev/null
  longest[$scene]=$(((${EPOCHREALTIME/./} - start) / 800))  # milliseconds, and a quarter more
  reference green $frames >/dev/null
done

signals=(KILL KILL KILL KILL INT TERM HUP)
stopped=0 refused=0
for ((kill_number = 1; kill_number <= count; ++kill_number)); do
  scene=${scenes[RANDOM % ${#scenes[@]}]}
  choose
  history+=("$scene: ${words[*]}")
  (run 1 "${words[@]}") &
  pids=($!)
  if ((RANDOM % 4 == 0)); then
    choose
    history+=("  and at once: ${words[*]}")
    (run 2 "${words[@]}") &
    pids+=($!)
  fi
  sleep "$(awk "BEGIN { print $((RANDOM % longest[$scene])) / 1000 }")"
  signal=${signals[RANDOM % ${#signals[@]}]}
  history+=("  $signal")
  kill -"$signal" "${pids[@]}" 2>/dev/null
  for pid in "${pids[@]}"; do
    wait "$pid" 2>/dev/null
    code=$?
    ((code == 0 || code == 3 || code > 128)) || fail "a run returned $code"
    ((code != 0)) && ((++stopped))
  done
  grep -qs "at work here" "$folder"/err[12] && ((++refused))
  rm -f "$folder"/err[12]
  check_folder
  ((RANDOM % 6 == 0)) && check_end
done
for scene in "${scenes[@]}"; do check_end; done
echo "$count kills: $stopped runs were cut short, $refused times a second one was refused; no wrong byte, no mixed folder"
