#!/usr/bin/env bash
# The code for any x86-64 processor and the code with AVX2 give the same bytes.
# Usage: processors.sh PROGRAM. Returns 1 if a check fails, 77 where the linker has no choice to be made.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"

loader=/lib64/ld-linux-x86-64.so.2
[[ -x $loader && $("$loader" --help 2>/dev/null) == *"x86-64-v3 (supported"* ]] || exit 77
mask=(--glibc-hwcaps-mask x86-64-v2)
better=glibc-hwcaps/x86-64-v3/libspindrift_sim
[[ $("$loader" --list "$program") == *"$better"* ]] || fail "AVX2 is not made use of"
[[ $("$loader" "${mask[@]}" --list "$program") == *"$better"* ]] && fail "the mask has no effect"
plain=("$loader" "${mask[@]}" "$program")

cp "${BASH_SOURCE[0]%/*}/../../scenes/knot.obj" "$folder"
cat >"$folder/scene.json" <<'JSON'
{
  "fluid": {"spacing": 0.05, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.4, 0.7, 0.5]}}]},
  "domain": {"min": [0, 0, 0], "max": [1, 1, 0.5]},
  "obstacles": [
    {"sphere": {"center": [0.7, 0.1, 0.25], "radius": 0.15}},
    {"mesh": {"file": "knot.obj", "scale": 0.15, "rotate": [30, 20, 10], "translate": [0.75, 0.3, 0.25]}}
  ],
  "video": {"width": 160, "height": 96, "duration": 0.4}
}
JSON
spindrift render "$folder/scene.json" -o "$folder/avx2" --quiet || fail "with AVX2 it returned $?"
"${plain[@]}" render "$folder/scene.json" -o "$folder/plain" --quiet || fail "without AVX2 it returned $?"
for file in frames/0011.png video.mp4; do
  cmp "$folder/avx2/$file" "$folder/plain/$file" || fail "$file differs"
done
(cd "$folder/avx2/particles" && find . -name '*.particles') | while read -r file; do
  # The statistics in the header hold no times, so that whole files are the same.
  cmp "$folder/avx2/particles/$file" "$folder/plain/particles/$file" || exit 1
done || fail "particles differ"
exit 0
