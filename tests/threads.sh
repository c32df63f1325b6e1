#!/usr/bin/env bash
# Builds the program with the thread sanitizer, runs whole scenes in it, and fails where it sees a data race: the
# pipeline's threads, the loops of OpenMP, moving bodies, emitters and sinks, both solvers, and a sweep's tasks.
# usage: tests/threads.sh
#
# tests/threads.supp says what it may report. LLVM's Archer tells the sanitizer how OpenMP orders its threads. Libraries
# that are not built with the sanitizer (Mesa, libav) are left out, since it sees their accesses and not what orders
# them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. tests/tools.sh
need clang libclang-rt-dev libomp-dev
quietly cmake --preset thread
quietly cmake --build --preset thread --target spindrift --parallel "$(nproc)"
program=build/thread/spindrift
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
archer=$(clang++ --print-resource-dir)/../../libarcher.so
[[ -f $archer ]] || { echo "threads: clang has no libarcher.so; on Debian: apt-get install libomp-dev" >&2; exit 3; }
export OMP_TOOL_LIBRARIES=$archer TSAN_OPTIONS="ignore_noninstrumented_modules=1 exitcode=66 suppressions=$PWD/tests/threads.supp"

watched() { # WHAT COMMAND...
  local what=$1
  shift
  "$@" >"$out/log" 2>&1 || { cat "$out/log"; echo "threads: $what FAILED" >&2; exit 1; }
  echo "$what: no data race"
}
small=(--threads 2 --quiet --set video.width=160 --set video.height=90)
for scene in small_dam_break mixer fountain; do
  watched "render $scene" "$program" render "scenes/$scene.json" -o "$out/$scene" "${small[@]}" \
    --set video.duration=0.1 --export meshes,particles
done
watched "simulate by basic SPH" "$program" simulate scenes/small_dam_break.json -o "$out/sph" --threads 2 --quiet \
  --set solver.type=sph --set video.duration=0.1
watched "go on with kept particles" "$program" render scenes/small_dam_break.json -o "$out/small_dam_break" \
  "${small[@]}" --set video.duration=0.2
watched "sweep" "$program" sweep scenes/small_dam_break.json --set fluid.viscosity=0.1,1 -o "$out/sweep" --quiet --jobs 2 \
  --threads 2 --set video.width=160 --set video.height=90 --set video.duration=0.1
