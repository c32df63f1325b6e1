#!/usr/bin/env bash
# The command line as a user types it: what each command returns and what it says.
# Usage: command_line.sh PROGRAM PART, from the source tree's root. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
part=$2
failures=0

# expect CODE TEXT ARGUMENT...: the exit code, and a text that must be in the output of the command.
# Errors must be on stderr, and stdout empty then.
expect() {
  local code=$1 text=$2 found out err
  shift 2
  spindrift "$@"
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

# expect_json TEXT ARGUMENT...: a failure that is told on stdout in JSON as well; TEXT without line breaks.
expect_json() {
  local text=$1 found
  shift
  spindrift "$@"
  found=$?
  local flat
  flat=$(sed 's/^ *//' "$folder/out" | tr '\n' ' ' | sed 's/{ /{/g; s/ }/}/g')
  [[ $flat == '{"errors": ['*"$text"*'], "exit_code": '$found'}'* ]] || complain "is not told in JSON: $text" "$@"
  [[ -s $folder/err ]] || complain "is not told in words" "$@"
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

# What the program counts; nproc would tell OMP_NUM_THREADS instead.
processors=$(env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc)

case $part in
  usage)
    expect 0 "render" --help
    expect 0 "--frames" render --help
    expect 0 "spindrift 0" --version
    expect 0 "spindrift 0" -V
    expect 0 "spindrift 0" version
    expect 0 "--frames" help render
    expect 0 "render" help
    for word in schema help version --version -V; do
      expect 0 "$word" --help
      grep -qE "^  (-V,)?${word#-V}" "$folder/out" || complain "does not list $word" --help
    done
    expect 2 'unknown command "rendr"; did you mean "render"' help rendr
    expect 0 '"title": "Spindrift scene"' schema
    expect 2 "a command is missing"
    expect 2 'did you mean "render"' rendr scenes/dam_break.json
    expect 2 'did you mean "--threads"' check scenes/dam_break.json --thread 2
    expect 2 "scene is required" render
    expect 2 "there is no such file" render no_such_scene.json
    expect 2 "no_such_scene.json" render no_such_scene.json
    expect 2 "scenes: is a folder, not a file" check scenes
    mkfifo "$folder/pipe.json"
    expect 2 "pipe.json: is a pipe (FIFO), not a file" check "$folder/pipe.json"
    expect 2 "is a device, not a file" check /dev/zero
    expect 2 "within 0:119" render scenes/dam_break.json --frames 7:500
    expect 2 "within 0:119" render scenes/dam_break.json --frames 7:5
    expect 2 "within 0:119" render scenes/dam_break.json --frames first
    expect 2 "no_such_folder" render scenes/dam_break.json --from-particles no_such_folder
    expect 2 "meshes" render scenes/dam_break.json --export foam
    expect 2 "threads" check scenes/dam_break.json --threads 0
    for command in check render simulate bench sweep; do
      expect 2 "--threads 4096: $processors processor" $command scenes/dam_break.json --threads 4096
    done
    OMP_NUM_THREADS=5000 expect 2 "OMP_NUM_THREADS 5000: " golden check tests/golden/scenes.json
    expect 0 "warning: --threads $((processors + 1)): " check scenes/dam_break.json --threads $((processors + 1))
    expect 0 "" check scenes/dam_break.json --threads $((processors + 1)) --quiet
    [[ ! -s $folder/err ]] || complain "--quiet warned" check
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
      expect 3 "unset __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null" render scenes/dam_break.json --frames 0:0 -o "$folder/no_egl"
    __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null expect 0 "none: there is no EGL device" info
    expect 2 "--backend: gpu not in {auto,cpu,cuda}" render scenes/dam_break.json --backend gpu
    if "$program" info | grep -q 'cuda .*no '; then
      expect 2 'solver.backend is "cuda", but' render scenes/dam_break.json --backend cuda -o "$folder/no_cuda"
      expect 2 'solver.backend is "cuda", but' golden check tests/golden/scenes.json --set solver.backend=cuda
    fi
    expect 2 "--set fluid.spacing=wide" check scenes/dam_break.json --set fluid.spacing=wide
    # Every problem on a line of its own; none of them can write to the terminal.
    scene_with $'{"fluid": {"spacng": 0.1},\n "look": {"stile": 1},\n "a\\u001b[2J": 1}'
    expect 2 "scene.json:2:11: look.stile: unknown key" check "$folder/scene.json"
    [[ $(grep -c "^spindrift: .*scene.json:[123]:" "$folder/err") == 3 ]] || complain "did not tell all three" check
    grep -q $'\x1b' "$folder/out" "$folder/err" && complain "let control characters through" check
    # For machines they are on stdout as well.
    expect_json '{"source": "'"$folder"'/scene.json", "line": 1, "column": 12, "path": "fluid.spacng", "message": "unknown key; did you mean \"spacing\"?"}' \
      check "$folder/scene.json" --json
    expect_json '{"source": "'"$folder"'/scene.json", "line": 2, "column": 11, "path": "look.stile",' render "$folder/scene.json" --json
    expect_json '{"message": "unknown option --frmes; did you mean \"--frames\"? (see spindrift --help)"}' \
      render "$folder/scene.json" --json --frmes 3
    expect_json 'there is no such file"}' golden check "$folder/no_list.json" --json
    expect_json '"source": "--set fluid.spacing=1,wide", "path": "fluid.spacing",' \
      sweep scenes/small_dam_break.json --set fluid.spacing=1,wide --json
    expect_json 'there is no such file or folder' compare "$folder/a.png" "$folder/b.png" --json
    ;;
  stdin)
    # A scene from the standard input is called so, and its meshes' paths start at the current folder.
    "$program" check scenes/knot.json --json >"$folder/file.json" || complain "failed" check
    (cd scenes && "$program" check - --json <knot.json >"$folder/stdin.json") || complain "failed" check -
    diff <(sed 's/"name": "knot"/"name": "stdin"/' "$folder/file.json") "$folder/stdin.json" || complain "read another scene" check -
    echo '{"fluid": {"spacng": 1}}' | "$program" check - >"$folder/out" 2>"$folder/err"
    [[ $? == 2 ]] && grep -q "stdin:1:12: fluid.spacng" "$folder/err" || complain "gave no place" check -
    echo '{"name": "piped", "fluid": {"spacing": 0.1}, "video": {"duration": 0.1}}' |
      (mkdir "$folder/here" && cd "$folder/here" && "$program" simulate - --quiet) || complain "failed" simulate -
    [[ -f $folder/here/out/piped/run.json ]] || complain "left no results" simulate -
    yes 2>/dev/null | timeout 60 "$program" check - >"$folder/out" 2>"$folder/err"
    [[ ${PIPESTATUS[1]} == 2 ]] && grep -q "stdin: longer than 32 MB" "$folder/err" || complain "read without end" check -
    ;;
  probes)
    scene_with '{
      "fluid": {"spacing": 0.1, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.4, 0.8, 0.4]}}]},
      "domain": {"min": [0, 0, 0], "max": [0.8, 1.2, 0.4]},
      "probes": [{"name": "gauge", "surface_height": {"x": 0.2, "z": 0.2}},
                 {"name": "dry", "surface_height": {"x": 0.7, "z": 0.2}},
                 {"name": "tap", "pressure": {"point": [0.2, 0, 0.2]}}],
      "video": {"duration": 0.1, "frames_per_second": 20, "width": 32, "height": 32}
    }'
    out=$folder/probed
    expect 0 '"table": "probes.csv"' simulate "$folder/scene.json" -o "$out" --json
    [[ $(head -n 1 "$out/probes.csv") == "time_s,gauge_m,dry_m,tap_Pa" ]] || complain "has no header" simulate
    awk -F, 'NR == 2 && !($1 == 0 && $2 > 0.75 && $2 < 0.85 && $3 == "" && $4 == 0) { exit 1 }
             NR == 3 && !($1 == 0.05 && $2 > 0.7 && $2 < 0.85) { exit 1 }
             END { exit NR != 3 }' "$out/probes.csv" || complain "read something else" simulate
    [[ $(grep -c '"curves":\[{' "$out/probes.html") == 2 ]] || complain "did not plot what was measured" simulate
    grep -qi 'src="[^d]\|href=.http' "$out/probes.html" && complain "needs other files for its report" simulate
    # At a rate of their own, kept with the particles; other probes of kept particles, a reading a frame.
    expect 0 "probes.html" simulate "$folder/scene.json" -o "$out" --set probes_rate=400
    [[ $(wc -l <"$out/probes.csv") == 22 ]] || complain "did not read at the rate" simulate
    cp "$out/probes.csv" "$folder/first.csv"
    expect 0 "probes.html" simulate "$folder/scene.json" -o "$out" --set probes_rate=400
    cmp "$out/probes.csv" "$folder/first.csv" || complain "lost what was read between the frames" simulate
    expect 0 "--no-cache reads them 400 times a second" simulate "$folder/scene.json" -o "$out" --set probes_rate=400 \
      --set 'probes=[{"name": "all", "volume": {}}]'
    [[ $(wc -l <"$out/probes.csv") == 3 ]] || complain "did not read the kept frames" simulate
    expect 2 'did you mean "pressure"?' check "$folder/scene.json" --set 'probes=[{"name": "a", "presure": {}}]'
    ;;
  compare)
    small=(--set fluid.spacing=0.1 --set video.duration=0.1 --set video.width=64 --set video.height=36 --quiet)
    "$program" render scenes/dam_break.json -o "$folder/a" "${small[@]}"
    "$program" render scenes/dam_break.json -o "$folder/b" "${small[@]}" --set light.direction=[1,-1,0]
    expect 0 "all 3 pairs" compare "$folder/a" "$folder/b" -o "$folder/out_ab"
    expect 0 "light.direction: " compare "$folder/a" "$folder/b" -o "$folder/out_ab" --json
    expect 1 "the mean of FLIP is 0." compare "$folder/a" "$folder/b" -o "$folder/out_ab" --max-flip 0.001 --quiet
    expect 0 "" compare "$folder/a" "$folder/a/frames" -o "$folder/out_aa" --max-flip 0 --max-changed 0 --min-ssim 1
    expect 0 "" compare "$folder/a/video.mp4" "$folder/b/video.mp4" -o "$folder/out_v"
    expect 2 "give another folder by -o" compare "$folder/out_ab/differences" "$folder/b" -o "$folder/out_ab"
    expect 0 "0001.png" compare "$folder/a/frames/0001.png" "$folder/b/frames/0001.png" -o "$folder/out_ab"
    [[ $(ls "$folder/out_ab/differences") == 0001.png ]] ||
      complain "pictures of an earlier comparison stayed" compare
    head -c 300 "$folder/a/frames/0001.png" >"$folder/cut.png"
    expect 2 "damaged or cut short" compare "$folder/cut.png" "$folder/b/frames/0001.png"
    expect 2 "there is no such file or folder" compare "$folder/a" "$folder/c" -o "$folder/out_ac"
    expect 2 "64x36 pixels" compare "$folder/a/frames/0000.png" docs/images/knot.png -o "$folder/out_s"
    expect 2 "not in range" compare "$folder/a" "$folder/b" --min-ssim 2
    expect 2 'did you mean "--max-flip"?' compare "$folder/a" "$folder/b" --max-flop 1
    ;;
  info)
    expect 0 "processor" info
    expect 0 "cuda" info
    expect 0 '"renderer"' info --json
    unset OMP_WAIT_POLICY GOMP_SPINCOUNT
    # Threads wait shortly, so that a core held by another program delays little; the user may say otherwise.
    OMP_DISPLAY_ENV=verbose expect 0 "GOMP_SPINCOUNT = '2000'" --version
    OMP_DISPLAY_ENV=verbose OMP_WAIT_POLICY=active expect 0 "OMP_WAIT_POLICY = 'ACTIVE'" --version
    ;;
  *)
    echo "unknown part $part"
    failures=1
    ;;
esac
exit $((failures > 0))
