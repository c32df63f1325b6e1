#!/usr/bin/env bash
# What only a machine with a GPU can check, within 8 minutes: the device backend's tests on it, under compute-sanitizer
# too, the benchmark with both backends, a golden frame, and a whole run, whose pictures should be drawn by the same
# GPU. Prints what passed, and the rows that docs/gpu.md lacks, and leaves both in LOGS/gpu.md.
# With --cpu: only what needs no GPU, to try the bundle itself.
# usage: check.sh PROGRAM TESTS SOURCE LOGS [--cpu]
#   PROGRAM  spindrift, built with CUDA   TESTS  test_gpu   SOURCE  the folder with scenes/ and tests/golden/
set -euo pipefail
program=$1 tests=$2 source=$3 logs=$4 cpu_only=${5:-}
mkdir -p "$logs"

gpu="none (--cpu)"
if [[ -z $cpu_only ]] &&
  ! gpu=$(nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv,noheader 2>&1); then
  echo "gpu check: nvidia-smi finds no GPU on this machine ($gpu); nothing was checked" >&2
  exit 3
fi

failed=0
rows=()
# check NAME SECONDS COMMAND...: runs it, keeps what it says, and notes how it ended. Longer than so many seconds is a
# failure.
check() {
  local name=$1 limit=$2 begin=$SECONDS result=passed code=0
  shift 2
  timeout "$limit" "$@" >"$logs/$name.txt" 2>&1 || code=$?
  if ((code == 124)); then
    result="FAILED: longer than $limit s"
  elif ((code != 0)); then
    result="FAILED: $(tail -n 1 "$logs/$name.txt" | cut -c 1-120)"
  fi
  ((code == 0)) || failed=1
  rows+=("| $name | $result | $((SECONDS - begin)) s |")
}
skip() { rows+=("| $1 | not checked: $2 | |"); } # NAME REASON

sanitizer=$(command -v compute-sanitizer || ls /usr/local/cuda*/bin/compute-sanitizer 2>/dev/null | head -n 1 || true)
sanitize() { # NAME SECONDS TESTS...
  if [[ -n $sanitizer ]]; then
    check "$1" "$2" "$sanitizer" --tool "$1" --error-exitcode 1 "$tests" "${@:3}"
  else
    skip "$1" "no compute-sanitizer on this machine"
  fi
}

bench() { # BACKEND
  check "bench_$1" 75 "$program" bench --scaling --quick --set solver.backend="$1" --limit 60 -o "$logs/bench_$1"
}

backend=cuda
if [[ -n $cpu_only ]]; then
  backend=cpu
else
  check tests 60 "$tests"
  sanitize memcheck 120 "~[slow]"
  # Shared memory is used by reductions and by sorts, sums and selections alone; a step has all of them.
  sanitize racecheck 60 "a step on the device is the processor's"
  bench cuda
fi
bench cpu
if "$program" info >"$logs/info.txt" 2>&1 && ! grep -q "cannot draw\|no EGL" "$logs/info.txt"; then
  check golden_frame 45 "$program" golden check "$source/tests/golden/scenes.json" --only dam_break \
    --set solver.backend="$backend" -o "$logs/golden"
  check render 45 "$program" render "$source/scenes/small_dam_break.json" --backend "$backend" \
    --set video.duration=0.5 -o "$logs/render"
else
  skip golden_frame "nothing draws on this machine: $(sed -n "s/^renderer *//p" "$logs/info.txt")"
  check simulate 45 "$program" simulate "$source/scenes/small_dam_break.json" --backend "$backend" \
    --set video.duration=0.5 -o "$logs/render"
fi

# A bench.csv's columns by name: particles, ns for a particle and step, and the errors that it was had at.
bench_rows() { # BACKEND
  [[ -f $logs/bench_$1/bench.csv ]] || return 0
  awk -F, -v backend="$1" '
    NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
    { printf "| %s | %s | %s | %s %% | %s %% |\n", $column["particles"], backend,
        $column["ns_per_particle_step"], 100 * $column["mean_compression"], 100 * $column["max_compression"] }' \
    "$logs/bench_$1/bench.csv"
}
{
  echo "GPU: $gpu"
  echo "drawn by: $(grep -o '"egl_device": "[^"]*"' "$logs/render/run.json" 2>/dev/null || echo nothing)"
  echo
  echo "| check | result | time |"
  echo "|---|---|---|"
  printf '%s\n' "${rows[@]}"
  echo
  echo "| particles | backend | ns for a particle and step | mean compression | largest |"
  echo "|---|---|---|---|---|"
  bench_rows cuda
  bench_rows cpu
} | tee "$logs/gpu.md"
exit $failed
