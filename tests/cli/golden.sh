#!/usr/bin/env bash
# Golden tests of a project of one's own, and what they notice.
# Usage: golden.sh PROGRAM. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
mkdir "$folder/project"
cd "$folder/project" || exit 1

# expect CODE TEXT ARGUMENT...: the exit code of `golden`, and a text that it must say.
expect() {
  local code=$1 text=$2 found
  shift 2
  spindrift golden "$@"
  found=$?
  ((found == code)) || fail "golden $*: returned $found instead of $code"
  [[ $(<"$folder/out")$(<"$folder/err") == *"$text"* ]] || fail "golden $*: did not say \"$text\""
}

cat >honey.json <<'JSON'
{
  "fluid": {
    "spacing": 0.05, "rest_density": 1400, "viscosity": 20, "wall_viscosity": 20,
    "volumes": [{"box": {"min": [0.2, 0.05, 0.2], "max": [0.6, 0.8, 0.6]}}]
  },
  "domain": {"min": [0, 0, 0], "max": [1.6, 1, 0.8]},
  "obstacles": [
    {"box": {"min": [0.8, 0, 0.1], "max": [0.9, 0.15, 0.3]}},
    {"box": {"min": [0.8, 0, 0.5], "max": [0.9, 0.15, 0.7]}}
  ],
  "video": {"duration": 0.5}
}
JSON
cat >list.json <<'JSON'
{
  "width": 160, "height": 90,
  "goldens": [
    {"scene": "honey.json", "frames": [12]},
    {"scene": "honey.json", "name": "start", "frames": [0, 1]}
  ]
}
JSON

# Without references nothing passes; update makes them, and leaves those that are right.
expect 1 "references/start/0001.png: there is no such reference; \`spindrift golden update list.json\` makes it" \
  check list.json
expect 1 '"within_limits": false' check list.json --only start --json
expect 0 "new        references/honey/0012.png" update list.json
touch -d "2001-01-01" references/start/0000.png
printf 'no picture' >references/start/0001.png
expect 0 "changed    references/start/0001.png" update list.json --only start
[[ $(stat -c %Y references/start/0000.png) == $(date -d 2001-01-01 +%s) ]] || fail "update wrote what was right"
[[ -z $(find references -name '.*') ]] || fail "update left a temporary file"
expect 0 "all 3 pairs" check list.json
expect 0 '"within_limits": true' check list.json --json --only honey
expect 0 '"result": "as before"' update list.json --json --only honey

# What can't be rendered is named, and no success.
stuck='"set": ["solver.max_iterations=3", "solver.min_time_step=0.005", "fluid.volumes[0].velocity=[0,-30,0]"]'
sed "s/\"name\": \"start\"/&, $stuck/" list.json >stuck.json
expect 3 "spindrift: start: it could not be rendered" check stuck.json --only start
expect 3 '"within_limits": false' check stuck.json --only start --json
expect 3 "spindrift: start: it could not be rendered" update stuck.json --only start
expect 2 "--set is for \`golden check\`" update list.json --set light.intensity=0.5

# A driver that computes otherwise passes: in vectors of 128 bits, as on a processor without AVX.
GALLIUM_OVERRIDE_CPU_CAPS=sse4.1 LP_NATIVE_VECTOR_WIDTH=128 expect 0 "" check list.json

# Changes that a person would want to know of.
for change in light.direction=[-0.4,-1,0.4] fluid.viscosity=24 fluid.viscosity=16 forces.gravity=[0,-8.8,0] \
  'obstacles=[{"box": {"min": [0.8, 0, 0.1], "max": [0.9, 0.15, 0.3]}}]'; do
  expect 1 "honey/0012.png: the" check list.json --only honey --set "$change" --quiet
done
for file in frames/0012.png reference/0012.png difference/0012.png; do
  [[ -s out/golden/honey/$file ]] || fail "a failure left no $file"
done
grep -q "data:image/png;base64" out/golden/golden.html || fail "the report shows nothing"

expect 0 "" check list.json --only honey
[[ -z $(find out/golden/honey/{reference,difference} -type f) ]] || fail "an old failure's pictures stayed"

# References that can't be compared, and bad input.
expect 1 "the reference has 160x90 pixels, the result 64x36" check list.json --only start \
  --set video.width=64 --set video.height=36
head -c 100 references/honey/0012.png >cut.png && mv cut.png references/start/0000.png
expect 1 "0000.png: damaged or cut short" check list.json --only start
expect 2 'did you mean "start"?' check list.json --only strat
expect 2 "nothing.json: there is no such file" check nothing.json
sed 's/max_flip/max_flop/; s/"width"/"max_flop": 1, "width"/' list.json >bad.json
expect 2 'bad.json:2:3: max_flop: unknown key; did you mean "max_flip"?' check bad.json
expect 2 "chek not in {check,update}" chek list.json
