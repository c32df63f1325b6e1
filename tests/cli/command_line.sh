#!/usr/bin/env bash
# The command line as a user types it: what each command returns and what it says.
# Usage: command_line.sh PROGRAM PART, from the source tree's root. Returns 1 if a check fails.
set -uo pipefail
program=$1
part=$2
failures=0
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# expect CODE TEXT ARGUMENT...: the exit code, and a text that must be in the output of the command.
# Errors must be on stderr, and stdout empty then.
expect() {
  local code=$1 text=$2 found out err
  shift 2
  "$program" "$@" >"$folder/out" 2>"$folder/err" </dev/null
  found=$?
  out=$(<"$folder/out") err=$(<"$folder/err")
  if ((found != code)); then
    complain "returned $found instead of $code" "$@"
  elif [[ $out$err != *"$text"* ]]; then
    complain "did not say \"$text\"" "$@"
  elif ((code != 0)) && [[ -n $out || $err != *"$text"* ]]; then
    complain "should say it on stderr only" "$@"
  fi
}

complain() {
  local what=$1
  shift
  echo "FAILED: spindrift $*: $what"
  sed 's/^/  /' "$folder/out" "$folder/err" | head -n 20
  failures=$((failures + 1))
}

scene_with() {
  echo "$1" >"$folder/scene.json"
}

case $part in
  usage)
    expect 0 "render" --help
    expect 0 "--frames" render --help
    expect 0 "spindrift 0" --version
    expect 2 "a command is missing"
    expect 2 'did you mean "render"' rendr scenes/dam_break.json
    expect 2 'did you mean "--threads"' check scenes/dam_break.json --thread 2
    expect 2 "scene is required" render
    expect 2 "there is no such file" render no_such_scene.json
    expect 2 "no_such_scene.json" render no_such_scene.json
    expect 2 "can't be read" check scenes
    expect 2 "within 0:119" render scenes/dam_break.json --frames 7:500
    expect 2 "within 0:119" render scenes/dam_break.json --frames 7:5
    expect 2 "within 0:119" render scenes/dam_break.json --frames first
    expect 2 "no_such_folder" render scenes/dam_break.json --from-particles no_such_folder
    expect 2 "meshes" render scenes/dam_break.json --export foam
    expect 2 "threads" check scenes/dam_break.json --threads 0
    expect 2 "one word too many" check scenes/dam_break.json scenes/dam_break.json
    ;;
  scenes)
    shipped=0
    for scene in scenes/*.json; do
      [[ $scene == scenes/scene.schema.json ]] && continue
      expect 0 "particles " check "$scene"
      expect 0 '"simulation_hash"' check "$scene" --json
      shipped=$((shipped + 1))
    done
    ((shipped >= 5)) || { echo "FAILED: only $shipped scenes found"; failures=1; }
    expect 0 "44294 of liquid" check scenes/drop_44k.json
    expect 0 '"viscosity": 0.05' check scenes/dam_break.json --set fluid.viscosity=0.05
    expect 0 "" check scenes/dam_break.json --quiet
    [[ ! -s $folder/out ]] || complain "--quiet printed something" check --quiet
    # The resolved scene is a scene file of its own and resolves to itself.
    "$program" check scenes/sphere_drop.json | sed '/^$/,$d' >"$folder/sphere_drop.json"
    "$program" check "$folder/sphere_drop.json" | sed '/^$/,$d' >"$folder/again.json"
    cmp "$folder/sphere_drop.json" "$folder/again.json" || failures=$((failures + 1))
    ;;
  errors)
    scene_with '{"fluid": {"spacng": 0.1}}'
    expect 2 'scene.json:1:12: fluid.spacng: unknown key; did you mean "spacing"?' check "$folder/scene.json"
    expect 2 'did you mean "spacing"?' render "$folder/scene.json"
    expect 2 'did you mean "spacing"?' simulate "$folder/scene.json"
    scene_with '{"fluid": {"spacing": -1}}'
    expect 2 "-1 is out of range; accepted: 1e-06 ... 100 m" check "$folder/scene.json"
    scene_with '{"fluid": '
    expect 2 "scene.json:2:1: not valid JSON" check "$folder/scene.json"
    scene_with '{"obstacles": [{"mesh": {"file": "cup.obj"}}]}'
    expect 2 "scene.json:1:26: obstacles[0].mesh.file: $folder/cup.obj: there is no such file" check "$folder/scene.json"
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$folder/cup.obj"
    expect 2 "is not closed: 3 edges are without a neighbour" render "$folder/scene.json"
    __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null \
      expect 3 "libgl1-mesa-dri" render scenes/dam_break.json --frames 0:0 -o "$folder/no_egl"
    __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null expect 0 "none: no EGL device" info
    expect 2 "--set fluid.spacing=wide" check scenes/dam_break.json --set fluid.spacing=wide
    ;;
  info)
    expect 0 "processor" info
    expect 0 '"renderer"' info --json
    ;;
  *)
    echo "unknown part $part"
    failures=1
    ;;
esac
exit $((failures > 0))
