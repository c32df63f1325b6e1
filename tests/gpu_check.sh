#!/usr/bin/env bash
# What only a machine with a GPU can check: the device backend's tests on it, under compute-sanitizer
# too, the benchmark's table for both backends, a golden frame, and a whole run, whose pictures
# should be drawn by the same GPU. Prints a table of what passed.
# usage: tests/gpu_check.sh [BUILD FOLDER, build/gpu if left out]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/gpu}
logs=$build/gpu_check
mkdir -p "$logs"

if ! nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv,noheader >"$logs/gpu.txt" 2>&1; then
  echo "gpu_check: nvidia-smi finds no GPU on this machine; nothing was checked" >&2
  exit 3
fi
cmake --preset release -B "$build" -DSPINDRIFT_CUDA=ON >"$logs/configure.txt"
cmake --build "$build" --target spindrift test_gpu --parallel "$(nproc)" >"$logs/build.txt" ||
  { tail -n 20 "$logs/build.txt" >&2; exit 3; }

failed=0
rows=()
# check NAME COMMAND...: runs it, keeps what it says, and notes how it ended.
check() {
  local name=$1 begin=$SECONDS result=passed
  shift
  "$@" >"$logs/$name.txt" 2>&1 || { result=FAILED; failed=1; }
  rows+=("| $name | $result | $((SECONDS - begin)) s | $logs/$name.txt |")
}

sanitizer() { # TOOL TESTS...
  compute-sanitizer --tool "$1" --error-exitcode 1 "$build/tests/test_gpu" "${@:2}"
}

bench() { # BACKEND
  "$build/spindrift" bench --scaling --quick --set solver.backend="$1" -o "$logs/bench_$1"
}

check tests "$build/tests/test_gpu"
check memcheck sanitizer memcheck
# Shared memory is used by reductions and by sorts, sums and selections alone; a step has all of them.
check racecheck sanitizer racecheck "a step on the device is the processor's"
check bench_cpu bench cpu
check bench_cuda bench cuda
check golden_frame "$build/spindrift" golden check tests/golden/scenes.json --only dam_break \
  --set solver.backend=cuda -o "$logs/golden"
check render "$build/spindrift" render scenes/small_dam_break.json --backend cuda \
  --set video.duration=0.5 -o "$logs/render"

echo "GPU: $(cat "$logs/gpu.txt")"
echo "drawn by: $(grep -o '"device": "[^"]*"' "$logs/render/run.json" || echo nothing)"
echo "| check | result | time | log |"
echo "|---|---|---|---|"
printf '%s\n' "${rows[@]}"
for backend in cpu cuda; do
  echo "bench, $backend: $logs/bench_$backend/bench.csv"
done
exit $failed
